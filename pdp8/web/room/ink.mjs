// How things are drawn: in inches, on a canvas whose transform says how many pixels an inch has.

const SANS = 'Helvetica, Arial, "Liberation Sans", sans-serif';

/** Pixels of the canvas for an inch. */
export const scale = (/** @type {Canvas} */ c) => c.getTransform().a;

/** Words whose capitals are about `size` inches high; a little larger where they would have less than `least` pixels. */
export function words(/** @type {Canvas} */ c, /** @type {string} */ text, /** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ size, { colour = "#d9ceb9", align = /** @type {CanvasTextAlign} */ ("left"), weight = 400, spread = 0.06, least = 0 } = {}) {
  const high = Math.max(size, Math.min(least / scale(c), 1.3 * size));
  c.save();
  c.translate(x, y);
  c.scale(0.01, 0.01); // browsers do not draw type of less than a pixel
  c.font = `${weight} ${high * 100}px ${SANS}`;
  c.letterSpacing = `${high * spread * 100}px`;
  c.textAlign = align;
  c.fillStyle = colour;
  c.fillText(text, 0, 0);
  c.restore();
}

/** Colours at equal distances from `from` down to `to`, or along a `line`. */
export function shade(/** @type {Canvas} */ c, /** @type {number} */ from, /** @type {number} */ to, /** @type {string[]} */ stops, /** @type {[number, number, number, number]} */ line = [0, from, 0, to]) {
  const found = c.createLinearGradient(...line);
  stops.forEach((colour, index) => found.addColorStop(index / (stops.length - 1), colour));
  return found;
}

export function box(/** @type {Canvas} */ c, /** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ width, /** @type {number} */ height, /** @type {number | number[]} */ radius, /** @type {string | CanvasGradient} */ fill, shadow = 0) {
  c.save();
  if (shadow) Object.assign(c, { shadowColor: "rgba(0,0,0,.6)", shadowBlur: shadow * scale(c), shadowOffsetY: shadow * 0.4 * scale(c) });
  c.fillStyle = fill;
  c.beginPath();
  c.roundRect(x, y, width, height, radius);
  c.fill();
  c.restore();
}

/** A canvas apart, of `width` by `height` inches and a margin, on which an inch has `sharp` pixels. */
export function sheet(/** @type {number} */ width, /** @type {number} */ height, /** @type {number} */ sharp, /** @type {(c: Canvas) => void} */ draw, margin = 0) {
  const picture = new OffscreenCanvas(Math.max(1, Math.round((width + 2 * margin) * sharp)), Math.max(1, Math.round((height + 2 * margin) * sharp)));
  const c = /** @type {OffscreenCanvasRenderingContext2D} */ (picture.getContext("2d"));
  c.setTransform(sharp, 0, 0, sharp, margin * sharp, margin * sharp);
  draw(c);
  return picture;
}

const MOST = 900; // pictures that are kept
const pictures = new Map();

/** A picture that is made once: the one called `name`, or what `make` makes. */
export function kept(/** @type {string} */ name, /** @type {() => OffscreenCanvas} */ make) {
  if (!pictures.has(name)) {
    if (pictures.size === MOST) pictures.clear();
    pictures.set(name, make());
  }
  return pictures.get(name);
}

/** Pixels for an inch of a picture that is kept: enough for the canvas as it is, few different ones, `most` at most. */
export const sharpness = (/** @type {Canvas} */ c, most = 256) => Math.min(most, 2 ** Math.ceil(Math.log2(scale(c))));
