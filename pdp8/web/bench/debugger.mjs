// The debugger: steps forward and back, run until; beside them the listing, the registers and core.

import { END_OF_BLOCK } from "../facts.mjs";
import { READABLE } from "../pictures.mjs";
import { find } from "../written.mjs";
import { Core } from "./core.mjs";
import { Listing } from "./listing.mjs";
import { Registers } from "./registers.mjs";

const PLACED = ["address", "word"]; // what a run goes on until that has an address

export class Debugger {
  constructor(bench) {
    this.bench = bench;
    this.listing = new Listing(bench);
    this.registers = new Registers(bench);
    this.core = new Core(bench);
    this.written = 0; // when, in ms
    document.querySelector("#debugger .steps").addEventListener("click", ({ target: { dataset } }) => {
      if (dataset.forward) this.#step(dataset.forward);
      if (dataset.back) this.#back(dataset.back);
    });
    find("run").addEventListener("click", () => this.#run());
    find("halt").addEventListener("click", () => bench.switches.press("stop"));
    find("kind").addEventListener("change", ({ target }) => (find("where").hidden = !PLACED.includes(target.value)));
    find("until").addEventListener("submit", (event) => {
      event.preventDefault();
      this.#run(this.#condition(find("kind").value, parseInt(find("where").value || "0", 8) & 0o7777));
    });
  }

  #step(unit) {
    this.bench.machine.until = null;
    this.bench.history.forward(unit);
    this.bench.show();
  }

  #back(unit) {
    this.bench.machine.processor.run = 0;
    if (!this.bench.history.back(unit)) this.bench.say("nothing is kept from before");
    this.bench.show();
  }

  #run(until = null) {
    this.bench.machine.until = until;
    this.bench.machine.panel.cont();
    this.bench.teletype.started();
    this.bench.touched();
  }

  /** The question whether what was asked for has happened. */
  #condition(kind, address) {
    const { core, processor, teletype } = this.bench.machine;
    const { punch } = teletype;
    const [word, punched] = [core[address], punch.frames.length];
    return {
      address: () => processor.pc === address,
      word: () => core[address] !== word,
      flag: aFlagRises(this.bench.machine),
      frame: () => punch.frames.length > punched,
      block: () => punch.frames.length > punched && punch.frames.at(-1) === END_OF_BLOCK,
    }[kind];
  }

  /** Show the machine; while it is `running`, no more often than can be read. */
  show(running) {
    if (find("debugger").hidden || (running && performance.now() - this.written < READABLE)) return;
    this.written = performance.now();
    this.registers.show();
    this.listing.show();
    this.core.show();
  }
}

/** The question whether a flag of the Teletype has risen since it was last asked. */
function aFlagRises({ bus, processor, teletype: { receiver, transmitter } }) {
  let before = [receiver.flag, transmitter.flag];
  return () => {
    bus.nextEvent(processor.clock); // lets a flag move whose time has come
    const now = [receiver.flag, transmitter.flag];
    const rises = now.some((flag, index) => flag > before[index]);
    before = now;
    return rises;
  };
}
