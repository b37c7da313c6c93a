// The current line of a list: lit, named to screen readers, and kept in view.
//
// To ask where a line is makes the browser lay the page out, so all are asked at once, and again when the list has
// another size.

const MARGIN = 40; // pixels that stay in view above the line, and its own height and as much below

export class Current {
  constructor(place) {
    this.place = place;
    this.line = null;
    this.scrolled = 0;
    this.tall = 0;
    place.addEventListener("scroll", () => (this.scrolled = place.scrollTop));
    new ResizeObserver(() => this.#measure()).observe(place);
    this.#measure();
  }

  /** Make `line` the current one; null: none is. */
  light(line) {
    if (line === this.line) return;
    this.line?.classList.remove("now");
    this.line?.removeAttribute("aria-current");
    this.line = line;
    if (!line) return;
    line.classList.add("now");
    line.setAttribute("aria-current", "true");
    this.#bringIntoView(this.#top(line));
  }

  #measure() {
    this.tops = new WeakMap();
    this.tall = this.place.clientHeight;
    this.scrolled = this.place.scrollTop;
    if (this.line) this.#bringIntoView(this.#top(this.line));
  }

  #top(line) {
    if (!this.tops.has(line)) for (const each of line.parentNode.children) this.tops.set(each, each.offsetTop);
    return this.tops.get(line);
  }

  #bringIntoView(top) {
    const above = top - this.scrolled;
    if (above >= MARGIN && above <= this.tall - 1.5 * MARGIN) return;
    this.place.scrollTop = this.scrolled = top - this.tall / 2;
  }
}
