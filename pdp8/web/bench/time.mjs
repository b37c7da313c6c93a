// The time bar: run and stop, steps by unit, speed; the same controls for the afternoon and for the live machine.

import { READABLE } from "../pictures.mjs";
import { find } from "../written.mjs";
import { SPEEDS, USUAL } from "./clock.mjs";
import { next } from "./next.mjs";
import { rove } from "./roving.mjs";
import { Until } from "./until.mjs";

const TYPED_INTO = "input, select, textarea, [tabindex='0']:not(button), a, summary"; // what has keys of its own

export class Time {
  constructor(bench) {
    this.bench = bench;
    this.unit = "instruction";
    this.written = 0; // when, in ms
    find("speed").replaceChildren(...SPEEDS.map(([, label]) => new Option(String(label))));
    find("speed").selectedIndex = USUAL;
    find("speed").addEventListener("change", () => this.#hurry(0));
    find("play").addEventListener("click", () => this.toggle());
    find("forward").addEventListener("click", () => this.step(1));
    find("back").addEventListener("click", () => this.step(-1));
    find("units").addEventListener("change", ({ target }) => (this.unit = target.value));
    find("next").addEventListener("click", ({ target }) => target.dataset.for && this.#use(target.dataset.for));
    document.querySelectorAll("[role=toolbar]").forEach((toolbar) => rove(toolbar));
    this.#keys();
  }

  /** Run or stop, play or pause. */
  toggle() {
    const { bench } = this;
    if (bench.afternoon.on) bench.afternoon.play(!bench.afternoon.playing);
    else if (bench.machine.processor.run) bench.switches.press("stop");
    else this.run();
  }

  /** Press CONT; the run ends at its `goal`. */
  run(goal = new Until()) {
    const { bench } = this;
    bench.until = goal;
    bench.machine.panel.cont();
    bench.teletype.started();
    bench.touched();
  }

  /** Go on (1) or back (-1) by the chosen unit. */
  step(direction) {
    const { bench, unit } = this;
    if (bench.afternoon.on) bench.afternoon.step(unit, direction);
    else if (direction > 0) this.#forward(unit);
    else this.#back(unit);
  }

  #forward(unit) {
    const { bench } = this;
    bench.until.over();
    bench.until = new Until();
    const reason = bench.history.forward(unit);
    bench.machine.processor.run = 0;
    if (reason === "limit") bench.say("");
    else bench.ended(reason);
  }

  #back(unit) {
    const { bench } = this;
    let said = "";
    try {
      bench.history.back(unit);
    } catch (error) {
      said = String(error);
    }
    bench.machine.processor.run = 0;
    bench.say(said);
  }

  choose(unit) {
    this.unit = unit;
    document.querySelector(`#units input[value=${unit}]`).checked = true;
  }

  setSpeed(speed) {
    find("speed").selectedIndex = SPEEDS.findIndex(([each]) => each === speed);
    this.#hurry(0);
  }

  /** Take a speed so many places faster. */
  #hurry(by) {
    const select = find("speed");
    select.selectedIndex = Math.max(0, Math.min(SPEEDS.length - 1, select.selectedIndex + by));
    this.bench.clock.speed = SPEEDS[select.selectedIndex][0];
    this.bench.clock.wake();
  }

  #use(selector) {
    const control = document.querySelector(selector);
    if (control.matches("button")) control.click();
    else control.focus();
  }

  show(brightness) {
    const { bench } = this;
    const { afternoon, clock, machine, writer } = bench;
    const running = afternoon.on ? afternoon.playing : Boolean(machine.processor.run);
    writer.text(find("play"), afternoon.on ? (running ? "Pause" : "Play") : running ? "Stop" : "Run");
    if (brightness && performance.now() - this.written < READABLE) return;
    this.written = performance.now();
    writer.text(find("kept"), running ? clock.kept : "");
    if (afternoon.on) return;
    const [said, controls] = next(bench);
    const buttons = controls.map(([label, selector]) => `<button class="text" data-for="${selector}">${label}</button>`);
    writer.html(find("next"), `<span>${said}</span> ${buttons.join(" ")} ${afternoon.script ? afternoon.way : ""}`);
  }

  #keys() {
    const { bench } = this;
    const keys = {
      " ": () => this.toggle(),
      ArrowRight: () => this.step(1),
      ArrowLeft: () => this.step(-1),
      1: () => this.choose("block"),
      2: () => this.choose("character"),
      3: () => this.choose("instruction"),
      4: () => this.choose("cycle"),
      "+": () => this.#hurry(1),
      "=": () => this.#hurry(1),
      "-": () => this.#hurry(-1),
      "[": () => bench.afternoon.act(-1),
      "]": () => bench.afternoon.act(1),
      Home: () => bench.afternoon.go(0),
      End: () => bench.afternoon.go(Infinity),
    };
    document.addEventListener("keydown", (event) => {
      const action = keys[event.key];
      const own = event.target.matches(TYPED_INTO) || (event.key === " " && event.target.matches("button"));
      if (!action || own || event.defaultPrevented || event.ctrlKey || event.altKey || event.metaKey) return;
      event.preventDefault();
      action();
    });
  }
}
