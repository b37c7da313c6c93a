// The editor: PAL III source in colour, assembled in the page, its messages under the places they are at.

import { assemble } from "../pal.mjs";
import { ERROR, printed } from "../pal/diagnostics.mjs";
import { LOADERS, PAL_III, PSEUDO_OPERATORS, SYMBOLS } from "../facts.mjs";
import { escaped, find, grouped, octal } from "../written.mjs";
import * as kinds from "./kinds.mjs";

const TOKENS = /(\/[^\n]*)|([A-Za-z][A-Za-z0-9]*)(,|=)?|([0-9]+)/g;

export class Editor {
  constructor(bench, text) {
    this.bench = bench;
    this.area = find("source");
    this.behind = this.area.previousElementSibling;
    this.assembly = null;
    this.name = "program.pal";
    this.area.value = text;
    this.area.addEventListener("input", () => this.#changed());
    this.area.addEventListener("scroll", () => this.#scroll());
    this.area.addEventListener("keydown", (event) => this.#key(event));
    find("assemble").addEventListener("click", () => this.assemble());
    find("load").addEventListener("click", () => this.load());
    find("boot").addEventListener("click", () => this.boot());
    find("sources").addEventListener("change", (event) => this.#open(event.target));
    bench.shelf.changed.push(() => this.#sources());
    this.#sources();
    this.#changed();
  }

  get text() {
    return this.area.value;
  }

  set text(text) {
    this.area.value = text;
    this.#changed();
  }

  #sources() {
    const names = this.bench.shelf.names().filter((name) => name.endsWith(".pal"));
    find("sources").replaceChildren(new Option("Open a program …", ""), ...names.map((name) => new Option(name, name)));
  }

  #open(select) {
    if (select.value) this.open(select.value, this.bench.shelf.get(select.value).frames);
    select.value = "";
  }

  /** Open the source that a tape or a file holds. */
  open(name, frames) {
    this.name = name;
    this.text = new TextDecoder("ascii").decode(frames).replaceAll("\r\n", "\n");
  }

  #changed() {
    this.behind.innerHTML = `${coloured(this.text)}\n`;
    this.#scroll();
    find("load").disabled = find("boot").disabled = true;
    this.bench.remember();
  }

  #scroll() {
    this.behind.scrollTop = this.area.scrollTop;
    this.behind.scrollLeft = this.area.scrollLeft;
  }

  /** TAB is a tabulator here; Escape, then Tab, leaves the editor. */
  #key(event) {
    if (event.key === "Escape") this.leaving = true;
    else if (event.key === "Tab" && !event.shiftKey && !this.leaving) {
      event.preventDefault();
      this.area.setRangeText("\t", this.area.selectionStart, this.area.selectionEnd, "end");
      this.#changed();
    } else this.leaving = false;
    if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) this.assemble();
  }

  /** Assemble what is there; return whether it has no errors. */
  assemble() {
    this.assembly = assemble(this.text);
    const { diagnostics, ok, tape } = this.assembly;
    const items = diagnostics.slice(0, PAL_III.MOST).map((diagnostic) => this.#item(diagnostic));
    const more = diagnostics.length - items.length;
    const rest = more ? `<p>and ${more.toLocaleString("en")} more</p>` : "";
    find("messages").innerHTML = `<p>${summary(this.assembly)}</p><ol>${items.join("")}</ol>${rest}`;
    for (const button of find("messages").querySelectorAll("button")) {
      button.addEventListener("click", () => this.#goTo(button.dataset));
    }
    find("load").disabled = find("boot").disabled = tape.length === 0;
    return ok;
  }

  /** A diagnostic as `pal` prints it; its first line leads to the place. */
  #item(diagnostic) {
    const [first, ...rest] = printed(diagnostic, this.name).split("\n");
    const { line, start, end, severity } = diagnostic;
    const place = `data-line="${line}" data-start="${start}" data-end="${end}"`;
    const said = `<button class="text" ${place}>${escaped(first)}</button><pre>${escaped(rest.join("\n"))}</pre>`;
    return `<li class="${severity}">${said}</li>`;
  }

  #goTo({ line, start, end }) {
    const begins = this.text.split("\n").slice(0, line - 1).join("\n").length + (line > 1 ? 1 : 0);
    this.area.focus();
    this.area.setSelectionRange(begins + Number(start), begins + Number(end));
  }

  /** Put the words into core, and the switches and PC on the first of them from 0200 on. */
  load() {
    const { machine } = this.bench;
    machine.panel.stop();
    machine.load(Object.entries(this.assembly.words).filter(([address]) => address < machine.core.length));
    this.bench.debug.listing.lay(this.assembly.lines);
    this.#ready();
  }

  /** Load as an operator does: RIM toggled in, RIM reads BIN, BIN reads the program's tape; at full speed. */
  boot() {
    const { bench } = this;
    const { machine } = bench;
    const { reader } = machine.teletype;
    machine.panel.stop();
    machine.processor.memProt = machine.processor.singStep = 0;
    reader.on = true;
    const kept = machine.teletype.punch.on;
    LOADERS.RIM.forEach((word, index) => machine.processor.deposit(LOADERS.RIM_START + index, word));
    this.#read(LOADERS.RIM_START, LOADERS.RIM_START, bench.record.loader, () => machine.outOfTape());
    machine.panel.stop();
    const tape = this.assembly.tape.slice(kinds.start(this.assembly.tape));
    this.#read(LOADERS.BIN_START, LOADERS.TELETYPE_READER, tape, () => !machine.processor.run);
    machine.teletype.punch.on = kept;
    const wrong = machine.ac !== 0 || machine.processor.ma !== LOADERS.BIN_HALT;
    const stopped = `BIN stopped at ${octal(machine.processor.ma)} with AC ${octal(machine.ac)}`;
    bench.say(wrong ? stopped : "loaded by BIN, checksum right");
    reader.remove();
    bench.debug.listing.lay(this.assembly.lines);
    this.#ready();
  }

  /** Start a loader on a tape, run until `done`. */
  #read(start, switches, tape, done) {
    const { machine } = this.bench;
    const { panel, processor, teletype } = machine;
    teletype.reader.load(typeof tape === "string" ? Uint8Array.from(atob(tape), (character) => character.charCodeAt(0)) : tape);
    panel.loadAddress(start);
    processor.sr = switches;
    panel.start();
    while (processor.run && !done()) machine.run(processor.clock + 20_000_000);
  }

  #ready() {
    const { machine } = this.bench;
    const addresses = Object.keys(this.assembly.words).map(Number);
    const start = addresses.includes(0o200) ? 0o200 : Math.min(...addresses);
    machine.processor.sr = start & 0o7777;
    machine.panel.loadAdd();
    this.bench.touched();
  }
}

/** What became of a source: its words, its tape, how many errors and notes. */
function summary({ diagnostics, tape, words }) {
  const errors = diagnostics.filter(({ severity }) => severity === ERROR).length;
  const made = `${counted(Object.keys(words).length, "word")}, a tape of ${counted(tape.length, "frame")}`;
  const said = [[errors, "error"], [diagnostics.length - errors, "note"]].filter(([number]) => number);
  return `${made}${said.length ? "; " : ""}${said.map(([number, what]) => counted(number, what)).join(", ")}.`;
}

function counted(number, what) {
  return `${grouped(number)} ${what}${number === 1 ? "" : "s"}`;
}

function coloured(text) {
  let html = "";
  let at = 0;
  for (const match of text.matchAll(TOKENS)) {
    const [token, comment, name, mark] = match;
    const known = name && (name in SYMBOLS || name in PSEUDO_OPERATORS);
    const kind = comment ? "comment" : name ? (mark ? "tag" : known ? "known" : "name") : "number";
    html += `${escaped(text.slice(at, match.index))}<span class="${kind}">${escaped(token)}</span>`;
    at = match.index + token.length;
  }
  return html + escaped(text.slice(at));
}
