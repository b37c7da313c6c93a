// The tabs of the desk: one pane at a time; beside an exercise, the program that answers it.

import { html, put } from "../html.mjs";
import { find } from "../written.mjs";
import { uncover } from "./wiring.mjs";

export class Tabs {
  constructor(/** @type {Bench} */ bench) {
    this.bench = bench;
    this.list = find("tabs");
    this.panes = [...document.querySelectorAll("[data-tab]")];
    const tabs = this.panes.map(({ id, dataset: { tab } }) => html`<button role="tab" data-opens="${id}" data-click="tabs.choose" aria-controls="${id}">${tab}</button>`);
    put(this.list, tabs);
    this.list.addEventListener("focusin", (/** @type {any} */ { target }) => this.choose(target));
    this.#show(this.panes[0].id);
  }

  /** Show only these panes, and their tabs. */
  only(/** @type {string[]} */ ids) {
    for (const tab of this.list.children) tab.hidden = !ids.includes(tab.dataset.opens);
    const shown = this.panes.filter(({ id }) => ids.includes(id));
    this.list.hidden = shown.length < 2;
    this.list.parentElement.hidden = !shown.length;
    if (shown.length) this.open(shown[0].id);
  }

  get kept() {
    return [...this.list.children].find((tab) => tab.ariaSelected === "true")?.dataset.opens;
  }

  set kept(opened) {
    if (this.panes.some(({ id }) => id === opened)) this.open(opened);
  }

  choose(/** @type {HTMLElement} */ { dataset: { opens } }) {
    this.open(String(opens));
  }

  open(/** @type {string} */ opened) {
    const { bench, list } = this;
    if (list.parentElement.hidden || [...list.children].some((tab) => tab.hidden && tab.dataset.opens === opened)) return;
    this.#show(opened);
    bench.show();
    if (bench.afternoon.on) return;
    uncover(list.parentElement);
    if (list.getBoundingClientRect().top < 0) list.scrollIntoView();
  }

  #show(/** @type {string} */ opened) {
    const beside = opened === "exercises" && !this.bench.exercises?.sheet ? "program" : "";
    for (const pane of this.panes) pane.hidden = pane.id !== opened && pane.id !== beside;
    document.querySelector("main").classList.toggle("beside", beside !== "");
    for (const tab of this.list.children) {
      const chosen = tab.dataset.opens === opened;
      tab.ariaSelected = String(chosen);
      tab.tabIndex = chosen ? 0 : -1;
    }
  }
}
