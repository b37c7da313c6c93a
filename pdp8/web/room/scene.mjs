// What is in the room, drawn through the camera: each thing in inches from its own upper left corner. What does not change is
// drawn once for the size that it has where the camera comes to rest, one thing in each picture of the room; so at first there is
// light on one after the other.

import { sheet } from "./ink.mjs";
import { drawMill, MILL } from "./mill.mjs";
import { drawPanel, inPieces, PANEL, WHOLE } from "./panel.mjs";
import { drawTeletype, TELETYPE } from "./teletype.mjs";

/** @type {Record<string, [{ w: number; h: number; hangs?: number }, (c: Canvas) => void]>} */ const STILLS = { panel: [PANEL, drawPanel], teletype: [TELETYPE, drawTeletype], mill: [MILL, drawMill] }; // in the order in which they come to light
const MARGIN = 1.5; // inches about a thing, for its shadow
const LARGEST = 4096; // pixels of a picture
const DIM = 0.62; // how dark it is where no light falls
const DUSK = 0.35; // seconds in which it gets dark

export class Scene {
  constructor(/** @type {HTMLCanvasElement} */ canvas) {
    this.canvas = canvas;
    this.context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
    this.stills = new Map();
    this.dark = new Map();
    this.width = this.height = this.fine = this.ratio = 0;
  }

  /** Be as large as the window, with `fine` pixels for one of CSS, or a part of them. */
  resize(/** @type {number} */ width, /** @type {number} */ height, /** @type {number} */ fine, /** @type {number} */ part) {
    Object.assign(this, { width, height, fine, ratio: fine * part });
    const [wide, high] = [width, height].map((side) => Math.round(side * this.ratio));
    if (this.canvas.width !== wide || this.canvas.height !== high) Object.assign(this.canvas, { width: wide, height: high });
  }

  /** Draw the room: `live` draws what moves on each thing that is there, `lit` says whether light falls on it; `shown` is how
   *  the panel is shown. Return whether the light still changes, or a picture is not yet as sharp as it can be.
   */
  draw(/** @type {import("./camera.mjs").Camera} */ camera, /** @type {Record<string, Place>} */ where, /** @type {Record<string, (c: Canvas) => void>} */ live, /** @type {(name: string) => boolean} */ lit, /** @type {number} */ seconds, shown = WHOLE) {
    const { context: c, canvas, ratio } = this;
    const { scale, origin } = camera;
    c.setTransform(1, 0, 0, 1, 0, 0);
    c.clearRect(0, 0, canvas.width, canvas.height);
    let changes = false;
    this.drawn = this.blurred = false;
    const seen = Object.keys(where).map((name) => {
      const [{ w, h }] = STILLS[name];
      const corner = [origin.x + where[name].x * scale, origin.y + where[name].y * scale];
      const [left, top] = camera.moves ? corner : corner.map((at) => (Math.round((at - MARGIN * scale) * ratio) / ratio) + MARGIN * scale);
      return { name, left, top, out: left > this.width || top > this.height || left + w * scale < 0 || top + h * scale < 0 };
    }).filter(({ out }) => !out);
    const first = Object.keys(STILLS).find((name) => !this.stills.has(name) && seen.some((each) => each.name === name));
    if (first) this.#still(first, camera);
    for (const { name, left, top } of seen.sort((one, other) => Number(lit(one.name)) - Number(lit(other.name)))) { // the dark lies below
      const [{ w, h, hangs = 0 }] = STILLS[name];
      const kept = this.#still(name, camera);
      if (!kept) continue;
      const { picture, sharp } = kept;
      c.setTransform(scale * ratio, 0, 0, scale * ratio, left * ratio, top * ratio);
      inPieces(c, name === "panel" ? shown : WHOLE, () => {
        c.drawImage(picture, -MARGIN, -MARGIN, picture.width / sharp, picture.height / sharp);
        live[name](c);
      });
      changes = this.#dim(c, name, w, h + hangs, lit(name), seconds) || changes;
    }
    return changes || this.blurred;
  }

  /** Light falls on what happens now; the rest of the room stands in the dark. */
  #dim(/** @type {Canvas} */ c, /** @type {string} */ name, /** @type {number} */ w, /** @type {number} */ h, /** @type {boolean} */ lit, /** @type {number} */ seconds) {
    const goal = lit ? 0 : DIM, before = this.dark.get(name) ?? goal;
    const dark = goal + (before - goal) * Math.exp(-seconds / DUSK);
    this.dark.set(name, dark);
    if (dark > 0.02) {
      c.globalCompositeOperation = "source-atop";
      c.fillStyle = `rgba(14,12,10,${dark.toFixed(3)})`;
      c.fillRect(0, 0, w, h);
      c.globalCompositeOperation = "source-over";
    }
    return Math.abs(dark - goal) > 0.01;
  }

  /** What does not change of a thing: its picture, with the pixels of an inch; nothing if another was drawn for this picture. */
  #still(/** @type {string} */ name, /** @type {import("./camera.mjs").Camera} */ camera) {
    const [{ w, h }, still] = STILLS[name];
    const kept = this.stills.get(name);
    const sharp = Math.min(camera.goal * this.fine, LARGEST / (Math.max(w, h) + 2 * MARGIN));
    if (kept?.sharp === sharp) return kept;
    if (this.drawn) {
      this.blurred = true;
      return kept;
    }
    this.drawn = true;
    const made = { picture: sheet(w, h, sharp, still, MARGIN), sharp };
    this.stills.set(name, made);
    return made;
  }
}
