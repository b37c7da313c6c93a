// The Hydra-Point's cutter on its staircase, as SVG: the whole contour, and a close view in the band.
//
// A contour is what bench/path.mjs makes of a path; a place on it is what the path's at() says (nc/path.py).

import { rect, text, View } from "./svg.mjs";

const LEFT = 22, BELOW = 18; // the rulers, in pixels
const NEAR = 300; // knots before and behind the cutter that a close view may show

/** The whole contour: what of it is milled, what is still to come, the cutter, the inches; it lies over the plate. */
export function whole(/** @type {Contour} */ { path: { knots }, diameter, bounds }, /** @type {PathPlace} */ place, /** @type {boolean} */ started, /** @type {number} */ width, /** @type {number} */ height) {
  const view = tableView(bounds, width, height);
  const milled = started ? [...knots.slice(0, place.knot + 1), place] : [];
  const way = view.line([place, ...knots.slice(place.knot + 1)], 'class="to-come"') + view.line(milled, 'class="milled"');
  return way + (started ? axis(view, place, Math.max(4, (diameter * view.sx) / 2), 5) : "") + rulers(view, width, height);
}

const tableView = (/** @type {Bounds} */ bounds, /** @type {number} */ width, /** @type {number} */ height) => new View(bounds, { x: LEFT, y: 0, width: width - LEFT, height: height - BELOW });

/** Draw the plate under it, milled as far as a place, as in the room. */
export function plated(/** @type {Contour} */ { bounds }, /** @type {import("./room/plate.mjs").Plate} */ plate, /** @type {PathPlace | null} */ place, /** @type {Canvas} */ c, /** @type {number} */ width, /** @type {number} */ height) {
  const { ox, oy, sx } = tableView(bounds, width, height);
  if (place) plate.to(place);
  c.translate(ox, oy);
  c.scale(sx, -sx);
  plate.draw(c, null);
}

/** A close view: the band, the staircase in it, the cutter's axis. The width of the view is about .15 in. */
export function close(/** @type {Contour} */ { path: { knots }, band }, /** @type {PathPlace} */ place, /** @type {boolean} */ started, /** @type {number} */ width, /** @type {number} */ height) {
  const scale = Math.min(width, height * 1.3) / 150;
  const [across, up] = [width / 2 / scale, height / 2 / scale];
  const around = { left: place.x - across, right: place.x + across, bottom: place.y - up, top: place.y + up };
  const view = new View(around, { x: 0, y: 0, width, height });
  const first = Math.max(0, place.knot - NEAR);
  const near = knots.slice(first, place.knot + NEAR);
  const seen = (/** @type {Place} */ { x, y }) => Math.abs(x - place.x) < across && Math.abs(y - place.y) < up;
  const dots = near.filter((knot) => knot.down && seen(knot)).map((knot) => view.dot(knot, 2.6, 'class="knot"'));
  const milled = started ? view.line([...near.slice(0, place.knot + 1 - first), place], 'class="milled"') + axis(view, place, 7, 13) : "";
  return grid(view, around) + (band ? limits(view, band, seen) : "") + view.line(near, 'class="to-come"') + dots.join("") + milled + bar(width, height, scale);
}

/** The band, as far as it is seen: what is drawn costs time where nobody sees it, too. */
function limits(/** @type {View} */ view, /** @type {Band} */ { inner, nominal, outer }, /** @type {(place: Place) => boolean} */ seen) {
  return stretches(nominal, seen).map(([from, to]) => {
    const [below, middle, above] = [inner, nominal, outer].map((points) => points.slice(from, to));
    const sides = view.line(above, 'class="limit"') + view.line(below, 'class="limit"');
    return view.line([...above, ...below.toReversed()], 'class="band"', true) + sides + view.line(middle, 'class="nominal"');
  }).join("");
}

/** The stretches of `points` that are seen, [from, to), each with the point before it and the one behind. */
function stretches(/** @type {Place[]} */ points, /** @type {(place: Place) => boolean} */ seen) {
  const found = /** @type {[number, number][]} */ ([]);
  points.forEach((point, index) => {
    if (!seen(point)) return;
    const last = found.at(-1);
    if (last && last[1] >= index) last[1] = index + 2;
    else found.push([Math.max(0, index - 1), index + 2]);
  });
  return found;
}

/** Squares of .010 in, wherever the view is. */
function grid(/** @type {View} */ view, /** @type {Bounds} */ { left, right, bottom, top }) {
  const { box: { width, height } } = view;
  let lines = "";
  for (let x = Math.ceil(left / 10) * 10; x < right; x += 10) lines += `M${view.x(x).toFixed(1)} 0v${height}`;
  for (let y = Math.ceil(bottom / 10) * 10; y < top; y += 10) lines += `M0 ${view.y(y).toFixed(1)}h${width}`;
  return `<path d="${lines}" class="grid"/>`;
}

/** The axes' inches, in rulers of their own at the left and below. */
function rulers(/** @type {View} */ view, /** @type {number} */ width, /** @type {number} */ height) {
  const floor = height - BELOW;
  const paper = rect({ x: 0, y: 0, width: LEFT, height }, 'class="ruler"') + rect({ x: 0, y: floor, width, height: BELOW }, 'class="ruler"');
  const marks = Array.from({ length: 21 }, (_, inch) => {
    const [x, y] = [view.x(inch * 1000), view.y(inch * 1000)];
    const below = x > LEFT + 4 && x < width - 8 ? `<path d="M${x} ${floor}v4"/>` + text(x, floor + BELOW / 2 + 2, `${inch}`) : "";
    const beside = y > 8 && y < floor - 4 ? `<path d="M${LEFT - 4} ${y}h4"/>` + text(LEFT / 2 - 2, y, `${inch}`) : "";
    return below + beside;
  });
  return `${paper}<g class="inches">${marks.join("")}</g>`;
}

/** The cutter's axis: a cross in a ring, filled while it cuts. */
function axis(/** @type {View} */ view, /** @type {PathPlace} */ place, /** @type {number} */ radius, /** @type {number} */ arm) {
  const cross = `<path d="M${view.x(place.x) - arm} ${view.y(place.y)}h${2 * arm}m${-arm} ${-arm}v${2 * arm}" class="tool"/>`;
  return view.dot(place, radius, `class="tool${place.down ? " down" : ""}"`) + cross;
}

function bar(/** @type {number} */ width, /** @type {number} */ height, /** @type {number} */ scale) {
  const long = 10 * scale;
  const line = `<path d="M${width - 14 - long} ${height - 14}h${long}" class="bar"/>`;
  return `${line}<g class="inches">${text(width - 14 - long / 2, height - 24, ".010 in")}</g>`;
}
