// The registers in octal, the flags and the time; PC, L and AC can be written. And what comes next, in words.

import { STATES } from "../../../pal/isa.mjs";
import { of_word as meaning } from "../../../pal/meaning.mjs";
import { wrote } from "../../computer/watch.mjs";
import { write } from "./core.mjs";
import { find, grouped, octal, seconds } from "../written.mjs";

export class Registers {
  constructor(/** @type {Bench} */ bench) {
    this.bench = bench;
    this.cells = new Map([...find("registers").querySelector("dl").children].map((row) => [row.dataset.register, row.lastElementChild]));
  }

  write() {
    for (const [name, value] of Object.entries(this.#values())) {
      const cell = this.cells.get(name);
      const input = cell.querySelector("input");
      if (!input) this.bench.writer.text(cell, String(value));
      else if (document.activeElement !== input && input.value !== String(value)) input.value = value;
    }
  }

  #values() {
    const { machine } = this.bench;
    const { processor, teletype } = machine;
    return {
      PC: octal(machine.pc),
      L: machine.link,
      AC: octal(machine.ac),
      MA: octal(machine.ma),
      MB: octal(processor.mb),
      IR: processor.ir,
      state: STATES[processor.state],
      ION: processor.ion ? "on" : "off",
      "reader flag": teletype.receiver.flag ? "up" : "down",
      "printer flag": teletype.transmitter.flag ? "up" : "down",
      core: wrote(processor) ? `${octal(machine.ma)} ← ${octal(processor.mb)}` : "–",
      instructions: grouped(processor.instructions),
      "since START": processor.instructions ? seconds(machine.ticks) : "–",
      next: meaning(processor.core[machine.pc], machine.pc)[0],
    };
  }

  set(/** @type {HTMLInputElement} */ input) {
    const name = /** @type {"pc" | "ac" | "link"} */ ({ PC: "pc", AC: "ac", L: "link" }[/** @type {"PC" | "AC" | "L"} */ (input.ariaLabel)]);
    const { ariaLabel, value } = input;
    input.blur();
    write(this.bench, { ariaLabel, value }, { pc: this.bench.machine.memory - 1, ac: 0o7777, link: 1 }[name], (machine, word) => (machine[name] = word));
  }
}
