// The current line of a list: lit, named to screen readers, and kept in view.

const MARGIN = 40; // pixels that stay in view above the line, and its own height and as much below

export class Current {
  constructor(place) {
    this.place = place;
    this.line = null;
    new ResizeObserver(() => this.#bringIntoView()).observe(place);
  }

  /** Make `line` the current one; null: none is. */
  light(line) {
    if (line === this.line) return;
    this.line?.classList.remove("now");
    this.line?.removeAttribute("aria-current");
    this.line = line;
    line?.classList.add("now");
    line?.setAttribute("aria-current", "true");
    this.#bringIntoView();
  }

  #bringIntoView() {
    if (!this.line) return;
    const { place, line: { offsetTop: top } } = this;
    const above = top - place.scrollTop;
    if (above < MARGIN || above > place.clientHeight - 1.5 * MARGIN) place.scrollTop = top - place.clientHeight / 2;
  }
}
