// The panel's switches and keys, by mouse, touch and keyboard, and the RIM loader's card beside them.
//
//     0 to 7          an octal digit into the switches, from the right      S L D E C T W   START, LOAD ADD, DEP, EXAM, CONT, STOP, in words

import { RIM, RIM_START } from "../../computer/use/operator.mjs";
import { Panel } from "../panel.mjs";
import { find, octal } from "../written.mjs";

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
    this.card = new Card(bench, this);
  }

  show(brightness) {
    const { machine } = this.bench;
    this.panel.show(machine, this.bench.afternoon.on ? this.bench.afternoon.pressed : null, brightness);
  }

  /** Set the switch register. */
  set(word) {
    this.bench.afternoon.takeOver();
    this.bench.machine.processor.sr = word & 0o7777;
    this.bench.touched();
  }

  press(name) {
    this.bench.afternoon.takeOver();
    const { panel, processor } = this.bench.machine;
    if (name === "sing step") processor.sing_step ^= 1;
    else if (name === "mem prot") processor.mem_prot ^= 1;
    else panel[METHODS[name]]();
    if (name === "sing step" && processor.sing_step) processor.stop();
    if (processor.run && (name === "start" || name === "cont")) this.bench.started(name);
    this.card.pressed(name);
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
  constructor(bench, switches) {
    this.bench = bench;
    this.switches = switches;
    this.drill = -1; // the word that is to be deposited next; -1: no drill
    const rows = RIM.map((word, index) => `<li><span>${octal(RIM_START + index)}</span> <b>${octal(word)}</b></li>`);
    find("card").innerHTML = `<details><summary>RIM loader</summary>
      <ol>${rows.join("")}</ol>
      <div class="tools"><button class="text" id="toggle-rim">Toggle it in for me</button><button class="text" id="drill" aria-pressed="false">Drill</button></div>
      <p role="status" id="drill-says"></p></details>`;
    find("toggle-rim").addEventListener("click", () => this.#toggle());
    find("drill").addEventListener("click", () => this.#start());
  }

  /** Lay the card open, and practise. */
  practise() {
    find("card").querySelector("details").open = true;
    if (this.drill < 0) this.#start();
    find("computer").querySelector(".rocker").focus();
  }

  #toggle() {
    this.bench.afternoon.takeOver();
    const { machine } = this.bench;
    machine.panel.stop();
    machine.processor.mem_prot = 0;
    this.switches.set(RIM_START);
    machine.panel.load_add();
    for (const word of RIM) {
      machine.processor.sr = word;
      machine.panel.dep();
    }
    this.bench.touched();
    this.#say("18 keys: the RIM loader is in 7756 to 7776.");
  }

  #start() {
    this.drill = this.drill < 0 ? 0 : -1;
    find("drill").ariaPressed = String(this.drill >= 0);
    this.address = false;
    this.#say(this.drill < 0 ? "" : `Set ${octal(RIM_START)} into the switches and press LOAD ADD.`);
    this.#mark();
  }

  /** A key was pressed: say what was wrong with it, or what comes next. */
  pressed(name) {
    if (this.drill < 0) return;
    const { processor } = this.bench.machine;
    const wanted = this.address ? RIM[this.drill] : RIM_START;
    const key = this.address ? "dep" : "load add";
    if (name !== key) {
      this.#say(`That was ${name.toUpperCase()}; ${key.toUpperCase()} is due.`);
    } else if (processor.sr !== wanted) {
      this.#say(`${wrong(processor.sr, wanted)}. Press LOAD ADD with ${octal(RIM_START + this.drill)} to go back to it.`);
      if (this.address) this.address = false;
    } else if (!this.address) {
      this.address = true;
      this.#say(`Now ${octal(RIM[this.drill])} and DEP.`);
    } else if (++this.drill === RIM.length) {
      this.drill = -1;
      find("drill").ariaPressed = "false";
      this.#say("All 17 words are in core.");
    } else {
      this.#say(`${octal(wanted)} is in ${octal(processor.ma)}. Now ${octal(RIM[this.drill])} and DEP.`);
    }
    this.#mark();
  }

  #mark() {
    [...find("card").querySelectorAll("li")].forEach((row, index) => row.classList.toggle("now", index === this.drill));
  }

  #say(words) {
    find("drill-says").textContent = words;
  }
}

/** Which switches are wrong. */
function wrong(set, wanted) {
  const bits = [...Array(12).keys()].filter((bit) => (set ^ wanted) & (0o4000 >> bit));
  const each = bits.map((bit) => `${bit} should be ${wanted & (0o4000 >> bit) ? "up" : "down"}`);
  return `${octal(set)} is set, ${octal(wanted)} is wanted: switch ${each.join(", switch ")}`;
}
