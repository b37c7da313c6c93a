// The debugger: the listing with its line lit, breakpoints, steps forward and back, run until, registers and core.

import { Current } from "../current.mjs";
import { END_OF_BLOCK, STATES } from "../facts.mjs";
import { inWords, mnemonic } from "../meaning.mjs";
import { escaped, find, grouped, octal, seconds } from "../written.mjs";

const UNITS = ["cycle", "instruction", "character"];
const PAGE = 0o200;
const WIDE = 8; // words a row

export class Debugger {
  constructor(bench) {
    this.bench = bench;
    this.lines = new Map(); // {address: element}
    this.current = new Current(find("lines"));
    this.page = 1;
    this.cells = [];
    this.#tools();
    this.#core();
    this.list([]);
  }

  #tools() {
    const steps = UNITS.map((unit) => `<span class="step"><button class="text" data-back="${unit}" aria-label="Back a ${unit}">←</button><button class="text" data-forward="${unit}">${unit} →</button></span>`);
    document.querySelector("#debugger .tools").innerHTML = `${steps.join("")}
      <button class="text go" id="run">Run</button><button class="text" id="halt">Stop</button>
      <form id="until"><label>until <select id="kind" aria-label="Run until"><option value="address">address</option><option value="word">word changes</option><option value="flag">a flag rises</option><option value="frame">a frame is punched</option><option value="block">a block is punched</option></select></label>
      <input id="where" type="text" size="5" aria-label="Address, octal" placeholder="0200" pattern="[0-7]{1,4}"><button class="text">Go</button></form>`;
    const click = (selector, act) => document.querySelectorAll(selector).forEach((button) => button.addEventListener("click", () => act(button)));
    click("#debugger [data-forward]", ({ dataset }) => this.#step(dataset.forward));
    click("#debugger [data-back]", ({ dataset }) => this.#back(dataset.back));
    click("#run", () => this.#run());
    click("#halt", () => this.bench.switches.press("stop"));
    find("kind").addEventListener("change", () => (find("where").hidden = !["address", "word"].includes(find("kind").value)));
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
    const { punch, receiver, transmitter } = teletype;
    const word = core[address];
    const punched = punch.frames.length;
    const flags = [receiver.flag, transmitter.flag];
    return {
      address: () => processor.pc === address,
      word: () => core[address] !== word,
      flag: () => (receiver.due <= processor.clock && receiver.advance(processor.clock), receiver.flag > flags[0] || transmitter.flag > flags[1] || ((flags[0] = receiver.flag), (flags[1] = transmitter.flag), false)),
      frame: () => punch.frames.length > punched,
      block: () => punch.frames.length > punched && punch.frames.at(-1) === END_OF_BLOCK,
    }[kind];
  }

  /** Show the lines of an assembly. */
  list(lines) {
    const place = find("lines");
    this.lines.clear();
    this.current.light(null);
    place.replaceChildren();
    for (const { address, word, source } of lines) {
      const row = document.createElement("div");
      row.className = "line";
      const known = address !== null && address < 0o10000;
      row.innerHTML = `${known ? `<button aria-pressed="false" aria-label="breakpoint at ${octal(address)}">${octal(address)}</button>` : "<span></span>"}<b>${known ? octal(word) : ""}</b><code>${escaped(source)}</code>`;
      if (known) {
        this.lines.set(address, row);
        row.firstChild.addEventListener("click", () => this.#breakpoint(address));
      }
      place.append(row);
    }
    if (!lines.length) place.textContent = "Assemble and load a program to see its listing here.";
    this.#marks();
  }

  #breakpoint(address) {
    const { breakpoints } = this.bench.machine;
    if (!breakpoints.delete(address)) breakpoints.add(address);
    this.#marks();
  }

  #marks() {
    for (const [address, row] of this.lines) row.firstChild.ariaPressed = String(this.bench.machine.breakpoints.has(address));
  }

  /** Core, a page of 128 words at a time; a word can be written over. */
  #core() {
    const pages = Array.from({ length: 0o40 }, (_, page) => `<option value="${page}">${octal(page * PAGE)}</option>`);
    const rows = Array.from({ length: PAGE / WIDE }, () => `<tr><th scope="row"></th>${`<td><input type="text" maxlength="4" inputmode="numeric"></td>`.repeat(WIDE)}</tr>`);
    find("core").innerHTML = `<label>Core from <select id="page">${pages.join("")}</select></label><table><tbody>${rows.join("")}</tbody></table>`;
    this.cells = [...find("core").querySelectorAll("input")];
    this.heads = [...find("core").querySelectorAll("th")];
    find("page").value = String(this.page);
    find("page").addEventListener("change", (event) => {
      this.page = Number(event.target.value);
      this.seen = [];
      this.show();
    });
    this.cells.forEach((cell, index) => cell.addEventListener("change", () => this.#write(cell, this.page * PAGE + index)));
    this.seen = [];
  }

  #write(cell, address) {
    if (/^[0-7]{1,4}$/.test(cell.value)) this.bench.machine.processor.deposit(address, parseInt(cell.value, 8));
    this.seen = [];
    this.bench.touched();
  }

  show() {
    if (find("debugger").hidden) return;
    this.#registers();
    const { core, processor } = this.bench.machine;
    this.current.light(this.lines.get(processor.run ? processor.at : processor.pc) ?? null);
    const first = this.page * PAGE;
    if (this.shown !== first) this.heads.forEach((head, row) => (head.textContent = octal(first + row * WIDE)));
    this.cells.forEach((cell, index) => {
      const word = core[first + index];
      const changed = this.seen[index] !== undefined && this.seen[index] !== word;
      if (cell.classList.contains("changed") !== changed) cell.classList.toggle("changed", changed);
      if (this.seen[index] === word && this.shown === first) return;
      this.seen[index] = word;
      cell.value = octal(word);
      cell.ariaLabel = `core ${octal(first + index)}`;
    });
    this.shown = first;
  }

  #registers() {
    const { machine, writer } = this.bench;
    const { processor, teletype } = machine;
    const following = machine.core[processor.pc];
    const shown = [
      ["PC", octal(processor.pc)], ["L", machine.link], ["AC", octal(machine.ac)], ["MA", octal(processor.ma)], ["MB", octal(processor.mb)],
      ["state", STATES[processor.state]], ["ION", processor.ion ? "on" : "off"], ["reader flag", teletype.receiver.flag ? "up" : "down"],
      ["printer flag", teletype.transmitter.flag ? "up" : "down"], ["instructions", grouped(processor.instructions)], ["since START", seconds(machine.ticks)],
      ["next", `${mnemonic(following, processor.pc)}: ${inWords(following, processor.pc)}`],
    ];
    const place = find("registers");
    if (!place.childElementCount) {
      place.innerHTML = shown.map(([name]) => `<div data-register="${name}"><dt>${name}</dt><dd>${name === "AC" || name === "PC" || name === "L" ? `<input type="text" maxlength="4" aria-label="${name}">` : ""}</dd></div>`).join("");
      for (const input of place.querySelectorAll("input")) input.addEventListener("change", () => this.#set(input));
    }
    shown.forEach(([, value], index) => {
      const cell = place.children[index].lastChild;
      const input = cell.firstChild?.tagName === "INPUT" ? cell.firstChild : null;
      if (!input) writer.text(cell, String(value));
      else if (document.activeElement !== input && input.value !== String(value)) input.value = value;
    });
  }

  #set(input) {
    const { processor } = this.bench.machine;
    const name = input.ariaLabel;
    if (/^[0-7]{1,4}$/.test(input.value)) {
      const word = parseInt(input.value, 8);
      if (name === "PC") Object.assign(processor, { pc: word & 0o7777, next: 0 });
      else if (name === "AC") processor.lac = (processor.lac & 0o10000) | (word & 0o7777);
      else processor.lac = (processor.lac & 0o7777) | ((word & 1) << 12);
    }
    input.blur();
    this.bench.touched();
  }
}
