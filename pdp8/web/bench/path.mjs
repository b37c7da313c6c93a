// What is drawn about the path of the milling machine: the room it takes, the circle it follows, if it follows one, the band.

const TOLERANCE = 5; // thousandths, half the width of the band
const NEAR = 4 * TOLERANCE; // a path that stays this near follows the circle
const MARGIN = 300; // thousandths about what is cut
const STEPS = 720; // of a circle that is drawn

/** What is drawn of a path. The band is the one that is known, { inner, nominal, outer } as [x, y], or that about the circle
 *  which the path follows.
 */
export function contour(/** @type {Path} */ path, /** @type {number} */ diameter, /** @type {{ [side in keyof Band]: number[][] } | null} */ known) {
  const circle = followed(path.cuts);
  const band = known ? { inner: places(known.inner), nominal: places(known.nominal), outer: places(known.outer) } : circle && about(circle);
  return { path, diameter, bounds: bounds(path, diameter), circle, band };
}

function places(/** @type {number[][]} */ points) {
  return points.map(([x, y]) => ({ x, y }));
}

/** The room that the path takes. */
export function bounds(/** @type {Path} */ { knots: all }, /** @type {number} */ diameter) {
  const cut = all.filter(({ down }) => down);
  const knots = cut.length ? cut : all, margin = diameter / 2 + MARGIN;
  const [xs, ys] = [knots.map(({ x }) => x), knots.map(({ y }) => y)];
  return {
    left: Math.min(...xs) - margin, right: Math.max(...xs) + margin,
    bottom: Math.min(...ys) - margin, top: Math.max(...ys) + margin,
  };
}

/** The circle that the milled path follows, with how far inside and outside of it the cutter's centre goes. */
function followed(/** @type {Path["cuts"]} */ cuts) {
  const ends = cuts.map(({ end }) => end);
  if (ends.length < 8) return null;
  const circle = fitted(ends);
  const radii = ends.map(({ x, y }) => Math.hypot(x - circle.x, y - circle.y) - circle.radius);
  const [lowest, highest] = [Math.min(...radii), Math.max(...radii)];
  return lowest >= -NEAR && highest <= NEAR ? { ...circle, lowest, highest } : null;
}

/** The circle of least squares through points (Kåsa), its centre and radius to a thousandth. */
function fitted(/** @type {Place[]} */ points) {
  const mean = (/** @type {(point: Place) => number} */ value) => points.reduce((sum, point) => sum + value(point), 0) / points.length;
  const [mx, my] = [mean(({ x }) => x), mean(({ y }) => y)];
  const u = (/** @type {Place} */ { x }) => x - mx, v = (/** @type {Place} */ { y }) => y - my, square = (/** @type {Place} */ point) => u(point) ** 2 + v(point) ** 2;
  const [uu, uv, vv] = [mean((p) => u(p) ** 2), mean((p) => u(p) * v(p)), mean((p) => v(p) ** 2)];
  const [us, vs] = [mean((p) => u(p) * square(p)), mean((p) => v(p) * square(p))];
  const determinant = 2 * (uu * vv - uv * uv) || 1;
  const x = Math.round(mx + (us * vv - vs * uv) / determinant);
  const y = Math.round(my + (vs * uu - us * uv) / determinant);
  return { x, y, radius: Math.round(mean((point) => Math.hypot(point.x - x, point.y - y))) };
}

/** The band about a circle. */
function about(/** @type {Circle} */ { x, y, radius }) {
  const ring = (/** @type {number} */ far) => Array.from({ length: STEPS + 1 }, (_, step) => {
    const angle = (2 * Math.PI * step) / STEPS;
    return { x: x + far * Math.cos(angle), y: y + far * Math.sin(angle) };
  });
  return { inner: ring(radius - TOLERANCE), nominal: ring(radius), outer: ring(radius + TOLERANCE) };
}
