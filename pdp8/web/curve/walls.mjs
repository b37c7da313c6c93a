// The walls that a round cutter leaves along a circle, and their errors, as nc/inspection.py measures them.
//
// From each station of the circle the stylus moves out and in along the radius until it meets metal: the cutter has
// removed a disc at each corner of its path and a rectangle between two. By hand, for inspection.py needs numpy; a
// test holds each station against it.

/** The errors [outer, inner] of both walls at `count` stations from angle `from` over `sweep`, radians; outward is +. */
export function walls(way, { x, y, radius }, cutter, from, sweep, count) {
  const half = cutter / 2;
  const sides = way.slice(1).map((end, index) => side(way[index], end, half)).filter(Boolean);
  const corners = way.map((place) => ({ ...place, reach: half }));
  const outer = new Float64Array(count).fill(NaN);
  const inner = new Float64Array(count).fill(NaN);
  for (let first = 0; first < count; first += GROUP) {
    const last = Math.min(first + GROUP, count);
    const rays = Array.from({ length: last - first }, (_, at) => ray({ x, y, radius }, from + (sweep * (first + at)) / count));
    const [nearCorners, nearSides] = [near(corners, rays), near(sides, rays)];
    rays.forEach((each, at) => {
      const found = [Infinity, -Infinity];
      for (const place of nearCorners) disc(place, each, half, found);
      for (const one of nearSides) rectangle(one, each, half, found);
      if (found[1] === -Infinity) return;
      outer[first + at] = found[1] - half;
      inner[first + at] = found[0] + half;
    });
  }
  return { outer, inner };
}

const GROUP = 64;

function ray({ x, y, radius }, angle) {
  const [nx, ny] = [Math.cos(angle), Math.sin(angle)];
  return { nx, ny, x: x + radius * nx, y: y + radius * ny };
}

/** What is within reach of some of the rays. */
function near(all, rays) {
  const [xs, ys] = [rays.map(({ x }) => x), rays.map(({ y }) => y)];
  const [left, right, low, high] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  return all.filter(({ x, y, reach }) => x >= left - reach && x <= right + reach && y >= low - reach && y <= high + reach);
}

function side(start, end, half) {
  const [dx, dy] = [end.x - start.x, end.y - start.y];
  const length = Math.hypot(dx, dy);
  if (!length) return null;
  const [ux, uy] = [dx / length, dy / length];
  return { x: (start.x + end.x) / 2, y: (start.y + end.y) / 2, ux, uy, long: length / 2, reach: length / 2 + half };
}

function disc(place, { x, y, nx, ny }, half, found) {
  const dx = place.x - x, dy = place.y - y;
  const towards = dx * nx + dy * ny;
  const aside = dx * ny - dy * nx;
  const square = half * half - aside * aside;
  if (square < 0) return;
  const root = Math.sqrt(square);
  span(towards - root, towards + root, found);
}

function rectangle(each, from, half, found) {
  const dx = from.x - each.x, dy = from.y - each.y;
  const { ux, uy } = each;
  let enter = -Infinity, leave = Infinity;
  for (const [place, speed, reach] of [
    [dx * ux + dy * uy, from.nx * ux + from.ny * uy, each.long],
    [dy * ux - dx * uy, from.ny * ux - from.nx * uy, half],
  ]) {
    if (Math.abs(speed) < 1e-12) {
      if (Math.abs(place) > reach) return;
      continue;
    }
    const one = (-reach - place) / speed, other = (reach - place) / speed;
    enter = Math.max(enter, Math.min(one, other));
    leave = Math.min(leave, Math.max(one, other));
  }
  if (enter <= leave) span(enter, leave, found);
}

/** What the ray passes of a part that was cut; it counts if the station itself was. */
function span(enter, leave, found) {
  if (enter > 0 || leave < 0) return;
  if (enter < found[0]) found[0] = enter;
  if (leave > found[1]) found[1] = leave;
}

/** The greatest less the least, NaN left out. */
export function troughToPeak(errors) {
  let low = Infinity, high = -Infinity;
  for (const error of errors) {
    if (error < low) low = error;
    if (error > high) high = error;
  }
  return high - low;
}
