// Editor and listing in one: PAL source in colour, and beside each line its number, address and word, breakpoint,
// count, and where the processor is. What is wrong is said at its line while it is typed.
//
//     keys ──► text ──► the lines that are seen, drawn at once
//                └── a pause ──► Worker, checked() ──► places, diagnostics ──► drawn

import * as rim from "../../../tapes/rim.mjs";
import { characters } from "../../../pal/source.mjs";
import { PERMANENT, PSEUDO_OPERATORS } from "../../../pal/symbols.mjs";
import { Listing } from "../../computer/use/trace.mjs";
import { instruction_at } from "../../computer/watch.mjs";
import { bytes, dict } from "../translator/runtime.mjs";
import { assembled, checked, here } from "../findings.mjs";
import { html, put } from "../html.mjs";
import { find, grouped, octal } from "../written.mjs";
import { Counts } from "./counts.mjs";
import { keep, kept } from "./store.mjs";
import { modified } from "./wiring.mjs";

const LONGEST = 200_000; // characters of a source that is taken
const SHORT = 2000; // characters that a browser pastes by itself
const WIDEST = 400; // of a line that is drawn
const TALL = 24; // pixels of a line; desk.css says it too
const PAUSE = 250; // ms without a key, and what was typed is looked at
const SECONDS = 5; // the most that may take
const KNOWN = new Set([...PERMANENT.map(({ mnemonic }) => mnemonic), ...PSEUDO_OPERATORS]);
const TOKENS = /(\/.*)|([A-Za-z][A-Za-z0-9]*)(,|=)?|([0-9]+)/g;
const NEW = "/ A new program\n*200\n\tCLA CLL\n\tHLT\n$\n";
const OPEN = "pdp8 open"; // the setting that names the program that was open

export class Editor {
  constructor(/** @type {Bench} */ bench) {
    this.bench = bench;
    this.area = find("source");
    this.behind = this.area.previousElementSibling;
    this.counts = new Counts();
    /** @type {{ value: string; from: number; until: number; made: string }[]} */ this.pasted = []; // long texts: what was there before
    this.name = this.laid = "";
    this.before = ""; // the text as it was kept or opened
    this.now = /** @type {number | null} */ (null); // the line that the processor is in
    this.#found(unmade(""));
    this.area.addEventListener("scroll", () => this.#draw());
    this.area.addEventListener("keydown", (/** @type {KeyboardEvent} */ event) => this.#key(event));
    this.area.addEventListener("paste", (/** @type {ClipboardEvent} */ event) => this.#paste(event));
    this.area.addEventListener("pointerdown", () => this.#write(true));
    this.area.addEventListener("blur", () => this.#write(false));
    new ResizeObserver(() => this.#draw()).observe(this.area);
    addEventListener("beforeprint", () => bench.room.open || put(find("printed"), html`<h2>${this.called}</h2><pre>${assembled(this.called, this.text).listing}</pre>`));
    addEventListener("afterprint", () => put(find("printed"), ""));
  }

  /** Put in a long text at once: a browser that does it by itself takes a second for each hundred lines. */
  #paste(/** @type {any} */ event) {
    const { area, area: { selectionStart: from, selectionEnd: until, value }, bench } = this;
    const text = event.clipboardData.getData("text/plain").replaceAll("\r\n", "\n");
    if (text.length < SHORT || area.readOnly) return;
    event.preventDefault();
    try {
      bounded(value.slice(0, from) + text + value.slice(until));
      area.setRangeText(text, from, until, "end");
      this.pasted.push({ value, from, until, made: area.value });
      this.changed();
    } catch (/** @type {any} */ error) {
      bench.say(error.message);
    }
  }

  /** Undo such a paste, which the browser does not know of; return whether it was what was done last. */
  #unpaste() {
    const { area, pasted } = this, last = pasted.at(-1);
    if (last?.made !== area.value || area.readOnly) return false;
    pasted.pop();
    area.value = last.value;
    area.setSelectionRange(last.from, last.until);
    this.changed();
    return true;
  }

  /** The name of what is shown: of the program, or of a source that is only read. */
  get called() {
    return this.area.readOnly ? this.laid : this.name;
  }

  get text() {
    return this.area.value;
  }

  /** Replace the program. Throws for one that is longer than a page can take. */
  set text(text) {
    bounded(text);
    this.area.value = text;
    this.changed();
  }

  /** Open the program that was open, or the first one. */
  begin(name = kept(OPEN) ?? "") {
    const { programs } = this.bench;
    this.#turn(programs.get(name) === undefined ? programs.names()[0] ?? programs.take("program.pal", NEW) : name);
  }

  /** Open the source that a tape or a file holds, as a program of its own. */
  open(/** @type {string} */ name, /** @type {Bytes} */ frames) {
    this.put(name, characters(frames).replaceAll("\r", "\n"));
  }

  /** Open a source as a program of its own: nothing that is kept is written over. */
  put(/** @type {string} */ name, /** @type {string} */ text) {
    bounded(text);
    this.keep(); // first: what is open and was written in may have had this very text
    this.#turn(this.bench.programs.take(name, text));
  }

  create() {
    this.put("program.pal", NEW);
    this.enter();
    this.area.setSelectionRange(0, NEW.length); // what is typed replaces it
  }

  #turn(/** @type {string} */ name) {
    this.keep();
    this.area.readOnly = false;
    this.#named(name);
    this.before = this.bench.programs.get(name);
    this.#show(this.before);
    this.#warn();
  }

  #warn() {
    const { held, refused } = this.bench.programs;
    if (refused) this.#say(`This browser does not keep ${[...held.keys()].join(", ") || "programs"} for this page (${refused}): save them as files.`);
  }

  #named(/** @type {string} */ name) {
    this.name = name;
    keep(OPEN, name);
    const options = (/** @type {string[]} */ names) => names.map((each) => html`<option value="${each}">${each}</option>`);
    put(find("sources"), html`<option value="">Open …</option><optgroup label="Yours">${options(this.bench.programs.names())}</optgroup>
      <optgroup label="Bundled">${options(this.bench.shelf.sources)}</optgroup>`);
  }

  #show(/** @type {string} */ text) {
    this.area.value = text;
    this.pasted = [];
    this.area.setSelectionRange(0, 0);
    this.area.scrollTop = this.area.scrollLeft = 0;
    find("program-name").value = this.name;
    for (const id of ["program-name", "delete-program"]) find(id).disabled = this.area.readOnly; // it is not what is shown
    this.#say("");
    this.changed();
  }

  /** Show the source of what is in core, to be read. */
  lay(/** @type {string} */ name) {
    this.keep();
    this.laid = name;
    this.area.readOnly = true;
    this.#show(new TextDecoder().decode(this.bench.shelf.get(name).frames));
    this.#say(html`${name} is in core. <button class="text" data-click="editor.back">Back to ${this.name}</button>`);
    this.#found(checked(name, this.text));
    this.write();
  }

  back() {
    this.begin(this.name);
  }

  /** Keep what is written: what another tab has made of the program meanwhile stays, and this gets a name of its own. */
  keep() {
    const { before, name, text, bench: { programs } } = this;
    if (!name || this.area.readOnly || text === before) return;
    const there = programs.get(name) ?? before;
    this.before = text;
    if (there === before || there === text) programs.keep(name, text);
    else {
      this.#named(programs.take(name, text));
      find("program-name").value = this.name;
      this.#say(`${name} was changed in another tab too: what is written here is kept as ${this.name}.`);
    }
    this.#warn();
  }

  /** Another tab has written a program: if it is the one that is open, say so. */
  elsewhere(/** @type {string} */ name) {
    const there = this.bench.programs.get(name);
    this.#named(this.name);
    if (name !== this.name || this.area.readOnly || there === this.text) return;
    if (there === undefined) this.#say(`${name} was deleted in another tab. It is kept again as soon as you write here.`);
    else this.#say(html`${name} was changed in another tab. What is written here is kept beside it. <button class="text" data-click="editor.back">Show it</button>`);
  }

  choose(/** @type {HTMLSelectElement} */ list) {
    const { value, selectedOptions: [{ parentElement: { label } }] } = /** @type {any} */ (list);
    if (label === "Yours") this.begin(value);
    else if (value) this.open(value, this.bench.shelf.get(value).frames);
    list.value = "";
  }

  rename(/** @type {HTMLInputElement} */ field) {
    const { programs } = this.bench;
    const name = field.value.trim();
    if (name && name !== this.name) {
      const old = this.name;
      this.keep();
      const called = programs.take(name, this.text);
      if (programs.get(old) === this.before) programs.remove(old);
      this.#named(called);
    }
    field.value = this.name;
  }

  remove() {
    const { programs } = this.bench;
    this.keep();
    this.deleted = [this.name, programs.get(this.name) ?? this.before]; // another tab may have deleted it
    programs.remove(this.name);
    this.name = "";
    this.begin();
    this.#say(html`${this.deleted[0]} is deleted. <button class="text" data-click="editor.undo">Undo</button>`);
  }

  undo() {
    this.put(.../** @type {[string, string]} */ (this.deleted));
  }

  save(/** @type {HTMLSelectElement} */ list) {
    const kind = list.value;
    list.value = "";
    if (!kind) return;
    if (!/pal|lst/.test(kind) && !this.assemble()) return this.#not("saved");
    const made = { pal: () => this.text, bin: () => this.assembly.tape, rim: () => rim.encode(dict(this.assembly.words)), lst: () => assembled(this.called, this.text).listing };
    try {
      this.bench.download(`${this.called.replace(/\.\w+$/, "")}.${kind}`, /** @type {any} */ (made)[kind]());
    } catch (/** @type {any} */ error) {
      this.bench.say(error.message); // a RIM tape has no fields
    }
  }

  #say(/** @type {unknown} */ content) {
    put(find("program-says"), content);
  }

  changed() {
    this.lines = this.text.split("\n");
    this.#draw();
    clearTimeout(this.pause);
    this.pause = setTimeout(() => this.#check(), PAUSE);
  }

  /** Keep what was typed, and have it looked at. */
  async #check() {
    const { name, text, bench } = this;
    this.keep();
    if (this.area.readOnly) return;
    try {
      const found = await bench.apart.ask("checked", [name, text], SECONDS);
      if (text === this.text) this.#found(found);
    } catch (/** @type {any} */ error) {
      if (text !== this.text) return;
      this.#found(bench.apart.unable ? checked(name, text) : unmade(`Not assembled: ${error.message}.`));
    }
  }

  #found(/** @type {Found} */ found) {
    const { places, diagnostics, more, summary } = found;
    /** @type {Found & { name: string; text: string; listing?: Listing }} */ this.assembly = { ...found, name: this.called, text: this.text };
    /** @type {Map<number, { address: number; word: number | null }>} */ this.places = new Map();
    /** @type {Map<number, number>} */ this.lineAt = new Map(places.map(([line, address]) => /** @type {[number, number]} */ ([address, line])).reverse());
    for (const [line, address, word] of places) if (!this.places.has(line)) this.places.set(line, { address, word });
    /** @type {Map<number, Note>} */ this.wrong = new Map(diagnostics.map((each) => /** @type {[number, Note]} */ ([each.line, each])).reverse());
    const items = diagnostics.map(({ line, start, end, severity, whole }) => {
      const [first, ...rest] = whole.split("\n");
      return html`<li class="${severity}"><button class="text" data-click="editor.goTo" data-line="${line}" data-start="${start}" data-end="${end}">${first}</button><pre>${rest.join("\n")}</pre></li>`;
    });
    put(find("messages"), html`<p>${summary}</p><ol>${items}</ol>${more ? html`<p>and ${more.toLocaleString("en")} more</p>` : ""}`);
    for (const id of ["load", "boot"]) find(id).disabled = !found.words.length;
    this.#draw();
    this.write();
  }

  /** Whether somebody writes in the editor: what Tab does depends on it. */
  #write(/** @type {boolean} */ on) {
    this.writing = on;
    find("editor-keys").classList.toggle("writing", on);
  }

  /** Go into the editor, to write. */
  enter() {
    this.area.focus();
    this.#write(true);
  }

  goTo(/** @type {HTMLElement} */ { dataset: { line, start, end } }) {
    const begins = this.lines.slice(0, Number(line) - 1).join("\n").length + (Number(line) > 1 ? 1 : 0);
    this.enter();
    this.area.setSelectionRange(begins + Number(start), begins + Number(end));
    this.#bringIntoView(Number(line));
  }

  /** Draw the lines that are seen. */
  #draw() {
    if (!this.lines) return;
    const { scrollTop, scrollLeft, clientHeight, clientWidth } = this.area;
    const first = Math.floor(scrollTop / TALL);
    const seen = this.lines.slice(first, first + Math.ceil(clientHeight / TALL) + 1);
    const down = first * TALL - scrollTop;
    put(this.behind, seen.flatMap((/** @type {string} */ line, /** @type {number} */ index) => [index ? "\n" : "", coloured(line, this.wrong.get(first + index + 1))]));
    this.behind.style.transform = `translate(${-scrollLeft}px, ${down}px)`;
    const { right } = this.area.getBoundingClientRect();
    for (const said of this.behind.querySelectorAll("em")) { // what has no space after its line is said below it
      if (said.getBoundingClientRect().right < right) continue;
      said.className = "below";
      Object.assign(said.style, { left: `${scrollLeft + 8}px`, maxWidth: `${clientWidth - 16}px` });
    }
    put(find("gutter"), html`<div style="transform: translateY(${down}px)">${seen.map((/** @type {string} */ _, /** @type {number} */ index) => this.#beside(first + index + 1))}</div>`);
  }

  /** The columns beside a line. */
  #beside(/** @type {number} */ line) {
    const place = this.places.get(line);
    const classes = `line${line === this.now ? " now" : ""} ${this.wrong.get(line)?.severity ?? ""}`;
    const current = line === this.now ? html` aria-current="true"` : "";
    if (!place) return html`<div class="${classes}" role="listitem"><span>${line}</span></div>`;
    const { address, word } = place;
    const set = this.bench.machine.watch.breakpoints.has(address);
    const count = find("counts").checked ? html`<i>${grouped(this.counts.executed[address])}</i>` : "";
    const button = html`<button tabindex="-1" data-click="editor.mark" value="${address}" aria-pressed="${set}" aria-label="breakpoint at ${octal(address)}">${octal(address)}</button>`;
    return html`<div class="${classes}" role="listitem"${current}><span>${line}</span>${button}<b>${octal(Number(word))}</b>${count}</div>`;
  }

  mark(/** @type {HTMLInputElement} */ { value }) {
    this.#breakpoint(Number(value));
  }

  #breakpoint(/** @type {number} */ address) {
    const { bench } = this;
    if (bench.lacks("breakpoint at", address)) return;
    bench.afternoon.takeOver();
    const { breakpoints } = bench.machine.watch;
    if (!breakpoints.delete(address)) breakpoints.add(address);
    this.#draw();
  }

  stopCounting() {
    find("counts").checked = false;
  }

  /** Begin or end to count how often each word is executed. */
  count(/** @type {HTMLInputElement} */ { checked: on }) {
    if (on) this.bench.afternoon.takeOver();
    this.counts = new Counts();
    this.bench.machine.watch.observer = on ? this.counts : null;
    this.#draw();
  }

  /** Tab is a tabulator to who has begun to write: by Enter, a click or a character. Escape ends that, and Tab leaves. */
  #key(/** @type {any} */ event) {
    const { key } = event;
    const writes = this.writing && !this.area.readOnly;
    if (key === "Escape") this.#write(false);
    else if (key === "Enter" && !this.writing) {
      event.preventDefault();
      this.#write(true);
    } else if (key === "Tab" && !event.shiftKey && writes) {
      event.preventDefault();
      if (document.execCommand?.("insertText", false, "\t")) return; // the one way that the browser undoes
      this.area.setRangeText("\t", this.area.selectionStart, this.area.selectionEnd, "end");
      this.changed();
    } else if (key.toLowerCase() === "z" && modified(event) && !event.shiftKey && !event.altKey) {
      if (this.#unpaste()) event.preventDefault();
    } else if (key.length === 1 && !modified(event)) this.#write(true);
    if (key === "F9") {
      const place = this.places.get(this.text.slice(0, this.area.selectionStart).split("\n").length);
      if (place) this.#breakpoint(place.address);
    }
    if (key === "Enter" && (event.ctrlKey || event.metaKey)) this.run();
  }

  /** Assemble what is there; return whether it has no errors. */
  assemble() {
    this.keep();
    const { called: name, text } = this;
    if (this.assembly?.name !== name || this.assembly.text !== text) this.#found(checked(name, text));
    return this.assembly.ok;
  }

  /** Assemble, and stop the machine: what is assembled goes into core next. Return what was assembled. */
  #stopped() {
    this.bench.afternoon.takeOver();
    this.assemble();
    this.bench.machine.panel.stop();
    this.bench.why = "";
    return this.assembly;
  }

  /** Put the words into core, and the switches and PC on the first of them from 0200 on; return whether they fit. */
  load() {
    const { words } = this.#stopped();
    try {
      this.bench.machine.load(words);
    } catch (/** @type {any} */ error) {
      this.bench.say(String(error));
      return false;
    }
    this.#ready();
    return true;
  }

  /** Assemble, load and start; where it cannot be assembled, the first error is said, or that there is nothing to run. */
  run() {
    if (this.assemble() && this.assembly.words.length) {
      if (this.load()) this.bench.switches.press("start");
      return;
    }
    this.#not("run");
  }

  /** Say why it is not run, or saved. */
  #not(/** @type {string} */ done) {
    const { diagnostics, summary } = this.assembly;
    const wrong = diagnostics.find(({ severity }) => severity === "error");
    this.bench.say(`Not ${done}: ${wrong ? `line ${wrong.line}, ${wrong.brief}` : summary}`);
  }

  /** Load as an operator does: RIM toggled in, RIM reads BIN, BIN reads the program's tape; at full speed. */
  async boot() {
    const { name, tape } = this.#stopped();
    const { bench, bench: { machine, record: { afternoon: { read } } } } = this;
    try {
      const { state, said } = await bench.apart.ask("booted", [bench.drives.bare(machine), read["bin.rim"], tape, name], SECONDS);
      if (machine !== bench.machine) return; // another has come meanwhile
      bench.drives.put(state);
      bench.why = said;
      this.#ready();
    } catch (/** @type {any} */ error) {
      bench.say(here(error.message));
    }
  }

  #ready() {
    const { machine } = this.bench;
    const addresses = this.assembly.words.map(([address]) => address);
    const start = addresses.includes(0o200) ? 0o200 : Math.min(...addresses);
    this.bench.switches.card.end();
    machine.sr = start & 0o7777;
    machine.panel.load_address(start);
    this.count(find("counts"));
    this.bench.touched();
  }

  /** Whether core holds what is listed: more than half of its words; the others are data that have changed. */
  get #inCore() {
    const { machine: { processor: { core } } } = this.bench;
    const words = this.assembly?.words ?? [];
    return this.area.readOnly || words.filter(([address, word]) => core[address] === word).length > words.length / 2;
  }

  /** The lines of what core holds; of nothing, if that is not what is listed. */
  get listing() {
    const { assembly } = this;
    if (!this.#inCore) return new Listing();
    assembly.listing ??= Listing.of(assembled(assembly.name, assembly.text));
    return assembly.listing;
  }

  /** Show where the processor is. */
  write() {
    const { machine } = this.bench;
    const counts = find("counts").checked;
    if (counts && machine.watch.observer !== this.counts) this.count(find("counts")); // another machine
    if (find("program").hidden) return;
    const now = this.#inCore ? this.lineAt.get(instruction_at(machine.processor)) ?? null : null;
    if (now === this.now && !counts) return;
    this.now = now;
    if (now && document.activeElement !== this.area) this.#bringIntoView(now);
    this.#draw();
  }

  #bringIntoView(/** @type {number} */ line) {
    const top = (line - 1) * TALL - this.area.scrollTop;
    if (top < TALL || top > this.area.clientHeight - 3 * TALL) this.area.scrollTop = (line - 1) * TALL - this.area.clientHeight / 2;
  }
}

/** What is found in a source that is not assembled, and why it is not. */
function unmade(/** @type {string} */ summary) {
  return { ok: false, tape: bytes(), words: [], places: [], diagnostics: [], more: 0, summary };
}

function bounded(/** @type {string} */ text) {
  if (text.length > LONGEST) throw new Error(`a source of ${grouped(text.length)} characters; ${grouped(LONGEST)} are allowed`);
}

/** A line in colour, and what is wrong with it. */
function coloured(/** @type {string} */ whole, /** @type {Note | undefined} */ wrong) {
  const line = whole.slice(0, WIDEST);
  const pieces = [];
  let at = 0;
  for (const match of line.matchAll(TOKENS)) {
    const [token, comment, name, mark] = match;
    const kind = comment ? "comment" : name ? (mark ? "tag" : KNOWN.has(name) ? "known" : "name") : "number";
    pieces.push(line.slice(at, match.index), html`<span class="${kind}">${token}</span>`);
    at = match.index + token.length;
  }
  pieces.push(line.slice(at));
  return wrong ? html`<u class="${wrong.severity}">${line ? pieces : " "}</u>  <em>${wrong.brief}</em>` : pieces;
}
