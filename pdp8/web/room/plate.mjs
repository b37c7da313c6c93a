// The plate and what is milled into it: a groove as wide as the cutter, its walls the very staircase of the tape.
//
//     knots ──► strokes as wide as the cutter ──► rim, inside: wall, floor, shadow ──► groove       only added to while it is cut
//
// Places are thousandths of an inch, Y up. What a round cutter leaves is what a round pen strokes: nc/inspection.py measures
// the same shape. How deep it looks is ours. What lies over another in the groove is lighter, so a stroke can be added at any
// time: the lightest is what is seen.

const DEPTH = 190; // how far the floor is seen below the face, from before and above
const SHADOW = [70, -60];
const BURR = 7; // how wide the bright edge is
const WALL = ["#1b2123", "#262e31", "#333c40", "#434d51", "#555f63"];
const FINE = 6; // thousandths: a shorter way is not worth drawing

export class Plate {
  /** The plate that is milled along `knots` by a cutter of that diameter, of `bounds`, so many pixels wide; seen from `before`,
   *  or from above.
   */
  constructor(/** @type {Knot[]} */ knots, /** @type {number} */ diameter, /** @type {Bounds} */ bounds, /** @type {number} */ pixels, /** @type {boolean} */ before) {
    this.knots = knots;
    this.diameter = diameter;
    this.bounds = bounds;
    this.before = before;
    this.depth = before ? DEPTH : 0;
    this.sharp = pixels / (bounds.right - bounds.left);
    this.rim = this.#canvas();
    this.inside = this.#canvas();
    this.groove = this.#canvas();
    this.inside.globalCompositeOperation = "lighten";
    this.#begin();
  }

  #canvas() {
    const { bounds: { left, right, bottom, top }, sharp } = this;
    const c = /** @type {OffscreenCanvasRenderingContext2D} */ (new OffscreenCanvas(Math.ceil((right - left) * sharp), Math.ceil((top - bottom) * sharp)).getContext("2d"));
    c.setTransform(sharp, 0, 0, -sharp, -left * sharp, top * sharp);
    return c;
  }

  #begin() {
    const { bounds: { left, right, bottom, top }, knots: [{ x, y }] } = this;
    for (const c of [this.rim, this.inside, this.groove]) c.clearRect(left, bottom, right - left, top - bottom);
    /** @type {Place & { knot: number }} */ this.at = { knot: 0, x, y };
  }

  /** Mill as far as a place of the path (Path.at). */
  to(/** @type {PathPlace} */ place) {
    const { knots } = this, { x, y } = knots[this.at.knot];
    const far = (/** @type {Place} */ each) => Math.hypot(each.x - x, each.y - y);
    if (place.knot < this.at.knot || (place.knot === this.at.knot && far(place) < far(this.at))) this.#begin(); // back
    const { at } = this;
    if (place.knot === at.knot && Math.hypot(place.x - at.x, place.y - at.y) < FINE) return;
    const path = new Path2D(), xs = /** @type {number[]} */ ([]), ys = /** @type {number[]} */ ([]);
    let from = /** @type {Place} */ (at);
    const move = (/** @type {Place} */ to, /** @type {boolean} */ down) => {
      if (down) {
        path.moveTo(from.x, from.y);
        path.lineTo(to.x + 0.01, to.y);
        xs.push(from.x, to.x);
        ys.push(from.y, to.y);
      }
      from = to;
    };
    for (let knot = at.knot + 1; knot <= place.knot; knot++) move(knots[knot], Boolean(knots[knot].down));
    move(place, place.down);
    this.at = { ...place };
    if (xs.length) this.#carve(path, xs, ys);
  }

  /** Add a path, with its ends, to what is milled. */
  #carve(/** @type {Path2D} */ path, /** @type {number[]} */ xs, /** @type {number[]} */ ys) {
    const { bounds: { left, top }, depth, diameter, sharp } = this;
    const { canvas: rim } = this.rim, { canvas: inside } = this.inside;
    edge(this.rim, path, diameter, depth);
    hollow(this.inside, path, diameter, depth);
    const wide = diameter / 2 + DEPTH + BURR;
    const [x, right] = [Math.min(...xs) - wide, Math.max(...xs) + wide].map((at) => Math.round((at - left) * sharp));
    const [y, bottom] = [Math.max(...ys) + wide, Math.min(...ys) - wide].map((at) => Math.round((top - at) * sharp));
    /** @type {[number, number, number, number]} */
    const box = [x, y, right - x, bottom - y];
    const c = this.groove;
    c.save();
    c.resetTransform();
    c.clearRect(...box);
    c.drawImage(rim, ...box, ...box);
    c.globalCompositeOperation = "source-atop";
    c.drawImage(inside, ...box, ...box);
    c.restore();
  }

  /** Draw it where the context's places are thousandths, Y up. */
  draw(/** @type {Canvas} */ c, /** @type {Place | null} */ light) {
    const { left, right, bottom, top } = this.bounds;
    const [w, h] = [right - left, top - bottom];
    face(c, this.bounds, light);
    c.save();
    c.scale(1, -1);
    c.drawImage(this.groove.canvas, left, -top, w, h);
    c.restore();
  }
}

/** Draw a groove along a path, so deep. */
export function carve(/** @type {Canvas} */ c, /** @type {Path2D} */ path, /** @type {number} */ diameter, /** @type {number} */ depth, /** @type {number[]} */ shadow) {
  edge(c, path, diameter, depth);
  c.globalCompositeOperation = "source-atop";
  hollow(c, path, diameter, depth, shadow);
}

/** All that is milled, and its bright edge. */
function edge(/** @type {Canvas} */ c, /** @type {Path2D} */ path, /** @type {number} */ diameter, /** @type {number} */ depth) {
  stroke(c, path, "#eef1ee", diameter + 2 * BURR * Math.min(1, depth / DEPTH + 0.25));
}

/** The wall as it is seen from before, the floor, the light on it; they go beyond the edge. */
function hollow(/** @type {Canvas} */ c, /** @type {Path2D} */ path, /** @type {number} */ diameter, /** @type {number} */ depth, [x, y] = SHADOW) {
  WALL.forEach((colour, layer) => stroke(c, path, colour, diameter, 0, (-depth * layer) / WALL.length));
  stroke(c, path, "#606a6d", diameter, 0, -depth);
  stroke(c, path, "#8f989b", diameter * 0.995, x, y - depth);
}

function stroke(/** @type {Canvas} */ c, /** @type {Path2D} */ path, /** @type {string} */ colour, /** @type {number} */ wide, x = 0, y = 0) {
  c.save();
  c.translate(x, y);
  Object.assign(c, { strokeStyle: colour, lineWidth: wide, lineCap: "round", lineJoin: "round" });
  c.stroke(path);
  c.restore();
}

/** The plate's face: ground steel, with the light's reflection at a place. */
export function face(/** @type {Canvas} */ c, /** @type {Bounds} */ { left, right, bottom, top }, /** @type {Place | null} */ light) {
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
