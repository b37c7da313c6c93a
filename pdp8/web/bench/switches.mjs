// The panel's switches and keys, by mouse, touch and keyboard, and the RIM loader's card beside them.
//
//     0 to 7          an octal digit into the switches, from the right      S L D E C T W   as the keys name them

import { FETCH } from "../../../pal/isa.mjs";
import { Operator, RIM, RIM_START } from "../../computer/use/operator.mjs";
import { Coach, find as drill } from "../../lessons/drill.mjs";
import { html, put } from "../html.mjs";
import { Panel } from "../panel.mjs";
import { find } from "../written.mjs";
import { keyed, modified } from "./wiring.mjs";

export class Switches {
  constructor(/** @type {Bench} */ bench) {
    this.bench = bench;
    this.panel = new Panel(find("computer"));
    this.card = new Card(bench);
    document.addEventListener("keydown", (event) => {
      const room = bench.room.open && find("room"), place = room ? room.querySelector(".hand") : find("computer");
      const own = room && (event.target?.matches("input") || room.querySelector("dialog[open]"));
      if (!own && place.checkVisibility() && (room || place.contains(/** @type {Node} */ (event.target)))) this.#key(place, event);
    });
  }

  show(/** @type {Lamps[] | undefined} */ samples) {
    this.panel.show(this.bench.machine, this.bench.afternoon.pressed, samples);
  }

  flip(/** @type {{ value: number | string }} */ { value: bit }) {
    this.#set(this.bench.machine.processor.sr ^ (0o4000 >> Number(bit)));
  }

  /** Set the switch register. */
  #set(/** @type {number} */ word) {
    this.bench.touch(({ panel }) => (panel.sr = word));
  }

  key(/** @type {HTMLElement} */ { dataset }) {
    this.press(String(dataset.key));
  }

  press(/** @type {string} */ name) {
    this.bench.afternoon.takeOver();
    const { panel, processor } = /** @type {{ panel: any; processor: Processor }} */ (this.bench.machine);
    const method = name.replace(" ", "_");
    const ran = processor.run;
    if (name === "sing step" || name === "mem prot") {
      if (name === "sing step") awaitHand(this.bench.machine);
      panel[method] = !panel[method];
    } else if (this.card.allows(method)) panel[method]();
    else return;
    this.bench.room.answer(name);
    if (processor.run && (name === "start" || name === "cont")) this.bench.started(name);
    this.bench.touched();
    if (ran && name === "stop") this.bench.say(this.bench.told("limit"));
  }

  #key(/** @type {HTMLElement} */ place, /** @type {KeyboardEvent} */ event) {
    const control = keyed(place, event);
    if (control) control.click();
    else if (/^[0-7]$/.test(event.key) && place.querySelector(".rocker") && !modified(event)) this.#set(((this.bench.machine.processor.sr << 3) | Number(event.key)) & 0o7777);
    else return;
    event.preventDefault();
  }
}

/** A picture ends between instructions, but a key may be pressed in any cycle. */
function awaitHand(/** @type {Machine} */ machine) {
  const { run, next } = machine.processor;
  if (run && next === FETCH) machine.run(null, null, Math.floor(Math.random() * 3));
}

/** The RIM loader as it was stuck on the panel; it can be toggled in, or practised. */
class Card {
  constructor(/** @type {Bench} */ bench) {
    this.bench = bench;
    this.card = drill("rim", []);
    this.coach = /** @type {Coach | null} */ (null); // who looks on while it is practised
    this.looked = 0; // when the coach last did: the clock is that of the visitor, not of the machine
    put(find("card").querySelector("ol"), this.card.steps.map(({ say }) => html`<li>${say}</li>`));
  }

  /** Lay the card open, and practise. */
  practise() {
    find("card").querySelector("details").open = true;
    this.#practise(true);
    find("card").scrollIntoView({ block: "nearest" });
    find("computer").querySelector(".rocker").focus({ preventScroll: true });
  }

  /** How far the practice has come. */
  get kept() {
    const { coach } = this;
    return coach && [coach.at, coach.wrong, coach.seconds, coach.begun];
  }

  set kept(/** @type {any} */ [at, wrong, seconds, begun]) {
    this.#practise(true);
    find("card").querySelector("details").open = true;
    const coach = Object.assign(/** @type {Coach} */ (this.coach), { at: at % this.card.steps.length, wrong, seconds, begun });
    this.#say(`Go on: ${this.card.steps[coach.at].say}`);
  }

  /** Something else is in core: nobody practises, nor has toggled it in. */
  end() {
    this.coach = /** @type {Coach | null} */ (null);
    this.#say("");
  }

  toggle() {
    this.end();
    const keys = this.bench.touch((machine) => {
      machine.panel.stop();
      machine.panel.mem_prot = false;
      return [...new Operator(machine).toggle(RIM_START, RIM)].length;
    });
    this.#say(`${keys} keys: the RIM loader is in 7756 to 7776.`);
  }

  drill() {
    this.bench.touch(({ panel }) => panel.stop()); // a machine that runs hears no key
    if (this.coach) this.#practise(false);
    else this.practise();
  }

  #practise(/** @type {boolean} */ on) {
    this.coach = on ? new Coach(this.card, this.bench.machine) : null;
    this.looked = performance.now();
    this.#say(this.coach?.said ?? "");
  }

  /** Whether a key may be pressed: where the card is practised, the next one alone. */
  allows(/** @type {string} */ key) {
    const { coach } = this;
    if (!coach) return true;
    coach.machine = this.bench.machine;
    const now = performance.now();
    coach.advance((now - this.looked) / 1000);
    this.looked = now;
    const allowed = coach.allows(key);
    if (coach.done) this.coach = /** @type {Coach | null} */ (null);
    this.#say(coach.said);
    return allowed;
  }

  #say(/** @type {string} */ words) {
    const at = this.coach ? this.coach.at : -1;
    [...find("card").querySelectorAll("li")].forEach((row, index) => row.classList.toggle("now", index === at));
    find("drill").ariaPressed = String(Boolean(this.coach));
    find("drill-says").textContent = words;
  }
}
