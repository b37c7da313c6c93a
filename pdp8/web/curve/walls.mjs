// The walls that a round cutter leaves along a circle, and their errors, as nc/inspection.py measures them.
//
// From each station of the circle the stylus moves out and in along the radius until it meets metal: the cutter has
// removed a disc at each corner of its path and a rectangle between two. By hand, for inspection.py needs numpy; a
// test holds each station against it.

const GROUP = 64; // rays that look at the same parts

/** The errors { outer, inner } of both walls at `count` stations from angle `from` over `sweep`, radians; outward is +;
 *  NaN where nothing was cut.
 */
export function walls(/** @type {Place[]} */ way, /** @type {Circle} */ { x, y, radius }, /** @type {number} */ cutter, /** @type {number} */ from, /** @type {number} */ sweep, /** @type {number} */ count) {
  const half = cutter / 2;
  const sides = way.slice(1).map((end, index) => side(way[index], end, half)).filter(({ reach }) => reach > half);
  const parts = [...way.map((place) => disc(place, half)), ...sides];
  const rays = Array.from({ length: count }, (_, station) => ray({ x, y, radius }, from + (sweep * station) / count));
  const [outer, inner] = [new Float64Array(count).fill(NaN), new Float64Array(count).fill(NaN)];
  for (let first = 0; first < count; first += GROUP) {
    const group = rays.slice(first, first + GROUP);
    const close = near(parts, group);
    group.forEach((each, at) => {
      let [low, high] = [Infinity, -Infinity];
      for (const { through } of close) {
        const [enter, leave] = through(each);
        if (!(enter <= 0 && leave >= 0)) continue; // it counts if the station itself was cut
        if (enter < low) low = enter;
        if (leave > high) high = leave;
      }
      if (high < low) return;
      outer[first + at] = high - half;
      inner[first + at] = low + half;
    });
  }
  return { outer, inner };
}

function ray(/** @type {Circle} */ { x, y, radius }, /** @type {number} */ angle) {
  const [nx, ny] = [Math.cos(angle), Math.sin(angle)];
  return { nx, ny, x: x + radius * nx, y: y + radius * ny };
}

/** What is within reach of some of the rays. */
function near(/** @type {ReturnType<typeof side>[]} */ all, /** @type {Place[]} */ rays) {
  const [xs, ys] = [rays.map(({ x }) => x), rays.map(({ y }) => y)];
  const [left, right, low, high] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  return all.filter(({ x, y, reach }) => x >= left - reach && x <= right + reach && y >= low - reach && y <= high + reach);
}

/** The disc cut at a corner: through(ray) is where a ray enters and leaves it, from its station on; NaN if it misses. */
function disc(/** @type {Place} */ { x, y }, /** @type {number} */ half) {
  const through = (/** @type {ReturnType<typeof ray>} */ from) => {
    const [dx, dy] = [x - from.x, y - from.y];
    const towards = dx * from.nx + dy * from.ny;
    const root = Math.sqrt(half * half - (dx * from.ny - dy * from.nx) ** 2);
    return [towards - root, towards + root];
  };
  return { x, y, reach: half, through };
}

/** The rectangle cut between two corners. */
function side(/** @type {Place} */ start, /** @type {Place} */ end, /** @type {number} */ half) {
  const [x, y] = [(start.x + end.x) / 2, (start.y + end.y) / 2];
  const length = Math.hypot(end.x - start.x, end.y - start.y);
  const [ux, uy] = [(end.x - start.x) / length, (end.y - start.y) / length];
  const through = (/** @type {ReturnType<typeof ray>} */ from) => {
    const [dx, dy] = [from.x - x, from.y - y];
    const [a, b] = between(dx * ux + dy * uy, from.nx * ux + from.ny * uy, length / 2);
    const [c, d] = between(dy * ux - dx * uy, from.ny * ux - from.nx * uy, half);
    return [Math.max(a, c), Math.min(b, d)];
  };
  return { x, y, reach: length / 2 + half, through };
}

/** When what begins at `place` and goes at `speed` is within `reach` of 0. */
function between(/** @type {number} */ place, /** @type {number} */ speed, /** @type {number} */ reach) {
  const [one, other] = [(-reach - place) / speed, (reach - place) / speed];
  return one < other ? [one, other] : [other, one];
}

/** The greatest less the least, NaN left out. */
export function troughToPeak(/** @type {Iterable<number>} */ errors) {
  let low = Infinity, high = -Infinity;
  for (const error of errors) {
    if (error < low) low = error;
    if (error > high) high = error;
  }
  return high - low;
}
