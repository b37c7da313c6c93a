// Drawings as SVG: places in thousandths of an inch, seen through a box of the page.

import { html } from "./html.mjs";

/** Where places, in thousandths, stand in a box of the drawing; Y goes up. */
export class View {
  constructor(/** @type {Bounds} */ { left, right, bottom, top }, /** @type {Box} */ box, uniform = true) {
    const across = box.width / (right - left), up = box.height / (top - bottom);
    this.sx = uniform ? Math.min(across, up) : across;
    this.sy = uniform ? Math.min(across, up) : up;
    this.ox = box.x + box.width / 2 - (this.sx * (left + right)) / 2;
    this.oy = box.y + box.height / 2 + (this.sy * (bottom + top)) / 2;
    this.box = box;
  }

  x(/** @type {number} */ at) {
    return this.ox + at * this.sx;
  }

  y(/** @type {number} */ at) {
    return this.oy - at * this.sy;
  }

  /** The place that stands there. */
  place(/** @type {number} */ x, /** @type {number} */ y) {
    return { x: (x - this.ox) / this.sx, y: (this.oy - y) / this.sy };
  }

  /** A line through places, but for the ways to those where the cutter is not `down`. */
  line(/** @type {Knot[]} */ places, /** @type {string} */ attributes, close = false) {
    const d = places.map(({ x, y, down = true }, index) => `${index && down ? "L" : "M"}${this.x(x).toFixed(1)} ${this.y(y).toFixed(1)}`);
    return `<path d="${d.join("")}${close ? "Z" : ""}" ${attributes}/>`;
  }

  /** A circle of so many thousandths. */
  circle(/** @type {Circle} */ { x, y, radius }, /** @type {string} */ attributes) {
    return this.dot({ x, y }, radius * this.sx, attributes);
  }

  /** A circle of so many pixels. */
  dot(/** @type {Place} */ { x, y }, /** @type {number} */ radius, /** @type {string} */ attributes) {
    return `<circle cx="${this.x(x).toFixed(1)}" cy="${this.y(y).toFixed(1)}" r="${radius.toFixed(1)}" ${attributes}/>`;
  }
}

let clips = 0;

/** `content`, cut off at a box. */
export function clipped(/** @type {Box} */ { x, y, width, height }, /** @type {string} */ content) {
  const name = `clip${clips++}`;
  return `<clipPath id="${name}"><rect x="${x}" y="${y}" width="${width}" height="${height}"/></clipPath><g clip-path="url(#${name})">${content}</g>`;
}

export function text(/** @type {number} */ x, /** @type {number} */ y, /** @type {string} */ words, attributes = "") {
  return `<text x="${x.toFixed(1)}" y="${y.toFixed(1)}" ${attributes}>${html`${words}`.source}</text>`;
}

export function rect(/** @type {Box} */ { x, y, width, height }, /** @type {string} */ attributes) {
  return `<rect x="${x.toFixed(1)}" y="${y.toFixed(1)}" width="${Math.max(0, width).toFixed(1)}" height="${Math.max(0, height).toFixed(1)}" ${attributes}/>`;
}
