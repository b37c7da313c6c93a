// Part programs with the options of `pdp8 part`, through to the cut.
//
//     options ── part() ──► ASCII tape in the reader ── eia.pal ──► EIA tape on the punch ──► Hydra-Point
//
// The record's `parts` (pdp8/web/parts.py) say what is asked for.

import * as circle from "../../../programs/circle.mjs";
import * as curve from "../../../programs/curve.mjs";
import * as die from "../../../programs/die.mjs";
import * as drawn from "../../../programs/drawn.mjs";
import * as drill from "../../../programs/drill.mjs";
import * as ellipse from "../../../programs/ellipse.mjs";
import * as fluidic from "../../../programs/fluidic.mjs";
import { Header } from "../../../programs/header.mjs";
import { Milling } from "../../../programs/milling.mjs";
import * as polynomial from "../../../programs/polynomial.mjs";
import * as profile from "../../../programs/profile.mjs";
import * as slope from "../../../programs/slope.mjs";
import { Unit } from "../../../programs/units.mjs";
import { encode } from "../../../tapes/ascii.mjs";
import { decode } from "../../../tapes/binary.mjs";
import { duration } from "../../../tapes/quantities.mjs";
import { ours, put } from "../html.mjs";
import * as method from "../method.mjs";
import { Pad } from "../pad.mjs";
import { clipped, rect } from "../svg.mjs";
import { bytes } from "../translator/runtime.mjs";
import { find, many } from "../written.mjs";

export const PROGRAMS = { circle, curve, die, drawn, drill, ellipse, fluidic, polynomial, profile, slope };
const RECORDS = { Header, Milling };
const SECONDS = 10; // that a printout may take
const TRANSLATION = 60;
const FRAMES_A_SECOND = 10; // of the ASR-33

/** What is kept for an option as it was typed; undefined: its default. */
function kept(/** @type {Option_} */ { choices, default: by_itself, flag, places, spelling, unit, whole }, /** @type {any} */ typed) {
  const text = typed || by_itself;
  if (flag || choices || !text) return text;
  try {
    return unit ? new Unit(.../** @type {ConstructorParameters<typeof Unit>} */ (unit)).keep(text, whole ?? false) : places ? drill.places(text) : text;
  } catch (/** @type {any} */ error) {
    throw new Error(`${spelling}: ${error.message}`, { cause: error });
  }
}

/** The printout of a part, for options as they were typed, {name: text}. Throws what the command would say. */
export function printout(/** @type {Part_} */ { name, options, arguments: places }, /** @type {any} */ typed) {
  const missing = options.find((option) => option.required && !typed[option.name]);
  if (missing) throw new Error(`${name}: Missing argument '${missing.name.toUpperCase()}'.`);
  const values = Object.fromEntries(options.map((option) => [option.name, kept(option, typed[option.name])]));
  const record = (/** @type {string} */ kind, /** @type {string[]} */ fields) => new (/** @type {any} */ (RECORDS))[kind](...fields.map((field) => values[field]));
  return /** @type {any} */ (PROGRAMS[name]).part(...places.map(([place, kind, fields]) => (kind ? record(kind, fields) : values[place])));
}

/** The EIA tape that eia.pal, on its BIN tape, makes of a printout. */
export function translated(/** @type {Iterable<number>} */ program, /** @type {string} */ text) {
  return Uint8Array.from(method.translated(decode(bytes(program)).words.items(), encode(text)).teletype.punch.tape);
}

export class Parts {
  constructor(/** @type {Bench} */ bench) {
    this.bench = bench;
    this.translating = /** @type {Machine | null} */ (null); // the machine at it
    this.tape = /** @type {Bytes | null} */ (null); // and the tape in its reader
    this.name = ""; // of the tape that was punched
    this.given = /** @type {Record<string, Record<string, any>>} */ ({}); // what has been typed for each part
    find("part-name").replaceChildren(...bench.record.parts.map((/** @type {Part_} */ { name }) => new Option(name)));
    this.pad = new Pad(find("part-pad"), () => (this.#drawn(), this.type()));
    this.ask();
  }

  get part() {
    return this.bench.record.parts[find("part-name").selectedIndex];
  }

  /** The part that is chosen, and what has been typed for all. */
  get kept() {
    return { name: this.part.name, given: this.given };
  }

  set kept({ name, given }) {
    Object.assign(this.given, given);
    this.choose(name);
  }

  /** Show the options of the part that is chosen, as they were typed. */
  ask() {
    const { form, name, summary } = this.part, typed = this.given[name] ?? {};
    find("part-is").textContent = summary;
    put(find("part-options"), ours(form));
    find("part-pad").parentElement.hidden = name !== "drawn";
    if (name === "drawn") {
      if (typed.heights) this.pad.text = typed.heights;
      this.#drawn();
    }
    for (const [option, value] of Object.entries(typed)) {
      const input = find("part-options").querySelector(`[name="${CSS.escape(option)}"]`);
      const [field, own] = input?.type === "checkbox" ? ["checked", Boolean(value)] : ["value", String(value)];
      if (!input || input[field] === own) continue;
      input[field] = own;
      input.closest("details")?.setAttribute("open", "");
    }
  }

  /** Keep what is typed. */
  type() {
    this.given[this.part.name] = this.typed;
  }

  /** Choose a part, with options as they were typed. Throws for one that there is not. */
  choose(/** @type {string} */ name, typed = this.given[name]) {
    const at = this.bench.record.parts.findIndex((/** @type {Part_} */ part) => part.name === name);
    if (at < 0) throw new Error(`no part program ${name}`);
    find("part-name").selectedIndex = at;
    this.given[name] = typed;
    this.ask();
  }

  /** Show the curve that is drawn, and its heights as an option. */
  #drawn() {
    const { pad } = this;
    const box = { x: 0, y: 0, width: 420, height: 277 };
    const view = pad.fit(box);
    put(find("part-pad"), ours(clipped(box, view.line(pad.places, 'class="path"')) + rect(box, 'class="frame"')));
    find("part-options").querySelector("[name=heights]").value = pad.text;
  }

  /** What of the part that is chosen has been typed, {name: text}. */
  get typed() {
    return Object.fromEntries([...find("part-options").querySelectorAll("[name]")].map(
      (input) => [input.name, input.type === "checkbox" ? input.checked : input.value.trim()],
    ));
  }

  /** Mill the EIA tape of the part that is chosen; it is made apart from the page, and the machine is left alone. */
  async mill(/** @type {string} */ name) {
    const { apart, mill, shelf } = this.bench;
    const said = find("part-is-cut");
    said.textContent = "The part program and eia.pal are running.";
    try {
      const text = await apart.ask("printout", [this.part, this.typed], SECONDS);
      mill.cut(shelf.put(name, bytes(await apart.ask("translated", [shelf.get("eia.bin").frames, text], TRANSLATION))));
      said.textContent = mill.summary;
    } catch (/** @type {any} */ error) {
      said.textContent = error.message;
    }
  }

  async punch() {
    const { part, typed, bench, bench: { machine } } = this;
    find("part-translate").disabled = find("part-cut").disabled = true;
    find("part-translated").textContent = find("part-is-cut").textContent = "";
    try {
      const text = await bench.apart.ask("printout", [part, typed], SECONDS);
      if (machine !== bench.machine) return; // another has come meanwhile
      const tape = encode(text);
      this.name = bench.shelf.put(`${part.name}.asc`, tape);
      bench.teletype.mount(this.name);
      find("part-punched").textContent = `${many(text.split("\n").length - 1, "blocks")}: ${this.name}, ${many(tape.length, "frames")}, is in the reader. Punching it took ${duration(tape.length / FRAMES_A_SECOND)}.`;
      find("part-translate").disabled = false;
    } catch (/** @type {any} */ error) {
      find("part-punched").textContent = error.message;
    }
  }

  /** Let eia.pal run on the tape, with an empty punch, at full speed; show() sees its end. */
  translate() {
    const { bench } = this;
    bench.editor.stopCounting();
    bench.machine.watch.breakpoints.clear(); // they were of another program
    bench.editor.open("eia.pal", bench.shelf.get("eia.pal").frames);
    bench.editor.load();
    bench.machine.panel.sing_step = false;
    bench.machine.wait(1); // what another program was reading or punching
    bench.machine.teletype.punch.frames.clear();
    bench.teletype.mount(this.name);
    bench.teletype.leverWaits = true; // also where it stood at STOP
    bench.switches.press("start");
    this.speed = bench.clock.speed;
    bench.time.setSpeed(Infinity);
    this.translating = bench.machine;
    this.tape = bench.machine.teletype.reader.tape;
    find("part-translated").textContent = "eia.pal is running.";
  }

  cut(/** @type {HTMLButtonElement} */ button) {
    const { mill, teletype } = this.bench;
    mill.cut(teletype.tear(button, this.name.replace(".asc", ".eia")));
    find("part-is-cut").textContent = mill.summary;
  }

  show() {
    const { translating, bench: { clock, machine, time } } = this, other = machine !== translating || machine.teletype.reader.tape !== this.tape;
    if (!machine.teletype.punch.frames.length) find("part-cut").disabled = true;
    if (!translating || (!other && machine.processor.run && !machine.waiting.endless)) return;
    this.translating = null;
    if (clock.speed === Infinity) time.setSpeed(this.speed);
    if (other) return void (find("part-translated").textContent = "");
    const { frames } = machine.teletype.punch;
    find("part-translated").textContent = `${machine.processor.run ? "" : "Stopped: "}${many(frames.length, "frames")} of EIA: ${duration(machine.elapsed)} on the PDP-8/L.`;
    find("part-cut").disabled = !frames.length;
  }
}
