// The 8/L's front panel: its lamps and switches, and nothing it has not (no PC, no MQ, no step counter).
//
// What stands where is in bench/panel.html. Left out: the field switches. EMA, PARITY and the states of the data break have their lamps, and never light.
//
// Source: PDP-8/L Users Handbook, chapter 2 (console).

import { shares } from "../computer/hardware/panel.mjs";
import { STATES } from "../../pal/isa.mjs";
import { html, put } from "./html.mjs";
import { find, octal } from "./written.mjs";

const LEVELS = 12; // of brightness
const SLACK = 1.5; // levels by which a lamp may be off while a machine runs: nobody sees less
const INERTIA = 0.6; // what a filament keeps of its brightness from one picture to the next

export class Panel {
  constructor(place) {
    for (const bits of place.querySelectorAll("[data-bits]")) put(bits, groups(bits.dataset.bits));
    this.lamps = Map.groupBy(place.querySelectorAll("[data-lamp]"), ({ dataset }) => dataset.lamp);
    this.rockers = [...place.querySelectorAll(".rocker")];
    this.keys = new Map([...place.querySelectorAll(".key")].map((button) => [button.dataset.key, button]));
    this.button = find("in-words");
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
    this.words = samples && machine.processor.run ? "running" : inWords(machine);
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

/** The twelve lamps of a word, or the switches, in groups of three. */
function groups(name) {
  const draw = name === "sr" ? rocker : (bit) => html`<span class="lamp" data-lamp="${name}" aria-hidden="true"><i></i><small>${bit}</small></span>`;
  return [0, 3, 6, 9].map((bit) => html`<span class="group">${draw(bit)}${draw(bit + 1)}${draw(bit + 2)}</span>`);
}

function rocker(bit) {
  return html`<button class="rocker" data-click="switches.flip" value="${bit}" role="switch" aria-checked="false" aria-label="switch ${bit}"><i></i><small>${bit}</small></button>`;
}
