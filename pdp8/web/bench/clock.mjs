// The page's time: the machine runs while the page is looked at, and nothing is drawn while nothing can change.
//
//     awake ──► a picture, some times a second: run, sample the lamps, show ──► asleep when all stands still
//
// While the processor stands still or waits for ever no time passes, but for what a device has begun. In slow motion
// the machine goes cycle by cycle. In the afternoon it is led by the script.

import { Bus } from "../../computer/hardware/bus.mjs";
import { Panel } from "../../computer/hardware/panel.mjs";
import { Processor } from "../../computer/hardware/processor.mjs";
import { CYCLE, INTERRUPT, NEVER, TICKS_PER_SECOND as SECOND } from "../../computer/hardware/signals.mjs";
import { FETCH } from "../../../pal/isa.mjs";
import { Pictures } from "../pictures.mjs";

const BUDGET = 24; // ms of computing for a picture
const SLICES = 8; // of a picture, each with a look at the lamps
const SLOW = 0.01; // and slower: cycle by cycle
const FORGETS = 0.15; // the share of a measured speed that each picture replaces

export class Clock {
  /** `show(samples, stop)` is called after every picture, with samples of the lamps and the reason why the run ended, "limit" if it goes on. */
  constructor(/** @type {Bench} */ bench, /** @type {(samples: Lamps[] | undefined, reason: string) => void} */ show) {
    this.bench = bench;
    this.show = show;
    this.glimpse = new Glimpse();
    this.due = 0; // ticks that have passed in slow motion and are not yet run
    this.measured = 0; // how many times as fast as it was the machine has run
    this.pictures = new Pictures((passed) => this.#picture(passed, performance.now()), 1);
    document.addEventListener("visibilitychange", () => (document.hidden ? this.#leave() : this.#return()));
  }

  get speed() {
    return this.pictures.speed;
  }

  set speed(speed) {
    this.pictures.speed = speed;
    this.measured = 0;
    this.wake();
  }

  /** The speed that is kept, as measured: "17 x". */
  get kept() {
    const { measured } = this;
    if (!measured) return "";
    return measured >= 0.9 ? `${measured.toFixed(measured < 9.5 ? 1 : 0)} x` : `1 : ${Math.round(1 / measured)}`;
  }

  /** Something was touched: go on, from now. */
  wake() {
    if (!document.hidden) this.pictures.start();
  }

  /** The tab is hidden: the machine stops, and the tab says so. */
  #leave() {
    this.hiddenAt = this.pictures.running ? performance.now() : 0;
    if (!this.hiddenAt) return;
    this.pictures.stop();
    /** @type {string} */ this.title = document.title;
    document.title = `Stopped: ${this.title}`;
  }

  #return() {
    if (this.hiddenAt) {
      document.title = this.title;
      const seconds = Math.round((performance.now() - this.hiddenAt) / 1000);
      this.bench.tell(`The tab was hidden; everything stood still for ${seconds} s.`, true);
    }
    this.hiddenAt = 0;
    this.wake();
  }

  /** Show what happens in some milliseconds; return whether it goes on. The time from `now` on counts, not from the frame's
   *  beginning: where it is drawn slowly nothing would happen.
   */
  #picture(/** @type {number} */ passed, /** @type {number} */ now) {
    const { afternoon, machine } = this.bench;
    if (afternoon.on && !afternoon.playing) return false;
    const before = afternoon.on ? afternoon.position : machine.processor.clock;
    const more = afternoon.on ? this.#led(passed, now) : this.#live(passed, now);
    const ticks = (afternoon.on ? afternoon.position : this.bench.machine.processor.clock) - before;
    const speed = ticks / SECOND / (passed / 1000);
    if (ticks > 0 && passed > 0) this.measured += (speed - this.measured) * (this.measured ? FORGETS : 1);
    return more && !document.hidden;
  }

  #led(/** @type {number} */ passed, /** @type {number} */ now) {
    const { afternoon } = this.bench;
    this.show(afternoon.pass(passed, this.speed, now + BUDGET), "limit");
    return afternoon.on ? afternoon.playing : this.#moves();
  }

  #live(/** @type {number} */ passed, /** @type {number} */ now) {
    const { machine, room } = this.bench;
    const speed = room.open ? 1 : this.speed; // the room has no other
    const ticks = (passed / 1000) * SECOND * speed;
    const samples = /** @type {Lamps[]} */ ([]);
    let reason = "limit";
    if (!machine.processor.run) {
      if (this.#busy()) machine.wait(Math.min(ticks, SECOND) / SECOND);
    } else if (speed <= SLOW) reason = this.#crawl(ticks, now);
    else reason = this.bench.history.together(() => this.#run(Math.ceil(ticks), now, samples));
    this.show(machine.processor.run && samples.length ? samples : [machine.panel.lamps], reason);
    return this.#moves();
  }

  /** Whether a device is at work: a character on its way in, or out. */
  #busy() {
    const { bus, processor } = this.bench.machine;
    return bus.next_event(processor.clock) < NEVER;
  }

  /** Whether anything can change of itself. */
  #moves() {
    const { machine } = this.bench;
    return machine.processor.run ? !machine.waiting.endless : this.#busy();
  }

  /** Go on cycle by cycle for `ticks`; return why it ended. */
  #crawl(/** @type {number} */ ticks, /** @type {number} */ now) {
    const { machine, machine: { processor }, until } = this.bench;
    this.due += ticks;
    while (this.due >= CYCLE && performance.now() - now < BUDGET) {
      const { clock } = processor;
      const reason = until.cycle(machine);
      this.due -= processor.clock - clock;
      if (reason !== "limit") return reason;
    }
    return "limit";
  }

  /** Run for `ticks`, or at full speed as long as there is time; return why it ended. */
  #run(/** @type {number} */ ticks, /** @type {number} */ now, /** @type {Lamps[]} */ samples) {
    const { machine, until } = this.bench;
    const { processor } = machine;
    const end = processor.clock + ticks;
    const slice = Math.min(SECOND / 30, ticks / SLICES);
    while (processor.clock < end && performance.now() - now < BUDGET) {
      const room = Math.max(1, Math.min(end - processor.clock, Math.ceil(slice * (0.5 + Math.random()))));
      const reason = until.run(machine, room);
      samples.push(this.glimpse.of(machine));
      if (reason !== "limit") return reason;
    }
    return "limit";
  }
}

/** The lamps as they are in some cycle of the instruction that comes: a second processor runs it, and writes nothing. */
class Glimpse {
  constructor() {
    this.processor = new Processor(new Bus());
    this.processor.deposit = () => {};
    this.panel = new Panel(this.processor, () => {});
  }

  of(/** @type {Machine} */ machine) {
    const { processor } = this;
    const { lac, pc, ma, mb, ir, state, next, sr, ion, protect, run, core } = machine.processor;
    if (next > INTERRUPT) return machine.panel.lamps; // a data break, which only its device can go on with
    Object.assign(processor.extension, machine.processor.extension);
    Object.assign(processor, { lac, pc, ma, mb, ir, state, next, sr, ion, protect, run, core, _core: core, ion_delayed: 0 });
    for (let cycles = Math.floor(Math.random() * 3); cycles && processor.run; cycles--) {
      processor.cycle();
      if (processor.next === FETCH) break;
    }
    return this.panel.lamps;
  }
}
