// How often each word is executed, beside the listing; a machine that is counted runs instruction by instruction.

import { FETCH } from "../../../pal/isa.mjs";

export class Counts {
  constructor() {
    this.executed = new Float64Array(0o10000);
  }

  /** A memory cycle has ended. */
  cycle(/** @type {Processor} */ { state, ma }) {
    if (state === FETCH) this.executed[ma]++;
  }

  /** A loop of two that waits for a flag was passed over: whole turns of it. */
  waited(/** @type {Processor} */ { pc }, /** @type {number} */ instructions) {
    for (const step of [0, 1]) this.executed[(pc + step) & 0o7777] += instructions / 2;
  }
}
