// The page: its controls, and everything on it shown as it was at one instant.

import { Afternoon, SECOND, unpacked, upper } from "./afternoon.mjs";
import { drawClose, drawWhole, Mill } from "./cutter.mjs";
import { CYCLE, Machine } from "./machine.mjs";
import { octal, Panel, STATES } from "./panel.mjs";
import { Paper } from "./paper.mjs";
import { drawTape, meaning } from "./tape.mjs";

const SPEEDS = [
  [1e-6, "1 : 1 000 000, a cycle in 1.6 s"],
  [1e-5, "1 : 100 000"],
  [1e-4, "1 : 10 000"],
  [1e-3, "1 : 1000"],
  [1e-2, "1 : 100"],
  [1e-1, "1 : 10"],
  [1, "as it was"],
  [10, "10 times"],
  [60, "a minute in a second"],
  [300, "5 minutes in a second"],
];
const SAID = 8 * SECOND; // how long the operator's last deed is told
const PRESSED = 0.4 * SECOND; // how long a key shows as pressed
const FIELDS = [["sequence", 3], ["prep.", 1], ["X", 5], ["Y", 5], ["res.", 1], ["tool", 2], ["misc.", 2], ["end", 1]];

const find = (id) => document.getElementById(id);

class Page {
  constructor(record) {
    this.record = record;
    this.afternoon = new Afternoon(record);
    this.mill = record.mill && new Mill(record.mill);
    this.panel = new Panel(find("computer"));
    this.paper = new Paper(find("paper"), find("paper-title"), record);
    this.playing = false;
    this.unit = "character";
    this.#describe();
    this.#controls();
    this.#keys();
    new ResizeObserver(() => this.show()).observe(document.querySelector("main"));
    const asked = /^#t=([\d.]+)$/.exec(location.hash);
    this.go(asked ? Number(asked[1]) * SECOND : 0);
  }

  /** Go to an instant, in ticks, and show it. */
  go(tick) {
    this.afternoon.to(tick);
    this.show();
  }

  step(direction) {
    this.play(false);
    if (direction > 0) this.afternoon.next(this.unit);
    else this.afternoon.previous(this.unit);
    this.show();
  }

  play(on) {
    if (on === this.playing) return;
    if (on && this.afternoon.now >= this.afternoon.end) this.afternoon.to(0);
    this.playing = on;
    document.body.classList.toggle("playing", on);
    find("play").setAttribute("aria-label", on ? "Pause" : "Play");
    if (on) requestAnimationFrame((at) => this.#frame(at, at));
  }

  #frame(at, before) {
    if (!this.playing) return;
    const { afternoon } = this;
    this.position = Math.max(this.position ?? afternoon.now, afternoon.now) + ((at - before) / 1000) * SECOND * this.speed;
    if (this.position >= afternoon.end) this.play(false);
    afternoon.to(Math.floor(this.position));
    this.show();
    requestAnimationFrame((next) => this.#frame(next, at));
  }

  get speed() {
    return SPEEDS[find("speed").selectedIndex][0];
  }

  #describe() {
    const { record } = this;
    document.title = `An afternoon in 1971: ${record.title}`;
    find("subject").textContent = record.subject;
    find("about").innerHTML = record.about.map((paragraph) => `<p>${escaped(paragraph)}</p>`).join("");
    find("figures").innerHTML = figures(record.figures);
    find("speed").innerHTML = SPEEDS.map(([, label]) => `<option>${label}</option>`).join("");
    find("speed").selectedIndex = 8;
    const end = this.afternoon.end;
    find("acts").innerHTML = record.acts
      .map((act, index) => actMark(act, index, (act.to - act.from) / end))
      .join("");
  }

  #controls() {
    const slider = find("slider");
    slider.max = this.afternoon.end;
    slider.addEventListener("input", () => {
      this.position = undefined;
      this.go(Number(slider.value));
    });
    find("play").addEventListener("click", () => this.play(!this.playing));
    find("forward").addEventListener("click", () => this.step(1));
    find("back").addEventListener("click", () => this.step(-1));
    find("next-act").addEventListener("click", () => this.act(1));
    find("previous-act").addEventListener("click", () => this.act(-1));
    find("units").addEventListener("change", (event) => (this.unit = event.target.value));
    find("acts").addEventListener("click", (event) => {
      const index = [...find("acts").children].indexOf(event.target.closest("span"));
      if (index >= 0) this.jump(this.record.acts[index].from);
    });
  }

  /** The act after or before. */
  act(direction) {
    const { acts } = this.record;
    const index = acts.indexOf(this.afternoon.act());
    const since = this.afternoon.now - acts[index].from;
    if (direction > 0) this.jump(acts[index + 1]?.from ?? this.afternoon.end);
    else this.jump(acts[since > SECOND ? index : Math.max(0, index - 1)].from);
  }

  jump(tick) {
    this.position = undefined;
    this.go(tick);
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
      Home: () => this.jump(0),
      End: () => this.jump(this.afternoon.end),
    };
    document.addEventListener("keydown", (event) => {
      const action = keys[event.key];
      if (!action || event.ctrlKey || event.altKey || event.metaKey || mine(event)) return;
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

  show() {
    const { afternoon, record } = this;
    const { now, machine } = afternoon;
    const act = afternoon.act();
    if (!this.playing) this.position = undefined;
    find("slider").value = now;
    find("slider").setAttribute("aria-valuetext", `${this.#clock(now)}, ${act.name}`);
    find("clock").textContent = this.#clock(now);
    find("act-name").textContent = act.name;
    [...find("acts").children].forEach((span, index) => span.classList.toggle("now", record.acts[index] === act));
    const deed = afternoon.deed;
    this.panel.show(machine, deed && now - deed.at < PRESSED ? deed.key : null);
    this.#caption(act, deed);
    document.querySelector("main").dataset.sheet = record.sheets[act.sheet].kind;
    this.#registers(act, machine);
    this.#tapes(act);
    this.paper.show(act, afternoon);
    this.#cutter();
  }

  #clock(tick) {
    const seconds = Math.floor(this.record.opens + tick / SECOND + 1e-9);
    const hours = Math.floor(seconds / 3600);
    return `${((hours + 11) % 12) + 1}:${two(Math.floor(seconds / 60) % 60)}:${two(seconds % 60)} ${hours % 24 < 12 ? "am" : "pm"}`;
  }

  #caption(act, deed) {
    const fresh = deed && deed.at >= act.from && this.afternoon.now - deed.at < SAID;
    const doing = fresh ? deed.say : waits(this.afternoon.machine);
    find("caption").innerHTML = `<b>${escaped(act.name)}.</b> ${escaped(act.say)} ${doing ? `<em>${escaped(doing)}</em>` : ""}`;
  }

  /** The registers, while there is a program beside them. */
  #registers(act, machine) {
    find("registers").hidden = this.record.sheets[act.sheet].kind !== "listing";
    const { teletype } = machine;
    const time = (machine.ticks - machine.started) / SECOND;
    const shown = [
      ["L", machine.link], ["AC", octal(machine.ac)], ["MA", octal(machine.ma)], ["MB", octal(machine.mb)],
      ["IR", machine.ir], ["PC", octal(machine.pc)], ["state", STATES[machine.state]],
      ["reader flag", teletype.readerFlag ? "up" : "down"], ["punch flag", teletype.punchFlag ? "up" : "down"],
      ["instructions", grouped(machine.instructions)], ["since START", `${time.toFixed(8).replace(/(\.\d{3})(\d{3})(\d{2})$/, "$1 $2 $3")} s`],
    ];
    find("registers").innerHTML = shown.map(([name, value]) => `<div><dt>${name}</dt><dd>${value}</dd></div>`).join("");
  }

  #tapes(act) {
    const reader = this.#reader(act);
    const punch = this.#punch(act);
    this.#label("in", reader);
    this.#label("out", punch);
    this.#block(act.kind === "terminal" ? punch : reader);
    if (reader) drawTape(find("in-tape"), reader);
    if (punch) drawTape(find("out-tape"), punch);
  }

  /** The tape that is being read: by the Teletype, or by the Hydra-Point. */
  #reader(act) {
    const { afternoon, record } = this;
    if (act.kind === "mill" || act.kind === "inspect") {
      const frames = record.tapes.eia;
      const place = this.mill.row(afternoon.now);
      return { ...frames, head: frames.first + place, title: "in the Hydra-Point's reader" };
    }
    if (!afternoon.mounted) return null;
    const { taken } = afternoon.machine.teletype;
    return { ...record.tapes[afternoon.mounted], head: Math.max(0, taken - 1), title: "in the ASR-33's reader" };
  }

  /** The tape that is being punched, or was last; at the Hydra-Point there is no punch. */
  #punch(act) {
    const { afternoon, record } = this;
    const { teletype } = afternoon.machine;
    if (act.index > record.translation) return null;
    if (act.index < record.translation) {
      const tape = record.tapes.ascii;
      const first = record.acts[0];
      const punched = Math.min(tape.frames.length, Math.floor((afternoon.now - first.from) / 2_000_000));
      return { ...tape, head: punched - 1, punching: true, title: "in the terminal's punch" };
    }
    return { ...record.tapes.eia, frames: teletype.paper, head: teletype.punched - 1, punching: true, title: "in the ASR-33's punch" };
  }

  #label(which, tape) {
    const canvas = find(`${which}-tape`);
    canvas.closest("figure").hidden = !tape;
    if (!tape) return;
    const count = tape.punching ? `${grouped(tape.head + 1)} frames punched` : `frame ${grouped(tape.head)} of ${grouped(tape.frames.length)}`;
    find(`${which}-label`).innerHTML = `<b>${escaped(tape.label)}</b><span>${tape.title}</span><span>${count}</span>`;
    const frame = tape.frames[tape.head];
    canvas.setAttribute("aria-label", frame === undefined ? `${tape.label}, nothing yet` : `${tape.label}, ${count}: ${octal(frame, 3)} ${meaning(frame, tape.code)}`);
  }

  /** The block that is passing: its fields, the digits read so far dark. */
  #block(tape) {
    const place = find("block");
    place.hidden = !tape || (tape.code !== "ascii" && tape.code !== "eia");
    if (place.hidden) return;
    const { digits, read, number } = blockAt(tape);
    let at = 0;
    const cells = FIELDS.map(([name, width]) => {
      const cell = [...digits.slice(at, at + width).padEnd(width, "·")].map((digit, index) => `<i class="${at + index < read ? "read" : ""}">${digit}</i>`).join("");
      at += width;
      return `<span><b>${cell}</b><small>${name}</small></span>`;
    });
    place.innerHTML = `<b>block ${number}</b><p>${cells.join("")}</p>`;
  }

  #cutter() {
    find("cutter").hidden = !this.mill;
    if (!this.mill) return;
    const place = this.mill.at(this.afternoon.now);
    const started = place.block >= 0;
    const where = `X ${(place.x / 1000).toFixed(3)}  Y ${(place.y / 1000).toFixed(3)}`;
    const of = this.mill.blocks.length;
    find("whole-label").innerHTML = started
      ? `<b>Hydra-Point</b><span>${where}</span>`
      : `<b>Hydra-Point</b> waiting for its tape: ${of} blocks`;
    find("close-label").innerHTML = `<b>In its band</b><span>squares of .010 in</span>`;
    for (const id of ["whole", "close"]) find(id).setAttribute("aria-label", started ? `cutter at ${where}, block ${place.block + 1} of ${of}` : "nothing is cut yet");
    drawWhole(find("whole"), this.mill, place, started);
    drawClose(find("close"), this.mill, started ? place : this.mill.first(), started);
  }
}

/** What a running machine is waiting for, in words. */
function waits({ running, core, at }) {
  if (!running) return "";
  const word = core[at] >> 9 === 5 ? core[at - 1] : core[at];
  if (word === 0o6031) return "It waits for the reader.";
  if (word === 0o6041) return "It waits for the punch.";
  return "";
}

/** Whether a key means something to the control it is typed at. */
function mine({ key, target }) {
  if (target.matches("select")) return key.startsWith("Arrow") || key === " " || key === "Home" || key === "End" || /^\w$/.test(key);
  if (target.matches("input")) return key.startsWith("Arrow") || key === "Home" || key === "End" || (key === " " && target.type === "radio");
  return target.matches("button") && key === " ";
}

/** The block at the tape's head: its digits as the translation makes them, how many have passed, its number. */
function blockAt({ frames, head, code, lines }) {
  const ended = (frame) => (code === "ascii" ? (frame & 0o177) === 0o15 : frame === 0o200);
  let from = Math.max(0, head);
  while (from > 0 && !ended(frames[from - 1])) from--;
  let digits = "";
  let read = 0;
  for (let frame = from; frame < frames.length && digits.length < 20; frame++) {
    const digit = ended(frames[frame]) ? "↵" : digitOf(frames[frame], code);
    digits += digit;
    if (frame <= head) read += digit.length;
    if (digit === "↵") break;
  }
  return { digits, read, number: Math.min(lines.length, upper(lines, from - 1) + 1) };
}

function digitOf(frame, code) {
  if (code === "ascii") {
    const character = String.fromCharCode(frame & 0o177);
    return character === " " ? "0" : /\d/.test(character) ? character : "";
  }
  return frame === 0 ? "" : String(frame & 0o17);
}

function actMark({ name }, index, share) {
  const inside = share > 0.07 ? ` ${escaped(name)}` : "";
  return `<span style="flex-grow:${share}" title="${escaped(name)}"><b>${index + 1}</b>${inside}</span>`;
}

function figures({ columns, rows }) {
  const head = columns.map((column) => `<th scope="col">${escaped(column)}</th>`).join("");
  const body = rows.map(([first, ...rest]) => `<tr><th scope="row">${escaped(first)}</th>${rest.map((cell) => `<td>${escaped(cell)}</td>`).join("")}</tr>`);
  return `<thead><tr>${head}</tr></thead><tbody>${body.join("")}</tbody>`;
}

function escaped(text) {
  return text.replace(/[&<>"]/g, (character) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[character]);
}

function two(number) {
  return String(number).padStart(2, "0");
}

function grouped(number) {
  return String(number).replace(/\B(?=(\d{3})+$)/g, "\u2009");
}

const page = new Page(unpacked(JSON.parse(find("record").textContent)));
// For the curious, at the browser's console: replay.afternoon.to(tick), replay.afternoon.machine.core[0o200] ...
window.replay = { page, afternoon: page.afternoon, Machine, Afternoon, SECOND, CYCLE };
