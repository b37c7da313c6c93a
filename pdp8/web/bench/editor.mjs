// The editor: PAL source in colour, assembled in the page, its messages under the places they are at.

import { FOUND, assemble } from "../../../pal/assembling.mjs";
import { MOST } from "../../../pal/assembly.mjs";
import { PERMANENT, PSEUDO_OPERATORS } from "../../../pal/symbols.mjs";
import { Operator } from "../../computer/use/operator.mjs";
import { escaped, find, grouped } from "../written.mjs";
import { limited } from "./budget.mjs";

const LONGEST = 200_000; // characters of a source that is taken
const COLOURED = 50_000; // and of one that is shown in colour
const KNOWN = new Set([...PERMANENT.map(({ mnemonic }) => mnemonic), ...PSEUDO_OPERATORS]);
const TOKENS = /(\/[^\n]*)|([A-Za-z][A-Za-z0-9]*)(,|=)?|([0-9]+)/g;

export class Editor {
  constructor(bench, text) {
    this.bench = bench;
    this.area = find("source");
    this.behind = this.area.previousElementSibling;
    this.assembly = null;
    this.name = "program.pal";
    this.area.value = text;
    this.area.addEventListener("input", () => {
      this.#changed();
      bench.remember();
    });
    this.area.addEventListener("scroll", () => this.#scroll());
    this.area.addEventListener("keydown", (event) => this.#key(event));
    find("run-it").addEventListener("click", () => this.run());
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

  /** Show a source. Throws for one that is longer than a page can take. */
  set text(text) {
    if (text.length > LONGEST) throw new Error(`a source of ${grouped(text.length)} characters; ${grouped(LONGEST)} are allowed`);
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
      this.bench.remember();
    } else this.leaving = false;
    if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) this.assemble();
  }

  /** Assemble what is there; return whether it has no errors. */
  assemble() {
    this.assembly = assemble([this.text], [this.name], false, undefined, null, FOUND);
    const { diagnostics, ok, tape } = this.assembly;
    const items = diagnostics.slice(0, MOST).map((diagnostic) => this.#item(diagnostic));
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
    const [first, ...rest] = String(diagnostic).split("\n");
    const { line, column, end_column, severity } = diagnostic;
    const place = `data-line="${line}" data-start="${column - 1}" data-end="${end_column - 1}"`;
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
    this.bench.afternoon.takeOver();
    const { machine } = this.bench;
    machine.panel.stop();
    try {
      machine.load(this.assembly.words);
    } catch (error) {
      this.bench.say(String(error));
      return;
    }
    this.bench.debug.listing.lay(this.assembly.lines);
    this.#ready();
  }

  /** Assemble, load and start; where it cannot be assembled, its errors are shown. */
  run() {
    if (!this.assemble()) return;
    this.load();
    this.bench.switches.press("start");
  }

  /** Load as an operator does: RIM toggled in, RIM reads BIN, BIN reads the program's tape; at full speed. */
  boot() {
    const { bench } = this;
    bench.afternoon.takeOver();
    const { machine } = bench;
    const { punch, reader } = machine.teletype;
    const kept = punch.on;
    machine.panel.stop();
    reader.lever(true);
    try {
      const steps = () => [...new Operator(machine).boot(bench.record.loader.encode("latin-1"), this.assembly.tape, this.name)];
      bench.why = String(limited(machine, steps).at(-1));
    } catch (error) {
      machine.panel.stop();
      reader.remove();
      bench.why = String(error);
    }
    punch.on = kept;
    bench.debug.listing.lay(this.assembly.lines);
    this.#ready();
  }

  #ready() {
    const { machine } = this.bench;
    const addresses = [...this.assembly.words];
    const start = addresses.includes(0o200) ? 0o200 : Math.min(...addresses);
    machine.sr = start;
    machine.panel.load_add();
    this.bench.touched();
  }
}

/** What became of a source: its words, its tape, how many errors and notes. */
function summary({ diagnostics, tape, words }) {
  const errors = diagnostics.filter(({ error }) => error).length;
  const made = `${counted(words.length, "word")}, a tape of ${counted(tape.length, "frame")}`;
  const said = [[errors, "error"], [diagnostics.length - errors, "note"]].filter(([number]) => number);
  return `${made}${said.length ? "; " : ""}${said.map(([number, what]) => counted(number, what)).join(", ")}.`;
}

function counted(number, what) {
  return `${grouped(number)} ${what}${number === 1 ? "" : "s"}`;
}

function coloured(text) {
  if (text.length > COLOURED) return escaped(text);
  let html = "";
  let at = 0;
  for (const match of text.matchAll(TOKENS)) {
    const [token, comment, name, mark] = match;
    const known = name && KNOWN.has(name);
    const kind = comment ? "comment" : name ? (mark ? "tag" : known ? "known" : "name") : "number";
    html += `${escaped(text.slice(at, match.index))}<span class="${kind}">${escaped(token)}</span>`;
    at = match.index + token.length;
  }
  return html + escaped(text.slice(at));
}
