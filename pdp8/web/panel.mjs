// The 8/L's front panel: its lamps and switches, and nothing it has not (no PC, no MQ, no step counter).
//
// Left out: the field switches. EMA, PARITY and the states of the data break have their lamps, and never light.
//
// Source: PDP-8/L Users Handbook, chapter 2 (console).

import { shares } from "../computer/hardware/panel.mjs";
import { STATES } from "../../pal/isa.mjs";
import { octal } from "./written.mjs";

const SIGNS = {
  fetch: "FETCH", defer: "DEFER", execute: "EXECUTE", word_count: "WORD COUNT", current_address: "CURR ADDR",
  break_: "BREAK", ion: "ION", parity: "PARITY", protect: "PROTECT", run: "RUN",
};
/** With the letters that press them. */
const KEYS = { "MEM PROT": "", START: "S", "LOAD ADD": "L", DEP: "D", EXAM: "E", CONT: "C", STOP: "T", "SING STEP": "" };

const LEVELS = 12; // of brightness
const SLACK = 1.5; // levels by which a lamp may be off while a machine runs: nobody sees less
const INERTIA = 0.6; // what a filament keeps of its brightness from one picture to the next

export class Panel {
  constructor(place) {
    place.innerHTML = `<h2 class="spoken">The front panel</h2>
      <div class="brand"><b>digital</b><span>programmed data processor <i>PDP-8/L</i></span></div>
      <div class="lamps">
        ${row("ma", "MEMORY ADDRESS", lamp("ema", "EMA"))}${row("mb", "MEMORY BUFFER")}${row("ac", "ACCUMULATOR", lamp("link", "L"))}
        <div class="signs">
          <div class="row" data-row="IR"><span class="legend">INSTR REG</span><span class="group">${[0, 1, 2].map((bit) => lamp("ir", bit)).join("")}</span></div>
          <div class="states">${Object.entries(SIGNS).map(([name, label]) => lamp(name, label, "sign")).join("")}</div>
        </div>
        <div class="row" data-row="SR" role="toolbar" aria-label="Switch register"><span class="legend" aria-hidden="true">SWITCH REGISTER</span><span class="link"></span>${groups(rocker)}</div>
        <div class="keys" role="toolbar" aria-label="Keys">${Object.entries(KEYS).map(key).join("")}</div>
      </div>
      <div class="words"><button id="in-words" data-click="switches.panel.speak" aria-keyshortcuts="W" aria-pressed="false">Lamps in words</button><p role="status"></p></div>
      <button class="enlarge" data-click="enlarge" aria-label="The PDP-8/L's front panel: alone" aria-pressed="false" title="This alone, or all"><svg viewBox="0 0 20 20" aria-hidden="true"><path d="M3 3h6v2H5v4H3zM11 15h4v-4h2v6h-6z"/></svg></button>`;
    this.lamps = Map.groupBy(place.querySelectorAll("[data-lamp]"), ({ dataset }) => dataset.lamp);
    this.rockers = [...place.querySelectorAll(".rocker")];
    this.keys = new Map([...place.querySelectorAll(".key")].map((button) => [button.dataset.key, button]));
    this.button = place.querySelector("#in-words");
    this.shares = new Map(); // of the time in which each lamp was lit, as a filament keeps them
    this.levels = new Map();
  }

  /** Show the machine: its lamps as bright as they were in some samples, or as they are; the key that is being pressed,
   *  if any.
   */
  show(machine, pressed, samples) {
    const [inertia, slack] = samples ? [INERTIA, SLACK] : [0, 0];
    for (const [field, bits] of shares(samples ?? [machine.panel.lamps]).items()) {
      const lamps = this.lamps.get(field);
      bits.forEach((now, bit) => this.#light(lamps[bit], now, inertia, slack));
    }
    this.#switches(machine.processor);
    this.words = samples ? inWords(machine).split(", ").at(-1) : inWords(machine);
    if (this.speaking) this.#say(this.words);
    if (pressed === this.pressed) return;
    this.pressed = pressed;
    for (const [name, button] of this.keys) button.classList.toggle("pressed", name === pressed);
  }

  /** Say the lamps in words from now on, or no more. */
  speak() {
    this.speaking = !this.speaking;
    this.button.ariaPressed = String(this.speaking);
    this.#say(this.speaking ? this.words : "");
  }

  #say(words) {
    const place = this.button.nextElementSibling;
    if (place.textContent !== words) place.textContent = words;
  }

  #switches({ sr, sing_step: step, mem_prot: protection }) {
    const set = `${sr} ${step} ${protection}`;
    if (set === this.set) return;
    this.set = set;
    this.rockers.forEach((each, bit) => {
      const up = Boolean(sr & (0o4000 >> bit));
      each.classList.toggle("up", up);
      each.ariaChecked = String(up);
    });
    this.keys.get("sing step").ariaChecked = String(Boolean(step));
    this.keys.get("mem prot").ariaChecked = String(Boolean(protection));
  }

  /** A lamp keeps its level while that is within `slack` of its share of the time. */
  #light(place, now, inertia, slack) {
    const share = now + ((this.shares.get(place) ?? now) - now) * inertia;
    this.shares.set(place, share);
    if (Math.abs(share * LEVELS - this.levels.get(place)) <= slack) return;
    const level = Math.round(share * LEVELS);
    this.levels.set(place, level);
    place.classList.toggle("on", level > LEVELS / 2);
    place.style.setProperty("--lit", level / LEVELS);
  }
}

/** What the lamps say. */
export function inWords({ link, ac, processor: { ma, mb, ir, state, ion, run } }) {
  return `memory address ${octal(ma)}, memory buffer ${octal(mb)}, link ${link}, accumulator ${octal(ac)}, `
    + `instruction ${ir}, ${STATES[state].toLowerCase()}${ion ? ", interrupt on" : ""}, ${run ? "running" : "stopped"}`;
}

/** A row of lamps under its legend; one may stand before it. */
function row(name, legend, before = "") {
  return `<div class="row" data-row="${name.toUpperCase()}"><span class="legend">${legend}</span><span class="link">${before}</span>${groups((bit) => lamp(name, bit))}</div>`;
}

/** Twelve of what is drawn of a bit, in groups of three. */
function groups(draw) {
  return [0, 3, 6, 9].map((bit) => `<span class="group">${draw(bit)}${draw(bit + 1)}${draw(bit + 2)}</span>`).join("");
}

function lamp(name, label, kind = "") {
  return `<span class="lamp ${kind}" data-lamp="${name}" aria-hidden="true"><i></i><small>${label}</small></span>`;
}

function rocker(bit) {
  return `<button class="rocker" data-click="switches.flip" value="${bit}" role="switch" aria-checked="false" aria-label="switch ${bit}"><i></i><small>${bit}</small></button>`;
}

function key([name, letter]) {
  const role = letter ? ` aria-keyshortcuts="${letter}"` : ` role="switch" aria-checked="false"`;
  return `<button class="key" data-click="switches.key" data-key="${name.toLowerCase()}"${role} aria-label="${name}"><i></i><small>${name}</small></button>`;
}
