// How often each word is executed, beside the listing; a machine that is counted runs instruction by instruction.

import { FETCH, in_field } from "../../../pal/isa.mjs";
import { memory_address } from "../../computer/watch.mjs";

export class Counts {
  constructor() {
    this.executed = new Float64Array(0o100000);
  }

  /** A memory cycle has ended. */
  cycle(/** @type {Processor} */ processor) {
    if (processor.state === FETCH) this.executed[memory_address(processor)]++;
  }

  /** A loop of two that waits for a flag was passed over: whole turns of it. */
  waited(/** @type {Processor} */ { pc, extension }, /** @type {number} */ instructions) {
    for (const step of [0, 1]) this.executed[in_field(extension.inst_field, pc + step)] += instructions / 2;
  }
}
