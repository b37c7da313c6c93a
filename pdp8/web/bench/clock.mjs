// The bench's time: the machine runs while the page is looked at, and nothing is drawn while nothing can change.
//
//     awake ──► a picture, some times a second: run, sample the lamps, show ──► asleep when all stands still
//
// While the processor stands still or waits for ever no time passes, but for a character on its way in.

import { lit } from "../brightness.mjs";
import { Bus } from "../../computer/hardware/bus.mjs";
import { Processor } from "../../computer/hardware/processor.mjs";
import { TICKS_PER_SECOND as SECOND } from "../../computer/hardware/signals.mjs";
import { FETCH } from "../../../pal/isa.mjs";
import { Pictures } from "../pictures.mjs";

const BUDGET = 24; // ms of computing for a picture
const SLICES = 12; // of a picture, each with a look at the lamps
/** @type {[number, string][]} */
export const SPEEDS = [[1, "as it was"], [10, "10 times"], [100, "100 times"], [Infinity, "as fast as it goes"]];

export class Clock {
  /** `show(brightness, stop)` is called after every picture; `stop` is how a run ended, if it ended. */
  constructor(bench, show) {
    this.bench = bench;
    this.show = show;
    this.glimpse = new Glimpse();
    this.pictures = new Pictures((passed, now) => this.#picture(passed, now), 1);
    document.addEventListener("visibilitychange", () => document.hidden || this.wake());
  }

  get speed() {
    return this.pictures.speed;
  }

  set speed(speed) {
    this.pictures.speed = speed;
  }

  /** Something was touched: go on, from now. */
  wake() {
    this.pictures.start();
  }

  /** Show what the machine does in some milliseconds; return whether it goes on. */
  #picture(passed, now) {
    const { machine } = this.bench;
    const ticks = Math.ceil((passed / 1000) * SECOND * Math.min(this.speed, SPEEDS[2][0]));
    const shares = [];
    let stop = null;
    if (machine.processor.run) stop = this.bench.history.together(() => this.#run(ticks, now, shares));
    else if (this.#busy()) machine.wait(ticks / SECOND);
    this.show(machine.processor.run && shares.length ? mean(shares) : lit(machine), stop);
    return !document.hidden && this.#moves();
  }

  /** Whether a character is on its way in. */
  #busy() {
    const { receiver } = this.bench.machine.teletype;
    return receiver.stage > 0 || receiver.keyboard.waiting.length > 0;
  }

  /** Whether anything can change of itself. */
  #moves() {
    const { machine } = this.bench;
    return machine.processor.run ? !machine.waiting.endless : this.#busy();
  }

  /** Run for `ticks`, or at full speed as long as there is time; return how it ended, null if it goes on. */
  #run(ticks, now, shares) {
    const { machine, until } = this.bench;
    const { processor } = machine;
    const end = this.speed === Infinity ? Infinity : processor.clock + ticks;
    const slice = this.speed === Infinity ? SECOND / 30 : ticks / SLICES;
    while (processor.clock < end && performance.now() - now < BUDGET) {
      const room = Math.max(1, Math.min(end - processor.clock, Math.ceil(slice * (0.5 + Math.random()))));
      const stop = until.run(machine, room);
      shares.push(this.glimpse.of(machine));
      if (stop.reason !== "limit") return stop;
    }
    return null;
  }
}

/** The lamps as they are in some cycle of the instruction that comes: a second processor runs it, and writes nothing. */
class Glimpse {
  constructor() {
    this.processor = new Processor(new Bus());
    this.processor.deposit = () => {};
  }

  of(machine) {
    const { processor } = this;
    const { lac, pc, ma, mb, ir, state, next, sr, ion, protect, run, core } = machine.processor;
    Object.assign(processor, { lac, pc, ma, mb, ir, state, next, sr, ion, protect, run, core, _core: core, ion_delayed: 0 });
    for (let cycles = Math.floor(Math.random() * 3); cycles && processor.run; cycles--) {
      processor.cycle();
      if (processor.next === FETCH) break;
    }
    return lit({ processor });
  }
}

function mean(shares) {
  const all = {};
  for (const lamps of shares) for (const name in lamps) all[name] = (all[name] ?? 0) + lamps[name] / shares.length;
  return all;
}
