// Loops that only wait, and how many turns of one can be passed over at once: pdp8/computer/speed/waiting.py in JavaScript.
//
// A program waits when it is again as it was: the same PC, AC, L and core, and since then no device was commanded and
// no flag moved. Every further turn is the same turn until the next event of a device. The count of instructions and
// of ticks stays exact. A loop that no event can end is `endless`; the page's clock goes on, so its turns pass too.
//
// Besides those, ISZ X, JMP .-1 is counted down at once, which in Python engine.py does.

import { ISA, TIMES } from "../facts.mjs";
import { NEVER } from "./bus.mjs";
import { FETCH, IOT, ISZ, JMP, jumpsTo, refersTo, testsFlag } from "./isa.mjs";

const { CYCLE, IO_TICKS } = TIMES;

const PERIOD = 200_000; // ticks between two looks at a loop that tests no flag
const TESTS = 8; // flag tests of one ring: after so many the state remembered is given up for a new one
const STEPS = 5_000; // instructions of one ring that has no flag test
export const FLAG_TICKS = CYCLE + IO_TICKS + CYCLE; // a turn of KSF, JMP .-1
const DELAY_TICKS = 3 * CYCLE; // a turn of ISZ X, JMP .-1

/** Watches a running processor; `look` belongs after every instruction. */
export class Waiting {
  constructor(processor) {
    this.processor = processor;
    this.endless = false; // set when the processor stands in a loop that no event will ever end
    this.watched = false; // set while somebody looks at single instructions: a turn is seen before others are passed over
    this.nextLook = 0; // the tick from which the next look is due wherever the processor is
    // Set while every instruction is looked at, because core did not change since the last look of this kind.
    this.stepping = false;
    this.core = null; // core as it was remembered, if that is needed because words were written since
    this.#remember();
  }

  #remember() {
    const p = this.processor;
    this.quietUntil = p.bus.nextEvent(p.clock);
    this.pc = p.pc;
    this.lac = p.lac;
    this.sr = p.sr;
    this.memProt = p.memProt;
    this.ion = p.ion;
    this.actions = p.bus.actions;
    this.clock = p.clock;
    this.instructions = p.instructions;
    this.tries = TESTS;
    this.stepping = false;
    this.core = null;
    this.endless = false;
    this.writes = p.writes;
    p.bus.tested.fill(0);
  }

  /** Remember nothing: the operator has touched something, or what is passed over next has to be seen first. */
  forget() {
    this.actions = -1;
  }

  /** Look at the processor between two instructions; pass over what it would only wait through, up to `until`. */
  look(until) {
    const p = this.processor;
    if (this.stepping) {
      this.#compare(until);
    } else if (p.clock >= this.nextLook) {
      this.#lookAnywhere();
    } else {
      const word = p.core[p.pc];
      if (word >> 9 === IOT) {
        if (testsFlag(word) && !this.#waitsForFlag(until)) this.#compare(until);
      } else if (word >> 9 === JMP) {
        if (jumpsTo(p.pc, word, p.pc)) this.#compare(until);
      } else if (word >> 9 === ISZ) {
        this.#countDown(word, until);
      }
    }
  }

  /** Whether KSF, JMP .-1 or one of its kin is here, which needs no second turn to be known; pass over its turns. */
  #waitsForFlag(until) {
    const p = this.processor;
    const event = p.bus.nextEvent(p.clock);
    if (this.watched || event === NEVER || !p.run || p.next !== FETCH || p.ion !== p.ionDelayed) return false;
    const code = (p.core[p.pc] >> 3) & 0o77;
    if (code === 0 || !this.#loops()) return false;
    if (p.ion && p.bus.request(p.clock)) return false;
    const device = p.bus.device(code);
    if (device === null || !device.flag) this.#pass(event, until, FLAG_TICKS, 2);
    return true;
  }

  /** Remember, and if core stood still since the last time, compare what follows step by step. */
  #lookAnywhere() {
    const p = this.processor;
    this.nextLook = p.clock - (p.clock % PERIOD) + PERIOD;
    const still = p.bus.actions === this.actions && p.clock < this.quietUntil && this.#unchanged();
    this.#remember();
    if (still) {
      this.stepping = true;
      this.tries = STEPS;
    }
    this.core = p.core.slice();
  }

  #unchanged() {
    const p = this.processor;
    return p.writes === this.writes || (this.core !== null && same(p.core, this.core));
  }

  #compare(until) {
    const p = this.processor;
    if (p.bus.actions !== this.actions || p.clock >= this.quietUntil) {
      this.#remember();
    } else if (p.pc !== this.pc || p.lac !== this.lac || p.next !== FETCH) {
      if (--this.tries === 0) this.#remember();
    } else if (p.ion !== this.ion || p.sr !== this.sr || p.memProt !== this.memProt) {
      this.#remember();
    } else if (this.#unchanged()) {
      this.#passTurns(until);
    } else {
      this.#remember();
      this.core = p.core.slice();
    }
  }

  #passTurns(until) {
    const p = this.processor;
    const ticks = p.clock - this.clock;
    const count = p.instructions - this.instructions;
    const event = p.bus.nextEvent(p.clock);
    if (event === this.quietUntil && count > 0) this.#pass(event, until, ticks, count);
    if (event === NEVER && this.quietUntil === NEVER) {
      this.endless = true;
      this.clock = p.clock;
      this.instructions = p.instructions;
    } else {
      this.#remember();
    }
  }

  /** Pass over the turns of `count` instructions in `ticks` that end before `event` and `until`. */
  #pass(event, until, ticks, count) {
    const p = this.processor;
    const turns = Math.floor((Math.min(event, until) - 1 - p.clock) / ticks);
    if (turns <= 0) return;
    p.clock += turns * ticks;
    p.instructions += turns * count;
    this.nextLook = Math.max(this.nextLook, p.clock - (p.clock % PERIOD) + PERIOD);
  }

  /** Whether a direct JMP to the instruction at PC follows it. */
  #loops() {
    const p = this.processor;
    const following = (p.pc + 1) & 0o7777;
    return jumpsTo(p.pc, p.core[following], following);
  }

  /** Count ISZ X, JMP .-1 down, short of its end, of the next event under ION and of `until`. */
  #countDown(word, until) {
    const p = this.processor;
    if (word & ISA.INDIRECT || p.memProt || this.watched || p.next !== FETCH || !p.run) return;
    const counter = refersTo(word, p.pc);
    if (!this.#loops() || counter === p.pc || counter === ((p.pc + 1) & 0o7777)) return;
    if (p.ion && (!p.ionDelayed || p.bus.request(p.clock))) return;
    const end = p.ion ? Math.min(until, p.bus.nextEvent(p.clock)) : until;
    const turns = Math.min(0o7776 - p.core[counter], Math.floor((end - 1 - p.clock) / DELAY_TICKS));
    if (turns <= 0) return;
    p.deposit(counter, p.core[counter] + turns);
    p.clock += turns * DELAY_TICKS;
    p.instructions += turns * 2;
  }
}

function same(one, other) {
  for (let address = 0; address < one.length; address++) if (one[address] !== other[address]) return false;
  return true;
}
