// A live figure: its inputs, a drawing as wide as the page gives it, and a line that says the numbers.

import { XY_FEED } from "../../../tapes/hydrapoint.mjs";
import { ours, put } from "../html.mjs";
import { CENTRE, RADIUS } from "../method.mjs";
import { clipped, rect, text, View } from "../svg.mjs";
import { Wanted, withoutWaiting } from "./made.mjs";
import { find, inches } from "../written.mjs";

/** How the value of an input is written: data-unit names it. */
const UNITS = {
  band: (/** @type {number} */ thousandths) => `±${mils(thousandths)} in`,
  count: String,
  degrees: (/** @type {number} */ angle) => `${angle}°`,
  feed: (/** @type {number} */ code) => `${XY_FEED.at(code).toFixed(1)} in/min`,
  part: (/** @type {number} */ thousandths) => `${(thousandths / 10).toFixed(0)} %`,
  percent: (/** @type {number} */ part) => `${part > 0 ? "+" : part < 0 ? "−" : ""}${Math.abs(part)} %`,
  sixteenths: (/** @type {number} */ count) => `${count / 16} in`,
  times: (/** @type {number} */ many) => `${many.toFixed(many < 10 ? 1 : 0)} ×`,
};

/** A figure of the page: draws itself when it comes near, and again when one of its inputs changes, or its width. */
export class Figure {
  /** `draw(values, width)` returns [the SVG's content, its height, what is said of it, its holds], or throws Wanted for what it
   *  has to wait for. A hold is what of the drawing can be dragged, by the name of its input: {x, y} or {box}, and `to`, which
   *  makes the input's value of a drag {x, y, dx, dy, start}. `words` writes values that have no unit.
   */
  constructor(/** @type {string} */ id, /** @type {(values: any, width: number) => any} */ draw, /** @type {Record<string, (value: any, values: any) => string>} */ words = {}) {
    this.element = find(id);
    this.draw = draw;
    this.words = words;
    this.svg = this.element.querySelector("svg");
    this.said = this.element.querySelector(".said");
    this.inputs = /** @type {HTMLInputElement[]} */ ([...this.element.querySelectorAll("input")]);
    this.holds = /** @type {Record<string, any>} */ ({});
    this.held = /** @type {any} */ (null);
    for (const event of ["input", "focusin", "focusout"]) this.element.addEventListener(event, () => this.later());
    this.svg.addEventListener("pointerdown", (/** @type {PointerEvent} */ event) => this.#take(event));
    this.svg.addEventListener("pointermove", (/** @type {PointerEvent} */ event) => this.#drag(event));
    for (const event of ["pointerup", "pointercancel"]) this.svg.addEventListener(event, (/** @type {PointerEvent} */ { pointerId }) => pointerId === this.held?.pointerId && (this.held = null));
    new IntersectionObserver(([{ isIntersecting }]) => {
      this.near = isIntersecting;
      this.later();
    }, { rootMargin: "500px" }).observe(this.element);
    new ResizeObserver(() => this.later()).observe(this.element);
    addEventListener("beforeprint", () => this.now());
  }

  /** The inputs' values by their names. */
  get values() {
    return Object.fromEntries(this.inputs.map((input) => [input.name, valued(input)]));
  }

  #input(/** @type {string} */ name) {
    return /** @type {HTMLInputElement} */ (this.inputs.find((input) => input.name === name));
  }

  set(/** @type {string} */ name, /** @type {number} */ value) {
    this.#input(name).value = String(value);
    this.later();
  }

  #at(/** @type {PointerEvent} */ { clientX, clientY }) {
    const { left, top, width } = this.svg.getBoundingClientRect();
    const scale = this.svg.viewBox.baseVal.width / width;
    return { x: (clientX - left) * scale, y: (clientY - top) * scale };
  }

  #take(/** @type {any} */ event) {
    const name = event.target.closest("[data-hold]")?.dataset.hold;
    if (!name || this.held) return;
    event.preventDefault();
    this.svg.setPointerCapture(event.pointerId);
    this.#input(name).focus({ preventScroll: true });
    this.held = { pointerId: event.pointerId, name, from: this.#at(event), start: Number(this.#input(name).value) };
  }

  #drag(/** @type {any} */ event) {
    if (!this.held || event.pointerId !== this.held.pointerId) return;
    const { name, from, start } = this.held;
    const { x, y } = this.#at(event);
    this.set(name, this.holds[name].to({ x, y, dx: x - from.x, dy: y - from.y, start }));
  }

  /** Draw before the next picture, once for however many changes; not while it is far. */
  later() {
    if (!this.near) return;
    this.waits ??= setTimeout(() => {
      /** @type {ReturnType<typeof setTimeout> | null} */ this.waits = null;
      this.show();
    });
  }

  /** Draw here and now, whatever has to be made for it. */
  now() {
    withoutWaiting(() => this.#made(this.values));
  }

  /** Draw as soon as all is made for it; inputs that have changed meanwhile are looked at when it is drawn. */
  show() {
    this.behind = this.waiting;
    if (!this.waiting) this.#made(this.values);
  }

  #made(/** @type {any} */ values) {
    const width = Math.max(280, Math.round(this.svg.parentElement.clientWidth));
    try {
      const texts = this.inputs.map(({ dataset, name }) => (this.words[name] ?? UNITS[/** @type {keyof typeof UNITS} */ (dataset.unit)])?.(values[name], values) ?? "");
      this.#put(width, .../** @type {[string, number, any, any?]} */ (this.draw(values, width)));
      this.inputs.forEach((input, at) => {
        const output = input.parentElement?.querySelector("output");
        if (!output) return;
        output.textContent = texts[at];
        input.setAttribute("aria-valuetext", texts[at]);
      });
    } catch (wanted) {
      if (!(wanted instanceof Wanted)) throw wanted;
      this.waiting = true;
      wanted.answer.then(() => {
        this.waiting = false;
        this.#made(values);
        if (this.behind) this.later();
      });
    }
  }

  #put(/** @type {number} */ width, /** @type {string} */ content, /** @type {number} */ height, /** @type {any} */ said, holds = {}) {
    this.holds = holds;
    const drawn = Object.entries(holds).map(([name, { box, x, y }]) => {
      const marks = `class="hold${document.activeElement === this.#input(name) ? " on" : ""}" data-hold="${name}"`;
      return box ? rect(box, marks) : `<circle cx="${x.toFixed(1)}" cy="${y.toFixed(1)}" r="11" ${marks}/>`;
    });
    this.svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    put(this.svg, ours(content + drawn.join("")));
    put(this.said, said);
  }
}

/** The value of an input. One with data-most has steps that grow: 0 to 100 is 1 to that, whole but for times.
 *  @param {any} input */
function valued({ checked, dataset: { most, unit }, type, value }) {
  if (type === "checkbox") return checked;
  if (!most) return Number(value);
  const grown = most ** (value / 100);
  return unit === "times" ? grown : Math.round(grown);
}

/** The value of an input with data-most that stands for so many. */
export function grownBack(/** @type {number} */ many, /** @type {number} */ most) {
  return (100 * Math.log(many)) / Math.log(most);
}

/**
 * The band made straight: along it in true proportion, across it magnified until the band can be seen.
 * `traces` are [places as {x: along, y: off}, class]; `tolerance` is half the band.
 */
export function straightened(/** @type {Box} */ box, /** @type {number} */ length, /** @type {number} */ tolerance, /** @type {number} */ reach, /** @type {[Place[], string][]} */ traces) {
  const view = new View({ left: 0, right: length, bottom: -reach, top: reach }, box, false);
  const limit = (/** @type {number} */ off) => view.line([{ x: 0, y: off }, { x: length, y: off }], 'class="limit"');
  const band = rect({ x: box.x, y: view.y(tolerance), width: box.width, height: view.y(-tolerance) - view.y(tolerance) }, 'class="band"');
  const drawn = traces.map(([places, name]) => view.line(places, `class="${name}"`)).join("");
  const centre = view.line([{ x: 0, y: 0 }, { x: length, y: 0 }], 'class="intended"');
  const label = (/** @type {number} */ off, /** @type {string} */ sign) => text(box.x + box.width + 4, view.y(off) + 4, `${sign}${mils(tolerance)}`, 'class="small"');
  const apart = view.y(-tolerance) - view.y(tolerance) > 14;
  const labels = apart ? label(tolerance, "+") + label(-tolerance, "−") : label(0, "±");
  return clipped(box, band + limit(tolerance) + limit(-tolerance) + centre + drawn) + labels + rect(box, 'class="frame"');
}

/** The place on the circle at so many degrees, from 3 o'clock against the clock's hands. */
export function onCircle(/** @type {number} */ degrees) {
  const angle = (degrees * Math.PI) / 180;
  return { x: CENTRE + RADIUS * Math.cos(angle), y: CENTRE + RADIUS * Math.sin(angle) };
}

/** A length in inches, as an engineer of 1971 writes it: .0106 */
export function mils(/** @type {number} */ thousandths, places = 3) {
  return (thousandths / 1000).toFixed(places).replace(/^0\./, ".");
}

export function inch(/** @type {number} */ thousandths) {
  return `${inches(thousandths)} in`;
}

export function minutes(/** @type {number} */ value) {
  return value < 10 ? `${value.toFixed(2)} min` : `${value.toFixed(1)} min`;
}
