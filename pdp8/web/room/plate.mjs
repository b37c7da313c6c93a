// The plate and what is milled into it: a groove as wide as the cutter, its walls the very staircase of the tape.
//
//     knots ──► strokes as wide as the cutter ──► wall, floor, shadow, burr          only added to while it is cut
//
// Places are thousandths of an inch, Y up. What a round cutter leaves is what a round pen strokes: nc/inspection.py measures
// the same shape. How deep it looks is ours.

const CHUNK = 24; // moves in a path that is stroked as one
const DEPTH = 190; // how far the floor is seen below the face, from before and above
const SHADOW = [70, -60];
const BURR = 7; // how wide the bright edge is
const WALL = ["#1b2123", "#262e31", "#333c40", "#434d51", "#555f63"];
const FINE = 6; // thousandths: a shorter way is not worth drawing

export class Plate {
  /** The plate that is milled along `knots` by a cutter of that diameter, of `bounds`, so many pixels wide; seen from before and
   *  above, or, with a `depth` of 0, from above.
   */
  constructor(knots, diameter, bounds, pixels, depth = DEPTH) {
    this.depth = depth;
    this.knots = knots;
    this.diameter = diameter;
    this.bounds = bounds;
    const { left, right, bottom, top } = bounds;
    const sharp = pixels / (right - left);
    this.groove = new OffscreenCanvas(Math.ceil((right - left) * sharp), Math.ceil((top - bottom) * sharp));
    this.context = this.groove.getContext("2d");
    this.context.setTransform(sharp, 0, 0, -sharp, -left * sharp, top * sharp);
    this.#begin();
  }

  #begin() {
    const { left, right, bottom, top } = this.bounds;
    this.context.clearRect(left, bottom, right - left, top - bottom);
    this.chunks = [];
    this.at = { knot: 0, x: 0, y: 0 };
  }

  /** Mill as far as a place of the path (Path.at). */
  to(place) {
    const { at, knots } = this;
    if (place.knot < at.knot || (place.knot === at.knot && Math.hypot(place.x - at.x, place.y - at.y) < FINE)) {
      if (place.knot >= at.knot) return;
      this.#begin();
    }
    const changed = new Box();
    for (let knot = Math.max(1, this.at.knot); knot <= place.knot; knot++) if (knots[knot].down) this.#move(knots[knot - 1], knots[knot], changed);
    if (place.down) this.#move(knots[place.knot], place, changed);
    this.at = { ...place };
    if (changed.left <= changed.right) this.#carve(changed.grown(this.diameter / 2 + DEPTH + BURR));
  }

  #move(from, to, changed) {
    let chunk = this.chunks.at(-1);
    if (!chunk || chunk.moves === CHUNK) this.chunks.push((chunk = { path: new Path2D(), box: new Box(), moves: 0 }));
    chunk.path.moveTo(from.x, from.y);
    chunk.path.lineTo(to.x + 0.01, to.y);
    chunk.moves++;
    for (const { x, y } of [from, to]) for (const each of [chunk.box, changed]) each.take(x, y);
  }

  /** Draw what is milled anew, in a box. */
  #carve(box) {
    const { context: c, diameter } = this;
    c.save();
    c.beginPath();
    c.rect(box.left, box.bottom, box.right - box.left, box.top - box.bottom);
    c.clip();
    c.clearRect(box.left, box.bottom, box.right - box.left, box.top - box.bottom);
    carve(c, this.chunks.filter((each) => each.box.meets(box)).map(({ path }) => path), diameter, this.depth);
    c.restore();
  }

  /** Draw it where the context's places are thousandths, Y up. */
  draw(c, light) {
    const { left, right, bottom, top } = this.bounds;
    const [w, h] = [right - left, top - bottom];
    face(c, this.bounds, light);
    c.save();
    c.scale(1, -1);
    c.drawImage(this.groove, left, -top, w, h);
    c.restore();
  }
}

/** Draw a groove along `paths`, so deep: its wall as it is seen from before, its floor, the shadow on it. */
export function carve(c, paths, diameter, depth, shadow = SHADOW) {
  const stroke = (colour, x, y, wide = diameter) => {
    c.save();
    c.translate(x, y);
    Object.assign(c, { strokeStyle: colour, lineWidth: wide, lineCap: "round", lineJoin: "round" });
    for (const path of paths) c.stroke(path);
    c.restore();
  };
  stroke("#eef1ee", 0, 0, diameter + 2 * BURR * Math.min(1, depth / DEPTH + 0.25));
  c.globalCompositeOperation = "source-atop";
  WALL.forEach((colour, layer) => stroke(colour, 0, (-depth * layer) / WALL.length));
  stroke("#606a6d", 0, -depth);
  stroke("#8f989b", shadow[0], shadow[1] - depth, diameter * 0.995);
  c.globalCompositeOperation = "source-over";
}

/** The plate's face: ground steel, with the light's reflection at a place. */
export function face(c, { left, right, bottom, top }, light) {
  const [w, h] = [right - left, top - bottom];
  const steel = c.createLinearGradient(left, top, right, bottom);
  [["#c3cacc", 0], ["#9aa3a6", 0.5], ["#b4bcbe", 1]].forEach(([colour, at]) => steel.addColorStop(Number(at), String(colour)));
  c.fillStyle = steel;
  c.fillRect(left, bottom, w, h);
  c.fillStyle = "rgba(255,255,255,.05)"; // ground
  for (let line = 0; line < 90; line++) c.fillRect(left, bottom + ((line * 37) % 90) * (h / 90), w, h * (0.001 + ((line * 7) % 5) * 0.0012));
  if (!light) return;
  const shine = c.createRadialGradient(light.x, light.y, 0, light.x, light.y, w * 0.6);
  shine.addColorStop(0, "rgba(255,248,230,.5)");
  shine.addColorStop(1, "rgba(255,248,230,0)");
  c.fillStyle = shine;
  c.fillRect(left, bottom, w, h);
}

/** A box that grows. */
class Box {
  constructor(left = Infinity, bottom = Infinity, right = -Infinity, top = -Infinity) {
    Object.assign(this, { left, bottom, right, top });
  }

  take(x, y) {
    this.left = Math.min(this.left, x);
    this.right = Math.max(this.right, x);
    this.bottom = Math.min(this.bottom, y);
    this.top = Math.max(this.top, y);
  }

  grown(by) {
    return new Box(this.left - by, this.bottom - by, this.right + by, this.top + by);
  }

  meets(other) {
    const reach = 2 * (DEPTH + BURR);
    return this.left < other.right + reach && this.right > other.left - reach && this.bottom < other.top + reach && this.top > other.bottom - reach;
  }
}
