// What is drawn: only what has changed, at the size that an observer has seen last.

/** Writes into elements, each text only when it is another one. */
export class Writer {
  constructor() {
    this.written = new Map();
  }

  text(element, text) {
    if (this.written.get(element) === text) return;
    this.written.set(element, text);
    element.textContent = text;
  }

  html(element, html) {
    if (this.written.get(element) === html) return;
    this.written.set(element, html);
    element.innerHTML = html;
  }

  label(element, label) {
    if (element.ariaLabel !== label) element.ariaLabel = label;
  }
}

/** A canvas that is drawn again when what it shows, its size or the colours have changed. */
export class Sheet {
  constructor(canvas, changed = () => {}) {
    this.canvas = canvas;
    this.key = null;
    this.width = this.height = 0;
    const look = () => {
      const style = getComputedStyle(canvas);
      this.width = canvas.clientWidth;
      this.height = canvas.clientHeight;
      this.colours = Object.fromEntries(["ink", "soft", "rust"].map((name) => [name, style.getPropertyValue(`--${name}`)]));
      this.key = null;
      changed();
    };
    new ResizeObserver(look).observe(canvas);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", look);
  }

  /** Let `draw(context, width, height, colours)` draw in CSS pixels, unless `key` says that it would be the same. */
  draw(key, draw) {
    const { canvas, width, height } = this;
    if (this.key === key || width === 0 || height === 0) return;
    this.key = key;
    const ratio = window.devicePixelRatio || 1;
    const [wide, tall] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (canvas.width !== wide || canvas.height !== tall) Object.assign(canvas, { width: wide, height: tall });
    const context = canvas.getContext("2d");
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    draw(context, width, height, this.colours);
  }
}
