// Core as a table, a page of 128 words at a time: a word that has changed is marked, and each can be written over.

import { until } from "../../computer/use/goals.mjs";
import { html, put } from "../html.mjs";
import { find, octal } from "../written.mjs";

const PAGE = 0o200;
const WIDE = 8; // words a row
const CELL = html`<td><input type="text" maxlength="4" inputmode="numeric" data-change="core.set"></td>`;

/** Let somebody write a word into a field, which takes no more than `most`; where it cannot be, say so. */
export function write(/** @type {Bench} */ bench, /** @type {{ ariaLabel: string | null; value: string }} */ { ariaLabel, value }, /** @type {number} */ most, /** @type {(machine: Machine, word: number) => void} */ act) {
  const word = /^[0-7]+$/.test(value) ? parseInt(value, 8) : NaN;
  bench.touch((machine) => word <= most && act(machine, word));
  if (!(word <= most)) bench.tell(`${ariaLabel} ${value}: 0 to ${octal(most, 1)} in octal is allowed`, true);
}

export class Core {
  constructor(/** @type {Bench} */ bench) {
    this.bench = bench;
    this.#offer(1);
    put(find("words"), Array(PAGE / WIDE).fill(html`<tr><th scope="row"></th>${Array(WIDE).fill(CELL)}</tr>`));
    this.heads = [...find("words").querySelectorAll("th")];
    this.cells = [...find("words").querySelectorAll("input")];
    this.turn();
  }

  /** Offer all pages of the machine's core, with one chosen. */
  #offer(/** @type {number} */ chosen) {
    this.words = this.bench.machine.memory;
    const pages = Array.from({ length: this.words / PAGE }, (_, page) => new Option(octal(page * PAGE), String(page), page === chosen, page === chosen));
    find("page").replaceChildren(...pages);
  }

  /** Turn to the page that is chosen. */
  turn() {
    /** @type {number} */ this.first = Number(find("page").value) * PAGE;
    /** @type {number[]} */ this.seen = []; // the words as they are shown
    this.heads.forEach((head, row) => (head.textContent = octal(this.first + row * WIDE)));
    this.cells.forEach((cell, index) => (cell.ariaLabel = `core ${octal(this.first + index)}`));
    this.write();
  }

  /** Run until what the form asks for. */
  runUntil() {
    const { bench } = this, kind = find("kind").value, where = parseInt(find("where").value || "0", 8);
    bench.afternoon.takeOver();
    if (/address|word/.test(kind) && bench.lacks("word", where)) return;
    bench.aim(); // the goal before may watch the same word
    bench.time.run(until(bench.machine, kind, where));
  }

  set(/** @type {HTMLInputElement} */ cell) {
    this.seen = [];
    write(this.bench, cell, 0o7777, ({ processor }, word) => processor.deposit(this.first + this.cells.indexOf(cell), word));
  }

  write() {
    if (find("debugger").hidden) return;
    const { memory, processor: { core } } = this.bench.machine;
    if (memory !== this.words) {
      this.#offer(Math.min(this.first / PAGE, memory / PAGE - 1));
      return this.turn();
    }
    this.cells.forEach((cell, index) => this.#word(cell, index, core[this.first + index]));
  }

  #word(/** @type {HTMLInputElement} */ cell, /** @type {number} */ index, /** @type {number} */ word) {
    const before = this.seen[index];
    cell.classList.toggle("changed", before !== undefined && before !== word);
    if (before === word) return;
    this.seen[index] = word;
    cell.value = octal(word);
  }
}
