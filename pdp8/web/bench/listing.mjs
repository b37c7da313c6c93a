// The listing beside the machine: its current line lit, and a breakpoint at every address that is pressed.

import { Current } from "../current.mjs";
import { instructionAt } from "../meaning.mjs";
import { escaped, find, octal } from "../written.mjs";

const CORE = 0o10000;

export class Listing {
  constructor(bench) {
    this.bench = bench;
    this.rows = new Map(); // {address: element}
    this.current = new Current(find("lines"));
    this.lay([]);
  }

  /** Show the lines of an assembly. */
  lay(lines) {
    this.current.light(null);
    this.rows.clear();
    find("lines").replaceChildren(...lines.map((line) => this.#row(line)));
    if (!lines.length) find("lines").textContent = "Assemble and load a program to see its listing here.";
    this.#mark();
  }

  #row({ address, word, source }) {
    const row = document.createElement("div");
    row.className = "line";
    const placed = address !== null && address < CORE;
    const number = placed ? `<button aria-label="breakpoint at ${octal(address)}">${octal(address)}</button>` : "<span></span>";
    row.innerHTML = `${number}<b>${placed ? octal(word) : ""}</b><code>${escaped(source)}</code>`;
    if (placed) {
      this.rows.set(address, row);
      row.firstChild.addEventListener("click", () => this.#breakpoint(address));
    }
    return row;
  }

  #breakpoint(address) {
    const { breakpoints } = this.bench.machine.watch;
    if (!breakpoints.discard(address)) breakpoints.add(address);
    this.#mark();
  }

  #mark() {
    const { breakpoints } = this.bench.machine.watch;
    for (const [address, row] of this.rows) row.firstChild.ariaPressed = String(breakpoints.has(address));
  }

  show() {
    this.current.light(this.rows.get(instructionAt(this.bench.machine.processor)) ?? null);
  }
}
