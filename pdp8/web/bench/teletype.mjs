// The Teletype on the bench: its page and keyboard, its reader and punch with their levers, and the shelf of tapes.

import { printed } from "../../computer/hardware/teletype.mjs";
import { sent } from "../../computer/use/keys.mjs";
import { CR, LF } from "../../../tapes/ascii.mjs";
import * as kinds from "../../../tapes/kinds.mjs";
import { bytes } from "../translator/runtime.mjs";
import { Sheet } from "../sheet.mjs";
import { drawTape, meaning, tapeKey } from "../tape.mjs";
import { find, grouped, octal } from "../written.mjs";
import { BLOCK, blockAt } from "./block.mjs";
import { codeOf } from "./shelf.mjs";

const BELL = 0o7;
const COLUMNS = 72; // of a Model 33
const LINES = 400; // kept on the page
const ROLL = 100_000; // frames on the paper, until it is torn off behind the page
const TYPED = { return: "\r", linefeed: "\n", rubout: "\x7f" };
const NAMED = { Enter: "\r", Backspace: "\x7f", Escape: "\x1b" };

export class Teletype {
  constructor(bench) {
    this.bench = bench;
    const sheet = (which) => new Sheet(canvas(which), () => this.#tapes());
    this.sheets = { reader: sheet("reader"), punch: sheet("punch") };
    this.name = "";
    this.code = "ascii";
    this.#clear();
    this.#keyboard();
    this.#levers();
  }

  show() {
    const { afternoon, machine } = this.bench;
    if (afternoon.on) this.named(afternoon.mounted.name, afternoon.mounted.code);
    this.terminal = afternoon.terminal;
    this.#page(this.terminal?.frames ?? machine.teletype.printer.frames);
    this.#tapes();
  }

  /** Call the tape in the reader by its name. */
  named(name, code) {
    this.name = name;
    this.code = code ?? "bin";
  }

  #clear() {
    this.lines = [""];
    this.column = 0;
    this.taken = 0;
  }

  /** Type what has been printed since the last look. */
  #page(frames) {
    if (frames.length < this.taken || Boolean(this.terminal) !== this.typed) this.#clear();
    else if (frames.length === this.taken && this.drawn === this.taken) return;
    this.typed = Boolean(this.terminal);
    for (; this.taken < frames.length; this.taken++) this.#type(printed(bytes([frames[this.taken]])).decode("ascii"));
    this.drawn = this.taken;
    this.lines = this.lines.slice(-LINES);
    find("paper").firstElementChild.textContent = this.lines.join("\n");
    find("paper").scrollTop = find("paper").scrollHeight;
    if (this.taken > ROLL && !this.bench.afternoon.on) this.#tearPaper();
  }

  /** Tear off the paper that has been shown, or hours of printing would fill the memory. No step leads back to it. */
  #tearPaper() {
    this.bench.machine.teletype.printer.frames.clear();
    this.taken = this.drawn = 0;
    this.bench.history.begin();
  }

  #type(character) {
    const code = character.charCodeAt(0);
    if (code === CR) this.column = 0;
    else if (code === LF) this.lines.push(" ".repeat(this.column));
    else if (code === BELL || !character) this.bench.sound.ring(character !== "");
    else {
      const line = this.lines.at(-1).padEnd(this.column);
      this.lines[this.lines.length - 1] = line.slice(0, this.column) + character + line.slice(this.column + 1);
      this.column = Math.min(this.column + 1, COLUMNS - 1);
      this.bench.sound.click();
    }
  }

  #keyboard() {
    const press = (key) => this.bench.touch(({ teletype }) => teletype.keyboard.press(sent(key)));
    find("paper").addEventListener("keydown", (event) => {
      if (event.altKey || event.metaKey || event.key === "Tab") return;
      const copied = event.ctrlKey && event.key === "c" && String(getSelection());
      const control = event.ctrlKey && /^[a-z]$/i.test(event.key) && !copied;
      if (event.ctrlKey && !control) return;
      const key = control ? String.fromCharCode(event.key.charCodeAt(0) & 0o37) : NAMED[event.key] ?? event.key;
      if (key.length !== 1 || !sent(key).length) return;
      event.preventDefault();
      press(key);
    });
    find("save-page").addEventListener("click", () => this.bench.download("page.txt", `${this.lines.join("\n")}\n`));
    find("typed").addEventListener("input", (event) => {
      for (const character of event.target.value) press(character);
      event.target.value = "";
    });
    find("typed").addEventListener("keydown", (event) => {
      if (event.key !== "Enter") return;
      event.preventDefault();
      press(NAMED.Enter);
    });
    for (const button of document.querySelectorAll("[data-key]:not(.key)")) {
      button.addEventListener("click", () => press(TYPED[button.dataset.key]));
    }
  }

  #levers() {
    const { bench } = this;
    find("lever").addEventListener("click", () => {
      this.leverWaits = false;
      bench.touch(({ teletype: { reader } }) => reader.lever(!reader.on));
    });
    find("punch-on").addEventListener("click", () => bench.touch(({ teletype: { punch } }) => (punch.on = !punch.on)));
    find("tear").addEventListener("click", () => this.tear());
    find("store").addEventListener("click", () => {
      bench.download("punched.tape", Uint8Array.from(bench.machine.teletype.punch.frames));
    });
    find("to-mill").addEventListener("click", () => bench.mill.cut(this.tear()));
    bench.shelf.offer(find("shelf"), (name) => this.mount(name));
  }

  /** Put a tape from the shelf into the reader, a loader's on its leader. READER RUN is set while the processor stands
   *  still, and START would drop the frame on its way: so the lever goes to STOP, to be thrown with START.
   */
  mount(name) {
    const { code, frames } = this.bench.shelf.get(name);
    this.bench.touch(({ processor, teletype: { reader } }) => {
      this.named(name, code);
      if (reader.on && !processor.run) {
        reader.lever(false);
        this.leverWaits = true;
      }
      reader.load(frames.slice(kinds.start(frames)));
    });
  }

  /** START or CONT was pressed: throw the lever that waits, as an operator does with the other hand. */
  started() {
    if (this.leverWaits) this.bench.machine.teletype.reader.lever(true);
    this.leverWaits = false;
  }

  /** Tear the punched tape off; it goes onto the shelf. Return its name. */
  tear(called = "punched") {
    return this.bench.touch(({ teletype: { punch: { frames } } }) => {
      const name = this.bench.shelf.put(called, Uint8Array.from(frames));
      frames.clear();
      return name;
    });
  }

  #tapes() {
    const { reader, punch } = this.bench.machine.teletype;
    const head = Math.max(0, reader.position - 1);
    const read = { frames: reader.tape, head, code: this.code, label: this.name };
    const frames = this.terminal?.frames ?? punch.frames;
    const punched = { frames, head: frames.length - 1, code: codeOf(frames), label: this.terminal?.name ?? "", punching: true };
    this.#tape("reader", read, reader.loaded);
    this.#tape("punch", punched, true);
    this.#block(this.terminal ? punched : reader.loaded ? read : null);
    this.#lever("lever", "Reader", reader.on ? "START" : "STOP", reader.on ? "STOP" : "START");
    this.#lever("punch-on", "Punch", punch.on ? "ON" : "OFF", punch.on ? "OFF" : "ON");
    const empty = !punch.frames.length;
    for (const id of ["tear", "store", "to-mill"]) if (find(id).disabled !== empty) find(id).disabled = empty;
  }

  /** A lever says where it goes when it is pressed; its name says where it stands, too. */
  #lever(id, whose, stands, goes) {
    this.bench.writer.text(find(id), id === "lever" ? `Lever to ${goes}` : `Punch ${goes}`);
    this.bench.writer.label(find(id), `${whose} ${stands}: ${find(id).textContent}`);
  }

  /** The block that is passing: its fields, the digits read so far dark. */
  #block(tape) {
    const shown = tape && (tape.code === "ascii" || tape.code === "eia") ? blockAt(tape) : null;
    if (find("block").hidden !== !shown) find("block").hidden = !shown;
    if (shown) this.bench.writer.fill(find("block"), BLOCK, ...shown);
  }

  #tape(which, view, loaded) {
    const count = `${grouped(view.frames.length)}${view.punching ? " frames" : ""}`;
    const caption = view.punching ? count : `${view.label} ${grouped(this.bench.machine.teletype.reader.position)} of ${count}`;
    this.bench.writer.text(find(which).querySelector(".name"), loaded ? caption : "no tape");
    const frame = view.frames[view.head];
    const says = frame === undefined ? "nothing" : `${octal(frame, 3)} ${meaning(frame, view.code)}`;
    this.bench.writer.label(canvas(which), `the ${which}'s tape, under the head: ${says}`);
    const draw = (context, ...size) => loaded && drawTape(context, view, ...size);
    this.sheets[which].draw(`${tapeKey(view)} ${view.code} ${loaded}`, draw);
  }
}

function canvas(which) {
  return find(which).querySelector("canvas");
}
