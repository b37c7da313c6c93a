// The path of the milling machine as it is drawn: its knots in ticks, and the circle it follows, if it follows one.

import { MoveKind } from "../../../nc/path.mjs";
import { TICKS_PER_SECOND } from "../../computer/hardware/signals.mjs";

const CUTTING = [MoveKind.MILL, MoveKind.FEED_IN, MoveKind.FEED_OUT];

/** What is drawn of a path: blocks and knots [tick, x, y, whether it cut on the way]; the band about the circle that it
 *  follows, or about the curve `nominal`: {points, tolerance}.
 */
export function pictured({ steps, read_seconds, tool_change_seconds }, cutter, nominal) {
  const reading = Math.round(read_seconds * TICKS_PER_SECOND);
  const path = [[0, 0, 0, false]];
  const blocks = [];
  let now = 0;
  for (const { moves, tool_changed: changed } of steps) {
    blocks.push({ at: Math.round(now), reading });
    now += reading + (changed ? tool_change_seconds * TICKS_PER_SECOND : 0);
    if (moves.length) path.push([Math.round(now), moves[0].start.x, moves[0].start.y, false]);
    for (const { kind, end, seconds } of moves) {
      now += seconds * TICKS_PER_SECOND;
      path.push([Math.round(now), end.x, end.y, CUTTING.includes(kind)]);
    }
  }
  const circle = followed(steps);
  const outlines = nominal ? beside(nominal) : circle && beside({ points: around(circle), tolerance: TOLERANCE });
  return { blocks, path, diameter: cutter, band: outlines, circle, end: now };
}

const TOLERANCE = 5; // thousandths, half the width of the band
const NEAR = 4 * TOLERANCE; // a path that stays this near follows the circle

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
