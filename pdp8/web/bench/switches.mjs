// The panel's switches and keys, by mouse, touch and keyboard, and the RIM loader's card beside them.
//
//     0 to 7          an octal digit into the switches, from the right      S L D E C T W   START, LOAD ADD, DEP, EXAM, CONT, STOP, in words

import { Operator, RIM, RIM_START } from "../../computer/use/operator.mjs";
import { Coach, find as drill } from "../../lessons/drill.mjs";
import { Panel } from "../panel.mjs";
import { find } from "../written.mjs";

const METHODS = { start: "start", "load add": "load_add", dep: "dep", exam: "exam", cont: "cont", stop: "stop" };
const LETTERS = { s: "start", l: "load add", d: "dep", e: "exam", c: "cont", t: "stop" };

export class Switches {
  constructor(bench) {
    this.bench = bench;
    this.panel = new Panel(find("computer"));
    this.panel.rockers.forEach((rocker, bit) => {
      rocker.addEventListener("click", () => this.set(bench.machine.processor.sr ^ (0o4000 >> bit)));
    });
    for (const [name, key] of this.panel.keys) key.addEventListener("click", () => this.press(name));
    find("computer").addEventListener("keydown", (event) => this.#key(event));
    this.card = new Card(bench);
  }

  show(brightness) {
    const { machine } = this.bench;
    this.panel.show(machine, this.bench.afternoon.on ? this.bench.afternoon.pressed : null, brightness);
  }

  /** Set the switch register. */
  set(word) {
    this.bench.touch(({ processor }) => (processor.sr = word & 0o7777));
  }

  press(name) {
    this.bench.afternoon.takeOver();
    if (!this.card.allows(METHODS[name])) return;
    const { panel, processor } = this.bench.machine;
    if (name === "sing step") processor.sing_step ^= 1;
    else if (name === "mem prot") processor.mem_prot ^= 1;
    else panel[METHODS[name]]();
    if (name === "sing step" && processor.sing_step) processor.stop();
    if (processor.run && (name === "start" || name === "cont")) this.bench.started(name);
    this.bench.touched();
  }

  #key(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (/^[0-7]$/.test(event.key)) this.set((this.bench.machine.processor.sr << 3) | Number(event.key));
    else if (event.key.toLowerCase() === "w") this.panel.speak();
    else if (LETTERS[event.key.toLowerCase()]) this.press(LETTERS[event.key.toLowerCase()]);
    else return;
    event.preventDefault();
  }
}

/** The RIM loader as it was stuck on the panel; it can be toggled in, or practised. */
class Card {
  constructor(bench) {
    this.bench = bench;
    this.card = drill("rim", null);
    this.coach = null; // who looks on while it is practised
    find("card").innerHTML = `<details><summary>RIM loader</summary><p role="status" id="drill-says"></p>
      <ol>${this.card.steps.map(({ say }) => `<li>${say}</li>`).join("")}</ol>
      <div class="tools"><button class="text" id="toggle-rim">Toggle it in for me</button><button class="text" id="drill" aria-pressed="false">Drill</button></div></details>`;
    find("toggle-rim").addEventListener("click", () => this.#toggle());
    find("drill").addEventListener("click", () => this.#practise(!this.coach));
  }

  /** Lay the card open, and practise. */
  practise() {
    find("card").querySelector("details").open = true;
    this.#practise(true);
    find("card").scrollIntoView({ block: "nearest" });
    find("computer").querySelector(".rocker").focus({ preventScroll: true });
  }

  /** Something else is in core: nobody practises. */
  end() {
    if (!this.coach) return;
    this.coach = null;
    this.#say("");
  }

  #toggle() {
    const keys = this.bench.touch((machine) => {
      machine.panel.stop();
      machine.panel.mem_prot = false;
      return [...new Operator(machine).toggle(RIM_START, RIM)].length;
    });
    this.#say(`${keys} keys: the RIM loader is in 7756 to 7776.`);
  }

  #practise(on) {
    this.bench.afternoon.takeOver();
    this.coach = on ? new Coach(this.card, this.bench.machine) : null;
    this.#say(this.coach?.said ?? "");
  }

  /** Whether a key may be pressed: where the card is practised, the next one alone. */
  allows(key) {
    const { coach } = this;
    if (!coach || !key) return true;
    coach.machine = this.bench.machine;
    const allowed = coach.allows(key);
    this.#say(coach.said);
    if (coach.done) this.coach = null;
    return allowed;
  }

  #say(words) {
    const at = this.coach && !this.coach.done ? this.coach.at : -1;
    [...find("card").querySelectorAll("li")].forEach((row, index) => row.classList.toggle("now", index === at));
    find("drill").ariaPressed = String(Boolean(this.coach && !this.coach.done));
    find("drill-says").textContent = words;
  }
}
