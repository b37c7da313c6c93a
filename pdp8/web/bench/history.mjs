// Steps, forward and back, by cycle, instruction and character. The past is kept by computer/past/history.py.

import { TICKS_PER_SECOND } from "../../computer/hardware/signals.mjs";
import { History as Past } from "../../computer/past/history.mjs";
import * as rewind from "../../computer/past/rewind.mjs";
import { until } from "./until.mjs";

const MEMORY = 32 << 20; // bytes
const FAR = 3 * TICKS_PER_SECOND; // ticks that a step may take at most
const GLANCE = 0.001; // seconds between two looks whether a character has passed
const BACK = { block: rewind.blocks, cycle: rewind.cycles, instruction: rewind.instructions, character: rewind.characters };

export class History {
  constructor(bench) {
    this.bench = bench;
    this.begin();
  }

  /** Begin again, with the machine as it stands. */
  begin() {
    this.past = new Past(this.bench.machine, MEMORY);
  }

  /** Record no more. */
  end() {
    this.past.close();
  }

  /** Let `work` do many runs that are kept as one; it returns how the last ended, null if by its limit. */
  together(work) {
    const { machine } = this.bench;
    this.past.begins();
    machine.recorder = null;
    let stop = null;
    try {
      stop = work();
    } finally {
      machine.recorder = this.past;
      this.past.ended(stop?.reason ?? "limit");
    }
    return stop;
  }

  /** Characters read and printed so far. */
  #characters() {
    const { reader, printer, keyboard } = this.bench.machine.teletype;
    return reader.position + printer.frames.length - keyboard.waiting.length;
  }

  /** One step of `unit` forward; return why it ended, "limit" if by itself. */
  forward(unit) {
    const { machine } = this.bench;
    if (unit === "cycle") return this.#cycle();
    if (unit === "instruction") return machine.run(null, 1).reason;
    const characters = this.#characters();
    const end = machine.processor.clock + FAR;
    const glances = () => {
      let stop;
      do stop = machine.run(GLANCE);
      while (stop.reason === "limit" && this.#characters() === characters && machine.processor.clock < end);
      return stop;
    };
    if (unit === "character") return this.together(glances).reason;
    const block = until(machine, "block");
    const { reason } = block.run(machine, 10 * FAR);
    block.over();
    return reason === "reached" ? "limit" : reason;
  }

  #cycle() {
    const { processor } = this.bench.machine;
    processor.run = 1;
    processor.cycle();
    return processor.run ? "limit" : "halt";
  }

  /** One step of `unit` back. Throws HistoryError where the past does not go back so far. */
  back(unit) {
    BACK[unit](this.past, 1);
  }
}
