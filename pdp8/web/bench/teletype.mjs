// The Teletype on the bench: its page and keyboard, its reader and punch with their levers; and the PC8/L beside it.

import { Paper, sent } from "../../computer/use/keys.mjs";
import { start } from "../../../tapes/codes.mjs";
import { BLOCK, passing } from "../passing.mjs";
import { Sheet } from "../sheet.mjs";
import { drawTape, tapeKey } from "../tape.mjs";
import { find, grouped, many, octal } from "../written.mjs";
import { codeFor, codeOf } from "./shelf.mjs";

const LINES = 400; // shown of the paper
const KEPT = 10_000; // and kept, to be saved
const ROLL = 100_000; // frames on the paper, until it is torn off behind the page
const NAMED = { Enter: "\r", Backspace: "\x7f", Escape: "\x1b" };

export class Teletype {
  constructor(/** @type {Bench} */ bench) {
    this.bench = bench;
    const sheet = (/** @type {"reader" | "punch"} */ which) => new Sheet(canvas(which), () => this.#tapes());
    this.sheets = { reader: sheet("reader"), punch: sheet("punch") };
    this.leverWaits = false;
    this.names = /** @type {WeakMap<Bytes, string>} */ (new WeakMap()); // of tapes: a step back has another one in the reader
    this.clear();
    for (const place of [find("paper"), find("typed")]) place.addEventListener("paste", (/** @type {ClipboardEvent} */ event) => this.#paste(event));
    find("paper").addEventListener("keydown", (/** @type {KeyboardEvent} */ event) => this.#key(event));
    find("typed").addEventListener("keydown", (/** @type {KeyboardEvent} */ event) => {
      if (event.key !== "Enter") return;
      event.preventDefault();
      this.#press(NAMED.Enter);
    });
  }

  /** Where characters are typed: in the field, where a finger finds no other keys. */
  get keys() {
    return find(matchMedia("(pointer: coarse)").matches ? "typed" : "paper");
  }

  show() {
    this.terminal = this.bench.afternoon.terminal;
    this.#page(this.terminal?.frames ?? this.bench.machine.teletype.printer.frames);
    this.#tapes();
    this.#highspeed();
  }

  /** What the tape in a machine's reader is called; "" where nobody knows, as in a state. */
  called({ teletype: { reader: { tape } } } = this.bench.machine) {
    return this.names.get(tape) ?? "";
  }

  /** Call the tape in a machine's reader by its name; the lever of another machine waits no more. */
  name(/** @type {string} */ name, waits = false, { teletype: { reader: { tape } } } = this.bench.machine) {
    this.names.set(tape, name);
    this.leverWaits = waits;
  }

  /** Begin a fresh paper: what is on it comes from another place. */
  clear() {
    /** @type {Paper} */ this.paper = new Paper(KEPT);
    /** @type {number} */ this.taken = 0;
    /** @type {number} */ this.drawn = -1;
  }

  /** Type what has been printed since the last look. */
  #page(/** @type {ArrayLike<number>} */ frames) {
    if (frames.length < this.taken || Boolean(this.terminal) !== this.typed) this.clear();
    else if (frames.length === this.taken && this.drawn === this.taken) return;
    this.typed = Boolean(this.terminal);
    for (; this.taken < frames.length; this.taken++) this.#sound(this.paper.take(frames[this.taken]));
    this.drawn = this.taken;
    find("paper").firstElementChild.textContent = this.paper.lines.slice(-LINES).join("\n");
    find("paper").scrollTop = find("paper").scrollHeight;
    if (this.taken > ROLL && !this.bench.afternoon.on) this.#tearPaper();
  }

  /** Sound for a character that is printed; "" is none. */
  #sound(/** @type {string} */ character) {
    if (character === "\x07") this.bench.sound.strike("bell");
    else if (character > "\r") this.bench.sound.strike("print");
  }

  /** Tear off the paper that has been shown, or hours of printing would fill the memory. No step back restores it. */
  #tearPaper() {
    this.bench.machine.teletype.printer.frames.clear();
    this.taken = this.drawn = 0;
    this.bench.remember();
  }

  savePage() {
    this.bench.download("page.txt", `${this.paper.lines.join("\n")}\n`);
  }

  /** A key that prints nothing: its code is the button's value. */
  key(/** @type {HTMLInputElement} */ { value }) {
    this.#press(String.fromCharCode(Number(value)));
  }

  /** What is typed into the field goes to the computer at once. */
  type(/** @type {HTMLInputElement} */ field) {
    for (const character of field.value) this.#press(character);
    field.value = "";
  }

  #press(/** @type {string} */ key) {
    this.bench.touch(({ teletype }) => teletype.keyboard.press(sent(key)));
  }

  /** What is pasted is typed, a line's end by RETURN: a field of the browser's would lose it. */
  #paste(/** @type {any} */ event) {
    event.preventDefault();
    this.#press(event.clipboardData.getData("text/plain").replace(/\r?\n/g, NAMED.Enter));
  }

  #key(/** @type {any} */ event) {
    if (event.metaKey || event.key === "Tab") return;
    const signs = event.altKey && /^[^\w\s]$/.test(event.key); // by AltGr
    const copied = event.ctrlKey && event.key === "c" && String(getSelection());
    const control = event.ctrlKey && /^[a-z]$/i.test(event.key) && !event.altKey && !event.shiftKey && !copied; // Ctrl-Shift-V pastes, as at a terminal
    if ((event.ctrlKey || event.altKey) && !control && !signs) return;
    const key = control ? String.fromCharCode(event.key.charCodeAt(0) & 0o37) : /** @type {Record<string, string>} */ (NAMED)[event.key] ?? event.key;
    if (key.length !== 1 || !sent(key).length) return;
    event.preventDefault();
    this.#press(key);
  }

  lever() {
    this.leverWaits = false;
    this.bench.touch(({ teletype: { reader } }) => reader.lever(!reader.on));
  }

  punchOn() {
    this.bench.touch(({ teletype: { punch } }) => (punch.on = !punch.on));
  }

  /** Put the tape that is chosen from a list into the reader of the list's device. */
  choose(/** @type {HTMLSelectElement} */ list) {
    if (list.value && list.dataset.device === "highspeed") this.bench.touch(({ highspeed }) => highspeed.reader.load(this.#wound(list.value)));
    else if (list.value) this.mount(list.value);
    list.value = "";
  }

  /** The frames of a tape from the shelf, a loader's from its leader on. */
  #wound(/** @type {string} */ name) {
    const { frames } = this.bench.shelf.get(name);
    return frames.slice(start(frames));
  }

  /** Put a tape from the shelf into the reader. READER RUN is set while the processor stands still, and START would drop
   *  the frame on its way: so the lever goes to STOP, to be thrown with START.
   */
  mount(/** @type {string} */ name) {
    this.bench.touch(({ processor, teletype: { reader } }) => {
      const waits = reader.on && !processor.run;
      if (waits) reader.lever(false);
      reader.load(this.#wound(name));
      this.name(name, waits || this.leverWaits);
    });
  }

  /** START or CONT was pressed: throw the lever that waits, as an operator does with the other hand. */
  started() {
    if (this.leverWaits) this.bench.machine.teletype.reader.lever(true);
    this.leverWaits = false;
  }

  /** Tear a punched tape off; it goes onto the shelf. Return its name. */
  tear(/** @type {{ value: string }} */ { value: device }, called = "punched") {
    return this.bench.touch((machine) => {
      const { frames } = /** @type {any} */ (machine)[device].punch;
      const name = this.bench.shelf.put(called, Uint8Array.from(frames));
      frames.clear();
      return name;
    });
  }

  save() {
    this.bench.download("punched.tape", Uint8Array.from(this.bench.machine.teletype.punch.frames));
  }

  cut(/** @type {HTMLButtonElement} */ button) {
    this.bench.mill.cut(this.tear(button));
  }

  #tapes() {
    const { reader, punch } = this.bench.machine.teletype;
    const head = Math.max(0, reader.position - 1);
    const read = { frames: reader.tape, head, code: codeFor(reader.tape), label: this.called() };
    const frames = this.terminal?.frames ?? punch.frames;
    const punched = { frames, head: frames.length - 1, code: codeOf(frames), label: this.terminal?.name ?? "", punching: true };
    this.#tape("reader", read, reader.loaded);
    this.#tape("punch", punched, true);
    this.#block(this.terminal ? punched : reader.loaded ? read : null);
    this.#lever("lever", "Lever to", "Reader", reader.on ? ["START", "STOP"] : ["STOP", "START"]);
    this.#lever("punch-on", "Turn punch", "Punch", punch.on ? ["ON", "OFF"] : ["OFF", "ON"]);
    for (const id of ["tear", "store", "to-mill"]) find(id).toggleAttribute("disabled", !punch.frames.length);
  }

  /** A lever says where it goes when it is pressed; its name says where it stands, too. */
  #lever(/** @type {string} */ id, /** @type {string} */ says, /** @type {string} */ whose, /** @type {[string, string]} */ [stands, goes]) {
    this.bench.writer.text(find(id), `${says} ${goes}`);
    this.bench.writer.label(find(id), `${whose} ${stands}: ${says} ${goes}`);
  }

  /** The block that is passing: its fields, the digits read so far dark. */
  #block(/** @type {any} */ tape) {
    const texts = tape ? passing(tape.frames, tape.head, tape.code) : [];
    find("block").hidden = !texts.length;
    if (texts.length) this.bench.writer.fill(find("block"), BLOCK, ...texts);
  }

  #tape(/** @type {"reader" | "punch"} */ which, /** @type {TapeView} */ view, /** @type {any} */ loaded) {
    const { length } = view.frames;
    const caption = view.punching ? many(length, "frames") : `${view.label} ${grouped(this.bench.machine.teletype.reader.position)} of ${grouped(length)}`.trim();
    this.bench.writer.text(find(which).querySelector(".name"), loaded ? caption : "no tape");
    const frame = view.frames[view.head];
    const says = frame === undefined ? "nothing" : `${octal(frame, 3)} ${view.code.caption(frame)}`;
    this.bench.writer.label(canvas(which), `the ${which}'s tape, under the head: ${says}`);
    const draw = (/** @type {Canvas} */ context, /** @type {any[]} */ ...size) => loaded && drawTape(context, view, .../** @type {[number, number, Colours]} */ (size));
    this.sheets[which].draw(`${tapeKey(view)} ${view.code.name} ${loaded}`, draw);
  }

  #highspeed() {
    const { machine: { highspeed: { punch: { frames }, reader } }, writer } = this.bench;
    writer.text(find("pc8-reader"), reader.loaded ? `${grouped(reader.position)} of ${grouped(reader.tape.length)}` : "no tape");
    writer.text(find("pc8-punch"), `${many(frames.length, "frames")} punched`);
    find("pc8-tear").toggleAttribute("disabled", !frames.length);
  }
}

function canvas(/** @type {"reader" | "punch"} */ which) {
  return find(which).querySelector("canvas");
}
