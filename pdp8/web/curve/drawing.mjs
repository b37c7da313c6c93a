// A live figure: its inputs, a drawing as wide as the page gives it, and a line that says the numbers.

import { XY_FEED } from "../../../tapes/hydrapoint.mjs";
import { escaped, inches } from "../written.mjs";

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
  /** `draw(values, width)` returns [the SVG's content, its height, what is said of it in HTML]; `words` writes values that
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
    this.svg.innerHTML = content;
    this.said.innerHTML = said;
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

/** Where places, in thousandths, stand in a box of the drawing; Y goes up. */
export class View {
  constructor({ left, right, bottom, top }, box, uniform = true) {
    const across = box.width / (right - left), up = box.height / (top - bottom);
    this.sx = uniform ? Math.min(across, up) : across;
    this.sy = uniform ? Math.min(across, up) : up;
    this.ox = box.x + box.width / 2 - (this.sx * (left + right)) / 2;
    this.oy = box.y + box.height / 2 + (this.sy * (bottom + top)) / 2;
    this.box = box;
  }

  x(at) {
    return this.ox + at * this.sx;
  }

  y(at) {
    return this.oy - at * this.sy;
  }

  /** A line through places. */
  line(places, attributes, close = false) {
    const d = places.map(({ x, y }, index) => `${index ? "L" : "M"}${this.x(x).toFixed(1)} ${this.y(y).toFixed(1)}`);
    return `<path d="${d.join("")}${close ? "Z" : ""}" ${attributes}/>`;
  }

  /** A circle of so many thousandths. */
  circle({ x, y, radius }, attributes) {
    return this.dot({ x, y }, radius * this.sx, attributes);
  }

  /** A circle of so many pixels. */
  dot({ x, y }, radius, attributes) {
    return `<circle cx="${this.x(x).toFixed(1)}" cy="${this.y(y).toFixed(1)}" r="${radius.toFixed(1)}" ${attributes}/>`;
  }
}

let clips = 0;

/** `content`, cut off at a box. */
export function clipped({ x, y, width, height }, content) {
  const name = `clip${clips++}`;
  return `<clipPath id="${name}"><rect x="${x}" y="${y}" width="${width}" height="${height}"/></clipPath><g clip-path="url(#${name})">${content}</g>`;
}

export function text(x, y, words, attributes = "") {
  return `<text x="${x.toFixed(1)}" y="${y.toFixed(1)}" ${attributes}>${escaped(words)}</text>`;
}

export function rect({ x, y, width, height }, attributes) {
  return `<rect x="${x.toFixed(1)}" y="${y.toFixed(1)}" width="${Math.max(0, width).toFixed(1)}" height="${Math.max(0, height).toFixed(1)}" ${attributes}/>`;
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
