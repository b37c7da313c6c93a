/* global URL, localStorage, sessionStorage */
// Objects of the page by themselves, on a page that has nothing: what each does the second time, at an end, or while it is
// still at the first. `cases` has what is seen, and what has to be seen, by what is tried.

import { Context } from "./canvas.mjs";

export const nothing = () => undefined;
function blank() {
  return anything;
}
/** Answers whatever it is asked. */
export const anything = new Proxy(blank, { get: (_, name) => (name === Symbol.toPrimitive ? () => 0 : name === Symbol.iterator ? [][Symbol.iterator] : name === "then" ? undefined : anything), set: () => true });

/** An element: it keeps what is set, and has one child for each selector. */
export class Element {
  constructor() {
    Object.assign(this, { children: [], classes: new Set(), dataset: {}, heard: {}, held: {}, hidden: false, options: [], value: "", textContent: "" });
    this.classList = { contains: (name) => this.classes.has(name), add: (name) => this.classes.add(name), remove: (name) => this.classes.delete(name), toggle: (name, on = !this.classes.has(name)) => (this.classes[on ? "add" : "delete"](name), on) };
    Object.assign(this, { style: { setProperty: nothing }, clientWidth: 0, clientHeight: 0, viewBox: { baseVal: { width: 1 } } });
    for (const name of ["focus", "observe", "setAttribute", "removeAttribute", "replaceChildren", "scrollIntoView", "toggleAttribute", "setSelectionRange", "setPointerCapture", "showModal"]) this[name] = nothing;
  }
  addEventListener(name, act) { (this.heard[name] ??= []).push(act); }
  hear(name, event = {}) { for (const act of this.heard[name] ?? []) act(event); }
  querySelector(selector) { return (this.held[selector] ??= new Element()); }
  querySelectorAll(selector) { return [this.querySelector(selector)]; }
  getBoundingClientRect() { return { left: 0, top: 0, right: 1000, bottom: 0, width: 1 }; }
  getContext() { return anything; }
  closest() { return this; }
  checkVisibility() { return true; }
  get parentElement() { return (this.parent ??= new Element()); }
  get previousElementSibling() { return this.querySelector("before"); }
}

export const page = new Element();
export const find = (id) => page.querySelector(id);
const store = () => {
  const kept = {};
  const methods = { getItem: (name) => kept[name] ?? null, setItem: (name, text) => (kept[name] = text), removeItem: (name) => delete kept[name] };
  return Object.setPrototypeOf(kept, methods);
};
const still = { on: false };
export const drawn = []; // what is written on canvases
class Sheet extends Element {
  constructor(width = 0, height = 0) { super(); Object.assign(this, { width, height }); }
  getContext() {
    this.context ??= Object.assign(new Context(), { canvas: this });
    this.context.fillText = (text, x, y) => (drawn.push(text), Context.prototype.fillText.call(this.context, text, x, y));
    return this.context;
  }
}
const workers = [];
class Worker {
  constructor() { this.asked = []; workers.push(this); }
  postMessage(message) { this.asked.push(message); }
  terminate() {}
}
const timer = setTimeout;
globalThis.setTimeout = (act, after) => { // what would come in a minute keeps nobody waiting
  const made = timer(act, after);
  if (after > 1000) made.unref();
  return made;
};
URL.createObjectURL = () => "blob:";
Map.groupBy ??= () => new Map(); // Node.js 20 has none
Object.assign(globalThis, {
  Worker, OffscreenCanvas: Sheet, Path2D: blank, ResizeObserver: Element, IntersectionObserver: Element, Option: Element, CSS: { escape: String },
  addEventListener: (...given) => page.addEventListener(...given), window: { devicePixelRatio: 1 },
  document: Object.assign(page, { getElementById: find, createElement: () => new Element(), body: new Element(), documentElement: new Element() }),
  history: { pushState: nothing, replaceState: nothing }, location: { hash: "", href: "", search: "" },
  matchMedia: (query) => ({ addEventListener: nothing, matches: still.on && query.includes("reduced") }), requestAnimationFrame: nothing, cancelAnimationFrame: nothing,
  sessionStorage: store(), localStorage: store(),
});

export const get = async (module) => import(`./pdp8/web/${module}.mjs`);
export const machine = async () => new (await import("./pdp8/computer/machine.mjs")).Machine((await import("./pdp8/computer/hardware/devices.mjs")).one_of_each());
export const soon = (milliseconds = 0) => new Promise((done) => setTimeout(done, milliseconds));

/** A room over an afternoon of seven acts of a hundred seconds each. */
export async function room(reduced = false) {
  still.on = reduced;
  const acts = Array.from({ length: 7 }, (_, at) => ({ kind: "", starts: at * 2e9, ends: (at + 1) * 2e9 }));
  const story = Array.from({ length: 8 }, (_, at) => [`${at}`, `act ${at}`]);
  const bench = {
    machine: await machine(), record: { afternoon: { machines: [[0]], story } }, say: nothing, show: nothing, first: nothing,
    clock: { pictures: { stop: nothing } }, time: { focus: nothing }, sound: { hum: nothing }, writer: { text: nothing }, adopt: (own) => (bench.machine = own), teletype: { name: nothing }, switches: { card: { end: nothing } },
    touch: (work) => ((bench.afternoon.on = false), work(bench.machine)),
    afternoon: { on: false, script: { now: 0, act: acts[0], day: { acts } }, lead() { this.on = true; bench.machine = bench.led; }, release(own) { this.on = false; bench.machine = own; } },
  };
  bench.led = await machine();
  return new (await get("room/room")).Room(bench);
}

export async function worked(word) {
  const made = await machine();
  made.processor.deposit(0o200, word);
  return made;
}

/** An afternoon whose script stands at its end. */
export async function afternoon() {
  const clock = { wake: nothing };
  const bench = { clock, show: nothing, tell: nothing, aim: nothing, history: { close: nothing }, record: { afternoon: { machines: [] } }, switches: { panel: {}, card: { end: nothing } } };
  const made = new (await get("bench/afternoon")).Afternoon(bench);
  made.made = { now: 9, end: 9, act: { name: "" }, machine: await machine(), to(tick) { this.now = tick; } };
  made.on = true;
  return made;
}

/** A figure whose only input has a name and a value. */
export async function figure(id, name, value, dataset = {}) {
  const input = Object.assign(find(id).querySelector("input"), { name, value: String(value), dataset });
  return [input, await get("curve/drawing")];
}

export const cases = {
  "the story plays as it is entered": async () => {
    const made = await room();
    made.enter();
    const plays = made.playing;
    made.enter(5);
    return [[plays, made.playing], [true, false]];
  },
  "nothing plays where nothing shall move": async () => {
    const made = await room(true);
    made.enter();
    return [made.playing, false];
  },
  "an act's last tick is its own, the next is not": async () => {
    const { tour } = await room().then((made) => (made.enter(), made));
    const { ends } = tour.day.acts[1];
    const scale = ({ w, h }) => Math.min(390 / w, 560 / h); // in a narrow window
    const larger = Array.from({ length: tour.length }, (_, turn) => (tour.go(turn), Number(scale(tour.box(true)) > scale(tour.box(false)))));
    return [[[ends - 1, ends].map((tick) => (tour.at(tick), tour.turn)), larger.join("")], [[2, 3], "11010111"]];
  },
  "the picture to keep has the last rows": async () => {
    drawn.length = 0;
    (await get("room/keepsake")).keepsake(Uint8Array.from([...Array(100).fill(0o301), 0o332]), "Z");
    const signs = drawn.slice(1, -2); // below the title, above the two lines that say how it was made
    return [[drawn.filter((text) => text).slice(-3, -2), signs.findIndex((text) => text), signs.length], [["Z"], 4, 60 + 2 * 4]];
  },
  "a reload finds its own tab's, another visit the last": async () => {
    const { keep, kept } = await get("bench/store");
    keep("one", "mine");
    localStorage.setItem("one", "another's");
    const own = kept("one");
    delete sessionStorage.one;
    return [[own, kept("one")], ["mine", "another's"]];
  },
  "a store has what was kept last, whether the browser takes it or not": async () => {
    const programs = new (await get("bench/store")).Store("program"), prototype = Object.getPrototypeOf(localStorage), { setItem } = prototype;
    const has = new Map(), lost = new Set(), wrong = [];
    for (let step = 0, chance = 1; step < 300; step++) {
      const name = "abc"[(chance = (chance * 16807) % 2147483647) % 3], way = chance % 5, text = String(step);
      if (way < 2) prototype.setItem = way ? setItem : () => { throw new Error("full"); };
      else if (way === 2) {
        for (const of of [has, lost]) of.delete(name);
        programs.remove(name);
      }
      else {
        const called = way === 3 ? (programs.keep(name, text), name) : programs.take(name, text);
        has.set(called, text);
        if (prototype.setItem === setItem) lost.clear();
        else lost.add(called);
      }
      if (programs.refused !== (lost.size ? "full" : "")) wrong.push(step);
      if (String(programs.names()) !== String([...has.keys()].sort()) || [...has].some(([each, kept]) => programs.get(each) !== kept)) wrong.push(step);
    }
    prototype.setItem = setItem;
    programs.keep("a", "kept");
    localStorage.setItem("pdp8 program: a", "another tab's");
    return [[wrong, programs.get("a")], [[], "another tab's"]];
  },
  "before anything is lost it is asked": async () => {
    const { Session } = await get("bench/session");
    const seen = ["", "answers", "given", "marks", "programs", "reel 0", "reel 1"].map((name) => {
      const drives = { units: [0, 1], unsaved: (unit) => name === `reel ${unit}` };
      const [answers, given, marks, programs] = ["answers", "given", "marks", "programs"].map((of) => ({ refused: of === name ? "full" : "" }));
      page.heard.beforeunload = [];
      new Session({ editor: { keep: nothing }, exercises: { answers, given, marks }, programs, drives }, {});
      let asked = false;
      page.hear("beforeunload", { preventDefault: () => (asked = true) });
      return asked;
    });
    return [seen, [false, true, true, true, true, true, true]];
  },
  "of many tapes the newest are kept": async () => {
    page.querySelectorAll = () => [];
    const shelf = new (await get("bench/shelf")).Shelf({ "u.asc": "A" });
    const names = [...Array.from({ length: 25 }, (_, at) => shelf.put("t.asc", [at])), shelf.put("t.asc", [7]), shelf.put("u.asc", [0o101])]; // two are there
    return [[shelf.kept.map(([name]) => name), names.pop()], [[...names.slice(5, 7), ...names.slice(8)], "u.asc"]];
  },
  "Run mills from the beginning once all is milled": async () => {
    const { Mill } = await get("bench/mill");
    const seen = [1, -0.5, 0.5].map((part) => {
      const mill = Object.assign(Object.create(Mill.prototype), { part, pictures: { start: nothing } });
      mill.run();
      return mill.part;
    });
    return [seen, [0, 0, 0.5]];
  },
  "a tolerance that comes after another tape was chosen is not shown": async () => {
    const { Mill } = await get("bench/mill");
    const frames = Object.assign(Uint8Array.of(0o40), { decode: () => "" });
    let answer;
    const bench = { shelf: { get: () => ({ frames }) }, tabs: { open: nothing }, record: { cutter: {} }, apart: { ask: () => new Promise((done) => (answer = done)) } };
    const mill = new Mill(bench);
    const loosening = mill.loosen({ value: "4" });
    await soon();
    mill.cut("mine.eia");
    answer([0o40]);
    await loosening;
    return [mill.name, "mine.eia"];
  },
  "a text that is opened again is as it was, whatever was written in it": async () => {
    const { Editor } = await get("bench/editor");
    const programs = new (await get("bench/store")).Store("again");
    const editor = new Editor({ machine: await machine(), afternoon: { takeOver: nothing }, room: {}, programs, shelf: { sources: ["a.pal"], get: () => ({ frames: "HLT" }) }, apart: { ask: () => new Promise(nothing) } });
    editor.put("a.pal", "HLT");
    editor.area.value = "HLTx";
    editor.choose({ value: "a.pal", selectedOptions: [{ parentElement: { label: "Bundled" } }] });
    return [[editor.text, editor.name, programs.get("a.pal")], ["HLT", "a 2.pal", "HLTx"]];
  },
  "what is set while a figure is made is drawn too": async () => {
    const [input, { Figure }] = await figure("x", "size", 1);
    const { Wanted } = await get("curve/made");
    const shown = [];
    let answer;
    const first = new Promise((done) => (answer = done));
    const of = new Figure("x", ({ size }) => {
      if (!shown.length) shown.push("waits");
      else return [shown.push(size) && "", 1, ""];
      throw new Wanted(first);
    });
    of.near = true;
    of.show();
    input.value = "2";
    of.show();
    answer();
    await soon(20);
    return [shown, ["waits", 1, 2]];
  },
  "the start of a circle is called what it is": async () => {
    const { roundness } = await get("curve/roundness");
    const input = Object.assign(find("roundness").querySelector("input"), { name: "closed", type: "checkbox", dataset: {} });
    const others = [["times", 1], ["cutter", 8]].map(([name, value]) => Object.assign(new Element(), { name, value: String(value) }));
    find("roundness").querySelectorAll = () => [input, ...others];
    const of = roundness();
    const seen = [true, false].map((checked) => {
      input.checked = checked;
      of.now();
      return /where [a-z ]+/.exec(of.said.innerHTML)[0];
    });
    return [seen, ["where it starts and ends", "where the last cut is missing"]];
  },
};
