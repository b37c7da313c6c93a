// The 8/L's front panel: its lamps and switches, and nothing it has not (no PC, no MQ, no step counter).
//
// Left out: MEM PROT and the field switches, which nobody touches this afternoon. EMA, PARITY, PROTECT and the states of
// the data break have their lamps, and never light.
//
// Source: PDP-8/L Users Handbook, chapter 2 (console).

import { lit } from "./brightness.mjs";
import { STATES } from "../../pal/isa.mjs";
import { octal } from "./written.mjs";

const SIGNS = ["FETCH", "DEFER", "EXECUTE", "WORD COUNT", "CURR ADDR", "BREAK", "ION", "PARITY", "PROTECT", "RUN"];
const KEYS = ["START", "LOAD ADD", "DEP", "EXAM", "CONT", "STOP", "SING STEP"];

const LEVELS = 12; // of brightness
const SLACK = 1.5; // levels by which a lamp may be off while a machine runs: nobody sees less
const INERTIA = 0.6; // what a filament keeps of its brightness from one picture to the next

export class Panel {
  /** In `place`; `live` switches and keys are buttons, with MEM PROT among them. */
  constructor(place, live = false) {
    const rockerOf = live ? liveRocker : rocker;
    const keyOf = live ? liveKey : key;
    const keys = live ? ["MEM PROT", ...KEYS] : KEYS;
    place.innerHTML = `
      <div class="brand"><b>digital</b><span>programmed data processor <i>PDP-8/L</i></span></div>
      <div class="lamps">
        <div class="words">
          ${row("MA", "MEMORY ADDRESS", 12, "EMA", "EMA")}${row("MB", "MEMORY BUFFER", 12)}${row("AC", "ACCUMULATOR", 12, "LINK", "L")}
        </div>
        <div class="signs">
          <div class="row" data-row="IR"><span class="legend">INSTR REG</span>${group(lamps("IR", [0, 1, 2]))}</div>
          <div class="states">${SIGNS.map(sign).join("")}</div>
        </div>
      </div>
      <div class="switches">
        <div class="row" data-row="SR"><span class="legend">SWITCH REGISTER</span>${groups(12, rockerOf)}</div>
        <div class="keys">${keys.map(keyOf).join("")}</div>
      </div>
      <p class="spoken" aria-hidden="true"></p>`;
    this.lamps = new Map([...place.querySelectorAll("[data-lamp]")].map((lamp) => [lamp.dataset.lamp, lamp]));
    this.rockers = [...place.querySelectorAll(".rocker")];
    this.keys = new Map([...place.querySelectorAll(".key")].map((button) => [button.dataset.key, button]));
    this.spoken = place.querySelector(".spoken");
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
    this.#switches(machine.processor.sr);
    if (pressed !== this.pressed) {
      this.pressed = pressed;
      for (const [name, button] of this.keys) button.classList.toggle("pressed", name === pressed);
    }
  }

  /** What the lamps say, in words, for who cannot see them. */
  say(machine) {
    const words = spoken(machine);
    if (this.spoken.textContent !== words) this.spoken.textContent = words;
  }

  #switches(sr) {
    if (sr === this.sr) return;
    this.sr = sr;
    this.rockers.forEach((rocker, bit) => {
      const up = Boolean(sr & (0o4000 >> bit));
      rocker.classList.toggle("up", up);
      if (rocker.ariaChecked !== null) rocker.ariaChecked = String(up);
    });
  }

  /** A lamp keeps its level while that is within `slack` of its share. */
  #light(name, share, slack) {
    if (Math.abs(share * LEVELS - this.levels.get(name)) <= slack) return;
    const level = Math.round(share * LEVELS);
    this.levels.set(name, level);
    const lamp = this.lamps.get(name);
    lamp.classList.toggle("on", level > LEVELS / 2);
    lamp.style.setProperty("--lit", level / LEVELS);
  }
}

/** The name of a major state, as its lamp has it. */
export function stateName(state) {
  return STATES[state];
}

function spoken({ link, ac, processor: { ma, mb, ir, state, ion, run } }) {
  const cycle = stateName(state).toLowerCase();
  return `memory address ${octal(ma)}, memory buffer ${octal(mb)}, link ${link}, accumulator ${octal(ac)}, `
    + `instruction ${ir}, ${cycle}${ion ? ", interrupt on" : ""}, ${run ? "running" : "stopped"}`;
}

/** A row of lamps under its legend; one may stand before it. */
function row(name, legend, bits, before = "", label = "") {
  const link = `<span class="link">${before && lamp(before, label)}</span>`;
  const lamps = groups(bits, (bit) => lamp(name + bit, bit));
  return `<div class="row" data-row="${name}"><span class="legend">${legend}</span>${link}${lamps}</div>`;
}

function groups(bits, draw) {
  let html = "";
  for (let bit = 0; bit < bits; bit += 3) html += group([bit, bit + 1, bit + 2].map(draw).join(""));
  return html;
}

function group(inside) {
  return `<span class="group">${inside}</span>`;
}

function lamps(name, bits) {
  return bits.map((bit) => lamp(name + bit, bit)).join("");
}

function lamp(name, label) {
  return `<span class="lamp" data-lamp="${name}" aria-hidden="true"><i></i><small>${label}</small></span>`;
}

function sign(name) {
  return `<span class="lamp sign" data-lamp="${name}" aria-hidden="true"><i></i><small>${name}</small></span>`;
}

function rocker(bit) {
  return `<span class="rocker" aria-hidden="true"><i></i><small>${bit}</small></span>`;
}

function liveRocker(bit) {
  const said = `role="switch" aria-checked="false" aria-label="switch ${bit}"`;
  return `<button class="rocker" ${said}><i></i><small>${bit}</small></button>`;
}

function liveKey(name) {
  const locking = name === "MEM PROT" || name === "SING STEP";
  const role = locking ? ` role="switch" aria-checked="false"` : "";
  return `<button class="key" data-key="${name.toLowerCase()}"${role} aria-label="${name}"><i></i><small>${name}</small></button>`;
}

function key(name) {
  return `<span class="key" data-key="${name.toLowerCase()}" aria-hidden="true"><i></i><small>${name}</small></span>`;
}
