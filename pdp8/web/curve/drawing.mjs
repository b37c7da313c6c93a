// A live figure: its inputs, a drawing as wide as the page gives it, and a line that says the numbers.

import { XY_FEED } from "../../../tapes/hydrapoint.mjs";
import { ours, put } from "../html.mjs";
import { CENTRE, RADIUS } from "../method.mjs";
import { clipped, rect, text, View } from "../svg.mjs";
import { inches } from "../written.mjs";

/** How the value of an input is written: data-unit names it. */
const UNITS = {
  band: (thousandths) => `±${mils(thousandths)} in`,
  count: String,
  degrees: (angle) => `${angle}°`,
  feed: (code) => `${XY_FEED.at(code).toFixed(1)} in/min`,
  percent: (part) => `${part > 0 ? "+" : part < 0 ? "−" : ""}${Math.abs(part)} %`,
  sixteenths: (count) => `${count / 16} in`,
  times: (many) => `${many.toFixed(many < 10 ? 1 : 0)} ×`,
};

/** A figure of the page: draws itself again when one of its inputs changes, or its width. */
export class Figure {
  /** `draw(values, width)` returns [the SVG's content, its height, what is said of it]; `words` writes values that
   *  have no unit.
   */
  constructor(id, draw, words = {}) {
    this.element = document.getElementById(id);
    this.draw = draw;
    this.words = words;
    this.svg = this.element.querySelector("svg");
    this.said = this.element.querySelector(".said");
    this.inputs = [...this.element.querySelectorAll("input")];
    this.element.addEventListener("input", () => this.later());
    new ResizeObserver(() => this.later()).observe(this.element);
    this.later();
  }

  /** The inputs' values by their names. */
  get values() {
    return Object.fromEntries(this.inputs.map((input) => [input.name, valued(input)]));
  }

  set(name, value) {
    this.inputs.find((input) => input.name === name).value = String(value);
    this.later();
  }

  /** Draw before the next picture, once for however many changes. */
  later() {
    this.waits ??= setTimeout(() => {
      this.waits = null;
      this.show();
    });
  }

  show() {
    const width = Math.max(280, Math.round(this.svg.parentElement.clientWidth));
    const { values } = this;
    for (const input of this.inputs) {
      const output = input.parentElement.querySelector("output");
      if (!output) continue;
      output.textContent = (this.words[input.name] ?? UNITS[input.dataset.unit])(values[input.name], values);
      input.setAttribute("aria-valuetext", output.textContent);
    }
    const [content, height, said] = this.draw(values, width);
    this.svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    put(this.svg, ours(content));
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

/**
 * The band made straight: along it in true proportion, across it magnified until the band can be seen.
 * `traces` are [places as {x: along, y: off}, class]; `tolerance` is half the band.
 */
export function straightened(box, length, tolerance, reach, traces) {
  const view = new View({ left: 0, right: length, bottom: -reach, top: reach }, box, false);
  const limit = (off) => view.line([{ x: 0, y: off }, { x: length, y: off }], 'class="limit"');
  const band = rect({ x: box.x, y: view.y(tolerance), width: box.width, height: view.y(-tolerance) - view.y(tolerance) }, 'class="band"');
  const drawn = traces.map(([places, name]) => view.line(places, `class="${name}"`)).join("");
  const centre = view.line([{ x: 0, y: 0 }, { x: length, y: 0 }], 'class="intended"');
  const label = (off, sign) => text(box.x + box.width + 4, view.y(off) + 4, `${sign}${mils(tolerance)}`, 'class="small"');
  const apart = view.y(-tolerance) - view.y(tolerance) > 14;
  const labels = apart ? label(tolerance, "+") + label(-tolerance, "−") : label(0, "±");
  return clipped(box, band + limit(tolerance) + limit(-tolerance) + centre + drawn) + labels + rect(box, 'class="frame"');
}

export const CIRCLE = { x: CENTRE, y: CENTRE, radius: RADIUS };

/** The place on the circle at so many degrees, from 3 o'clock against the clock's hands. */
export function onCircle(degrees) {
  const angle = (degrees * Math.PI) / 180;
  return { x: CENTRE + RADIUS * Math.cos(angle), y: CENTRE + RADIUS * Math.sin(angle) };
}

/** `make`, but nothing is made twice. */
export function remembered(make) {
  const made = new Map();
  return (...given) => {
    const key = String(given);
    if (!made.has(key)) made.set(key, make(...given));
    return made.get(key);
  };
}

/** A length in inches, as an engineer of 1971 writes it: .0106 */
export function mils(thousandths, places = 3) {
  return (thousandths / 1000).toFixed(places).replace(/^0\./, ".");
}

export function inch(thousandths) {
  return `${inches(thousandths)} in`;
}

export function minutes(value) {
  return value < 10 ? `${value.toFixed(2)} min` : `${value.toFixed(1)} min`;
}
