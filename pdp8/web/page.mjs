// The page's controls: slider, buttons and keys, and the clock of a play.

import { Afternoon, prepared } from "./afternoon.mjs";
import { unpacked } from "./packed.mjs";
import { over } from "./brightness.mjs";
import { Machine } from "../computer/machine.mjs";
import { TICKS_PER_SECOND as SECOND } from "../computer/hardware/signals.mjs";
import { Pictures } from "./pictures.mjs";
import { Scene } from "./scene.mjs";
import { escaped, find } from "./written.mjs";

/** @type {[number, string][]} */
const SPEEDS = [
  [1e-6, "1 : 1 000 000, a cycle in 1.6 s"],
  [1e-5, "1 : 100 000"],
  [1e-4, "1 : 10 000"],
  [1e-3, "1 : 1000"],
  [1e-2, "1 : 100"],
  [1e-1, "1 : 10"],
  [1, "as it was"],
  [10, "10 times"],
  [60, "a minute a second"],
  [300, "5 minutes a second"],
];
const USUAL = 8;

const TYPED_INTO = "input, select, textarea, [tabindex], a, summary"; // what has keys of its own

class Page {
  constructor(record) {
    this.record = record;
    this.afternoon = new Afternoon(record);
    this.scene = new Scene(record, this.afternoon);
    this.playing = false;
    this.pictures = new Pictures((passed) => this.#picture(passed));
    this.position = 0; // the instant in ticks and, in slow motion, parts of them
    this.unit = "character";
    this.#describe();
    this.#controls();
    this.#keys();
    this.#panes();
    document.addEventListener("visibilitychange", () => document.hidden && this.play(false));
    addEventListener("hashchange", () => this.#goAsked());
    if (!this.#goAsked()) this.go(0);
  }

  /** Go to the instant that the address names, #t=SECONDS; return whether it names one. */
  #goAsked() {
    const asked = /^#t=(\d+(?:\.\d+)?)$/.exec(location.hash);
    if (asked && location.hash !== this.address) this.go(Number(asked[1]) * SECOND);
    return Boolean(asked);
  }

  /** Go to an instant, in ticks, and show it. */
  go(tick) {
    this.afternoon.to(tick);
    this.#arrived();
  }

  /** Go on (1) or back (-1) by the chosen unit. */
  step(direction) {
    this.play(false);
    if (direction > 0) this.afternoon.next(this.unit);
    else this.afternoon.previous(this.unit);
    this.#arrived();
  }

  #arrived() {
    this.position = this.afternoon.now;
    this.scene.show();
    if (!this.playing) this.#say();
  }

  /** The instant stands still: say it to who listens, and let the address name it. */
  #say() {
    clearTimeout(this.saying);
    this.saying = setTimeout(() => {
      this.scene.say();
      this.address = `#t=${this.afternoon.now / SECOND}`;
      history.replaceState(null, "", this.address);
    }, 150);
  }

  play(on) {
    if (on === this.playing) return;
    if (on && this.afternoon.now >= this.afternoon.end) this.go(0);
    this.playing = on;
    document.body.classList.toggle("playing", on);
    find("play").setAttribute("aria-label", on ? "Pause" : "Play");
    if (on) this.pictures.start();
    else this.pictures.stop();
    if (!on) this.#arrived();
  }

  /** Show the next picture of a play; return whether it goes on. */
  #picture(passed) {
    const speed = (this.pictures.speed = this.speed);
    this.position += (passed / 1000) * SECOND * speed;
    const { afternoon } = this;
    const brightness = over(afternoon.machine, afternoon.now, Math.floor(this.position), (tick) => afternoon.to(tick));
    this.scene.show(brightness);
    if (this.position >= afternoon.end) this.play(false);
    return this.playing;
  }

  get speed() {
    return SPEEDS[find("speed").selectedIndex][0];
  }

  #describe() {
    const { acts, about, figures, subject, title } = this.record;
    const { end } = this.afternoon;
    document.title = `An afternoon in 1971: ${title}`;
    find("subject").textContent = subject;
    find("about").innerHTML = about.map((paragraph) => `<p>${escaped(paragraph)}</p>`).join("");
    find("figures").innerHTML = table(figures);
    find("speed").innerHTML = SPEEDS.map(([, label]) => `<option>${label}</option>`).join("");
    find("speed").selectedIndex = USUAL;
    find("acts").innerHTML = acts.map((act) => mark(act, (act.to - act.from) / end)).join("");
  }

  #controls() {
    find("slider").max = this.afternoon.end;
    find("slider").addEventListener("input", (event) => this.#drag(Number(event.target.value)));
    find("slider").addEventListener("change", () => this.#drop());
    find("link").addEventListener("click", () => this.#copyLink());
    find("play").addEventListener("click", () => this.play(!this.playing));
    find("forward").addEventListener("click", () => this.step(1));
    find("back").addEventListener("click", () => this.step(-1));
    find("next-act").addEventListener("click", () => this.act(1));
    find("previous-act").addEventListener("click", () => this.act(-1));
    find("units").addEventListener("change", (event) => (this.unit = event.target.value));
    find("acts").addEventListener("click", (event) => {
      const act = event.target.closest("[data-act]");
      if (act) this.go(this.record.acts[act.dataset.act].from);
    });
  }

  /** The slider is dragged: a play waits until it is let go. */
  #drag(tick) {
    this.dragged ??= this.playing;
    this.play(false);
    this.go(tick);
  }

  #drop() {
    if (this.dragged) this.play(true);
    this.dragged = undefined;
  }

  /** Copy the address of this instant; where the browser does not let a page do that, show it. */
  async #copyLink() {
    const link = location.href.replace(/#.*/, "") + `#t=${this.afternoon.now / SECOND}`;
    try {
      await navigator.clipboard.writeText(link);
      find("link").textContent = "Copied";
    } catch {
      prompt("The address of this instant:", link);
    }
    setTimeout(() => (find("link").textContent = "Copy link"), 1500);
  }

  /** Each pane can be made as large as the page, for a projector. */
  #panes() {
    for (const pane of document.querySelectorAll("main > section")) {
      const button = document.createElement("button");
      button.className = "enlarge";
      button.ariaLabel = `${pane.ariaLabel}: alone`;
      button.title = "This alone, or all";
      button.innerHTML = `<svg viewBox="0 0 20 20" aria-hidden="true"><path d="M3 3h6v2H5v4H3zM11 15h4v-4h2v6h-6z"/></svg>`;
      button.addEventListener("click", () => {
        const alone = pane.classList.toggle("alone");
        document.querySelector("main").classList.toggle("one", alone);
        button.ariaPressed = String(alone);
      });
      pane.append(button);
    }
  }

  /** Go to the beginning of the act before (-1), or of this one if it is under way; or of the next (1). */
  act(direction) {
    const { acts } = this.record;
    const { index, from } = this.afternoon.act();
    if (direction > 0) this.go(acts[index + 1]?.from ?? this.afternoon.end);
    else this.go(this.afternoon.now - from > SECOND ? from : acts[Math.max(0, index - 1)].from);
  }

  #keys() {
    const keys = {
      " ": () => this.play(!this.playing),
      ArrowRight: () => this.step(1),
      ArrowLeft: () => this.step(-1),
      1: () => this.#choose("block"),
      2: () => this.#choose("character"),
      3: () => this.#choose("instruction"),
      4: () => this.#choose("cycle"),
      "+": () => this.#hurry(1),
      "=": () => this.#hurry(1),
      "-": () => this.#hurry(-1),
      "[": () => this.act(-1),
      "]": () => this.act(1),
      Home: () => this.go(0),
      End: () => this.go(this.afternoon.end),
    };
    document.addEventListener("keydown", (event) => {
      const action = keys[event.key];
      const own = event.target.matches(TYPED_INTO) || (event.key === " " && event.target.matches("button"));
      if (!action || own || event.ctrlKey || event.altKey || event.metaKey) return;
      event.preventDefault();
      action();
    });
  }

  #choose(unit) {
    this.unit = unit;
    document.querySelector(`#units input[value=${unit}]`).checked = true;
  }

  #hurry(by) {
    const select = find("speed");
    select.selectedIndex = Math.max(0, Math.min(SPEEDS.length - 1, select.selectedIndex + by));
  }
}

/** An act on the rail, as wide as its time; where there is no room, its number alone. */
function mark({ name, index }, share) {
  const inside = share > 0.07 ? ` ${escaped(name)}` : "";
  return `<span data-act="${index}" style="flex-grow:${share}" title="${escaped(name)}"><b>${index + 1}</b>${inside}</span>`;
}

function table({ columns, rows }) {
  const head = columns.map((column) => `<th scope="col">${escaped(column)}</th>`).join("");
  const body = rows.map(([figure, ...said]) => `<tr><th scope="row">${escaped(figure)}</th>${said.map(cell).join("")}</tr>`);
  return `<thead><tr>${head}</tr></thead><tbody>${body.join("")}</tbody>`;
}

function cell(text) {
  return `<td>${escaped(text)}</td>`;
}

const page = new Page(prepared(await unpacked(find("record").textContent)));
// For the curious, at the browser's console: replay.page.go(tick), replay.afternoon.machine.core[0o200] ...
window.replay = { page, afternoon: page.afternoon, Machine, SECOND };
