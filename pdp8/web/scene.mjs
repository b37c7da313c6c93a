// Everything on the page, shown as it was at one instant.

import { endsLine, upper } from "./afternoon.mjs";
import { FRAME, TICKS_PER_SECOND as SECOND } from "../computer/hardware/signals.mjs";
import { autoindexed, DCA, DEFER, EXECUTE, ISZ, JMP, JMS } from "../../pal/isa.mjs";
import { CHARACTERS } from "../../tapes/eia.mjs";
import { FIELDS } from "../../tapes/hydrapoint.mjs";
import { drawClose, drawWhole, Mill } from "./cutter.mjs";
import { instructionAt, inWords } from "./meaning.mjs";
import { Panel, stateName } from "./panel.mjs";
import { Paper } from "./paper.mjs";
import { READABLE } from "./pictures.mjs";
import { Sheet, Writer } from "./sheet.mjs";
import { drawTape, meaning, tapeKey } from "./tape.mjs";
import { clock, escaped, find, grouped, octal, seconds } from "./written.mjs";

const SAID = 8 * SECOND; // how long the operator's last action is shown
const PRESSED = 0.4 * SECOND; // how long a key shows as pressed
const FINE = 4000; // steps of the slider: about half a pixel
const SHORT = { preparatory: "prep.", x: "X", y: "Y", reserved: "res.", miscellaneous: "misc." };
const CELLS = [...FIELDS.items(), ["end", 1]]; // of a block
const DIGITS = FIELDS.values().reduce((sum, width) => sum + width);

const LABEL = `<b data-text></b><span data-text></span><span data-text></span>`;
const PLACE = `<b data-text></b><span data-text></span>`;
const BLOCK = `<b data-text></b><p>${CELLS.map(cell).join("")}</p>`;

export class Scene {
  constructor(record, afternoon) {
    this.record = record;
    this.afternoon = afternoon;
    this.mill = new Mill(record.mill);
    this.panel = new Panel(find("computer"));
    this.paper = new Paper(find("paper"), find("paper-title"), record);
    this.writer = new Writer();
    this.sheets = Object.fromEntries(
      ["in-tape", "out-tape", "whole", "close"].map((id) => [id, new Sheet(find(id), () => this.show())]),
    );
    this.registers = new Map();
    this.written = 0; // when the registers and their line were written last, in ms
    this.instructions = 0; // the count that they had then
  }

  /** Show the instant; `brightness` is that of the lamps since the last one, if time went on. */
  show(brightness) {
    const { afternoon, record } = this;
    const { now, machine, action } = afternoon;
    const act = afternoon.act();
    const [reader, punch] = [this.#reader(act), this.#punch(act)];
    const place = this.mill.at(now);
    this.#pictures(reader, punch, place);
    const another = this.act !== act;
    this.#time(act, now);
    this.panel.show(machine, action && now - action.at < PRESSED ? action.key : null, brightness);
    const { kind } = record.sheets[act.sheet];
    if (this.kind !== kind) document.querySelector("main").dataset.sheet = this.kind = kind;
    this.#tapes(act, reader, punch);
    this.#cutter(place);
    if (brightness && !another && kind === "listing" && !this.#readable(machine.processor)) return;
    this.#caption(act, action);
    this.#registers(kind, machine);
    this.paper.show(act, afternoon);
  }

  /** Whether the last writing of the registers has stood long enough, or the next instruction is all that changed. */
  #readable({ instructions }) {
    return performance.now() - this.written >= READABLE || Math.abs(instructions - this.instructions) <= 1;
  }

  /** Draw the tapes and the table, before any text is written: a canvas that sets a font, and a list that is scrolled,
   *  has the browser work out at once what has changed so far.
   */
  #pictures(reader, punch, place) {
    const { mill, sheets } = this;
    const started = place.block >= 0;
    const close = started ? place : mill.first();
    const key = `${place.knot} ${place.x} ${place.y} ${started}`;
    if (reader) sheets["in-tape"].draw(tapeKey(reader), (context, ...size) => drawTape(context, reader, ...size));
    if (punch) sheets["out-tape"].draw(tapeKey(punch), (context, ...size) => drawTape(context, punch, ...size));
    sheets.whole.draw(key, (context, ...size) => drawWhole(context, mill, place, started, ...size));
    sheets.close.draw(key, (context, ...size) => drawClose(context, mill, close, started, ...size));
  }

  /** Say the instant in words, for who cannot see it. */
  say() {
    const { afternoon, panel } = this;
    panel.say(afternoon.machine);
    const when = clock(this.record.opens, afternoon.now);
    this.writer.text(find("said"), `${when}, ${afternoon.act().name}. ${panel.spoken.textContent}`);
  }

  #time(act, now) {
    const time = clock(this.record.opens, now);
    this.writer.text(find("clock"), time);
    this.writer.text(find("act-name"), act.name);
    if (Math.abs(find("slider").value - now) > this.afternoon.end / FINE) find("slider").value = now;
    if (time !== this.time) find("slider").setAttribute("aria-valuetext", `${time}, ${act.name}`);
    this.time = time;
    if (this.act === act) return;
    this.act = act;
    [...find("acts").children].forEach((mark, index) => mark.classList.toggle("now", index === act.index));
  }

  #caption(act, action) {
    const fresh = action && action.at >= act.from && this.afternoon.now - action.at < SAID;
    const doing = fresh ? action.say : waits(this.afternoon.machine);
    this.writer.html(find("caption"), `<b>${escaped(act.name)}.</b> ${escaped(act.say)} <em>${escaped(doing)}</em>`);
  }

  /** The registers, while there is a program beside them. */
  #registers(kind, machine) {
    const hidden = kind !== "listing";
    if (find("registers").hidden !== hidden) find("registers").hidden = hidden;
    if (hidden) return;
    this.written = performance.now();
    this.instructions = machine.processor.instructions;
    const { processor, teletype } = machine;
    const shown = [
      ["L", machine.link], ["AC", octal(machine.ac)], ["MA", octal(processor.ma)], ["MB", octal(processor.mb)],
      ["IR", processor.ir], ["PC", octal(processor.pc)], ["state", stateName(processor.state)],
      ["reader flag", teletype.receiver.flag ? "up" : "down"], ["punch flag", teletype.transmitter.flag ? "up" : "down"],
      ["instructions", grouped(processor.instructions)], ["since START", processor.started ? seconds(machine.ticks) : "–"],
      ["core", wrote(processor) ? `${octal(processor.ma)} ← ${octal(processor.mb)}` : "–"],
      ["instruction", inWords(processor.core[instructionAt(processor)], instructionAt(processor))],
    ];
    for (const [name, value] of shown) this.writer.text(this.#register(name), String(value));
  }

  /** The element that shows a register. */
  #register(name) {
    if (!this.registers.has(name)) {
      const cell = document.createElement("div");
      cell.dataset.register = name;
      cell.innerHTML = `<dt>${name}</dt><dd></dd>`;
      find("registers").append(cell);
      this.registers.set(name, cell.lastChild);
    }
    return this.registers.get(name);
  }

  #tapes(act, reader, punch) {
    this.#label("in", reader);
    this.#label("out", punch);
    this.#block(act.kind === "terminal" ? punch : reader);
  }

  /** The tape that is being read: by the Teletype, or by the Hydra-Point. */
  #reader(act) {
    const { afternoon, record } = this;
    if (act.kind === "mill" || act.kind === "inspect") {
      const tape = record.tapes.eia;
      return { ...tape, head: tape.first + this.mill.row(afternoon.now), title: "in the Hydra-Point's reader" };
    }
    if (!afternoon.mounted) return null;
    const { position } = afternoon.machine.teletype.reader;
    return { ...record.tapes[afternoon.mounted], head: Math.max(0, position - 1), title: "in the ASR-33's reader" };
  }

  /** The tape that is being punched, or was last, where there is a punch. */
  #punch(act) {
    const { afternoon, record } = this;
    const { frames } = afternoon.machine.teletype.punch;
    if (act.kind !== "terminal" && act.kind !== "toggle" && act.kind !== "translate") return null;
    if (act.index < record.translation) {
      const tape = record.tapes.ascii;
      const punched = Math.min(tape.frames.length, Math.floor(afternoon.now / FRAME));
      return { ...tape, head: punched - 1, punching: true, title: "in the terminal's punch" };
    }
    const head = frames.length - 1;
    return { ...record.tapes.eia, frames, head, punching: true, title: "in the ASR-33's punch" };
  }

  #label(which, tape) {
    const canvas = find(`${which}-tape`);
    const figure = canvas.closest("figure");
    if (figure.hidden !== !tape) figure.hidden = !tape;
    if (!tape) return;
    const count = tape.punching
      ? `${grouped(tape.head + 1)} frames punched`
      : `frame ${grouped(tape.head)} of ${grouped(tape.frames.length)}`;
    this.writer.fill(find(`${which}-label`), LABEL, tape.label, tape.title, count);
    const frame = tape.frames[tape.head];
    const now = frame === undefined ? "nothing yet" : `${count}: ${octal(frame, 3)} ${meaning(frame, tape.code)}`;
    this.writer.label(canvas, `${tape.label}, ${now}`);
  }

  /** The block that is passing: its fields, the digits read so far dark. */
  #block(tape) {
    const place = find("block");
    const hidden = !tape || (tape.code !== "ascii" && tape.code !== "eia");
    if (place.hidden !== hidden) place.hidden = hidden;
    if (hidden) return;
    const { digits, read, number } = blockAt(tape);
    let at = 0;
    const parts = CELLS.flatMap(([, width]) => {
      const shown = digits.slice(at, at + width).padEnd(width, "·");
      const passed = Math.max(0, read - at);
      at += width;
      return [shown.slice(0, passed), shown.slice(passed)];
    });
    this.writer.fill(place, BLOCK, `block ${number}`, ...parts);
  }

  #cutter(place) {
    const where = place.block >= 0
      ? `X ${(place.x / 1000).toFixed(3)}  Y ${(place.y / 1000).toFixed(3)}`
      : `waiting for its tape: ${this.mill.blocks.length} blocks`;
    this.writer.fill(find("whole-label"), PLACE, "Hydra-Point", where);
    this.writer.fill(find("close-label"), PLACE, this.mill.band ? "In its band" : "Close by", "squares of .010 in");
    this.writer.label(find("whole"), `the Hydra-Point's table, ${where}`);
    this.writer.label(find("close"), `the staircase close by, ${where}`);
  }
}

/** A field of a block: the digits that are read, those that are not, and its name. */
function cell([name]) {
  return `<span><b><i class="read" data-text></i><i data-text></i></b><small>${SHORT[name] ?? name}</small></span>`;
}

/** Whether the last cycle wrote the word at MA. */
function wrote({ state, ir, ma, protect }) {
  if (state === EXECUTE) return [ISZ, DCA, JMS].includes(ir) && !protect;
  return state === DEFER && autoindexed(ma);
}

/** What a running machine is waiting for, in words. */
function waits({ processor }) {
  if (!processor.run) return "";
  const { core } = processor;
  const at = instructionAt(processor);
  const word = core[at] >> 9 === JMP ? core[at - 1] : core[at];
  if (word === 0o6031) return "It waits for the reader.";
  if (word === 0o6041) return "It waits for the punch.";
  return "";
}

/** The block at the tape's head: its digits as the translation makes them, how many have passed, its number. */
function blockAt({ frames, head, code, lines }) {
  let from = Math.max(0, head);
  while (from > 0 && !endsLine(frames[from - 1], code)) from--;
  let digits = "";
  let read = 0;
  for (let frame = from; frame < frames.length && digits.length <= DIGITS; frame++) {
    const digit = endsLine(frames[frame], code) ? "↵" : digitOf(frames[frame], code);
    digits += digit;
    if (frame <= head) read += digit.length;
    if (digit === "↵") break;
  }
  return { digits, read, number: Math.min(lines.length, upper(lines, from - 1) + 1) };
}

function digitOf(frame, code) {
  if (code === "ascii") {
    const character = String.fromCharCode(frame & 0o177);
    return character === " " ? "0" : /\d/.test(character) ? character : "";
  }
  return CHARACTERS.get(frame, "");
}
