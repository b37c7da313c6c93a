// The Hydra-Point on the bench: an EIA tape is cut, its path and band drawn, its blocks listed, its refusal said.

import { close, plated, whole } from "../cutter.mjs";
import { CutError, cut } from "../../../nc/machine.mjs";
import { TICKS_PER_SECOND as SECOND } from "../../computer/hardware/signals.mjs";
import { FIELDS } from "../../../tapes/hydrapoint.mjs";
import { contour } from "./path.mjs";
import { html, put } from "../html.mjs";
import { BLOCK, passing } from "../passing.mjs";
import { Pictures } from "../pictures.mjs";
import { Drawing, Sheet } from "../sheet.mjs";
import { Plate } from "../room/plate.mjs";
import { EIA } from "../../../tapes/codes.mjs";
import { duration } from "../../../tapes/quantities.mjs";
import { drawTape, tapeKey } from "../tape.mjs";
import { bytes } from "../translator/runtime.mjs";
import { find, grouped, inches, LATER, many, octal } from "../written.mjs";

const TOLERANCES = [1, 2, 3, 5, 7, 10, 15, 20, 30, 50, 70, 100, 150, 200, 300, 430, 500]; // thousandths
const FINE = 900; // pixels of the plate
const TAKES = 20; // seconds in which a whole tape is cut on the page
const MARGIN = 40; // pixels that stay in view above the current line, and its own height and as much below

export class Mill {
  constructor(/** @type {Bench} */ bench) {
    this.bench = bench;
    this.drawing = null;
    this.part = 0;
    /** @type {[number, string] | null} */ this.asked = null; // what the tape that is made of the tolerance is made of
    /** @type {Path} */ this.path = LATER;
    /** @type {Step[]} */ this.steps = [];
    /** @type {HTMLElement[]} */ this.rows = [];
    /** @type {Omit<TapeView, "head"> & { first: number }} */ this.tape = LATER;
    /** @type {HTMLElement | null} */ this.line = null; // the block that is carried out, in the list
    this.pictures = new Pictures((passed) => this.#picture(passed));
    this.plate = new Sheet(find("plate"), () => this.show());
    this.whole = new Drawing(find("whole"), () => this.show());
    this.close = new Drawing(find("close"), () => this.show());
    this.reader = new Sheet(find("mill-reader").querySelector("canvas"), () => this.show());
  }

  choose(/** @type {HTMLInputElement} */ { value }) {
    if (value) this.cut(value);
  }

  /** Put a tape of the shelf under the head, and show the whole of what it does. */
  cut(/** @type {string} */ name) {
    this.name = name;
    this.asked = null; // what the Worker is making belongs to another tape
    const frames = this.bench.shelf.get(name).frames;
    const { path, refusal } = carriedOut(frames);
    this.lay(name, frames, path, refusal);
    this.bench.tabs.open("mill");
    this.#go(1);
  }

  /** Cut the circle within another tolerance: its tape is made by the whole chain, on another machine. */
  async loosen(/** @type {HTMLInputElement} */ { value }) {
    const tolerance = TOLERANCES[Number(value)];
    /** @type {[number, string]} */ const asked = [tolerance, this.bench.shelf.get("eia.pal").frames.decode("ascii")];
    this.asked = asked;
    await this.making;
    if (this.asked !== asked) return; // the slider was drawn on
    const made = await (this.making = this.bench.apart.ask("loosened", asked, TAKES).catch((/** @type {Error} */ { message }) => message));
    if (this.asked !== asked) return;
    if (typeof made === "string") return void (find("loosened").textContent = made);
    const frames = bytes(made);
    const { path, refusal } = carriedOut(frames);
    this.lay(`circle within ${inches(tolerance)} in`, frames, path, refusal);
    find("loosened").textContent = `${inches(tolerance)} in: ${many(this.path.cuts.length, "cuts")}, ${duration(this.path.times.total)}`;
    this.#go(1);
  }

  /** Show the path of a tape: what of it is cut, and what is still to come; `band` is that of the curve, if it is known. */
  lay(/** @type {string} */ name, /** @type {Bytes} */ frames, /** @type {Path | null} */ path, refusal = "", /** @type {any} */ band = null) {
    if (path && this.path === path) return;
    this.path = /** @type {Path} */ (path);
    this.name = name;
    this.tape = { label: name, code: EIA, frames, first: frames.findIndex((frame) => frame !== 0) };
    this.steps = path?.steps ?? [];
    find("refusal").textContent = refusal;
    this.drawing = this.steps.length ? contour(this.path, this.bench.record.cutter, band) : null;
    this.milled = this.drawing && new Plate(this.path.knots, this.drawing.diameter, this.drawing.bounds, FINE, false);
    find("eia").value = name;
    find("save-cut").toggleAttribute("disabled", false);
    find("run-mill").toggleAttribute("disabled", !this.drawing);
    for (const each of find("mill").querySelectorAll(".pictures, .block, .reading")) each.hidden = !this.drawing; // else they are of another tape
    put(find("blocks"), html`<ol>${this.steps.map((step) => row(step))}</ol>`);
    this.line = null;
    this.rows = [...find("blocks").querySelectorAll("li")];
  }

  /** Show it so many ticks after it began; before, it waits for its tape. */
  follow(/** @type {number} */ ticks) {
    this.#go(ticks / SECOND / this.path.times.total);
  }

  /** Go to a part, 0 to 1, of the time that the tape takes; before 0 nothing has begun. */
  #go(/** @type {number} */ part) {
    this.part = Math.min(part, 1);
    find("at").value = String(part);
    this.show();
  }

  /** Show as much of it as the slider says. */
  slide(/** @type {HTMLInputElement} */ { value }) {
    this.#go(Number(value));
  }

  /** Cut it before the visitor's eyes. */
  run() {
    if (this.part >= 1 || this.part < 0) this.part = 0;
    this.pictures.start();
  }

  /** Cut on; return whether there is more to cut. */
  #picture(/** @type {number} */ passed) {
    this.#go(Math.min(1, this.part + passed / 1000 / TAKES));
    return this.part < 1;
  }

  save() {
    this.bench.download(String(this.name).replace(/(\.eia)?$/, ".eia"), Uint8Array.from(this.tape.frames));
  }

  /** How many blocks were cut, and how long it takes. */
  get summary() {
    return find("refusal").textContent || `${many(this.steps.length, "blocks")}: ${duration(this.path?.times.total ?? 0)} at the Hydra-Point.`;
  }

  #where(/** @type {PathPlace} */ { block, x, y }) {
    return `${this.name}, block ${block + 1} of ${this.steps.length}: X ${inches(x)} Y ${inches(y)}, ${grouped(Math.round((this.path.times.total * this.part) / 60))} min`;
  }

  show() {
    const { drawing, path, bench } = this;
    if (!drawing || find("mill").hidden) return;
    const started = this.part >= 0;
    const second = path.times.total * this.part + 1 / SECOND; // what begins at this tick is under way
    const place = started ? path.at(second) : path.first;
    const key = `${this.name} ${place.knot} ${place.x} ${place.y} ${started}`;
    bench.writer.text(find("whole-label"), started ? this.#where(place) : `waits for its tape: ${many(this.steps.length, "blocks")}`);
    bench.writer.text(find("close-label"), drawing.circle ? roundness(drawing.circle) : "close by, squares of .010 in");
    this.plate.draw(key, (/** @type {[Canvas, number, number]} */ ...at) => plated(drawing, /** @type {Plate} */ (this.milled), started ? place : null, ...at));
    this.whole.draw(key, (/** @type {[number, number]} */ ...size) => whole(drawing, place, started, ...size));
    this.close.draw(key, (/** @type {[number, number]} */ ...size) => close(drawing, place, started, ...size));
    this.#tape({ ...this.tape, head: this.tape.first + (started ? path.row(second) : 0) });
    this.#light(this.rows[place.block]);
  }

  /** Make a line of the list the current one: lit, named to screen readers, and kept in view. */
  #light(/** @type {HTMLElement} */ line) {
    if (line === this.line) return;
    this.line?.classList.remove("now");
    this.line?.removeAttribute("aria-current");
    this.line = line;
    if (!line) return;
    line.classList.add("now");
    line.setAttribute("aria-current", "true");
    const list = find("blocks");
    const above = line.offsetTop - list.scrollTop;
    if (above < MARGIN || above > list.clientHeight - 1.5 * MARGIN) list.scrollTop = line.offsetTop - list.clientHeight / 2;
  }

  /** The tape under the head of the Hydra-Point's reader. */
  #tape(/** @type {TapeView} */ view) {
    const { bench } = this;
    const frame = view.frames[view.head];
    const says = `frame ${grouped(view.head)} of ${grouped(view.frames.length)}: ${octal(frame, 3)} ${EIA.caption(frame)}`;
    bench.writer.text(find("mill-reader").querySelector(".name"), says);
    bench.writer.label(find("mill-reader").querySelector("canvas"), `${view.label}, ${says}`);
    bench.writer.fill(find("mill-block"), BLOCK, ...passing(/** @type {Bytes} */ (view.frames), view.head, view.code));
    this.reader.draw(tapeKey(view), (context, /** @type {[number, number, Colours]} */ ...size) => drawTape(context, view, ...size));
  }
}

/** The path of a tape as far as it was cut, and why no further. */
function carriedOut(/** @type {Bytes} */ frames) {
  try {
    return { path: cut(frames), refusal: "" };
  } catch (/** @type {any} */ error) {
    return { path: error instanceof CutError ? error.path : null, refusal: `Refused: ${error}` };
  }
}

function roundness(/** @type {Circle & { lowest: number; highest: number }} */ { radius, x, y, lowest, highest }) {
  const ideal = `circle of ${inches(radius)} in about ${inches(x)}, ${inches(y)}`;
  return `${ideal}; centre within ${signed(lowest)} and ${signed(highest)}`;
}

function row(/** @type {Step} */ { block, at }) {
  let from = 0;
  const fields = [...FIELDS.values()].map((width) => block.digits.slice(from, (from += width)));
  return html`<li>${fields.join(" ")} <span>X ${inches(at.x)} Y ${inches(at.y)} Z ${inches(at.z)}</span></li>`;
}

function signed(/** @type {number} */ length) {
  return `${length < 0 ? "−" : "+"}${Math.abs(length / 1000).toFixed(4)}`;
}
