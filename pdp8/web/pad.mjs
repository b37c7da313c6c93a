// A frame to draw a curve in: one height above every .04 inch of X, as programs/drawn.py takes them.

import { View } from "./svg.mjs";

const [FROM, STEP, COUNT, LOW, HIGH, EDGE] = [2000, 40, 101, 3600, 6400, 200]; // X and Y of the table, thousandths

export class Pad {
  /** `changed()` is called with each move of the finger, and when it is lifted; fit() comes before the first. */
  constructor(/** @type {SVGSVGElement} */ svg, /** @type {() => void} */ changed) {
    this.svg = svg;
    this.heights = Array.from({ length: COUNT }, (_, n) => Math.round(5000 + 800 * Math.sin(n / 13) * Math.exp(-n / 90)));
    this.finger = null;
    this.pointer = 0; // the finger that draws: no other does meanwhile
    svg.addEventListener("pointerdown", (event) => {
      if (this.finger || event.target?.closest("[data-hold]") || !this.#inside(event)) return;
      event.preventDefault();
      svg.setPointerCapture(event.pointerId);
      this.finger = this.#at(event);
      this.pointer = event.pointerId;
      this.drawn = [this.finger.n, this.finger.n];
    });
    svg.addEventListener("pointermove", (event) => {
      if (!this.finger || event.pointerId !== this.pointer) return;
      this.#draw(this.finger, this.finger = this.#at(event));
      changed();
    });
    for (const event of ["pointerup", "pointercancel"]) svg.addEventListener(event, (/** @type {any} */ { pointerId }) => {
      if (!this.finger || pointerId !== this.pointer) return;
      this.finger = null;
      if (this.drawn[0] === this.drawn[1]) return changed(); // a tap draws nothing
      this.#join();
      this.#smooth();
      changed();
    });
  }

  /** Let the frame fill a box of the drawing; return where places stand in it. */
  fit(/** @type {Box} */ box) {
    /** @type {View} */ this.view = new View({ left: FROM - 100, right: FROM + STEP * (COUNT - 1) + 100, bottom: LOW, top: HIGH }, box);
    return this.view;
  }

  get places() {
    return this.heights.map((y, n) => ({ x: FROM + STEP * n, y }));
  }

  /** The heights in inches, as they are typed. */
  get text() {
    return this.heights.map((y) => (y / 1000).toFixed(3)).join(" ");
  }

  set text(words) {
    const heights = words.trim().split(/\s+/).map((word) => Math.round(1000 * Number(word)));
    if (heights.length === COUNT && heights.every(Number.isFinite)) this.heights = heights;
  }

  /** How far along the curve a place is, and how far off it, square to it. */
  beside(/** @type {Place} */ { x, y }) {
    const n = Math.min(COUNT - 2, Math.max(0, Math.floor((x - FROM) / STEP)));
    const rise = (this.heights[n + 1] - this.heights[n]) / STEP;
    return { x: x - FROM, y: (y - this.heights[n] - rise * (x - FROM - STEP * n)) / Math.hypot(1, rise) };
  }

  /** How long it is in X. */
  get length() {
    return STEP * (COUNT - 1);
  }

  #inside(/** @type {PointerEvent} */ event) {
    const { y, height } = this.view.box;
    const { top, width } = this.svg.getBoundingClientRect();
    const down = ((event.clientY - top) * this.svg.viewBox.baseVal.width) / width;
    return down >= y && down <= y + height;
  }

  #at(/** @type {PointerEvent} */ { clientX, clientY }) {
    const { left, top, width } = this.svg.getBoundingClientRect();
    const scale = this.svg.viewBox.baseVal.width / width;
    const { x, y } = this.view.place((clientX - left) * scale, (clientY - top) * scale);
    return { n: (x - FROM) / STEP, y: Math.min(HIGH - EDGE, Math.max(LOW + EDGE, y)) };
  }

  #draw(/** @type {{ n: number; y: number }} */ before, /** @type {{ n: number; y: number }} */ now) {
    const [one, other] = before.n < now.n ? [before, now] : [now, before];
    this.drawn = [Math.min(this.drawn[0], one.n), Math.max(this.drawn[1], other.n)];
    for (let n = Math.max(0, Math.ceil(one.n)); n <= Math.min(COUNT - 1, other.n); n++) {
      this.heights[n] = Math.round(one.y + ((other.y - one.y) * (n - one.n)) / (other.n - one.n || 1));
    }
  }

  /** Move what was there on either side of the stroke up or down to meet it: no cliffs. */
  #join() {
    const [first, last] = [Math.max(0, Math.ceil(this.drawn[0])), Math.min(COUNT - 1, Math.floor(this.drawn[1]))];
    if (first > last) return;
    const [before, after] = [this.heights[first] - this.heights[first - 1], this.heights[last] - this.heights[last + 1]];
    this.heights = this.heights.map((y, n) => Math.min(HIGH - EDGE, Math.max(LOW + EDGE, y + (n < first ? before : n > last ? after : 0))));
  }

  /** Smooth out the finger's tremor. */
  #smooth() {
    const was = this.heights.slice();
    for (let n = 1; n < COUNT - 1; n++) this.heights[n] = Math.round((was[n - 1] + 2 * was[n] + was[n + 1]) / 4);
  }
}
