// The one page: a whole PDP-8/L with its Teletype, assembler and milling machine, live, and the afternoon that plays on it.
//
//     Bench ──► panes, each a class of bench/NAME.mjs and a section of HTML: what is seen and what is pressed
//           ──► clock, history, goal, shelf, programs: what they share
//
// The panes are a script of their own (bench/desk.mjs): the room plays before they are there. The HTML names the methods that
// its controls call (bench/wiring.mjs). What a pane does to `bench.machine` it tells by `bench.touched()`; `bench.say(words)`
// says what happened. Its show(samples) shows every picture, with samples of the lamps while time goes on; its write() writes
// what is read, not so often while the machine runs.
// In HTML its section has data-pane, the name that ?embed= knows, and data-tab, if it is a tab of the desk.

import { Afternoon } from "./bench/afternoon.mjs";
import { rest, RESTS } from "./bench/alone.mjs";
import { Clock } from "./bench/clock.mjs";
import { LONGEST, linked, opened, shortened, whole } from "./bench/sharing.mjs";
import { Shelf } from "./bench/shelf.mjs";
import { wire } from "./bench/wiring.mjs";
import { one_of_each } from "../computer/hardware/devices.mjs";
import { Machine } from "../computer/machine.mjs";
import { History } from "../computer/past/history.mjs";
import { LARGEST, save } from "../computer/past/state.mjs";
import { Stop } from "../computer/stop.mjs";
import { told } from "../computer/use/ending.mjs";
import { Goal } from "../computer/use/goals.mjs";
import { Listing } from "../computer/use/trace.mjs";
import { decode, encode, ends_blocks, only_figures } from "../../tapes/ascii.mjs";
import { ASCII, BLANK_TAPE, EIA, recognise, UNKNOWN } from "../../tapes/codes.mjs";
import { unspelled } from "../../tapes/dump.mjs";
import { is_utf16 } from "../../tapes/text.mjs";
import { html, ours, put } from "./html.mjs";
import { READABLE } from "./pictures.mjs";
import { bytes } from "./translator/runtime.mjs";
import { Writer } from "./sheet.mjs";
import { Room } from "./room/room.mjs";
import { Sound } from "./room/sound.mjs";
import { DESK, find, grouped, LATER, octal, readdress } from "./written.mjs";

const GOES_ON = ["limit", "tape out", "idle"]; // when its time has come, or somebody does something
const FARTHEST = 50_000_000; // instructions that a link may have run: two or three seconds
const MEMORY = 32 << 20; // bytes of what can be undone

export class Bench {
  constructor(/** @type {any} */ record) {
    this.record = record;
    this.machine = new Machine(one_of_each());
    /** @type {Desk["Drives"]} */ this.drives = LATER;
    this.writer = new Writer();
    this.shelf = new Shelf(record.tapes);
    this.shared = ""; // what a link was asked for, as a file
    this.written = 0; // when what is read was
    this.texts = /** @type {Map<string, string> | null} */ (null); // the bundled tapes as a state has them, once they are asked for
    this.until = new Goal();
    this.remember();
    this.sound = new Sound();
    /** @type {any[]} */
    this.panes = [];
    this.afternoon = new Afternoon(this);
    this.room = new Room(this);
    this.clock = new Clock(this, (samples, reason) => this.#pictured(samples, reason));
    /** @type {Desk["Apart"]} */ this.apart = LATER; /** @type {Desk["Core"]} */ this.core = LATER; /** @type {Desk["Editor"]} */ this.editor = LATER;
    /** @type {Desk["Exercises"]} */ this.exercises = LATER; /** @type {Desk["Mill"]} */ this.mill = LATER; /** @type {Desk["Parts"]} */ this.parts = LATER;
    /** @type {Desk["Store"]} */ this.programs = LATER; /** @type {Desk["Session"]} */ this.session = LATER; /** @type {Desk["Switches"]} */ this.switches = LATER;
    /** @type {Desk["Tabs"]} */ this.tabs = LATER; /** @type {Desk["Teletype"]} */ this.teletype = LATER; /** @type {Desk["Time"]} */ this.time = LATER;
    /** @type {{ state: string; breakpoints: number[]; tape: any }} */ this.before = LATER;
    this.why = ""; // what is said of how the last run ended, or of what was done
    this.stop = new Stop("limit", 0, 0); // and the reasons
    this.ready = false; // whether the desk is there
    this.opening = /** @type {Promise<void> | null} */ (null); // and when it will be
    for (const kind of ["dragover", "drop"]) document.addEventListener(kind, (/** @type {any} */ event) => {
      if (!event.dataTransfer?.types.includes("Files")) return; // a text that is dragged is the browser's
      event.preventDefault();
      const reader = event.target?.closest("#reader")?.id;
      if (kind === "drop") [...event.dataTransfer.files].forEach((file) => this.take(file, reader));
    });
  }

  /** The visitor's machine: while the afternoon leads the page's, the one that the room keeps, if any. */
  get own() {
    return this.afternoon.on ? this.room.own : this.machine;
  }

  /** It, with what is watched in it and its tape's name; where there is none, as it was kept before. */
  get kept() {
    const { own: machine, teletype, until } = this, { leverWaits } = teletype;
    if (!machine) return this.before;
    const breakpoints = [...machine.watch.breakpoints].filter((address) => address !== until.added);
    return { state: this.drives.bare(machine), breakpoints, tape: { leverWaits, name: teletype.called(machine) } };
  }

  set kept({ state, breakpoints, tape }) {
    this.before = { state, breakpoints, tape };
    const machine = this.drives.restored(state);
    for (const address of breakpoints) if (address < machine.memory) machine.watch.breakpoints.add(address);
    if (this.room.open) {
      machine.panel.stop();
      this.room.keep(machine);
    } else this.#standing(machine);
    if (tape) this.teletype.name(String(tape.name), tape.leverWaits, machine);
  }

  /** Let a machine be the page's, as a copy that has a PC8/L. */
  adopt(/** @type {Machine} */ machine, stops = false) {
    this.aim();
    this.drives?.rescue(machine);
    this.teletype?.clear(); // another machine has another paper
    this.machine = this.like(machine);
    if (stops) this.machine.panel.stop();
    this.remember();
  }

  /** A copy of a machine with its breakpoints, a PC8/L, `more` devices, and so many words of core. */
  like(/** @type {Machine} */ machine, more = /** @type {Machine["devices"]} */ ([]), memory = machine.memory) {
    const devices = one_of_each(), usual = devices.map((each) => each.constructor);
    const others = machine.devices.map((each) => /** @type {new () => typeof each} */ (each.constructor)).filter((made) => !usual.includes(made));
    const copy = new Machine([...devices, ...others.map((made) => new made()), ...more], memory);
    copy.put(machine.values());
    copy.watch.breakpoints.update(machine.watch.breakpoints);
    return copy;
  }

  /** Keep what the machine does from now on, so that it can be undone. */
  remember() {
    /** @type {History} */ this.history = new History(this.machine, MEMORY);
  }

  /** Let somebody do `work` at the machine, which is theirs then; return what it returns. */
  touch(/** @type {(machine: Machine) => any} */ work) {
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
    else this.aim(); // a run to a goal is over
    this.show();
    this.clock.wake();
  }

  /** The machine runs on until a goal, from now on. */
  aim(goal = new Goal()) {
    this.until.over();
    this.until = goal;
  }

  #pictured(/** @type {Lamps[] | undefined} */ samples, /** @type {string} */ reason) {
    if (!GOES_ON.includes(reason)) this.ended(reason);
    else {
      if (reason !== "limit") this.why = this.told(reason);
      this.show(samples);
    }
  }

  /** What there is to say of a run that ended for this reason, in the words of every front end. */
  told(/** @type {string} */ reason) {
    const { pc, elapsed } = this.machine;
    const [stop, said] = told(new Stop(reason, pc, elapsed), this.history, this.ready ? this.editor.listing : new Listing());
    this.stop = stop;
    return said.charAt(0).toUpperCase() + said.slice(1);
  }

  /** A run has ended: say why and where. */
  ended(/** @type {string} */ reason) {
    const { processor, watch, pc, ma } = this.machine;
    const place = watch.breakpoints.has(pc) ? pc : ma; // a JMS to a breakpoint is beyond it
    const { said } = this.until;
    this.aim();
    processor.run = 0;
    this.say(said || (reason === "breakpoint" ? `${reason} at ${octal(place)}` : this.told(reason)));
  }

  /** START or CONT was pressed and the machine runs; START on a breakpoint stops there. */
  started(/** @type {string} */ key) {
    const { pc, watch } = this.machine;
    this.teletype.started();
    if (key === "start" && watch.breakpoints.has(pc)) this.ended("breakpoint");
  }

  show(samples = /** @type {Lamps[] | undefined} */ (undefined)) {
    const { processor, waiting } = this.machine;
    if (this.room.open) {
      this.room.show(samples);
      return;
    }
    for (const pane of this.panes) pane.show?.(samples);
    const goes = samples && (this.afternoon.on || (processor.run && !waiting.endless));
    if (goes && performance.now() - this.written < READABLE) return;
    this.written = performance.now();
    for (const pane of this.panes) pane.write?.();
  }

  say(/** @type {string} */ words) {
    this.why = words;
    if (words && this.afternoon.on) this.tell(words, true);
    this.show();
  }

  /** Whether an address is beyond core; then say that there is no such `what`. */
  lacks(/** @type {string} */ what, /** @type {number} */ address) {
    const { memory } = this.machine, beyond = address >= memory;
    if (beyond) this.say(`no ${what} ${octal(address)}: core ends at ${octal(memory - 1)}`);
    return beyond;
  }

  /** Say something to who listens; what all should know is `seen` too, until the machine is touched. */
  tell(/** @type {unknown} */ words, seen = false) {
    if (seen) this.afternoon.hush();
    this.writer.html(find("said"), html`${words}`);
    find("said").classList.toggle("spoken", !seen);
  }

  /** Show a pane alone, as large as the page, or all again. */
  enlarge(/** @type {HTMLElement} */ button) {
    const alone = /** @type {HTMLElement} */ (button.parentElement).classList.toggle("alone");
    document.querySelector("main").classList.toggle("one", alone);
    button.ariaPressed = String(alone);
  }

  /** Turn the sound on or off, by the box on the desk or the room's button. */
  hear({ checked = !this.sound.on }) {
    this.sound.turn(checked);
    find("sound").checked = checked;
    Object.assign(find("hear"), { ariaPressed: String(checked), textContent: checked ? "Sound on" : "Sound off" });
  }

  /** Ask for files: for the reader, or for what each is. */
  browse(/** @type {HTMLButtonElement} */ { value }) {
    Object.assign(find("file"), { value: "", name: value }).click(); // the same file once more is a change, too
  }

  taken(/** @type {HTMLInputElement} */ { files, name }) {
    [...(files ?? [])].forEach((file) => this.take(file, name));
  }

  /** Take a file for what it is: a saved state or session, an exercise, a program's source, or a tape, which goes into
   *  the reader or to the mill. What is put into the `reader` is a tape.
   */
  async take(/** @type {File} */ file, reader = "") {
    const { name } = file;
    await this.opening;
    if (this.room.open) this.room.leave();
    this.say("");
    if (file.size > LARGEST) {
      this.say(`${name}: longer than ${grouped(LARGEST)} bytes, the most that is read of a file`);
      return;
    }
    try {
      const frames = bytes(new Uint8Array(await file.arrayBuffer())); // of a folder there are none
      const text = new TextDecoder().decode(frames);
      const [tape, note] = unspelled(frames);
      if (reader) this.teletype.mount(this.shelf.put(name, frames));
      else if (this.drives.takes(name, frames)) this.drives.mount(name, frames);
      else if (note) {
        this.#tape(this.shelf.put(name, tape));
        this.say(`${name}: ${note}`);
      } else if (is_utf16(frames)) this.say(`${name}: UTF-16, as PowerShell's > writes it; save it as UTF-8`);
      else if (text.trimStart().startsWith("{")) this.#written(name, JSON.parse(text), text);
      else if (/\.toml$/i.test(name)) this.say(`${name} is an exercise as a teacher writes it; what this page takes is said under Exercises`);
      else this.#paper(name, frames, text);
    } catch (/** @type {any} */ error) {
      const said = error instanceof SyntaxError ? "damaged or cut short: it begins as JSON, and is none" : why(error);
      this.say(said.startsWith(name) ? said : `${name}: ${said}`);
    }
  }

  /** Take a source, or a tape: a text of figures is a source only by its name, and a BIN tape may have an origin by chance. */
  #paper(/** @type {string} */ name, /** @type {Bytes} */ frames, /** @type {string} */ text) {
    const code = recognise(frames), pal = /\.(pa[l8]?|src)$/i.test(name), figures = !pal && only_figures(frames);
    const named = pal || /\.txt$/i.test(name) || /^\s*\*[0-7]+\s/m.test(text); // it has an origin
    const source = named && !figures && (code === ASCII || code === BLANK_TAPE);
    if (code === UNKNOWN || !(source || frames.length)) this.say(`${name} is no tape, program, state or exercise; put into the reader, it is read as a tape all the same`);
    else if (source) {
      this.tabs.open("program");
      this.editor.open(name, frames);
      bring("program");
    } else if (figures && !ends_blocks(frames)) {
      this.#tape(this.shelf.put(name, encode(decode(frames))));
      this.say(`${name}: a text of figures, punched with CR and LF at the ends of its lines`);
    } else this.#tape(this.shelf.put(name, frames));
  }

  #tape(/** @type {string} */ name) {
    const eia = this.shelf.get(name).code === EIA;
    if (eia) this.mill.cut(name);
    else this.teletype.mount(name);
    bring(eia ? "mill" : "reader");
  }

  /** Take what a file in JSON is. */
  #written(/** @type {string} */ name, /** @type {any} */ what, /** @type {string} */ text) {
    if (what.task) {
      this.exercises.take(name, what);
      bring("exercises");
    } else if (what.program || what.machine || what.part) this.#open(what);
    else this.#restore(text);
  }

  /** Let the machine be as a saved state has it, but standing still. */
  #restore(/** @type {string} */ text) {
    this.#standing(this.drives.restored(text));
  }

  #standing(/** @type {Machine} */ machine) {
    this.afternoon.takeOver();
    this.adopt(machine, true);
    this.switches.card.end();
    this.teletype.leverWaits = false;
    this.touched();
    if (machine.processor.run) this.say("It was running when it was saved");
  }

  /** Let the machine be as a saved state has it, and run on for some instructions, which can be undone. Throws for too many. */
  lead(/** @type {string} */ text, /** @type {number} */ until, says = "") {
    if (!Number.isInteger(until) || until < 0 || until > FARTHEST) throw new Error(`until: ${until} instructions; 0 to ${grouped(FARTHEST)} are allowed`);
    this.#restore(text);
    const { machine } = this;
    machine.run(null, until);
    machine.processor.run = 0;
    this.say(`${says || `${grouped(until)} instructions have been run`}. The next is at ${octal(machine.pc)}; step back from here`);
  }

  save() {
    this.download("pdp8.state", save(this.machine));
  }

  download(/** @type {string} */ name, /** @type {BlobPart} */ content) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([content]));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    this.tell(`Saved as ${name}`, true);
  }

  /** The bundled tapes, frame by frame as a saved state has them. */
  #bundled() {
    const written = (/** @type {Bytes} */ frames) => Array.from(frames, (frame) => octal(frame, 3)).join(" ");
    this.texts ??= new Map(Object.keys(this.record.tapes).map((name) => [name, written(this.shelf.get(name).frames)]));
    return this.texts;
  }

  /** A state whose bundled tapes go by their names, with these. */
  whole(/** @type {any} */ state) {
    return whole(state, this.#bundled());
  }

  /** Give a link to the program and the machine, or, where it would be too long, a file of them. */
  async share() {
    const { called: name, text } = this.editor;
    const state = JSON.parse(this.drives.bare(this.machine));
    const { format, version } = state;
    const machine = shortened(state, JSON.parse(save(new Machine(one_of_each()))), this.#bundled());
    this.shared = JSON.stringify({ program: { name, text }, machine: { format, version, ...machine } });
    return this.give(await linked(JSON.parse(this.shared), ""), true);
  }

  /** Give the program and the machine as a file. */
  hand() {
    this.download("session.json", this.shared);
  }

  /** Give the link with that end; where it is too long a file, if one could be; where the page is a file nobody else can open
   *  it, so one is offered.
   */
  async give(/** @type {string} */ end, file = false) {
    if (end.length > LONGEST) {
      if (file) this.hand();
      this.say(`a link would have ${grouped(end.length)} characters, and ${grouped(LONGEST)} are allowed${file ? ": here is a file instead" : ""}`);
      return;
    }
    readdress(end, false, true);
    const { record: { url } } = this;
    const only = !url && location.protocol === "file:";
    let said = "The link is copied";
    try {
      await navigator.clipboard.writeText(url ? url + end : location.href);
    } catch {
      said = url ? `The link: ${url}${end}` : "The address of this page is the link now";
    }
    const offer = file ? html` <button class="text" data-click="hand">Save the program as a file</button> <small>Others drop it on their page.</small>` : "";
    this.tell(only ? html`${said}, but it leads to a file on this computer.${offer}` : `${said}.`, true);
  }

  /** Open what a link or a file of a session holds. */
  #open(/** @type {any} */ { program, machine, exercise, until, part }) {
    const texts = [...(program ? [program.name, program.text] : []), ...(part ? [part.name] : [])];
    if (texts.some((text) => typeof text !== "string")) throw new TypeError("a text is wanted");
    if (typeof exercise === "string") this.exercises.open(exercise);
    else if (exercise) this.exercises.take(String(exercise.name), exercise.tables);
    if (exercise) {
      this.tabs.open("exercises");
      const pane = find("exercises");
      requestAnimationFrame(() => pane.getBoundingClientRect().top > document.documentElement.clientHeight / 2 && pane.scrollIntoView());
    } else if (program) this.tabs.open("program");
    if (program) this.editor.put(program.name, program.text);
    if (part) {
      this.tabs.open("parts");
      this.parts.choose(part.name, part.typed ?? {});
      if (part.tape) this.parts.mill(String(part.tape));
    }
    if (!machine) return;
    const state = JSON.stringify(this.whole(machine));
    if (until === undefined) this.#restore(state);
    else this.lead(state, until);
  }

  /** Lay the desk, while the room plays if the page opens there; then open what the address holds, and what this browser has
   *  kept. A link that cannot be opened is forgotten.
   */
  async open() {
    const { room } = this;
    if (room.open) {
      room.enter(this.afternoon.asked);
      await idle();
    }
    const { lay } = await import("./bench/desk.mjs");
    Object.assign(this.record, await pack.more());
    const pieces = lay(this);
    while (!pieces.next().done) if (room.open) await idle();
    if (this.programs.names().length) this.editor.begin();
    else this.editor.open("hello.pal", this.shelf.get("hello.pal").frames);
    const found = this.session.open();
    if (room.open) room.show(); // it is where the address says already
    else if (this.afternoon.asked !== null) this.afternoon.go(this.afternoon.asked);
    else if (await this.#linked(found && history.state && !document.body.classList.contains("embed"))) this.#begins();
    this.ready = true;
    addEventListener("hashchange", () => this.#went());
    this.show();
  }

  /** Open what the address holds, if it is not `known`: what a session has is later. Return whether it could be. */
  async #linked(/** @type {boolean} */ known) {
    try {
      const shared = known ? null : await opened();
      if (shared) this.#open(shared);
      if (shared && shared.until === undefined && !shared.part) readdress(location.hash, false, true);
      return true;
    } catch (/** @type {any} */ error) {
      readdress(DESK);
      this.say(`the link cannot be opened: ${why(error)}`);
      return false;
    }
  }

  /** The address is another one: one has gone back or forward, to an instant or a link. */
  #went() {
    const { afternoon, afternoon: { asked }, room } = this;
    const link = /^#(s|exercise)=/.test(location.hash);
    if (link || location.hash.startsWith(DESK) || !inTheRoom()) {
      if (room.open) room.leave();
      if (asked !== null) afternoon.go(asked);
      if (link && !history.state) this.#linked(false);
    } else if (asked !== null || !location.hash) room.enter(asked);
  }

  /** A tape is cut; on some panes alone an afternoon plays. */
  #begins() {
    if (this.record.view) this.mill.cut(this.record.view);
    else if (document.body.classList.contains("embed") && this.record.opens) this.afternoon.watch();
  }

  /** Go from the desk into the room. */
  enter() {
    readdress("", true);
    this.room.enter();
    find("take").focus();
  }

  /** Write a first program: hello.pal runs, and the Teletype types; then it is changed. */
  first() {
    this.tabs.open("program");
    this.editor.open("hello.pal", this.shelf.get("hello.pal").frames);
    this.editor.run();
    this.editor.enter();
    for (const place of [find("paper"), find("gutter"), document.querySelector("#gutter .line")]) place.scrollIntoView({ block: "nearest" }); // the first instruction, and what is printed
  }
}

/** Bring what has come of a file into view: on a phone it may be screens away. */
function bring(/** @type {string} */ id) {
  const place = find(id);
  if (place.getBoundingClientRect().top > document.documentElement.clientHeight / 2) place.scrollIntoView({ block: "nearest" });
}

/** What there is to say of an error in what somebody else has made. */
function why(/** @type {any} */ error) {
  return error instanceof TypeError ? "a value in it is not what the page expects there" : String(error.message ?? error);
}

/** The browser has nothing else to do, or has been busy for a while. */
function idle() {
  const { requestIdleCallback: ask } = globalThis;
  return new Promise((done) => (ask ? ask(done, { timeout: 100 }) : setTimeout(done)));
}

/** Whether the page opens in the room where its address ends with nothing, or an instant. */
function inTheRoom() {
  return document.body.classList.contains("room") && !/[?&]embed=(?!room)/.test(location.search);
}

/** Put the page into its place, in the room or, if its address asks for something else, at the desk. */
function furnish(/** @type {any} */ record) {
  const { hash } = location, { body, head } = document;
  const page = document.createElement("template");
  put(page, ours(record.html));
  /** @type {HTMLElement} */ (page.content.getElementById("room")).hidden = !inTheRoom() || !/^(#t=.*)?$/.test(hash);
  body.classList.toggle("afternoon", hash.startsWith(`${DESK}&t=`)); // nothing moves when its bar comes
  head.append(Object.assign(document.createElement("style"), { textContent: record.style }));
  body.prepend(page.content);
}

async function start() {
  const record = await pack.record;
  furnish(record);
  const bench = new Bench(record);
  // For the curious, at the browser's console: workbench.machine.core[0o200] ...
  window.workbench = bench;
  bench.opening = bench.open();
  for (const file of pack.early()) bench.take(file);
  wire(bench);
  if (RESTS) rest();
}

if (globalThis.document) start();
