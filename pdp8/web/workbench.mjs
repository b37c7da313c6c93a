// The one page: a whole PDP-8/L with its Teletype, assembler and milling machine, live, and the afternoon that plays on it.
//
//     Bench ──► panes, each a class of bench/NAME.mjs and a section of HTML: what is seen and what is pressed
//           ──► clock, history, until, shelf, sound: what they share
//
// A pane is made with the bench. What it does to `bench.machine` it tells by `bench.touched()`; `bench.say(words)` says
// what happened. Its show(brightness), if it has one, writes what has changed; brightness is there while time goes on.
// In HTML its section has data-pane, the name that ?embed= knows, and data-tab, if it is a tab of the desk.

import { Afternoon } from "./bench/afternoon.mjs";
import { Apart, serve } from "./bench/apart.mjs";
import { booted } from "./bench/boot.mjs";
import { checked } from "./bench/checker.mjs";
import { embed, enlargeable } from "./bench/alone.mjs";
import { Clock } from "./bench/clock.mjs";
import { Debugger } from "./bench/debugger.mjs";
import { Doors } from "./bench/doors.mjs";
import { Editor } from "./bench/editor.mjs";
import { Exercises } from "./bench/exercises.mjs";
import { Figures } from "./bench/figures.mjs";
import { fitted, HighSpeed } from "./bench/highspeed.mjs";
import { History } from "./bench/history.mjs";
import { keep, kept } from "./bench/kept.mjs";
import { marks } from "./bench/marker.mjs";
import { Mill } from "./bench/mill.mjs";
import { Parts, printout } from "./bench/parts.mjs";
import { Programs } from "./bench/programs.mjs";
import { rest } from "./bench/rest.mjs";
import { LONGEST, linked, opened, shortened, whole } from "./bench/sharing.mjs";
import { Shelf } from "./bench/shelf.mjs";
import { Sound } from "./bench/sound.mjs";
import { Switches } from "./bench/switches.mjs";
import { Tabs } from "./bench/tabs.mjs";
import { Time } from "./bench/time.mjs";
import { Teletype } from "./bench/teletype.mjs";
import { Until } from "./bench/until.mjs";
import { Machine } from "../computer/machine.mjs";
import { LARGEST, restore, save } from "../computer/past/state.mjs";
import * as kinds from "../../tapes/kinds.mjs";
import { unpacked } from "./packed.mjs";
import { bytes } from "./translator/runtime.mjs";
import { Writer } from "./sheet.mjs";
import { find, grouped, octal } from "./written.mjs";

const REASONS = { halt: "HLT", "stop key": "stopped", breakpoint: "breakpoint", protect: "MEM PROT", reached: "reached" };
const WAITS = ["tape out", "idle"]; // the program goes on when somebody does something
const OPEN = "pdp8 program"; // the name of that which was open

class Bench {
  constructor(record) {
    this.record = record;
    this.machine = new Machine(true);
    this.writer = new Writer();
    this.shelf = new Shelf(record.tapes);
    this.sound = new Sound(find("sound"));
    this.history = new History(this);
    this.until = new Until();
    this.tabs = new Tabs();
    this.afternoon = new Afternoon(this);
    this.switches = new Switches(this);
    this.teletype = new Teletype(this);
    this.highspeed = new HighSpeed(this);
    this.debug = new Debugger(this);
    this.mill = new Mill(this);
    this.apart = new Apart();
    this.programs = new Programs();
    this.editor = new Editor(this);
    this.exercises = new Exercises(this);
    this.parts = new Parts(this);
    this.figures = new Figures(record.afternoon);
    this.time = new Time(this);
    this.doors = new Doors(this);
    /** @type {any[]} */
    this.panes = [this.afternoon, this.switches, this.teletype, this.highspeed, this.debug, this.editor, this.mill, this.exercises, this.parts, this.time];
    this.clock = new Clock(this, (brightness, stop) => this.#pictured(brightness, stop));
    this.#controls();
    this.tabs.changed = () => this.show();
    this.show();
  }

  /** Let somebody do `work` at the machine, which is theirs then; return what it returns. */
  touch(work) {
    this.afternoon.takeOver();
    const done = work(this.machine);
    this.touched();
    return done;
  }

  /** The machine was touched: keep it, show it, let it go on. */
  touched() {
    this.afternoon.takeOver();
    this.tell("");
    const { machine } = this;
    machine.waiting.endless = false;
    if (machine.processor.run) this.why = "";
    this.show();
    this.clock.wake();
  }

  #pictured(brightness, stop) {
    if (stop && !WAITS.includes(stop.reason)) this.ended(stop.reason);
    else this.show(brightness);
  }

  /** A run has ended: say why and where. */
  ended(reason) {
    const { processor, watch } = this.machine;
    const { pc, ma } = processor;
    const asked = reason === "breakpoint" && !watch.breakpoints.has(pc) ? ma : pc; // a JMS to a breakpoint is beyond it
    const place = reason === "halt" || reason === "protect" ? ma : asked;
    this.until.over();
    this.until = new Until();
    processor.run = 0;
    this.say(`${REASONS[reason] ?? reason} at ${octal(place)}`);
  }

  /** START or CONT was pressed and the machine runs; START on a breakpoint stops there. */
  started(key) {
    const { pc } = this.machine.processor;
    this.teletype.started();
    if (key === "start" && this.machine.watch.breakpoints.has(pc)) this.ended("breakpoint");
  }

  show(brightness) {
    const { machine, writer } = this;
    const waits = machine.processor.run && machine.waiting.endless;
    const running = brightness && machine.processor.run && !waits ? brightness : undefined;
    for (const pane of this.panes) pane.show?.(brightness, running);
    if (this.afternoon.on) return;
    writer.text(find("clock"), `${machine.elapsed.toFixed(3)} s`);
    const doing = !waits ? "runs" : machine._out_of_tape() ? "waits for tape" : "waits";
    writer.text(find("why"), machine.processor.run ? doing : "stands still");
  }

  say(words) {
    this.why = words;
    this.show();
  }

  /** Say something to who listens; what all should know is `seen` too, until the machine is touched. */
  tell(words, seen = false) {
    this.writer.text(find("said"), words);
    find("said").classList.toggle("spoken", !seen);
  }

  /** Lay the listing of a program on the desk. */
  lay(name, assembly) {
    this.editor.lay(name, assembly);
  }

  /** Load eia.pal with a tape in the reader, and an empty punch: what the exercises begin with. */
  translate(name) {
    this.editor.open("eia.pal", this.shelf.get("eia.pal").frames);
    this.editor.load();
    this.machine.teletype.punch.frames.clear();
    this.teletype.mount(name);
  }

  #controls() {
    find("share").addEventListener("click", () => this.#share());
    find("save").addEventListener("click", () => this.download("pdp8.state", save(this.machine)));
    find("open").addEventListener("click", () => find("file").click());
    find("file").addEventListener("change", ({ target }) => [...target.files].forEach((file) => this.take(file)));
    document.addEventListener("dragover", (event) => event.preventDefault());
    document.addEventListener("drop", (event) => {
      event.preventDefault();
      const reader = event.target.closest("#reader");
      [...event.dataTransfer.files].forEach((file) => this.take(file, reader));
    });
  }

  /** Take a file for what it is: a saved state or session, an exercise, a program's source, or a tape, which goes into
   *  the reader or to the mill. What is put into the `reader` is a tape.
   */
  async take(file, reader = null) {
    if (file.size > LARGEST) {
      this.say(`${file.name}: longer than ${grouped(LARGEST)} bytes, the most that is read of a file`);
      return;
    }
    const frames = bytes(new Uint8Array(await file.arrayBuffer()));
    const text = new TextDecoder().decode(frames);
    this.#attempt(() => {
      if (reader) this.teletype.mount(this.shelf.put(file.name, frames));
      else if (text.startsWith("{")) this.#written(file.name, JSON.parse(text), text);
      else if (file.name.endsWith(".toml")) this.say(`${file.name} is an exercise as a teacher writes it; what this page takes is said under Exercises`);
      else if (/\.(pa[l8]?|txt|src)$/i.test(file.name)) this.#source(file.name, frames);
      else if (!frames.length || kinds.classify(frames) === kinds.UNKNOWN) this.say(`${file.name} is no tape, program, state or exercise; dropped on the reader, it is read as a tape all the same`);
      else this.#tape(this.shelf.put(file.name, frames));
    });
  }

  #source(name, frames) {
    this.tabs.open("program");
    this.editor.open(name, frames);
  }

  #tape(name) {
    if (this.shelf.get(name).code === "eia") this.mill.cut(name);
    else this.teletype.mount(name);
  }

  /** Take what a file in JSON is. */
  #written(name, what, text) {
    if (what.task) this.exercises.take(name, what);
    else if (what.program || what.machine) this.#open(what);
    else this.#restore(text);
  }

  /** Do what may fail; say why it did. */
  #attempt(work) {
    try {
      work();
    } catch (error) {
      this.say(String(error.message ?? error));
    }
  }

  #restore(text) {
    this.afternoon.takeOver();
    this.machine = fitted(restore(text));
    this.history.begin();
    this.touched();
  }

  download(name, content) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([content]));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }

  /** The program and the machine, short: bundled tapes by name. */
  session() {
    const state = JSON.parse(save(this.machine));
    const { format, version } = state;
    const machine = shortened(state, JSON.parse(save(new Machine(true))), this.#bundled());
    return { program: { name: this.editor.name, text: this.editor.text }, machine: { format, version, ...machine } };
  }

  /** The bundled tapes, frame by frame as a saved state has them. */
  #bundled() {
    const written = (frames) => Array.from(frames, (frame) => octal(frame, 3)).join(" ");
    return new Map(Object.keys(this.record.tapes).map((name) => [name, written(this.shelf.get(name).frames)]));
  }

  async #share() {
    const session = this.session();
    const link = await linked(session);
    if (link.length <= LONGEST) return this.give(link);
    this.download("session.json", JSON.stringify(session));
    return this.say(`a link would have ${grouped(link.length)} characters, and ${grouped(LONGEST)} are allowed: here is a file instead`);
  }

  /** Give the link that was asked for. */
  async give(link) {
    history.replaceState(null, "", link);
    try {
      await navigator.clipboard.writeText(link);
      this.tell("The link is copied.", true);
    } catch {
      this.tell("The address of this page is the link now.", true);
    }
  }

  /** Open what a link or a file of a session holds. */
  #open({ program, machine, exercise }) {
    if (typeof exercise === "string") this.exercises.open(exercise);
    else if (exercise) this.exercises.take(exercise.name, exercise.tables);
    if (exercise) this.tabs.open("exercises");
    if (program) this.editor.put(String(program.name), String(program.text));
    if (machine) this.#restore(JSON.stringify(whole(machine, this.#bundled())));
  }

  /** A program was opened: so it is when the page is opened again. */
  opened(name) {
    keep(OPEN, name);
  }

  /** Open what the address holds, and what this browser has kept. A link that cannot be opened is forgotten. */
  async open() {
    await this.programs.open();
    if (!this.programs.names().length) this.programs.take("hello.pal", this.record.source);
    this.editor.begin(kept(OPEN));
    if (this.afternoon.asked()) return;
    try {
      const shared = await opened();
      if (shared) this.#open(shared);
    } catch (error) {
      history.replaceState(null, "", location.href.replace(/#.*/, ""));
      this.say(`the link cannot be opened: ${error.message ?? error}`);
      return;
    }
    if (this.record.view) this.mill.cut(this.record.view);
    if (this.record.door) this.doors.open(this.record.door);
  }
}

async function start() {
  const bench = new Bench(await unpacked(find("record").textContent));
  embed(bench.tabs);
  enlargeable();
  rest();
  await bench.open();
  // For the curious, at the browser's console: workbench.machine.core[0o200] ...
  window.workbench = bench;
}

if (globalThis.document) start();
else serve({ booted, checked, marks, printout });
