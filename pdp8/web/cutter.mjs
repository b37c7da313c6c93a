// The Hydra-Point's cutter on its staircase: the whole contour, and a close view in the band.
//
// Coordinates are thousandths of an inch, Y upward, as the tape has them. A contour is what bench/path.mjs makes of a
// path; a place on it is what the path's at() says (nc/path.py).

import { write } from "./sheet.mjs";

const PLATE = "#cfd2cf", RULER = "#e8e4d8", GROOVE = "#8f979b", FLOOR = "#a9b0b2", PAPER = "#f7f3e9";
const LINE = "#20303a", BAND = "#2f6f5e", TOOL = "#b3401f", FAINT = "#57534a";
const FONT = "11px Helvetica, Arial, sans-serif";
const LEFT = 22, BELOW = 18; // the rulers, in pixels
const NEAR = 300; // knots before and behind the cutter that a close view may show

/** The whole contour: the plate, the groove milled so far, what is still to come, the cutter. */
export function drawWhole(context, contour, place, started, width, height) {
  const { path: { knots }, diameter, bounds: { left, right, bottom, top } } = contour;
  const margin = 300;
  const [wide, tall] = [width - LEFT, height - BELOW];
  const scale = Math.min(wide / (right - left + 2 * margin), tall / (top - bottom + 2 * margin));
  const view = viewport(LEFT + wide / 2, tall / 2, (left + right) / 2, (bottom + top) / 2, scale);
  fill(context, PLATE, width, height);
  context.lineJoin = "bevel"; // round ones cost more, and no step is as wide as the groove
  context.lineCap = "round";
  const milled = way([...knots.slice(0, place.knot + 1), place], view);
  if (started) {
    stroke(context, milled, GROOVE, diameter * scale + 1.5);
    stroke(context, milled, FLOOR, diameter * scale);
  }
  stroke(context, way([place, ...knots.slice(place.knot + 1)], view), "rgba(32,48,58,.45)", 1, [3, 4]);
  if (started) {
    stroke(context, milled, LINE, 1.3);
    const inside = place.down ? "rgba(179,64,31,.28)" : "rgba(255,255,255,.35)";
    drawAxis(context, view, place, Math.max(4, (diameter / 2) * scale), 5, inside);
  }
  drawInches(context, view, width, height);
}

/** A close view: the band, the staircase in it, the cutter's axis. The width of the view is about .15 in. */
export function drawClose(context, { path: { knots }, band }, place, started, width, height) {
  const scale = Math.min(width, height * 1.3) / 150;
  const view = viewport(width / 2, height / 2, place.x, place.y, scale);
  const first = Math.max(0, place.knot - NEAR);
  const near = knots.slice(first, place.knot + NEAR);
  const reach = Math.hypot(width, height) / scale;
  const seen = ({ x, y }) => Math.hypot(x - place.x, y - place.y) < reach;
  fill(context, PAPER, width, height);
  drawGrid(context, place, scale, width, height);
  if (band) drawBand(context, band, seen, view);
  context.lineJoin = "miter";
  context.lineCap = "butt";
  stroke(context, way(near, view), "rgba(32,48,58,.4)", 1, [4, 4]);
  context.fillStyle = LINE;
  for (const knot of near) if (knot.down && seen(knot)) context.fill(ring(view.x(knot.x), view.y(knot.y), 2.6));
  if (started) {
    const milled = [...near.slice(0, place.knot + 1 - first), place];
    stroke(context, way(milled, view), LINE, 2.6);
    drawAxis(context, view, place, 7, 13, "transparent");
  }
  drawScaleBar(context, width, height, scale);
}

/** Where the place (x, y) stands in the middle, and a thousandth of an inch is `scale` pixels. */
function viewport(middleX, middleY, x, y, scale) {
  return { x: (at) => middleX + (at - x) * scale, y: (at) => middleY - (at - y) * scale };
}

function fill(context, colour, width, height) {
  context.fillStyle = colour;
  context.fillRect(0, 0, width, height);
}

function stroke(context, path, colour, width, dash = []) {
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.setLineDash(dash);
  context.stroke(path);
}

/** The way through knots, where it was milled. */
function way(knots, view) {
  const path = new Path2D();
  knots.forEach(({ x, y, down }, index) => path[index && down ? "lineTo" : "moveTo"](view.x(x), view.y(y)));
  return path;
}

function outline(points, view) {
  return way(points.map(([x, y]) => ({ x, y, down: true })), view);
}

function ring(x, y, radius) {
  const path = new Path2D();
  path.arc(x, y, radius, 0, 2 * Math.PI);
  return path;
}

/** The band, as far as it is seen: what is drawn costs time where nobody sees it, too. */
function drawBand(context, { inner, nominal, outer }, seen, view) {
  for (const [from, to] of stretches(nominal, seen)) {
    const [below, middle, above] = [inner, nominal, outer].map((points) => points.slice(from, to));
    context.fillStyle = "rgba(47,111,94,.13)";
    context.fill(outline(above.concat(below.toReversed()), view));
    stroke(context, outline(above, view), BAND, 1.4);
    stroke(context, outline(below, view), BAND, 1.4);
    stroke(context, outline(middle, view), BAND, 1, [8, 4, 2, 4]);
  }
}

/** The stretches of `points` that are seen, [from, to), each with the point before it and the one behind. */
function stretches(points, seen) {
  const found = [];
  points.forEach((point, index) => {
    if (!seen({ x: point[0], y: point[1] })) return;
    const last = found.at(-1);
    if (last && last[1] >= index) last[1] = index + 2;
    else found.push([Math.max(0, index - 1), index + 2]);
  });
  return found;
}

/** Squares of .010 in. */
function drawGrid(context, place, scale, width, height) {
  const side = 10 * scale;
  const first = (middle, at) => (((middle - at * scale) % side) + side) % side;
  let lines = "";
  for (let x = first(width / 2, place.x); x < width; x += side) lines += `M${x} 0v${height}`;
  for (let y = first(height / 2, -place.y); y < height; y += side) lines += `M0 ${y}h${width}`;
  stroke(context, new Path2D(lines), "rgba(120,100,70,.16)", 1);
}

/** The axes' inches, in rulers of their own at the left and below. */
function drawInches(context, view, width, height) {
  const floor = height - BELOW;
  context.fillStyle = RULER;
  context.fillRect(0, 0, LEFT, height);
  context.fillRect(0, floor, width, BELOW);
  let marks = "";
  for (let inch = 0; inch <= 20; inch++) {
    const [x, y] = [view.x(inch * 1000), view.y(inch * 1000)];
    if (x > LEFT + 4 && x < width - 8) {
      marks += `M${x} ${floor}v4`;
      write(context, `${inch}`, x, floor + BELOW / 2 + 2, { colour: FAINT, font: FONT });
    }
    if (y > 8 && y < floor - 4) {
      marks += `M${LEFT - 4} ${y}h4`;
      write(context, `${inch}`, LEFT / 2 - 2, y, { colour: FAINT, font: FONT });
    }
  }
  stroke(context, new Path2D(marks), "rgba(70,66,60,.55)", 1);
}

/** The cutter's axis: a cross in a ring. */
function drawAxis(context, view, place, radius, arm, inside) {
  const [x, y] = [view.x(place.x), view.y(place.y)];
  const about = ring(x, y, radius);
  context.fillStyle = inside;
  context.fill(about);
  stroke(context, about, TOOL, 2);
  stroke(context, new Path2D(`M${x - arm} ${y}h${2 * arm}M${x} ${y - arm}v${2 * arm}`), TOOL, 2);
}

function drawScaleBar(context, width, height, scale) {
  const long = 10 * scale;
  stroke(context, new Path2D(`M${width - 14 - long} ${height - 14}h${long}`), FAINT, 2);
  write(context, ".010 in", width - 14 - long / 2, height - 20, { colour: FAINT, font: FONT, baseline: "alphabetic" });
}
