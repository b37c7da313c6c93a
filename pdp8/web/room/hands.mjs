// The panel's switches and keys as buttons, which lie unseen over those that are drawn: on the desk and in the room.

import { rove } from "../bench/wiring.mjs";
import { html, put } from "../html.mjs";
import { KEYS, SWITCHES, within } from "./panel.mjs";

/** The buttons: the switch register, then the keys. */
function buttons() {
  const rockers = Array.from({ length: 12 }, (_, bit) => html`<button class="rocker" data-click="switches.flip" value="${bit}" role="switch" aria-checked="false" aria-label="switch ${bit}"></button>`);
  return html`<div role="toolbar" aria-label="Switch register">${rockers}</div><div role="toolbar" aria-label="Keys">${KEYS.map(key)}</div>`;
}

/** @type {Record<string, string>} */ const SHORTCUTS = { start: "S", "load add": "L", dep: "D", exam: "E", cont: "C", stop: "T" };

function key(/** @type {string} */ name) {
  const role = SHORTCUTS[name] ? html`aria-keyshortcuts="${SHORTCUTS[name]}"` : html`role="switch" aria-checked="false"`;
  return html`<button class="key" data-click="switches.key" data-key="${name}" ${role} aria-label="${name.toUpperCase()}"></button>`;
}

export class Hands {
  constructor(/** @type {HTMLElement} */ place) {
    this.place = place;
    this.set = "";
    put(place, buttons());
    this.buttons = [...place.querySelectorAll("button")];
    for (const row of place.children) rove(/** @type {HTMLElement} */ (row));
  }

  /** Lay them over the panel as it is `shown`: all of it, or its parts. */
  lay(/** @type {Shown} */ shown) {
    this.buttons.forEach((button, index) => {
      const { x, y, w, h } = within(shown, SWITCHES[index]);
      const part = { left: x / shown.w, top: y / shown.h, width: w / shown.w, height: h / shown.h };
      for (const [side, share] of Object.entries(part)) button.style.setProperty(side,  `${(100 * share).toFixed(2)}%`);
    });
  }

  /** Mark what is to be touched: a key, or bits of the register. */
  due(/** @type {string | null} */ due, /** @type {number} */ bits) {
    this.buttons.forEach(({ dataset }, index, all) => (all[index].ariaCurrent = (dataset.key ? dataset.key === due : bits & (0o4000 >> index)) ? "step" : null));
  }

  /** Scroll to what is to be touched. */
  seek() {
    this.place.querySelector("[aria-current]")?.scrollIntoView({ block: "nearest" });
  }

  /** Say how the switches stand. */
  mark(/** @type {Processor} */ { sr, mem_prot: protection, sing_step: step }) {
    const set = `${sr} ${protection} ${step}`;
    if (set === this.set) return;
    this.set = set;
    /** @type {Record<string, number>} */ const down = { "mem prot": protection, "sing step": step };
    this.buttons.forEach((button, index) => {
      const { key: name } = button.dataset;
      if (button.role === "switch") button.ariaChecked = String(Boolean(name ? down[name] : sr & (0o4000 >> index)));
    });
  }
}
