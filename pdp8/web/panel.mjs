// The 8/L's front panel on the desk: drawn as in the room (room/panel.mjs), its switches as buttons over it, its lamps in words.

import { STATES } from "../../pal/isa.mjs";
import { Hands } from "./room/hands.mjs";
import { kept, scale, sheet } from "./room/ink.mjs";
import { APART, drawLamps, drawPanel, Filaments, inPieces, WHOLE } from "./room/panel.mjs";
import { Sheet } from "./sheet.mjs";
import { find, octal } from "./written.mjs";

const LEVELS = 12; // of brightness: a smaller change is not drawn
const INERTIA = 0.6; // what a filament keeps of its brightness from one picture to the next

export class Panel {
  constructor(/** @type {HTMLElement} */ place) {
    this.hands = new Hands(place.querySelector(".hand"));
    this.filaments = new Filaments();
    this.button = find("in-words");
    this.canvas = new Sheet(place.querySelector("canvas"), () => this.machine && this.#draw());
  }

  /** Show the machine: its lamps as bright as they were in some samples, or as they are; the key that is being pressed,
   *  if any.
   */
  show(/** @type {Machine} */ machine, /** @type {string | null} */ pressed, /** @type {Lamps[] | undefined} */ samples) {
    /** @type {Machine} */ this.machine = machine;
    /** @type {string | null} */ this.pressed = pressed;
    this.filaments.follow(samples ?? [machine.panel.lamps], samples ? INERTIA : 0, machine.panel.ema);
    this.hands.mark(machine.processor);
    /** @type {string} */ this.words = samples && machine.processor.run ? "running" : inWords(machine);
    if (this.speaking) this.#say(this.words);
    this.#draw();
  }

  #draw() {
    const { filaments: { lit }, machine: { processor }, pressed, canvas } = this;
    const { sr, mem_prot: protection, sing_step: step } = processor;
    const shown = canvas.width < canvas.height ? APART : WHOLE;
    this.hands.lay(shown);
    const levels = [...lit.values()].flat().map((level) => Math.round(level * LEVELS));
    canvas.draw(`${levels} ${sr} ${protection} ${step} ${pressed}`, (c, width) => {
      c.scale(width / shown.w, width / shown.w);
      const sharp = scale(c);
      const still = kept(`panel ${sharp}`, () => sheet(WHOLE.w, WHOLE.h, sharp, drawPanel));
      inPieces(c, shown, () => {
        c.drawImage(still, 0, 0, WHOLE.w, WHOLE.h);
        drawLamps(c, lit, processor, pressed);
      });
    });
  }

  /** Begin or end to say the lamps in words. */
  speak() {
    this.speaking = !this.speaking;
    this.button.ariaPressed = String(this.speaking);
    this.#say(this.speaking ? this.words : "");
  }

  #say(/** @type {string} */ words) {
    const place = this.button.nextElementSibling;
    if (place.textContent !== words) place.textContent = words;
  }
}

/** What the lamps say. */
export function inWords(/** @type {Machine} */ { link, ac, panel: { ema }, processor: { ma, mb, ir, state, ion, run } }) {
  return `${ema ? "EMA lit, " : ""}memory address ${octal(ma)}, memory buffer ${octal(mb)}, link ${link}, accumulator ${octal(ac)}, `
    + `instruction ${ir}, ${STATES[state].toLowerCase()}${ion ? ", interrupt on" : ""}, ${run ? "running" : "stopped"}`;
}
