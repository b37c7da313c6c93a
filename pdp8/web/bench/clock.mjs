// The bench's time: the machine runs while the page is looked at, and nothing is drawn while nothing can change.
//
//     awake ──► a picture, some times a second: run, sample the lamps, show ──► asleep when all stands still

import { lit } from "../brightness.mjs";
import { ISA, TIMES } from "../facts.mjs";
import { Pictures } from "../pictures.mjs";

const BUDGET = 24; // ms of computing for a picture at full speed
const SLICES = 12; // of a picture, each with a look at the lamps
export const SPEEDS = [[1, "as it was"], [10, "10 times"], [100, "100 times"], [Infinity, "as fast as it goes"]];

export class Clock {
  /** `show(brightness, reason)` is called after every picture. */
  constructor(bench, show) {
    this.bench = bench;
    this.show = show;
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
    const ticks = (passed / 1000) * TIMES.SECOND * Math.min(this.speed, 1e6);
    const { brightness, reason } = this.#run(ticks, now);
    this.show(brightness, reason);
    return !document.hidden && this.#moves();
  }

  /** Whether anything can change of itself. */
  #moves() {
    const { machine } = this.bench;
    const { transmitter, receiver } = machine.teletype;
    const busy = transmitter.register || receiver.stage || transmitter.unit;
    return busy || (machine.processor.run && !machine.waiting.endless);
  }

  /** Run for `ticks`, or at full speed as long as there is time; look at the lamps in between. */
  #run(ticks, now) {
    const { machine } = this.bench;
    const shares = {};
    let looks = 0;
    let reason = "";
    const slice = this.speed === Infinity ? TIMES.SECOND / 30 : ticks / SLICES;
    const end = this.speed === Infinity ? Infinity : machine.processor.clock + ticks;
    while (machine.processor.clock < end) {
      const until = Math.min(end, machine.processor.clock + Math.ceil(slice * (0.5 + Math.random())));
      if (machine.processor.run) reason = machine.run(until);
      if (!machine.processor.run && machine.processor.clock < until) machine.wait(until - machine.processor.clock);
      this.#sample(machine, shares);
      looks++;
      if (reason || machine.waiting.endless || performance.now() - now > BUDGET) break;
      if (this.speed === Infinity && !machine.processor.run) break;
    }
    if (!reason && machine.waiting.endless && machine.processor.clock < end && end < Infinity) machine.to(end);
    for (const name in shares) shares[name] /= looks;
    return { brightness: machine.processor.run ? shares : lit(machine), reason };
  }

  /** Look at the lamps in some cycle of the instruction that comes. */
  #sample(machine, shares) {
    const { processor, breakpoints } = machine;
    for (let cycles = Math.floor(Math.random() * 3); cycles && processor.run; cycles--) {
      if (processor.next === ISA.FETCH && (breakpoints.has(processor.pc) || machine.until)) break;
      processor.cycle();
    }
    const lamps = lit(machine);
    for (const name in lamps) shares[name] = (shares[name] ?? 0) + lamps[name];
  }
}
