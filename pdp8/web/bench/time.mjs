// The time bar: run and stop, steps by unit, speed; the same controls for the afternoon and for the live machine.

import * as rewind from "../../computer/past/rewind.mjs";
import { forward } from "../../computer/use/goals.mjs";
import { html } from "../html.mjs";
import { find } from "../written.mjs";
import { next } from "./next.mjs";
import { keyed, modified, uncover } from "./wiring.mjs";

const FINE = 4000; // steps of the slider: about half a pixel
const TYPED_INTO = "input, select, textarea, [tabindex='0']:not(button), a, summary"; // what has keys of its own

export class Time {
  constructor(/** @type {Bench} */ bench) {
    this.bench = bench;
    this.unit = "instruction";
    const keys = {
      "+": () => this.#hurry(1),
      "=": () => this.#hurry(1),
      "-": () => this.#hurry(-1),
      Home: () => bench.afternoon.go(0),
      End: () => bench.afternoon.go(Infinity),
    };
    document.addEventListener("keydown", (event) => {
      if (bench.room.open) return; // which has keys of its own
      const control = keyed(find("time"), event);
      const own = event.target?.matches(TYPED_INTO) || (event.key === " " && event.target?.matches("button"));
      const action = control ? () => control.click() : /** @type {Record<string, () => void>} */ (keys)[event.key];
      const away = /Home|End/.test(event.key) && !bench.afternoon.on; // from the machine of the visitor
      if (!action || own || away || event.defaultPrevented || modified(event)) return;
      event.preventDefault();
      action();
    });
  }

  /** Run or stop, play or pause. */
  toggle() {
    const { bench } = this;
    if (bench.afternoon.on) bench.afternoon.play(!bench.afternoon.playing);
    else if (bench.machine.processor.run) bench.switches.press("stop");
    else this.run();
  }

  /** Press CONT, if the card allows it; the run ends at its `goal`. */
  run(goal = /** @type {import("../../computer/use/goals.mjs").Goal | undefined} */ (undefined)) {
    const { bench } = this;
    bench.aim(goal);
    bench.switches.press("cont");
    if (!bench.machine.processor.run) bench.aim();
  }

  /** Go on (1) or back (-1) by the chosen unit. */
  step(/** @type {HTMLInputElement} */ { value }) {
    const { bench, unit } = this;
    if (bench.afternoon.on) return bench.afternoon.step(unit, Number(value));
    bench.aim();
    bench.switches.card.end(); // a step back takes words away
    if (Number(value) > 0) this.#forward(unit);
    else this.#back(unit);
  }

  #forward(/** @type {string} */ unit) {
    const { bench } = this;
    bench.teletype.started();
    const reason = forward(bench.history, unit);
    bench.machine.processor.run = 0;
    if (reason === "limit") bench.say("");
    else bench.ended(reason);
  }

  #back(/** @type {string} */ unit) {
    const { bench } = this;
    let said = "";
    try {
      /** @type {any} */ (rewind)[`${unit}s`](bench.history, 1);
    } catch (error) {
      said = String(error);
    }
    bench.machine.processor.run = 0;
    bench.say(said);
  }

  get kept() {
    const { translating, speed } = this.bench.parts;
    return { unit: this.unit, speed: translating ? String(speed) : find("speed").value };
  }

  set kept({ unit, speed }) {
    find("units").querySelector(`[value="${CSS.escape(unit)}"]`)?.click();
    if ([...find("speed").options].some(({ value }) => value === speed)) this.setSpeed(speed);
  }

  /** Show where the afternoon is: of so many ticks, and by its clock; what is done, and what comes next. */
  at(/** @type {number} */ now, /** @type {number} */ end, /** @type {string} */ time, /** @type {string} */ act) {
    const slider = find("slider");
    slider.max = end;
    if (Math.abs(slider.value - now) > end / FINE) slider.value = now;
    const says = `${time}, ${act}`;
    if (slider.getAttribute("aria-valuetext") !== says) slider.setAttribute("aria-valuetext", says);
    this.bench.writer.text(find("clock"), time);
  }

  says(/** @type {string} */ why, /** @type {ReturnType<typeof import("../html.mjs").html>} */ words) {
    this.bench.writer.text(find("why"), why);
    this.bench.writer.html(find("next"), words);
  }

  focus() {
    find("play").focus({ preventScroll: true });
  }

  choose(/** @type {HTMLInputElement} */ { value }) {
    this.unit = value;
  }

  speed(/** @type {HTMLInputElement} */ { value }) {
    this.bench.clock.speed = Number(value);
  }

  setSpeed(/** @type {number} */ speed) {
    find("speed").value = String(speed);
    this.speed(find("speed"));
  }

  /** Take a speed so many places faster. */
  #hurry(/** @type {number} */ by) {
    const select = find("speed");
    select.selectedIndex = Math.max(0, Math.min(select.options.length - 1, select.selectedIndex + by));
    this.speed(select);
  }

  /** Press the button, or go to the field, that what can be done next names. */
  use(/** @type {HTMLElement} */ { dataset }) {
    const control = dataset.for === "#paper" ? this.bench.teletype.keys : document.querySelector(String(dataset.for));
    control.closest("details")?.setAttribute("open", "");
    if (control.matches("button")) control.click();
    else {
      uncover(control);
      control.focus();
    }
  }

  show() {
    const { afternoon, machine, writer } = this.bench;
    const [go, halt] = afternoon.on ? ["Play", "Pause"] : ["Run", "Stop"];
    writer.text(find("play"), (afternoon.on ? afternoon.playing : machine.processor.run) ? halt : go);
    if (afternoon.on) return;
    const doing = machine.waiting.endless ? "waits" : "runs";
    writer.text(find("clock"), `${machine.elapsed.toFixed(3)} s`);
    writer.text(find("why"), machine.processor.run ? doing : "stopped");
  }

  write() {
    const { bench, bench: { afternoon, clock, machine, writer } } = this;
    writer.text(find("kept"), (afternoon.on ? afternoon.playing : machine.processor.run && !machine.waiting.endless) ? clock.kept : "");
    if (afternoon.on) return;
    const [said, controls] = next(bench);
    const buttons = controls.map(([label, selector]) => html`<button class="text" data-click="time.use" data-for="${selector}">${label}</button>`);
    writer.html(find("next"), html`<span>${said}</span> ${buttons} ${afternoon.way}`);
  }
}
