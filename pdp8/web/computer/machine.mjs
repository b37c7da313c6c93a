// The whole PDP-8/L: the one place that knows every part and wires it, and runs it; pdp8/computer/machine.py.
//
//     switches, keys, lamps: panel ── processor ◄─► core
//                                         │
//                                        bus ── 03 receiver ◄─ reader, keyboard   ┐ Teletype
//                                         ├──── 04 transmitter ─► printer, punch  ┘
//                                         ├──── 01 high-speed reader              ┐ if fitted
//                                         └──── 02 high-speed punch               ┘
//
// Nothing here knows a page: it runs in Node.js as it is. A page asks it to go on `to` a tick, and looks.

import { Bus } from "./bus.mjs";
import { HighSpeed } from "./highspeed.mjs";
import { FETCH, halts } from "./isa.mjs";
import { Panel } from "./panel.mjs";
import { Processor } from "./processor.mjs";
import { Teletype } from "./teletype.mjs";
import { FLAG_TICKS, Waiting } from "./waiting.mjs";

export class Machine {
  constructor(highspeed = false) {
    this.bus = new Bus();
    this.teletype = new Teletype();
    this.teletype.connect(this.bus);
    this.processor = new Processor(this.bus);
    this.waiting = new Waiting(this.processor);
    this.panel = new Panel(this.processor);
    this.breakpoints = new Set(); // addresses before whose instruction a run stops
    this.until = null; // a question that is asked after every instruction; a run stops when the answer is true
    this.highspeed = new HighSpeed();
    if (highspeed) this.highspeed.connect(this.bus);
    this.powerUp();
  }

  /** What the power switch does: INITIALIZE, and stand still. */
  powerUp() {
    this.processor.initialize();
    this.processor.run = 0;
  }

  get core() {
    return this.processor.core;
  }

  get ac() {
    return this.processor.lac & 0o7777;
  }

  get link() {
    return this.processor.lac >> 12;
  }

  /** Seconds of machine time since START are these ticks of 0.05 µs. */
  get ticks() {
    return this.processor.clock - this.processor.started;
  }

  /** Put `words`, [address, word] each, into core. */
  load(words) {
    for (const [address, word] of words) this.processor.deposit(Number(address), word & 0o7777);
  }

  /** Go on to the last cycle that ends at or before tick `until`; standing still, just let time pass. */
  to(until) {
    const p = this.processor;
    this.waiting.watched = false;
    this.#goOn();
    while (p.run && p.clock + p.nextCycle() <= until) {
      if (p.next === FETCH) this.waiting.look(until - FLAG_TICKS); // the lamps are those of a turn
      if (p.clock + p.nextCycle() <= until) p.cycle();
    }
    if (!p.run && p.clock < until) p.clock = until;
    this.bus.advance(p.clock);
  }

  /** Run to tick `until` at least, by whole instructions, for `most` of them; return why it ended, "" at a limit. */
  run(until, most = Infinity) {
    const p = this.processor;
    const { breakpoints, waiting } = this;
    const last = p.instructions + most;
    waiting.watched = breakpoints.size > 0 || most < Infinity || this.until !== null;
    this.#goOn();
    let first = true;
    while (p.run && p.clock < until && p.instructions < last) {
      if (!first && breakpoints.size && breakpoints.has(p.pc) && p.next === FETCH) return "breakpoint";
      first = false;
      p.instruction();
      if (this.until !== null && this.until()) return "reached";
      if (p.run && p.next === FETCH) waiting.look(until);
    }
    if (p.run) return "";
    this.bus.advance(p.clock);
    return this.#stopped();
  }

  /** Begin to run again: the operator may have changed anything, so that nothing is known to wait. */
  #goOn() {
    this.bus.advance(this.processor.clock);
    this.waiting.forget();
  }

  /** Why RUN went off. */
  #stopped() {
    const p = this.processor;
    if (p.protect) return "protect";
    return p.state === FETCH && halts(p.mb) ? "halt" : "stop key";
  }

  /** Let time pass while the processor stands still: the Teletype goes on with what it has begun. */
  wait(ticks) {
    this.processor.clock += ticks;
    this.bus.advance(this.processor.clock);
  }

  /** Whether the program waits for a reader whose tape has run out. */
  outOfTape() {
    const p = this.processor;
    if (!this.waiting.endless) return false;
    return [...this.bus].some((device) => device.outOfTape() && (p.ion || this.bus.tested[device.code]));
  }
}
