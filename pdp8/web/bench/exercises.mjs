// The exercises of `pdp8 check`, and a teacher's own: the task beside the editor, or a sheet of questions; marks and answers kept.

import { task as written } from "../../lessons/page.mjs";
import { html, ours, put } from "../html.mjs";
import { find, LATER, many } from "../written.mjs";
import { exercise as checked } from "./marker.mjs";
import { linked } from "./sharing.mjs";
import { Store } from "./store.mjs";

const SECONDS = 10; // of an answer, as pdp8 check gives it
const BEGUN = "/ NAME\n*200\n\tHLT\n$\n"; // what an answer begins with

export class Exercises {
  constructor(/** @type {Bench} */ bench) {
    this.bench = bench;
    /** @type {string} */ this.name = LATER;
    this.all = new Map(Object.entries(bench.record.exercises));
    this.given = new Store("exercise", (name) => this.#elsewhere(name)); // by a teacher
    this.answers = new Store("answers"); // to a sheet, {question: answer}
    this.marks = new Store("marks", () => this.#list()); // [points, of, whether all is right]
    for (const name of this.given.names()) this.#give(name, this.given.read(name));
    this.#show("add");
  }

  get kept() {
    return this.name;
  }

  set kept(name) {
    if (this.all.has(name)) this.#show(name); // the editor finds its own program
  }

  /** Take an exercise from a file or a link, and open it. Throws where it is none. */
  take(/** @type {string} */ name, /** @type {any} */ tables) {
    try {
      checked(tables);
    } catch (/** @type {any} */ error) {
      throw error instanceof TypeError ? error : new Error(`${name}: no exercise: ${error.message}`, { cause: error });
    }
    const text = JSON.stringify(tables);
    if (this.given.get(name) !== text) this.marks.remove(name); // it was of another exercise
    this.all.set(name, tables);
    this.given.keep(name, text);
    this.open(name);
    this.bench.tabs.open("exercises");
  }

  /** Another tab has taken an exercise. */
  #elsewhere(/** @type {string} */ name) {
    this.#give(name, this.given.read(name));
    if (name === this.name) this.#show(name);
    else this.#list();
  }

  /** Restore a teacher's exercise, if it is one. */
  #give(/** @type {string} */ name, /** @type {any} */ tables) {
    try {
      checked(tables);
      this.all.set(name, tables);
    } catch { /* it was kept by another version of the page */ }
  }

  /** Open an exercise, and the program that answers it, if that was begun. Throws where there is none of that name. */
  open(/** @type {string} */ name) {
    if (!this.all.has(name)) throw new Error(`there is no exercise ${name}; those there are stand under Exercises`);
    this.#show(name);
    const { editor, programs } = this.bench;
    if (!this.sheet && programs.get(this.#answer) !== undefined && editor.name !== this.#answer) editor.begin(this.#answer);
  }

  #show(/** @type {string} */ name) {
    this.name = name;
    const { asked, questions, title } = checked(this.all.get(name));
    this.sheet = questions.length > 0;
    const given = this.answers.read(name) ?? {};
    const asks = questions.map(({ name: called, ask }) =>
      html`<label>${called} <span>${ask}</span> <input type="text" name="${called}" value="${given[called] ?? ""}" data-input="exercises.answer" autocomplete="off"></label>`);
    const begin = this.sheet ? "" : html`<button class="text" type="button" data-click="exercises.begin">Open ${this.#answer}</button> `;
    put(find("asked"), html`<h2>${title}</h2>${ours(written(asked))}<form data-submit="exercises.mark">${asks}<div class="tools">${begin}<button class="text go">Mark ${this.sheet ? "the sheet" : this.#answer}</button></div></form>`);
    find("marks").replaceChildren();
    this.#list();
  }

  choose(/** @type {HTMLInputElement} */ { value }) {
    this.open(value);
    this.bench.tabs.open("exercises");
  }

  /** The name of the program that answers. */
  get #answer() {
    return `${this.name.replace(/\.\w+$/, "")}.pal`;
  }

  /** Keep what is written on the sheet. */
  answer(/** @type {HTMLInputElement} */ { name, value }) {
    this.answers.keep(this.name, JSON.stringify({ ...this.answers.read(this.name), [name]: value }));
  }

  /** How an exercise was marked, in a few characters. */
  #mark(/** @type {string} */ name) {
    const [points, of, right] = [this.marks.read(name) ?? []].flat();
    return right ? "✓ " : of ? `${points}/${of} ` : "";
  }

  /** The list: by level, a teacher's own last; each with its mark. */
  #list() {
    const option = (/** @type {[string, any]} */ [name, { title }]) => html`<option value="${name}">${this.#mark(name)}${title}</option>`;
    const levels = Map.groupBy(this.all, ([, { level }]) => level ?? "A teacher's own");
    put(find("exercise"), [...levels].map(([level, some]) => html`<optgroup label="${level}">${some.map(option)}</optgroup>`));
    find("exercise").value = this.name;
  }

  begin() {
    const { editor, programs, tabs } = this.bench;
    editor.keep();
    editor.put(this.#answer, programs.get(this.#answer) ?? BEGUN.replace("NAME", this.all.get(this.name).title));
    tabs.open("exercises");
    editor.enter();
  }

  /** Mark the sheet, or the program that answers; if another one is open, ask which. */
  mark() {
    const { editor } = this.bench;
    if (this.sheet || editor.name === this.#answer) this.markOpen();
    else put(find("marks"), html`<p>${editor.name} is open, and ${this.#answer} is the answer. <button class="text" data-click="exercises.begin">Open ${this.#answer}</button> <button class="text" data-click="exercises.markOpen">Mark ${editor.name}</button></p>`);
  }

  /** Mark the program that is open, or the sheet. */
  async markOpen() {
    const { apart, editor } = this.bench;
    const { name, sheet } = this;
    if (editor.area.readOnly) editor.back(); // a source that is only read answers nothing
    const tables = this.all.get(name);
    const lines = [...find("asked").querySelectorAll("input")].map((input) => `${input.name}: ${input.value}\n`);
    const called = sheet ? name : editor.name;
    const text = sheet ? lines.join("") : editor.text;
    put(find("marks"), html`<p>Marking …</p>`);
    try {
      const { right, points, of, said, wrong } = await apart.ask("marks", [tables, called, text], SECONDS);
      this.marks.keep(name, JSON.stringify([points, of, right]));
      this.#list();
      if (name !== this.name) return;
      put(find("marks"), html`<p><b class="${right ? "right" : ""}">${sheet ? "The sheet" : called}: ${of ? `${points} of ${many(of, "points")}` : "not marked"}</b></p>${ours(said)}`);
      this.marked = text;
      if (!sheet) this.#offer(wrong);
    } catch (/** @type {any} */ error) {
      if (name === this.name) put(find("marks"), html`<p>${error.message}</p>`);
    }
  }

  /** Put a button beside each case that failed: where it went wrong. */
  #offer(/** @type {string[]} */ wrong) {
    const heads = find("marks").querySelectorAll("h2");
    wrong.forEach((called, index) => {
      if (!called || !heads[index]) return;
      put(heads[index], html`${called} <button class="text" data-click="exercises.where" value="${called}" title="Run the program from START to this place; from there step back and forward">Show where it went wrong</button>`);
    });
  }

  /** Let the machine run from START to the place where the program goes wrong in a case; from there one can go back. */
  async where(/** @type {HTMLInputElement} */ { value }) {
    const { apart, editor, machine } = this.bench;
    if (editor.text !== this.marked) return this.bench.say("This is not what was marked: mark it again");
    try {
      const { says, state, until } = await apart.ask("located", [this.all.get(this.name), editor.name, editor.text, value], SECONDS);
      if (machine !== this.bench.machine) return; // another has come meanwhile
      this.bench.lead(state, until, `${value}: ${says}`);
      editor.area.blur();
      editor.write();
    } catch (/** @type {any} */ error) {
      this.bench.say(String(error.message ?? error));
    }
  }

  async link() {
    const { name, bench } = this, tables = this.all.get(name);
    bench.give(bench.record.exercises[name] === tables ? `#exercise=${name}` : await linked({ exercise: { name, tables } }, ""));
  }
}
