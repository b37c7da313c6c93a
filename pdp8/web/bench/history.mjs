// Steps, forward and back, by cycle, instruction, character and block. The past is kept by computer/past/history.py.

import { TICKS_PER_SECOND } from "../../computer/hardware/signals.mjs";
import { History as Past } from "../../computer/past/history.mjs";
import * as rewind from "../../computer/past/rewind.mjs";
import { until } from "./until.mjs";

const MEMORY = 32 << 20; // bytes
const FAR = { character: 3 * TICKS_PER_SECOND, block: 30 * TICKS_PER_SECOND }; // ticks that a step may take at most
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

  /** One step of `unit` forward; return why it ended, "limit" if by itself. */
  forward(unit) {
    const { machine } = this.bench;
    const { processor } = machine;
    if (unit === "instruction") return machine.run(null, 1).reason;
    if (unit === "cycle") {
      processor.run = 1;
      processor.cycle();
      return processor.run ? "limit" : "halt";
    }
    const goal = until(machine, unit);
    const end = processor.clock + FAR[unit];
    const { reason } = this.together(() => {
      let stop;
      do stop = goal.run(machine, end - processor.clock);
      while (stop.reason === "limit" && processor.clock < end);
      return stop;
    });
    return reason === "reached" ? "limit" : reason;
  }

  /** One step of `unit` back. Throws HistoryError where the past does not go back so far. */
  back(unit) {
    BACK[unit](this.past, 1);
  }
}
