// What is drawn: only what has changed, at the size that an observer has seen last.

import { ours, put } from "./html.mjs";

/** Writes into elements, each text only when it is another one. */
export class Writer {
  constructor() {
    this.written = new WeakMap();
  }

  text(/** @type {HTMLElement} */ element, /** @type {string} */ text) {
    if (this.written.get(element) === text) return;
    this.written.set(element, text);
    element.textContent = text;
  }

  html(/** @type {HTMLElement} */ element, /** @type {ReturnType<typeof ours>} */ html) {
    if (this.written.get(element) === html.source) return;
    this.written.set(element, html.source);
    put(element, html);
  }

  /** Write `texts` into those elements of `markup` that have `data-text`, in their order: the elements are made once. */
  fill(/** @type {HTMLElement} */ element, /** @type {string} */ markup, /** @type {any[]} */ ...texts) {
    this.html(element, ours(markup));
    element.querySelectorAll("[data-text]").forEach((/** @type {any} */ place, index) => this.text(place, texts[index]));
  }

  label(/** @type {HTMLElement} */ element, /** @type {string} */ label) {
    if (element.ariaLabel !== label) element.ariaLabel = label;
  }
}

/** Write on a canvas, with its edge or middle at a place. */
export function write(/** @type {Canvas} */ context, /** @type {string} */ words, /** @type {number} */ x, /** @type {number} */ y, /** @type {any} */ { colour, font, align = "center", baseline = "middle" }) {
  context.fillStyle = colour;
  context.font = font;
  context.textAlign = align;
  context.textBaseline = baseline;
  context.fillText(words, x, y);
}

/** A drawing in SVG that is drawn again when what it shows or its size has changed; then `changed` is called. */
export class Drawing {
  constructor(/** @type {HTMLElement} */ element, /** @type {() => void} */ changed) {
    this.element = element;
    this.width = this.height = 0;
    this.key = /** @type {string | null} */ (null);
    this.redraw = () => {
      this.key = null;
      changed();
    };
    new ResizeObserver(([{ contentRect: { width, height } }]) => {
      Object.assign(this, { width: Math.round(width), height: Math.round(height) });
      this.redraw();
    }).observe(element);
  }

  /** Let `draw(width, height)` say what is in it, unless `key` says that it would be the same, or nobody sees it. */
  draw(/** @type {string} */ key, /** @type {Draw} */ draw) {
    if (this.key === key || !this.width || !this.height || !this.element.checkVisibility({ visibilityProperty: true })) return;
    this.show(draw);
    this.key = key;
  }

  show(/** @type {Draw} */ draw) {
    put(this.element, ours(draw(this.width, this.height)));
  }
}

/** A drawing on a canvas: quicker where it moves all the time. It is drawn again when the colours have changed, too. */
export class Sheet extends Drawing {
  constructor(/** @type {HTMLCanvasElement} */ canvas, /** @type {() => void} */ changed) {
    super(canvas, changed);
    this.colours = /** @type {Record<string, string>} */ ({});
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", this.redraw);
  }

  /** Let `draw(context, width, height, {sheet, ink, soft, rust, ratio})` draw in CSS pixels, `ratio` of the screen's each. */
  show(/** @type {Draw} */ draw) {
    const { element, width, height } = this, canvas = /** @type {HTMLCanvasElement} */ (element);
    if (this.key === null) {
      const style = getComputedStyle(canvas);
      this.colours = Object.fromEntries(["sheet", "ink", "soft", "rust"].map((name) => [name, style.getPropertyValue(`--${name}`)]));
    }
    const ratio = (window.devicePixelRatio || 1) * (canvas.currentCSSZoom ?? 1);
    const [wide, tall] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (canvas.width !== wide || canvas.height !== tall) Object.assign(canvas, { width: wide, height: tall });
    const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d", { alpha: false })); // nothing shines through: the browser has less to do
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.fillStyle = this.colours.sheet;
    context.fillRect(0, 0, width, height);
    draw(context, width, height, { ...this.colours, ratio });
  }
}
