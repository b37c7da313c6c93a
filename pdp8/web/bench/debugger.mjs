// The debugger: steps forward and back, run until; beside them the listing, the registers and core.

import { READABLE } from "../pictures.mjs";
import { find } from "../written.mjs";
import { Core } from "./core.mjs";
import { Listing } from "./listing.mjs";
import { Registers } from "./registers.mjs";
import { until, Until } from "./until.mjs";

const PLACED = ["address", "word"]; // what a run goes on until that has an address

export class Debugger {
  constructor(bench) {
    this.bench = bench;
    this.listing = new Listing(bench);
    this.registers = new Registers(bench);
    this.core = new Core(bench);
    this.written = 0; // when, in ms
    document.querySelector("#debugger .steps").addEventListener("click", (/** @type {any} */ { target: { dataset } }) => {
      if (dataset.forward) this.#step(dataset.forward);
      if (dataset.back) this.#back(dataset.back);
    });
    find("run").addEventListener("click", () => this.#run());
    find("halt").addEventListener("click", () => bench.switches.press("stop"));
    find("kind").addEventListener("change", ({ target }) => (find("where").hidden = !PLACED.includes(target.value)));
    find("until").addEventListener("submit", (event) => {
      event.preventDefault();
      this.#run(until(this.bench.machine, find("kind").value, parseInt(find("where").value || "0", 8) & 0o7777));
    });
  }

  #step(unit) {
    const { bench } = this;
    bench.until = new Until();
    const reason = bench.history.forward(unit);
    bench.machine.processor.run = 0;
    if (reason === "limit") bench.show();
    else bench.ended(reason);
  }

  #back(unit) {
    const { bench } = this;
    try {
      bench.history.back(unit);
      bench.machine.processor.run = 0;
      bench.say("");
    } catch (error) {
      bench.machine.processor.run = 0;
      bench.say(String(error));
    }
  }

  #run(goal = new Until()) {
    this.bench.until = goal;
    this.bench.machine.panel.cont();
    this.bench.teletype.started();
    this.bench.touched();
  }

  /** Show the machine; while it is `running`, no more often than can be read. */
  show(_, running) {
    if (find("debugger").hidden || (running && performance.now() - this.written < READABLE)) return;
    this.written = performance.now();
    this.registers.show();
    this.listing.show();
    this.core.show();
  }
}
