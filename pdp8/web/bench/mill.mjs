// The Hydra-Point on the bench: an EIA tape is cut, its path and band drawn, its blocks listed, its refusal said.

import { Current } from "../current.mjs";
import { drawClose, drawWhole, Mill as Drawing } from "../cutter.mjs";
import { TICKS_PER_SECOND as SECOND } from "../../computer/hardware/signals.mjs";
import { CutError, cut } from "../../../nc/machine.mjs";
import { FIELDS } from "../../../tapes/hydrapoint.mjs";
import { pictured } from "./path.mjs";
import { Pictures } from "../pictures.mjs";
import { Sheet } from "../sheet.mjs";
import { escaped, find, grouped, inches } from "../written.mjs";

const TAKES = 20; // seconds in which a whole tape is cut on the page

export class Mill {
  constructor(bench) {
    this.bench = bench;
    this.drawing = null;
    this.current = new Current(find("blocks"));
    this.pictures = new Pictures((passed) => this.#picture(passed));
    this.sheets = { whole: new Sheet(find("whole"), () => this.show()), close: new Sheet(find("close"), () => this.show()) };
    find("eia").addEventListener("change", ({ target }) => target.value && this.cut(target.value));
    find("at").addEventListener("input", ({ target }) => this.#go(Number(target.value)));
    find("run-mill").addEventListener("click", () => this.#run());
    bench.shelf.changed.push(() => this.#names());
    this.#names();
  }

  #names() {
    const names = this.bench.shelf.names().filter((name) => this.bench.shelf.get(name).code === "eia");
    find("eia").replaceChildren(new Option("Cut a tape …", ""), ...names.map((name) => new Option(name, name)));
    find("eia").value = this.name ?? "";
  }

  /** Put a tape of the shelf under the head, and show the whole of what it does. */
  cut(name) {
    this.name = name;
    const { path, refusal } = carriedOut(this.bench.shelf.get(name).frames);
    this.steps = path?.steps ?? [];
    find("refusal").textContent = refusal;
    this.drawing = this.steps.length ? new Drawing(pictured(path, this.bench.record.cutter)) : null;
    find("eia").value = name;
    find("blocks").innerHTML = `<ol>${this.steps.map((step) => row(step)).join("")}</ol>`;
    this.current.light(null);
    this.rows = [...find("blocks").querySelectorAll("li")];
    this.bench.tabs.open("mill");
    this.#go(1);
  }

  /** Go to a part, 0 to 1, of the time that the tape takes. */
  #go(part) {
    this.part = part;
    find("at").value = String(part);
    this.show();
  }

  #run() {
    if (this.part >= 1) this.part = 0;
    this.pictures.start();
  }

  /** Cut on; return whether there is more to cut. */
  #picture(passed) {
    this.#go(Math.min(1, this.part + passed / 1000 / TAKES));
    return this.part < 1;
  }

  #where({ block, x, y }) {
    const minutes = grouped(Math.round((this.drawing.end * this.part) / SECOND / 60));
    return `${this.name}, block ${block + 1} of ${this.steps.length}: X ${inches(x)} Y ${inches(y)}, ${minutes} min`;
  }

  show() {
    const { drawing, sheets, bench } = this;
    if (!drawing) return;
    const place = drawing.at(Math.floor(drawing.end * this.part));
    const key = `${this.name} ${place.knot} ${place.x} ${place.y}`;
    bench.writer.text(find("whole-label"), this.#where(place));
    bench.writer.text(find("close-label"), drawing.circle ? roundness(drawing.circle) : "close by, squares of .010 in");
    sheets.whole.draw(key, (context, ...size) => drawWhole(context, drawing, place, true, ...size));
    sheets.close.draw(key, (context, ...size) => drawClose(context, drawing, place, true, ...size));
    this.current.light(this.rows[place.block] ?? null);
  }
}

/** The path of a tape as far as it was cut, and why no further. */
function carriedOut(frames) {
  try {
    return { path: cut(frames), refusal: "" };
  } catch (error) {
    return { path: error instanceof CutError ? error.path : null, refusal: `Refused: ${error}` };
  }
}

function roundness({ radius, x, y, lowest, highest }) {
  const ideal = `circle of ${inches(radius)} in about ${inches(x)}, ${inches(y)}`;
  return `${ideal}; centre within ${signed(lowest)} and ${signed(highest)}`;
}

function row({ block, at }) {
  let from = 0;
  const fields = FIELDS.values().map((width) => block.digits.slice(from, (from += width)));
  return `<li>${escaped(fields.join(" "))} <span>X ${inches(at.x)} Y ${inches(at.y)} Z ${inches(at.z)}</span></li>`;
}

function signed(length) {
  return `${length < 0 ? "−" : "+"}${Math.abs(length / 1000).toFixed(4)}`;
}
