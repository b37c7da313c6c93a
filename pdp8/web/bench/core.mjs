// Core as a table, a page of 128 words at a time: a word that has changed is marked, and each can be written over.

import { find, octal } from "../written.mjs";

const PAGE = 0o200;
const WIDE = 8; // words a row
const CELL = `<td><input type="text" maxlength="4" inputmode="numeric"></td>`;

export class Core {
  constructor(bench) {
    this.bench = bench;
    this.page = 1;
    this.seen = []; // the words as they are shown
    find("page").replaceChildren(...Array.from({ length: 0o40 }, (_, page) => new Option(octal(page * PAGE), String(page))));
    find("page").value = String(this.page);
    find("page").addEventListener("change", ({ target }) => this.turn(Number(target.value)));
    find("words").innerHTML = `<tr><th scope="row"></th>${CELL.repeat(WIDE)}</tr>`.repeat(PAGE / WIDE);
    this.heads = [...find("words").querySelectorAll("th")];
    this.cells = [...find("words").querySelectorAll("input")];
    this.cells.forEach((cell, index) => cell.addEventListener("change", () => this.#write(cell, this.first + index)));
    this.turn(this.page);
  }

  /** The first address that is shown. */
  get first() {
    return this.page * PAGE;
  }

  /** Turn to a page. */
  turn(page) {
    this.page = page;
    this.seen = [];
    this.heads.forEach((head, row) => (head.textContent = octal(this.first + row * WIDE)));
    this.cells.forEach((cell, index) => (cell.ariaLabel = `core ${octal(this.first + index)}`));
    this.show();
  }

  #write(cell, address) {
    this.seen = [];
    this.bench.touch(({ processor }) => {
      if (/^[0-7]{1,4}$/.test(cell.value)) processor.deposit(address, parseInt(cell.value, 8));
    });
  }

  show() {
    const { core } = this.bench.machine.processor;
    this.cells.forEach((cell, index) => this.#word(cell, index, core[this.first + index]));
  }

  #word(cell, index, word) {
    const before = this.seen[index];
    const changed = before !== undefined && before !== word;
    if (cell.classList.contains("changed") !== changed) cell.classList.toggle("changed", changed);
    if (before === word) return;
    this.seen[index] = word;
    cell.value = octal(word);
  }
}
