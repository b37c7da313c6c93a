// Steps, forward and back, by cycle, instruction and character. Back is forward again from an instant that was kept.

import { ISA } from "../facts.mjs";
import { restore, snapshot } from "../computer/snapshot.mjs";

const KEPT = 300;
const FAR = 20_000_000 * 3; // ticks that a step may take at most

export class History {
  constructor(bench) {
    this.bench = bench;
    this.kept = [];
  }

  /** Keep the machine as it is: after every picture, step and touch. */
  keep() {
    const { clock } = this.bench.machine.processor;
    if (this.kept.at(-1)?.clock === clock) this.kept.pop();
    this.kept.push({ clock, characters: this.#characters(), saved: snapshot(this.bench.machine) });
    if (this.kept.length > KEPT) this.kept.shift();
  }

  forget() {
    this.kept = [];
  }

  /** Characters read and printed so far. */
  #characters() {
    const { reader, printer, keyboard } = this.bench.machine.teletype;
    return reader.position + printer.frames.length - keyboard.waiting.length;
  }

  /** One step of `unit` forward. */
  forward(unit) {
    const { machine } = this.bench;
    const { processor } = machine;
    processor.run = 1;
    const characters = this.#characters();
    const end = processor.clock + FAR;
    const goesOn = () => processor.run && processor.clock < end && !machine.waiting.endless;
    do this.#once(unit);
    while (unit === "character" && this.#characters() === characters && goesOn());
    machine.bus.advance(processor.clock);
    processor.run = 0;
    this.keep();
  }

  #once(unit) {
    const { machine } = this.bench;
    if (unit === "cycle") machine.processor.cycle();
    else if (unit === "instruction") machine.run(Infinity, 1);
    else machine.run(machine.processor.clock + FAR, 50);
  }

  /** One step of `unit` back; false if nothing was kept that lies before. */
  back(unit) {
    const { machine } = this.bench;
    const { processor } = machine;
    const now = processor.clock;
    const characters = this.#characters();
    const before = (kept) => kept.clock < now && (unit !== "character" || kept.characters < characters);
    const index = this.kept.findLastIndex(before);
    if (index < 0) return false;
    const from = this.kept[index];
    this.kept.length = index + 1;
    restore(machine, from.saved);
    processor.run = 1;
    const target = this.#last(unit, now, characters);
    restore(machine, from.saved);
    processor.run = 1;
    while (processor.run && processor.clock < target) processor.cycle();
    machine.bus.advance(processor.clock);
    processor.run = 0;
    return true;
  }

  /** The last clock before `now` at which a step of `unit` ends. */
  #last(unit, now, characters) {
    const { machine } = this.bench;
    const { processor } = machine;
    let last = processor.clock;
    while (processor.run) {
      processor.cycle();
      machine.bus.advance(processor.clock);
      if (processor.clock >= now || (unit === "character" && this.#characters() >= characters)) break;
      if (unit === "cycle" || processor.next === ISA.FETCH) last = processor.clock;
    }
    return last;
  }
}
