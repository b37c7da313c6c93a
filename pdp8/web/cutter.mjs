// The Hydra-Point's cutter on its staircase: where it is at any instant, the whole contour, and a close view in the band.
//
// Coordinates are thousandths of an inch, Y upward, as the tape has them; `path` is a list of knots
// [tick, x, y, down] between which the cutter goes straight; `down` says that the way to the knot was milled.

import { bisect_left as before } from "./translator/runtime.mjs";
import { ROWS } from "../../tapes/hydrapoint.mjs";

const PLATE = "#cfd2cf", RULER = "#e8e4d8", GROOVE = "#8f979b", FLOOR = "#a9b0b2";
const LINE = "#20303a", BAND = "#2f6f5e", TOOL = "#b3401f", FAINT = "#57534a";
const LEFT = 22, BELOW = 18; // the rulers, in pixels

export class Mill {
  /** `circle` and `end`, the last tick, where they are known. */
  constructor({ path, blocks, diameter, band, circle = null, end = NaN }) {
    this.path = path;
    this.blocks = blocks;
    this.diameter = diameter;
    this.band = band;
    this.circle = circle;
    this.end = end;
    this.times = Float64Array.from(this.path, (knot) => knot[0]);
    this.starts = Float64Array.from(this.blocks, (block) => block.at);
    this.bounds = bounds(this.path.filter((knot) => knot[3]), this.diameter / 2);
  }

  /** Where the cutter is: {knot, x, y, down, block}; `knot` is the last one passed. */
  at(tick) {
    const knot = Math.max(0, before(this.times, tick + 1) - 1);
    const block = before(this.starts, tick + 1) - 1;
    const [since, x, y] = this.path[knot];
    const following = this.path[knot + 1];
    if (!following || tick <= since) return { knot, x, y, down: false, block };
    const part = (tick - since) / (following[0] - since);
    return { knot, x: x + (following[1] - x) * part, y: y + (following[2] - y) * part, down: Boolean(following[3]), block };
  }

  /** Where milling begins. */
  first() {
    const knot = Math.max(1, this.path.findIndex((each) => each[3]));
    const [, x, y] = this.path[knot - 1];
    return { knot: knot - 1, x, y, down: false, block: -1 };
  }

  /** The row under the head of the Hydra-Point's reader, counted from the first that is punched. */
  row(tick) {
    const block = before(this.starts, tick + 1) - 1;
    if (block < 0) return 0;
    const { at, reading } = this.blocks[block];
    return block * ROWS + Math.min(ROWS - 1, Math.floor(((tick - at) / reading) * ROWS));
  }
}

function bounds(knots, margin) {
  const xs = knots.map((knot) => knot[1]);
  const ys = knots.map((knot) => knot[2]);
  return {
    left: Math.min(...xs) - margin, right: Math.max(...xs) + margin,
    bottom: Math.min(...ys) - margin, top: Math.max(...ys) + margin,
  };
}

/** The whole contour: the plate, the groove milled so far, what is still to come, the cutter. */
export function drawWhole(context, mill, place, started, width, height) {
  const { left, right, bottom, top } = mill.bounds;
  const margin = 300;
  const [wide, tall] = [width - LEFT, height - BELOW];
  const scale = Math.min(wide / (right - left + 2 * margin), tall / (top - bottom + 2 * margin));
  const view = viewport(LEFT + wide / 2, tall / 2, (left + right) / 2, (bottom + top) / 2, scale);
  context.fillStyle = PLATE;
  context.fillRect(0, 0, width, height);
  context.lineJoin = "bevel"; // round ones cost more, and no step is as wide as the groove
  context.lineCap = "round";
  if (started) {
    trace(context, mill, place, view, GROOVE, mill.diameter * scale + 1.5);
    trace(context, mill, place, view, FLOOR, mill.diameter * scale);
  }
  rest(context, mill, place, view);
  if (started) trace(context, mill, place, view, LINE, 1.3);
  if (started) drawTool(context, view, place, (mill.diameter / 2) * scale);
  drawInches(context, view, width, height);
}

/** A close view: the band, the staircase in it, the cutter's axis. The width of the view is about .15 in. */
export function drawClose(context, mill, place, started, width, height) {
  const scale = Math.min(width, height * 1.3) / 150;
  const view = viewport(width / 2, height / 2, place.x, place.y, scale);
  context.fillStyle = "#f7f3e9";
  context.fillRect(0, 0, width, height);
  drawGrid(context, view, width, height);
  drawBand(context, mill, place, view, Math.hypot(width, height) / scale);
  context.lineJoin = "miter";
  context.lineCap = "butt";
  corners(context, mill, place, view, width, height);
  if (started) trace(context, mill, place, view, LINE, 2.6, 600);
  if (started) drawAxis(context, view, place);
  drawScaleBar(context, width, height, scale);
}

/** Where the place (x, y) stands in the middle, and a thousandth of an inch is `scale` pixels. */
function viewport(middleX, middleY, x, y, scale) {
  return { x: (at) => middleX + (at - x) * scale, y: (at) => middleY - (at - y) * scale, scale };
}

/** Draw the way milled up to `place`; only its last `knots` knots if given. */
function trace(context, mill, place, view, colour, width, knots = Infinity) {
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.beginPath();
  for (let knot = Math.max(1, place.knot - knots); knot <= place.knot; knot++) segment(context, mill.path, knot, view);
  if (place.down) {
    const [, x, y] = mill.path[place.knot];
    context.moveTo(view.x(x), view.y(y));
    context.lineTo(view.x(place.x), view.y(place.y));
  }
  context.stroke();
}

function segment(context, path, knot, view) {
  const [, x, y, down] = path[knot];
  if (!down) return;
  if (!path[knot - 1][3]) context.moveTo(view.x(path[knot - 1][1]), view.y(path[knot - 1][2]));
  context.lineTo(view.x(x), view.y(y));
}

/** What is still to come, faintly. */
function rest(context, mill, place, view) {
  context.strokeStyle = "rgba(32,48,58,.45)";
  context.lineWidth = 1;
  context.setLineDash([3, 4]);
  context.beginPath();
  if (place.down) context.moveTo(view.x(place.x), view.y(place.y));
  for (let knot = place.knot + 1; knot < mill.path.length; knot++) segment(context, mill.path, knot, view);
  context.stroke();
  context.setLineDash([]);
}

/** The staircase's corners that are in view, and the way through them. */
function corners(context, mill, place, view, width, height) {
  const from = Math.max(1, place.knot - 300);
  const to = Math.min(mill.path.length - 1, place.knot + 300);
  context.strokeStyle = "rgba(32,48,58,.4)";
  context.lineWidth = 1;
  context.setLineDash([4, 4]);
  context.beginPath();
  for (let knot = from; knot <= to; knot++) segment(context, mill.path, knot, view);
  context.stroke();
  context.setLineDash([]);
  context.fillStyle = LINE;
  for (let knot = from; knot <= to; knot++) {
    const x = view.x(mill.path[knot][1]);
    const y = view.y(mill.path[knot][2]);
    if (!mill.path[knot][3] || x < -5 || x > width + 5 || y < -5 || y > height + 5) continue;
    context.beginPath();
    context.arc(x, y, 2.6, 0, 2 * Math.PI);
    context.fill();
  }
}

/** The band, as far as it is near `place`: what is drawn costs time where nobody sees it, too. */
function drawBand(context, mill, place, view, reach) {
  if (!mill.band) return;
  const { inner, nominal, outer } = mill.band;
  for (const [from, to] of stretches(nominal, ([x, y]) => Math.hypot(x - place.x, y - place.y) < reach)) {
    const [below, middle, above] = [inner, nominal, outer].map((points) => points.slice(from, to));
    context.fillStyle = "rgba(47,111,94,.13)";
    context.beginPath();
    outline(context, above.concat(below.toReversed()), view);
    context.fill();
    context.strokeStyle = BAND;
    context.lineWidth = 1.4;
    context.beginPath();
    outline(context, above, view);
    outline(context, below, view);
    context.stroke();
    context.setLineDash([8, 4, 2, 4]);
    context.lineWidth = 1;
    context.beginPath();
    outline(context, middle, view);
    context.stroke();
    context.setLineDash([]);
  }
}

/** The stretches of `points` that are near, [from, to), each with the point before it and the one behind. */
function stretches(points, near) {
  const found = [];
  points.forEach((point, index) => {
    if (!near(point)) return;
    const last = found.at(-1);
    if (last && last[1] >= index) last[1] = index + 2;
    else found.push([Math.max(0, index - 1), index + 2]);
  });
  return found;
}

function outline(context, points, view) {
  points.forEach(([x, y], index) => {
    if (index) context.lineTo(view.x(x), view.y(y));
    else context.moveTo(view.x(x), view.y(y));
  });
}

function drawGrid(context, view, width, height) {
  context.strokeStyle = "rgba(120,100,70,.16)";
  context.lineWidth = 1;
  context.beginPath();
  const wide = width / view.scale;
  const tall = height / view.scale;
  const middle = { x: (width / 2 - view.x(0)) / view.scale, y: (view.y(0) - height / 2) / view.scale };
  const first = (coordinate) => Math.ceil(coordinate / 10) * 10;
  for (let x = first(middle.x - wide / 2); x < middle.x + wide / 2; x += 10) {
    line(context, view.x(x), 0, view.x(x), height);
  }
  for (let y = first(middle.y - tall / 2); y < middle.y + tall / 2; y += 10) {
    line(context, 0, view.y(y), width, view.y(y));
  }
  context.stroke();
}

/** The axes' inches, in rulers of their own at the left and below. */
function drawInches(context, view, width, height) {
  const floor = height - BELOW;
  context.fillStyle = RULER;
  context.fillRect(0, 0, LEFT, height);
  context.fillRect(0, floor, width, BELOW);
  context.fillStyle = FAINT;
  context.strokeStyle = "rgba(70,66,60,.55)";
  context.lineWidth = 1;
  context.font = "11px Helvetica, Arial, sans-serif";
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.beginPath();
  for (let inch = 0; inch <= 20; inch++) {
    const x = view.x(inch * 1000);
    const y = view.y(inch * 1000);
    if (x > LEFT + 4 && x < width - 8) {
      line(context, x, floor, x, floor + 4);
      context.fillText(`${inch}`, x, floor + BELOW / 2 + 2);
    }
    if (y > 8 && y < floor - 4) {
      line(context, LEFT - 4, y, LEFT, y);
      context.fillText(`${inch}`, LEFT / 2 - 2, y);
    }
  }
  context.stroke();
}

function drawTool(context, view, place, radius) {
  const x = view.x(place.x);
  const y = view.y(place.y);
  context.strokeStyle = TOOL;
  context.fillStyle = place.down ? "rgba(179,64,31,.28)" : "rgba(255,255,255,.35)";
  context.lineWidth = 2;
  context.beginPath();
  context.arc(x, y, Math.max(4, radius), 0, 2 * Math.PI);
  context.fill();
  context.stroke();
  context.beginPath();
  line(context, x - 5, y, x + 5, y);
  line(context, x, y - 5, x, y + 5);
  context.stroke();
}

function drawAxis(context, view, place) {
  const x = view.x(place.x);
  const y = view.y(place.y);
  context.strokeStyle = TOOL;
  context.lineWidth = 2;
  context.beginPath();
  context.arc(x, y, 7, 0, 2 * Math.PI);
  context.stroke();
  context.beginPath();
  line(context, x - 13, y, x + 13, y);
  line(context, x, y - 13, x, y + 13);
  context.stroke();
}

function drawScaleBar(context, width, height, scale) {
  const long = 10 * scale;
  context.strokeStyle = context.fillStyle = FAINT;
  context.lineWidth = 2;
  context.beginPath();
  line(context, width - 14 - long, height - 14, width - 14, height - 14);
  context.stroke();
  context.font = "11px Helvetica, Arial, sans-serif";
  context.textAlign = "center";
  context.textBaseline = "alphabetic";
  context.fillText(".010 in", width - 14 - long / 2, height - 20);
}

function line(context, x0, y0, x1, y1) {
  context.moveTo(x0, y0);
  context.lineTo(x1, y1);
}
