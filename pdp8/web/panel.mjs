// The 8/L's front panel: its lamps and switches, and nothing it has not (no PC, no MQ, no step counter).
//
// Left out: the field switches. EMA, PARITY and the states of the data break have their lamps, and never light.
//
// Source: PDP-8/L Users Handbook, chapter 2 (console).

import { lit } from "./brightness.mjs";
import { STATES } from "../../pal/isa.mjs";
import { octal } from "./written.mjs";

const SIGNS = ["FETCH", "DEFER", "EXECUTE", "WORD COUNT", "CURR ADDR", "BREAK", "ION", "PARITY", "PROTECT", "RUN"];
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
        ${row("MA", "MEMORY ADDRESS", 12, "EMA", "EMA")}${row("MB", "MEMORY BUFFER", 12)}${row("AC", "ACCUMULATOR", 12, "LINK", "L")}
        <div class="signs">
          <div class="row" data-row="IR"><span class="legend">INSTR REG</span><span class="group">${[0, 1, 2].map((bit) => lamp(`IR${bit}`, bit)).join("")}</span></div>
          <div class="states">${SIGNS.map((name) => lamp(name, name, "sign")).join("")}</div>
        </div>
        <div class="row" data-row="SR" role="toolbar" aria-label="Switch register"><span class="legend" aria-hidden="true">SWITCH REGISTER</span><span class="link"></span>${groups(12, rocker)}</div>
        <div class="keys" role="toolbar" aria-label="Keys">${Object.entries(KEYS).map(key).join("")}</div>
      </div>
      <div class="words"><button id="in-words" data-click="switches.panel.speak" aria-keyshortcuts="W" aria-pressed="false">Lamps in words</button><p role="status"></p></div>`;
    this.lamps = new Map([...place.querySelectorAll("[data-lamp]")].map((each) => [each.dataset.lamp, each]));
    this.rockers = [...place.querySelectorAll(".rocker")];
    this.keys = new Map([...place.querySelectorAll(".key")].map((button) => [button.dataset.key, button]));
    this.button = place.querySelector("#in-words");
    this.shares = {}; // of the time in which each lamp was lit, as a filament keeps them
    this.levels = new Map();
  }

  /** Show the machine: its lamps as bright as they were, or as they are; the key that is being pressed, if any. */
  show(machine, pressed, brightness) {
    const [inertia, slack] = brightness ? [INERTIA, SLACK] : [0, 0];
    const now = brightness ?? lit(machine);
    for (const name in now) {
      this.shares[name] = now[name] + ((this.shares[name] ?? now[name]) - now[name]) * inertia;
      this.#light(name, this.shares[name], slack);
    }
    this.#switches(machine.processor);
    this.words = brightness ? inWords(machine).split(", ").at(-1) : inWords(machine);
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

  /** A lamp keeps its level while that is within `slack` of its share. */
  #light(name, share, slack) {
    if (Math.abs(share * LEVELS - this.levels.get(name)) <= slack) return;
    const level = Math.round(share * LEVELS);
    this.levels.set(name, level);
    const place = this.lamps.get(name);
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
function row(name, legend, bits, before = "", label = "") {
  const link = `<span class="link">${before && lamp(before, label)}</span>`;
  return `<div class="row" data-row="${name}"><span class="legend">${legend}</span>${link}${groups(bits, (bit) => lamp(name + bit, bit))}</div>`;
}

function groups(bits, draw) {
  const each = Array.from({ length: bits }, (_, bit) => draw(bit));
  return each.map((html, bit) => (bit % 3 ? "" : `<span class="group">`) + html + (bit % 3 === 2 ? "</span>" : "")).join("");
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
