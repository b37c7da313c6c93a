// The debugger: registers and core, and what a run goes on until.

import { READABLE } from "../pictures.mjs";
import { find } from "../written.mjs";
import { Core } from "./core.mjs";
import { Registers } from "./registers.mjs";
import { until } from "./until.mjs";

const PLACED = ["address", "word"]; // what a run goes on until that has an address

export class Debugger {
  constructor(bench) {
    this.registers = new Registers(bench);
    this.core = new Core(bench);
    this.written = 0; // when, in ms
    find("kind").addEventListener("change", ({ target }) => (find("where").hidden = !PLACED.includes(target.value)));
    find("until").addEventListener("submit", (event) => {
      event.preventDefault();
      bench.afternoon.takeOver();
      bench.time.run(until(bench.machine, find("kind").value, parseInt(find("where").value || "0", 8) & 0o7777));
    });
  }

  /** Show the machine; while it is `running`, no more often than can be read. */
  show(_, running) {
    if (running && performance.now() - this.written < READABLE) return;
    this.written = performance.now();
    this.registers.show();
    if (!find("debugger").hidden) this.core.show();
  }
}
