// A wall of the groove from so near that its steps are seen: the very strokes of the cutter, many times as large, and the two
// lines between which the wall goes there (pdp8/web/record.py measures them).

import { words } from "./ink.mjs";
import { carve, face } from "./plate.mjs";

const SEEN = 420; // thousandths that the view is wide in the end
const ROOM = 9; // inches of the room that it takes then
const [WIDE, HIGH] = [900, 680]; // thousandths that are drawn, as far as there is plate: all that is seen
const SHADOW = [34, -26];
const [GOES, THERE, LEAVES, BACK] = [0.12, 0.42, 0.84, 0.98]; // parts of the act
const LINE = "#a3391b";

export class Wall {
  /** The wall that the record's `wall` is about, left by a cutter of that diameter along `knots` in a plate; `sharp` is how
   *  many pixels a thousandth has.
   */
  constructor(/** @type {any} */ { place: [x, y], normal, off, lines }, /** @type {Knot[]} */ knots, /** @type {number} */ diameter, /** @type {Bounds} */ plate, /** @type {number} */ sharp) {
    const { left, right, bottom, top } = plate;
    this.bounds = { left: Math.max(left, x - WIDE / 2), right: Math.min(right, x + WIDE / 2), bottom: Math.max(bottom, y - HIGH / 2), top: Math.min(top, y + HIGH / 2) };
    this.sharp = sharp;
    this.place = { x, y };
    this.normal = normal;
    this.off = off;
    this.lines = lines;
    this.knots = knots;
    this.diameter = diameter;
    this.picture = /** @type {OffscreenCanvas | null} */ (null); // made when it is seen
  }

  /** How close the view is at a part of the act, 0 to 1. */
  closeness(/** @type {number} */ part) {
    const way = Math.min(part - GOES, THERE - GOES) / (THERE - GOES) - Math.max(0, part - LEAVES) / (BACK - LEAVES);
    const at = Math.max(0, Math.min(1, way));
    return at * at * (3 - 2 * at);
  }

  /** How many times as large the plate is then, where a thousandth has `fit` inches of the room. */
  larger(/** @type {number} */ close, /** @type {number} */ fit) {
    return (ROOM / SEEN / fit) ** close;
  }

  /** What is in the middle of the view: on the way from a place to the wall. */
  between(/** @type {Place} */ from, /** @type {number} */ close, /** @type {number} */ fit) {
    const most = this.larger(1, fit);
    const part = (most / this.larger(close, fit) - 1) / (most - 1);
    return { x: this.place.x + (from.x - this.place.x) * part, y: this.place.y + (from.y - this.place.y) * part };
  }

  /** Draw it where places are thousandths, Y up. */
  draw(/** @type {Canvas} */ c, /** @type {number} */ close) {
    const { bounds: { left, right, bottom, top } } = this;
    this.picture ??= this.#made();
    c.save();
    c.globalAlpha = Math.max(0, Math.min(1, (close - 0.45) * 4));
    c.scale(1, -1);
    c.drawImage(this.picture, left, -top, right - left, top - bottom);
    c.restore();
    const shown = Math.max(0, (close - 0.8) * 5);
    c.save();
    c.globalAlpha = shown;
    Object.assign(c, { strokeStyle: LINE, lineWidth: 1.1, lineCap: "round" });
    for (const line of this.lines) {
      c.setLineDash([7, 5]);
      this.#line(c, line);
    }
    c.setLineDash([]);
    this.#arrow(c);
    c.restore();
  }

  #made() {
    const { bounds, bounds: { left, right, bottom, top }, diameter, knots, sharp } = this;
    const reach = diameter / 2 + SHADOW[0] + 20;
    const path = new Path2D();
    knots.forEach((knot, index) => {
      const before = knots[index - 1];
      if (!knot.down || Math.max(knot.x, before.x) < left - reach || Math.min(knot.x, before.x) > right + reach) return;
      if (Math.max(knot.y, before.y) < bottom - reach || Math.min(knot.y, before.y) > top + reach) return;
      path.moveTo(before.x, before.y);
      path.lineTo(knot.x + 0.01, knot.y);
    });
    const canvas = (/** @type {(c: Canvas) => void} */ draw) => {
      const made = new OffscreenCanvas(Math.round((right - left) * sharp), Math.round((top - bottom) * sharp));
      const c = /** @type {OffscreenCanvasRenderingContext2D} */ (made.getContext("2d"));
      c.setTransform(sharp, 0, 0, -sharp, -left * sharp, top * sharp);
      draw(c);
      return made;
    };
    const groove = canvas((c) => carve(c, path, diameter, 0, SHADOW));
    return canvas((c) => {
      face(c, bounds, { x: left, y: top });
      c.resetTransform();
      c.drawImage(groove, 0, 0);
    });
  }

  #line(/** @type {Canvas} */ c, /** @type {number[][]} */ points) {
    c.beginPath();
    for (const [x, y] of points) c.lineTo(x, y);
    c.stroke();
  }

  /** The measure between the lines, at the middle of them, drawn from outside as draughtsmen do where it is small. */
  #arrow(/** @type {Canvas} */ c) {
    const [nx, ny] = this.normal;
    const ends = this.lines.map((/** @type {number[][]} */ line) => line[Math.floor(line.length / 2)]);
    for (const [[x, y], way] of [[ends[0], -1], [ends[1], 1]]) {
      this.#line(c, [[x, y], [x + nx * 42 * way, y + ny * 42 * way]]);
      this.#line(c, [[x + (nx * 9 - ny * 4) * way, y + (ny * 9 + nx * 4) * way], [x, y], [x + (nx * 9 + ny * 4) * way, y + (ny * 9 - nx * 4) * way]]);
    }
  }

  /** Say the measure, in inches of the room. */
  label(/** @type {Canvas} */ c, /** @type {number} */ close) {
    c.save();
    c.globalAlpha = Math.max(0, (close - 0.8) * 5);
    words(c, `${this.off} in`, 9.5 + 1.6, 7 - 1.1, 0.5, { colour: "#7a2410", weight: 700, spread: 0 });
    c.restore();
  }
}
