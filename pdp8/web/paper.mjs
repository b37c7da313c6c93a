// The sheet on the desk: a program's listing with its current line lit, the Teletype's page, or the list of blocks.

import { upper } from "./afternoon.mjs";
import { Current } from "./current.mjs";
import { FRAME } from "../computer/hardware/signals.mjs";
import { RUBOUT } from "../../tapes/ascii.mjs";
import { instructionAt } from "./meaning.mjs";
import { octal } from "./written.mjs";

export class Paper {
  constructor(place, title, record) {
    this.place = place;
    this.title = title;
    this.record = record;
    this.sheets = new Map();
    this.shown = null;
    this.blockStarts = null;
    this.current = new Current(place);
  }

  show(act, afternoon) {
    const sheet = act.sheet;
    if (this.shown !== sheet) this.#lay(sheet);
    if (this.record.sheets[sheet].kind !== "picture") this.current.light(this.#line(sheet, act, afternoon));
  }

  /** Put one sheet on the desk. */
  #lay(name) {
    const { title, kind, svg } = this.record.sheets[name];
    this.current.light(null);
    this.shown = name;
    this.title.textContent = title;
    this.place.setAttribute("aria-label", title);
    this.place.scrollTop = 0;
    if (kind === "picture") {
      this.place.innerHTML = svg;
      return;
    }
    if (!this.sheets.has(name)) this.sheets.set(name, this.#typed(name));
    this.place.replaceChildren(this.sheets.get(name).list);
  }

  #typed(name) {
    const list = document.createElement("ol");
    const byAddress = new Map();
    const number = (value) => (value === null ? "" : octal(value));
    for (const [address, word, text, mark] of this.record.sheets[name].lines) {
      const line = document.createElement("li");
      if (mark) line.className = mark;
      if (address !== null) byAddress.set(address, line);
      for (const [kind, content] of [["address", number(address)], ["word", number(word)], ["text", text]]) {
        const part = document.createElement("span");
        part.className = kind;
        part.textContent = content;
        line.append(part);
      }
      list.append(line);
    }
    return { list, byAddress, lines: [...list.children] };
  }

  /** The element of the line that is current. */
  #line(name, act, { now, machine }) {
    const sheet = this.sheets.get(name);
    if (this.record.sheets[name].kind === "listing") return sheet.byAddress.get(instructionAt(machine.processor)) ?? null;
    const tape = this.record.tapes.ascii;
    if (act.kind !== "terminal") return sheet.lines[Math.max(0, upper(this.starts(), now) - 1)];
    const punched = Math.floor(now / FRAME);
    const line = Math.min(upper(tape.lines, punched - 1), sheet.lines.length - 1);
    sheet.lines.forEach((element, index) => element.classList.toggle("blank", index > line));
    const begins = line ? tape.lines[line - 1] + 1 : 0;
    this.#type(sheet.lines[line], this.record.sheets[name].lines[line][2], tape.frames.subarray(begins, punched));
    return sheet.lines[line];
  }

  /** Type of a line what has been punched of it, so far: `frames`, fill of the line before and all. */
  #type(line, text, frames) {
    if (this.typing && this.typing.line !== line) this.typing.line.lastChild.textContent = this.typing.text;
    this.typing = { line, text };
    const typed = frames.map((frame) => frame & 0o177).filter((code) => code >= 0o40 && code !== RUBOUT).length;
    line.lastChild.textContent = text.slice(0, typed) || " ";
  }

  starts() {
    this.blockStarts ??= Float64Array.from(this.record.mill.blocks, (block) => block.at);
    return this.blockStarts;
  }
}
