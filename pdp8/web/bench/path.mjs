// The path of the milling machine as it is drawn: its knots in ticks, and the circle it follows, if it follows one.

import { bisect_left as before } from "../translator/runtime.mjs";
import { MoveKind } from "../../../nc/path.mjs";
import { ROWS } from "../../../tapes/hydrapoint.mjs";
import { TICKS_PER_SECOND } from "../../computer/hardware/signals.mjs";

const CUTTING = [MoveKind.MILL, MoveKind.FEED_IN, MoveKind.FEED_OUT];
const TOLERANCE = 5; // thousandths, half the width of the band
const NEAR = 4 * TOLERANCE; // a path that stays this near follows the circle

/** What is drawn of a path. `knots` are [tick, x, y, down], between which the cutter goes straight; `down` says that the
 *  way to the knot was milled. `end` is the last tick. The band is that of the curve `nominal`, {points, tolerance}, or
 *  that about the circle which the path follows.
 */
export class Contour {
  constructor({ steps, read_seconds, tool_change_seconds }, cutter, nominal) {
    this.diameter = cutter;
    this.reading = Math.round(read_seconds * TICKS_PER_SECOND);
    /** @type {[number, number, number, boolean][]} */
    this.knots = [[0, 0, 0, false]];
    this.starts = []; // the tick at which each block begins
    this.end = 0;
    for (const { moves, tool_changed: changed } of steps) {
      this.starts.push(Math.round(this.end));
      this.end += this.reading + (changed ? tool_change_seconds * TICKS_PER_SECOND : 0);
      if (moves.length) this.#knot(moves[0].start, false);
      for (const { kind, end, seconds } of moves) {
        this.end += seconds * TICKS_PER_SECOND;
        this.#knot(end, CUTTING.includes(kind));
      }
    }
    this.times = this.knots.map(([tick]) => tick);
    this.bounds = bounds(this.knots.filter(([, , , down]) => down), cutter / 2);
    this.circle = followed(steps);
    this.band = nominal ? beside(nominal) : this.circle && beside({ points: around(this.circle), tolerance: TOLERANCE });
  }

  #knot({ x, y }, down) {
    this.knots.push([Math.round(this.end), x, y, down]);
  }

  /** Where the cutter is: {knot, x, y, down, block}; `knot` is the last one passed. */
  at(tick) {
    const knot = Math.max(0, before(this.times, tick + 1) - 1);
    const block = before(this.starts, tick + 1) - 1;
    const [since, x, y] = this.knots[knot];
    const following = this.knots[knot + 1];
    if (!following || tick <= since) return { knot, x, y, down: false, block };
    const part = (tick - since) / (following[0] - since);
    return { knot, x: x + (following[1] - x) * part, y: y + (following[2] - y) * part, down: following[3], block };
  }

  /** Where milling begins. */
  first() {
    const knot = Math.max(1, this.knots.findIndex(([, , , down]) => down)) - 1;
    const [, x, y] = this.knots[knot];
    return { knot, x, y, down: false, block: -1 };
  }

  /** The row under the head of the Hydra-Point's reader, counted from the first that is punched. */
  row(tick) {
    const block = before(this.starts, tick + 1) - 1;
    if (block < 0) return 0;
    return block * ROWS + Math.min(ROWS - 1, Math.floor(((tick - this.starts[block]) / this.reading) * ROWS));
  }
}

function bounds(knots, margin) {
  const [xs, ys] = [knots.map(([, x]) => x), knots.map(([, , y]) => y)];
  return {
    left: Math.min(...xs) - margin, right: Math.max(...xs) + margin,
    bottom: Math.min(...ys) - margin, top: Math.max(...ys) + margin,
  };
}

/** The circle that the milled path follows, with how far inside and outside of it the cutter's centre goes. */
function followed(steps) {
  const ends = steps.flatMap(({ moves }) => moves).filter(({ kind }) => kind === "mill").map(({ end }) => end);
  if (ends.length < 8) return null;
  const circle = fitted(ends);
  const radii = ends.map(({ x, y }) => Math.hypot(x - circle.x, y - circle.y) - circle.radius);
  const [lowest, highest] = [Math.min(...radii), Math.max(...radii)];
  return lowest >= -NEAR && highest <= NEAR ? { ...circle, lowest, highest } : null;
}

/** The circle of least squares through points (Kåsa), its centre and radius to a thousandth. */
function fitted(points) {
  const mean = (value) => points.reduce((sum, point) => sum + value(point), 0) / points.length;
  const [mx, my] = [mean(({ x }) => x), mean(({ y }) => y)];
  const u = ({ x }) => x - mx, v = ({ y }) => y - my, square = (point) => u(point) ** 2 + v(point) ** 2;
  const [uu, uv, vv] = [mean((p) => u(p) ** 2), mean((p) => u(p) * v(p)), mean((p) => v(p) ** 2)];
  const [us, vs] = [mean((p) => u(p) * square(p)), mean((p) => v(p) * square(p))];
  const determinant = 2 * (uu * vv - uv * uv) || 1;
  const x = Math.round(mx + (us * vv - vs * uv) / determinant);
  const y = Math.round(my + (vs * uu - us * uv) / determinant);
  return { x, y, radius: Math.round(mean((point) => Math.hypot(point.x - x, point.y - y))) };
}

function around({ x, y, radius }) {
  const angles = Array.from({ length: 721 }, (_, step) => (step * Math.PI) / 360);
  return angles.map((angle) => [x + radius * Math.cos(angle), y + radius * Math.sin(angle)]);
}

/** The curve through points and its two limits, at right angles to the way between the neighbours of each point. */
function beside({ points, tolerance }) {
  const limit = (offset) => points.map(([x, y], index) => {
    const [[x0, y0], [x1, y1]] = [points[index - 1] ?? points[index], points[index + 1] ?? points[index]];
    const long = Math.hypot(x1 - x0, y1 - y0) || 1;
    return [x + ((y1 - y0) / long) * offset, y - ((x1 - x0) / long) * offset];
  });
  return { inner: limit(-tolerance), nominal: points, outer: limit(tolerance) };
}
