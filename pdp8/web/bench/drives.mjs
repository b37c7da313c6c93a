// DECtape on the desk: a reel that is dropped on the page is mounted, and its reels turn as the tape moves.
//
// With the first one a TC08 and a second field of core are fitted, as in a PDP-8/L with an MC8/L; so the page's machine stays
// one of 4K for whoever brings no reel. A file is not written: Save gives what the program has made of the reel.

import { boot } from "../../computer/use/bootstrap.mjs";
import { TC08 } from "../../computer/dectape/tc08.mjs";
import { BLOCK_LINES, END_ZONE, LINE, LINES, STOPPED } from "../../computer/dectape/tu55.mjs";
import { FIELD } from "../../computer/hardware/extension.mjs";
import { save } from "../../computer/past/state.mjs";
import { BLOCKS, decode, is_for_td8e, is_image } from "../../../tapes/dectape.mjs";
import { html, put } from "../html.mjs";
import { find, many, octal } from "../written.mjs";
import { restored } from "./boot.mjs";

/** @typedef {import("../../computer/dectape/tu55.mjs").Transport} Transport */

const UNITS = [0, 1];
const TURNS = 180; // of a full reel for the whole tape
const FULL = 9, HUB = 4; // radii of a reel with the whole tape, and with none
/** @type {(on: number) => number} The radius of a reel that has a part of the tape, 0 to 1. */
const radius = (on) => Math.sqrt(HUB ** 2 + on * (FULL ** 2 - HUB ** 2));

/** @type {(machine: Machine | null) => TC08 | undefined} The DECtape control of a machine that has one. */
const controlOf = (machine) => machine?.devices.find((each) => each instanceof TC08);
/** @type {(drive: Transport) => string} What was written on a drive's reel. */
const changes = (drive) => `${[...drive.changed]}`;

export class Drives {
  constructor(/** @type {Bench} */ bench) {
    this.bench = bench;
    this.names = /** @type {WeakMap<Image, string>} */ (new WeakMap());
    this.saved = /** @type {WeakMap<Image, string>} */ (new WeakMap()); // what was written on each reel when it was saved
    put(find("reels"), UNITS.map((unit) => html`<div class="drive" role="group" aria-label="Drive ${unit}" hidden>
      <svg viewBox="0 0 40 20" aria-hidden="true">${[10, 30].map((x) => html`<g transform="translate(${x} 10)"><circle class="tape"/><path d="M-3.5 0h7M0-3.5v7" class="spokes"/></g>`)}</svg>
      <span class="name"></span>
      <label class="check"><input data-change="drives.lock" type="checkbox" value="${unit}"> write lock</label>
      <button data-click="drives.save" class="text" value="${unit}" title="The reel as it is now, as a file">Save the reel</button>
      <button data-click="drives.takeOff" class="text" value="${unit}">Take it off</button></div>`));
    this.units = [...find("reels").children];
  }

  /** The control of the visitor's machine, if it has one. */
  get control() {
    return controlOf(this.bench.own);
  }

  /** Whether a file is a reel. */
  takes(/** @type {string} */ name, /** @type {Bytes} */ frames) {
    return /\.(tu56|dt8)$/i.test(name) || is_image(frames);
  }

  /** Mount a reel on the first drive that is free, or on the last one. Throws for what is none. */
  mount(/** @type {string} */ name, /** @type {Bytes} */ frames) {
    const [image, notes] = decode(frames);
    const { bench } = this;
    if (!this.control) this.#fit();
    const { drives } = /** @type {TC08} */ (this.control);
    const free = UNITS.find((each) => !drives[each].image), unit = free ?? UNITS.length - 1;
    const before = free === undefined ? ` in place of ${this.called(unit)}` : "";
    this.#rescue(unit);
    this.names.set(image, name);
    bench.touch(() => drives[unit].mount(image));
    bench.remember(); // no step back restores another reel
    find("drives").open = true;
    const said = [`${name} is on DECtape drive ${unit}${before}; the machine has ${bench.machine.memory} words of core`, ...notes];
    if (unit === 0 && !is_for_td8e(image)) said.push("Press Boot drive 0");
    bench.say(said.join(". "));
  }

  /** Put the machine that is there into one with 8K and a TC08. */
  #fit() {
    const { bench } = this;
    bench.afternoon.takeOver();
    const { machine } = bench;
    bench.machine = bench.like(machine, [new TC08()], Math.max(machine.memory, 2 * FIELD));
    const { breakpoints, observer, writes } = machine.watch; // a goal that it runs to may take a breakpoint out
    Object.assign(bench.machine.watch, { breakpoints, observer, writes });
  }

  /** A machine of a saved state, which may have a TC08 with reels that are here. */
  restored(/** @type {string} */ state) {
    return restored(state, this.control?.drives.flatMap(({ image }) => image ?? []));
  }

  /** Let the machine be as a state of it says that has no reels; those that are here stay as they are. */
  put(/** @type {string} */ state) {
    const values = this.restored(state).values();
    for (const name of [...values.keys()]) if (name.includes(" drive")) values.delete(name);
    this.bench.machine.put(values);
    this.bench.remember(); // its instructions are another machine's
  }

  /** The state of a machine without its reels, which are too large to be kept. */
  bare(/** @type {Machine} */ machine) {
    const copy = this.bench.like(machine);
    for (const drive of controlOf(copy)?.drives ?? []) drive.mount(null);
    return save(copy);
  }

  /** Toggle in the bootstrap of drive 0, and press START. */
  boot() {
    const { bench } = this;
    bench.aim();
    bench.switches.card.end();
    bench.touch((machine) => {
      machine.panel.mem_prot = machine.panel.sing_step = false; // as by hand, or it would not go
      boot(machine);
    });
    bench.teletype.keys.focus();
  }

  lock(/** @type {HTMLInputElement} */ { checked, value }) {
    this.bench.touch(() => (this.#drive(value).locked = Number(checked)));
  }

  save(/** @type {{value: string}} */ { value }) {
    const drive = this.#drive(value);
    if (!drive.image) return;
    this.bench.download(this.called(Number(value)), /** @type {Image} */ (drive.written()).content());
    this.saved.set(drive.image, changes(drive));
  }

  /** What the reel on a drive is called, wherever a state has put it. */
  called(/** @type {number} */ unit) {
    return this.names.get(/** @type {Image} */ (this.control?.drives[unit].image)) ?? "a reel";
  }

  /** Whether blocks were written on the reel of a drive that are in no file. */
  unsaved(/** @type {number} */ unit) {
    const drive = this.control?.drives[unit];
    return Boolean(drive?.image && drive.blocks.length && changes(drive) !== this.saved.get(drive.image));
  }

  /** Save a reel that goes from its drive, as nobody else will. */
  #rescue(/** @type {number} */ unit) {
    if (this.unsaved(unit)) this.save({ value: String(unit) });
  }

  /** Save the reels that go with the visitor's machine: those that another one has not as they are. */
  rescue(/** @type {Machine | null} */ other) {
    const there = controlOf(other)?.drives ?? [];
    const has = (/** @type {Transport} */ drive) => there.some((each) => each.image === drive.image && changes(each) === changes(drive));
    this.control?.drives.forEach((drive, unit) => has(drive) || this.#rescue(unit));
  }

  takeOff(/** @type {HTMLInputElement} */ { value }) {
    this.#rescue(Number(value));
    this.bench.touch(() => this.#drive(value).mount(null));
    this.bench.remember();
  }

  #drive(/** @type {string} */ unit) {
    return /** @type {TC08} */ (this.control).drives[Number(unit)];
  }

  show() {
    const { drives = [] } = this.control ?? {};
    const { clock } = this.bench.machine.processor;
    find("boot-reel").disabled = !drives[0]?.image;
    this.units.forEach((row, unit) => {
      const drive = drives[unit];
      row.hidden = !drive?.image;
      if (!row.hidden) this.#turn(row, drive, unit, clock);
    });
  }

  #turn(/** @type {HTMLElement} */ row, /** @type {Transport} */ drive, /** @type {number} */ unit, /** @type {number} */ clock) {
    const line = drive.position(clock) / LINE;
    const part = line / LINES;
    row.querySelectorAll("g").forEach((reel, right) => {
      const size = radius(right ? part : 1 - part);
      reel.setAttribute("transform", `translate(${right ? 30 : 10} 10) rotate(${(360 * TURNS * part * FULL) / size})`);
      reel.querySelector("circle").setAttribute("r", size.toFixed(2));
    });
    const block = Math.floor((line - END_ZONE) / BLOCK_LINES);
    const place = block < 0 || block >= BLOCKS ? "end zone" : `block ${octal(block)}`;
    const moves = drive.phase === STOPPED ? "at rest" : drive.reverse ? "moves back" : "moves on";
    const written = drive.blocks.length ? `, ${many(drive.blocks.length, "blocks")} written` : "";
    this.bench.writer.text(row.querySelector(".name"), `${unit}: ${this.called(unit)}, ${place}, ${moves}${written}`);
    row.querySelector("input").checked = Boolean(drive.locked);
  }
}
