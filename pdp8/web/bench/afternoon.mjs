// The afternoon: a script of the operator's hands (pdp8/replay/day.py) that leads the page's machine to any instant.
//
//     record ──► Course ──► Script ──► bench.machine at `position`          `on`: the script leads the machine
//                                      touched: taken over, it is yours    `way`: what leads back to the script
//
// Positions are in ticks of 0.05 µs since one o'clock; in slow motion they have parts.

import { Action } from "../../computer/use/operator.mjs";
import { Act, clock, Course, Kind } from "../../replay/day.mjs";
import { Script } from "../../replay/script.mjs";
import { FRAME, TICKS_PER_SECOND as SECOND } from "../../computer/hardware/signals.mjs";
import { dict } from "../translator/runtime.mjs";
import { instruction_at } from "../../computer/watch.mjs";
import { html } from "../html.mjs";
import { DESK, readdress } from "../written.mjs";
import { out } from "./next.mjs";

const SAID = 8 * SECOND; // how long the last action of the operator is shown
const PRESSED = 0.4 * SECOND; // how long a key shows as pressed
const STEP = 5 * SECOND; // of a play as fast as it goes
const SAMPLES = 16; // of the lamps, for a picture
const [READER, PRINTER] = [0o6031, 0o6041]; // KSF and TSF
/** @type {Record<string, string>} */ const TABS = { terminal: "mill", mill: "mill", inspect: "figures" };

export class Afternoon {
  #saying = 0; // the timer of an announcement

  constructor(/** @type {Bench} */ bench) {
    this.bench = bench;
    this.made = /** @type {Script | null} */ (null); // the script
    this.given = /** @type {boolean[]} */ ([]); // the machines of the record that it has
    this.on = this.playing = false;
    this.position = 0;
    this.time = "";
    this.way = html``;
  }

  /** The instant that the address names, in ticks; null if it names none. */
  get asked() {
    const named = /^#(?:workbench&)?t=(\d+(?:\.\d+)?)$/.exec(location.hash);
    return named && Math.round(Number(named[1]) * SECOND);
  }

  /** Give the address of this instant. */
  link() {
    this.bench.give(`${DESK}&t=${this.script.now / SECOND}`);
  }

  /** Play it from one o'clock; where the terminal in Toronto is not to be seen, from the first switch. */
  watch() {
    this.go(0);
    if (out("teletype")) this.go(this.script.day.acts[1].starts);
    this.bench.time.kept = { unit: "character", speed: "60" };
    this.play(true);
  }

  /** The script that leads to any instant, made when it is asked for first. */
  get script() {
    this.made ??= this.#script();
    return this.made;
  }

  #script() {
    const { record: { afternoon: { acts, actions, millStarts, part, read } }, shelf } = this.bench;
    const made = [`${part}.asc`, `${part}.eia`].map((name) => [name, shelf.get(name).frames]);
    const loaded = Object.entries(read).map(([name, frames]) => [name, frames.encode("latin-1")]);
    const [all, done] = [acts.map((/** @type {ConstructorParameters<typeof Act>} */ act) => new Act(...act)), actions.map((/** @type {ConstructorParameters<typeof Action>} */ action) => new Action(...action))];
    return new Script(new Course(part, all, done, dict(/** @type {[string, Bytes][]} */ ([...made, ...loaded])), millStarts));
  }

  /** Let the script have the last of the record's machines that come before a tick. */
  #near(/** @type {number} */ tick) {
    const { record: { afternoon: { machines } }, shelf } = this.bench;
    const at = machines.findLastIndex((/** @type {[number]} */ [kept]) => kept <= tick);
    if (at < 0 || this.given[at]) return;
    this.given[at] = true;
    const [kept, values] = machines[at];
    const piece = (/** @type {string} */ name, /** @type {number} */ from, /** @type {number} */ to) => shelf.get(name).frames.slice(from, to);
    const value = (/** @type {string | [string, number, number] | number} */ written) => (typeof written === "string" ? written.encode("latin-1") : Array.isArray(written) ? piece(...written) : written);
    this.script.keep(kept, dict(Object.entries(values).map(([name, written]) => [name, value(written)])));
  }

  /** Go to an instant, in ticks, and show it. */
  go(/** @type {number} */ tick) {
    this.lead(tick);
    this.#arrived();
  }

  /** The script leads the machine, to an instant. */
  lead(/** @type {number} */ tick) {
    if (!this.on) this.#lead();
    this.#near(tick);
    this.script.to(Math.floor(Math.min(tick, this.script.end)));
    this.position = this.script.now;
  }

  #lead() {
    const { bench } = this;
    if (bench.ready) bench.before = bench.kept;
    bench.drives?.rescue(bench.room.own);
    bench.history.close();
    bench.aim();
    bench.switches?.card.end();
    bench.editor?.stopCounting();
    bench.teletype?.clear();
    this.on = true;
    this.program = null;
    bench.machine = this.script.machine;
    document.body.classList.add("afternoon");
  }

  /** Somebody touches the machine: it is theirs, and stops if the afternoon stood still. */
  takeOver() {
    if (!this.on) return;
    const { bench, script, playing } = this;
    this.release(script.machine, !playing);
    bench.teletype.name(script.mounted);
    bench.why = `You have taken over at ${clock(script.now)}`;
    bench.show();
  }

  /** The script no longer leads the machine; the page has it. */
  release(/** @type {Machine} */ machine, stops = false) {
    this.on = this.playing = false;
    this.bench.adopt(machine, stops);
    this.way = html`<button class="text" data-click="afternoon.back">Back to the afternoon, ${clock(this.script.now)}</button>`;
    if (this.asked !== null) readdress(DESK);
    this.bench.clock.wake(); // it may be running
    document.body.classList.remove("afternoon");
  }

  /** Go on with the script from where it was left. */
  back() {
    this.go(this.script.now);
  }

  /** Go on (1) or back (-1) by a unit. */
  step(/** @type {string} */ unit, /** @type {number} */ direction) {
    this.play(false);
    if (direction > 0) this.script.next(unit);
    else this.script.previous(unit);
    this.#arrived();
  }

  #arrived() {
    this.position = this.script.now;
    this.bench.show();
    if (!this.playing) this.#say();
  }

  /** Announce no instant: something else is to be said. */
  hush() {
    clearTimeout(this.#saying);
  }

  /** Time has stopped at an instant: announce it, and put it into the address. */
  #say() {
    this.hush();
    this.#saying = setTimeout(() => {
      if (!this.on) return;
      const { now, act } = this.script;
      this.bench.tell(`${clock(now)}, ${act.name}. ${this.bench.switches.panel.words}`);
      readdress(`${DESK}&t=${now / SECOND}`);
    }, 150);
  }

  play(/** @type {boolean} */ on) {
    if (on === this.playing) return;
    if (on && this.script.now >= this.script.end) this.go(0);
    this.playing = on;
    if (on) this.bench.clock.wake();
    else this.#arrived();
  }

  /** Let time pass at a speed, until `late` at most; return samples of the lamps, at instants spread over it at random: so
   *  none falls on the same cycle of a loop every time.
   */
  pass(/** @type {number} */ milliseconds, /** @type {number} */ speed, /** @type {number} */ late) {
    const { script } = this;
    if (speed === Infinity) {
      while (performance.now() < late && this.position < script.end) script.to((this.position += STEP));
    } else this.position += (milliseconds / 1000) * SECOND * speed;
    const [from, to] = [script.now, Math.floor(this.position)];
    const count = to - from > SAMPLES ? SAMPLES : 1;
    const samples = Array.from({ length: count }, (_, sample) => {
      const spread = sample + 1 < count ? sample + 1 - Math.random() : sample + 1;
      script.to(Math.floor(from + ((to - from) * spread) / count));
      return script.machine.panel.lamps;
    });
    if (this.position >= script.end) this.play(false);
    return samples;
  }

  /** The slider is dragged: a play waits until it is let go. */
  drag(/** @type {HTMLInputElement} */ { value }) {
    this.dragged ??= this.playing;
    this.play(false);
    this.go(Number(value));
  }

  drop() {
    if (this.dragged) this.play(true);
    this.dragged = /** @type {boolean | undefined} */ (undefined);
  }

  /** The key that is being pressed. */
  get pressed() {
    if (!this.on) return null;
    const { now, action } = this.script;
    return action && now - action.at < PRESSED ? action.key : null;
  }

  /** What the terminal in Toronto has typed and punched, while it does; null otherwise. */
  get terminal() {
    if (!this.on || this.script.act.kind !== Kind.TERMINAL) return null;
    const { day, now } = this.script;
    return { name: `${day.part}.asc`, frames: /** @type {Bytes} */ (day.tapes.get(`${day.part}.asc`)).slice(0, Math.floor(now / FRAME)) };
  }

  show() {
    if (!this.on) return;
    const { bench, script, script: { act, day, mounted, now } } = this;
    bench.time.at(now, script.end, clock(now), act.name);
    bench.teletype.name(mounted);
    if (this.shown !== act || this.program === null) this.#open(act);
    if (!act.program && bench.mill.path === day.path) bench.mill.follow(now - day.mill_starts);
  }

  write() {
    if (!this.on) return;
    const { act, action, machine, now } = this.script;
    const fresh = action && action.at >= act.starts && now - action.at < SAID;
    const doing = fresh ? action.say : waits(machine.processor);
    const caption = html`<span><b>${act.name}.</b> ${act.say} <em>${doing}</em></span>`;
    this.bench.time.says(act.name, html`${caption} <small>Touch a switch, a key or a lever to take over.</small>`);
  }

  /** An act begins: open the pane that belongs to it. */
  #open(/** @type {Act} */ act) {
    const { bench, script: { day } } = this;
    this.shown = act;
    this.program = act.program;
    if (act.program) bench.editor.lay(act.program);
    const tape = `${day.part}.eia`;
    bench.mill.lay(tape, /** @type {Bytes} */ (day.tapes.get(tape)), day.path, "", bench.record.afternoon.band);
    bench.tabs.open(TABS[act.kind] ?? "program");
  }
}

/** What a running processor is waiting for, in words. */
function waits(/** @type {Processor} */ processor) {
  if (!processor.run) return "";
  const { core } = processor;
  const at = instruction_at(processor);
  const around = [core[at], core[(at - 1) & 0o7777]];
  if (around.includes(READER)) return "It waits for the reader.";
  return around.includes(PRINTER) ? "It waits for the punch." : "";
}
