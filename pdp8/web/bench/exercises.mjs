// The exercises of `pdp8 check`, and a teacher's own: the task, an answer in the editor or on a sheet, its marks.

import { task as written } from "../../lessons/page.mjs";
import { html, ours, put } from "../html.mjs";
import { find } from "../written.mjs";
import { linked } from "./sharing.mjs";

const SECONDS = 10; // of an answer, as `pdp8 check` gives it
const BEGUN = "/ NAME\n*200\n\tHLT\n$\n"; // what an answer begins with

export class Exercises {
  constructor(bench) {
    this.bench = bench;
    this.all = new Map(Object.entries(bench.record.exercises));
    this.done = new Set(); // those that were right
    this.open("add");
  }

  /** Take an exercise from a file or a link, and open it. Throws where it is none. */
  take(name, tables) {
    if (typeof tables.title !== "string" || typeof tables.task !== "string") throw new Error(`${name}: no exercise`);
    this.all.set(name, tables);
    this.open(name);
    this.bench.tabs.open("exercises");
  }

  /** Open an exercise. Throws where there is none of that name. */
  open(name) {
    if (!this.all.has(name)) throw new Error(`there is no exercise ${name}; those there are stand under Exercises`);
    this.name = name;
    const { title, task, question: questions = [] } = this.all.get(name);
    const asks = questions.map(({ name: called, ask }) =>
      html`<label>${called} <span>${ask}</span> <input type="text" name="${called}" autocomplete="off"></label>`);
    const begin = questions.length ? "" : html`<button class="text" type="button" data-click="exercises.begin">Begin ${this.#answer}</button> `;
    put(find("asked"), html`<h2>${title}</h2>${ours(written(task))}<form data-submit="exercises.mark">${asks}<div class="tools">${begin}<button class="text go">Mark ${questions.length ? "the sheet" : "the program"}</button></div></form>`);
    find("marks").replaceChildren();
    this.#list();
  }

  choose({ value }) {
    this.open(value);
  }

  /** The name of the program that answers. */
  get #answer() {
    return `${this.name.replace(/\.\w+$/, "")}.pal`;
  }

  #list() {
    const options = [...this.all].map(([name, { title }]) => new Option(`${this.done.has(name) ? "✓ " : ""}${title}`, name));
    find("exercise").replaceChildren(...options);
    find("exercise").value = this.name;
  }

  begin() {
    const { editor, programs, tabs } = this.bench;
    editor.put(this.#answer, programs.get(this.#answer) ?? BEGUN.replace("NAME", this.all.get(this.name).title));
    tabs.open("program");
  }

  /** Mark the program that is open, or the sheet. */
  async mark() {
    const { apart, editor } = this.bench;
    const { name } = this;
    const tables = this.all.get(name);
    const lines = [...find("asked").querySelectorAll("input")].map((input) => `${input.name}: ${input.value}\n`);
    const source = tables.question ? lines.join("") : editor.text;
    put(find("marks"), html`<p>It is tried …</p>`);
    try {
      const { right, points, of, said } = await apart.ask("marks", [tables, tables.question ? name : editor.name, source], SECONDS);
      if (right) this.done.add(name);
      if (name !== this.name) return;
      put(find("marks"), html`<p><b class="${right ? "right" : ""}">${tables.question ? "The sheet" : editor.name}: ${of ? `${points} of ${of} points` : "not marked"}</b></p>${ours(said)}`);
      this.#list();
    } catch (error) {
      put(find("marks"), html`<p>${error.message}</p>`);
    }
  }

  async link() {
    const { name, bench } = this;
    const whole = location.href.replace(/#.*/, "");
    bench.give(name in bench.record.exercises ? `${whole}#exercise=${name}` : await linked({ exercise: { name, tables: this.all.get(name) } }));
  }
}
