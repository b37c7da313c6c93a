/* global atob, location, performance */
// The panes of the desk by themselves (again.mjs): lists, limits, what is shown beside what is done.

import { anything, afternoon, Element, find, get, machine, nothing, page, soon } from "./again.mjs";

const rows = (count) => Array.from({ length: count }, () => new Element());
const writer = { text: (element, text) => (element.textContent = text), html: (element, { source }) => (element.innerHTML = source), label: (element, text) => (element.ariaLabel = text), fill: nothing };

/** A desk with a machine, on which `touch` works at it. */
async function desk(more = {}) {
  Object.assign(page, { heard: {}, hidden: false });
  const bench = { machine: await machine(), afternoon: { on: false, takeOver: nothing }, room: { open: false, answer: nothing }, writer, said: [], show: nothing, tell: nothing, say: (words) => bench.said.push(words), ...more };
  bench.touch = (work) => work(bench.machine);
  bench.touched = nothing;
  return Object.defineProperty(bench, "own", { get: () => bench.machine });
}

export const cases = {
  "a screen rests so long after the last touch": async () => {
    location.search = "?rest=12";
    const { RESTS, rest } = await import("./pdp8/web/bench/alone.mjs?rest");
    location.search = "";
    const due = new Map();
    const before = { setTimeout: globalThis.setTimeout, clearTimeout: globalThis.clearTimeout };
    let count = 0, loaded = 0;
    Object.assign(globalThis, { setTimeout: (act, after) => (due.set((count += 1), [act, after]), count), clearTimeout: (number) => due.delete(number) });
    Object.assign(location, { reload: () => (loaded += 1) });
    page.heard = {};
    rest();
    for (const kind of ["pointerdown", "pointermove", "wheel", "keydown", "scroll"]) page.hear(kind);
    const waits = [...due.values()];
    Object.assign(globalThis, before);
    waits.forEach(([act]) => act());
    return [[RESTS, count, waits.length, waits[0][1], loaded], [12, 5, 1, 12000, 1]];
  },
  "it rests after ten seconds at the least, and only where it is asked": async () => {
    const seen = [];
    for (const [search, wanted] of [["?rest=1", 10], ["?rest=10", 10], ["?rest=11", 11], ["?rest=0", 0], ["?rest=-5", 0], ["?rest=x", 0], ["?rest=1e9", 2e6]]) {
      location.search = search;
      seen.push((await import(`./pdp8/web/bench/alone.mjs?${search}`)).RESTS === wanted);
    }
    location.search = "";
    return [seen, Array(7).fill(true)];
  },
  "an exercise's cases that failed are named, the others and hidden ones not": async () => {
    const { located, marks } = await get("bench/marker");
    const trial = (core) => [{ core: [["0300", core]] }];
    const tables = { title: "T", task: "", case: [{ name: "right", trial: trial(5), points: 1 }, { name: "wrong", trial: trial(6), points: 1 }, { name: "secret", hidden: true, trial: trial(7), points: 1 }] };
    const source = "*200\nCLA\nTAD X\nDCA I Y\nHLT\nX, 5\nY, 300\n$\n";
    const result = marks(tables, "a.pal", source);
    return [[result.wrong, result.points, result.of, result.right, located(tables, "a.pal", source, "right"), located(tables, "a.pal", source, "wrong") !== null], [["wrong", ""], 1, 3, false, null, true]];
  },
  "of tolerances asked for while one is made only the last is made, and shown": async () => {
    const { Mill } = await get("bench/mill");
    const answers = [];
    const frames = Object.assign(Uint8Array.of(0o40), { decode: () => "" });
    const mill = new Mill(await desk({ shelf: { get: () => ({ frames }) }, apart: { ask: () => new Promise((done) => answers.push(done)) } }));
    const laid = [];
    mill.lay = (name, of) => (laid.push(name), Object.assign(mill, { frames: of.length, path: { cuts: [], times: { total: 0 } } }));
    const done = mill.loosen({ value: "6" });
    await soon();
    const others = ["4", "6"].map((value) => mill.loosen({ value }));
    answers.shift()([0o40]);
    await soon();
    answers.shift()([0o40, 0o40]);
    await Promise.all([done, ...others]);
    return [[laid, mill.frames, answers.length], [["circle within 0.015 in"], 2, 0]];
  },
  "a tape with a leader is under the mill's head at its first block": async () => {
    const { Mill } = await get("bench/mill");
    const { bytes } = await import("./pdp8/web/translator/runtime.mjs");
    const { text, path } = (await get("method")).circle(10, true);
    const frames = bytes([0, 0, 0, ...(await import("./tapes/eia.mjs")).encode(text.replaceAll(" ", "0"))]);
    const mill = new Mill(await desk({ record: { cutter: 500 }, tabs: { open: nothing } }));
    find("mill").hidden = false;
    mill.lay("a.eia", frames, path);
    const head = () => find("mill-reader").querySelector(".name").textContent.replaceAll("\u202f", "").split(" ")[1];
    const seen = [-1e9, 1, path.times.total * 2e7].map((ticks) => (mill.follow(ticks), [Number(head()) > 3, find("whole-label").textContent.includes(`block ${path.steps.length} of`)]));
    mill.follow(-1);
    seen.push(head(), find("whole-label").textContent.startsWith("waits for its tape"), find("refusal").textContent);
    const { close } = await get("cutter"), near = path.knots.slice(0, 300).filter(({ down, x, y }) => down && Math.abs(x - path.first.x) < 200 / 2.6 && Math.abs(y - path.first.y) < 150 / 2.6);
    seen.push(close(mill.drawing, path.first, true, 400, 300).split('class="knot"').length - 1 === near.length);
    seen.push(/within [−+]\d\.\d{4} and [−+]\d\.\d{4}$/.test(find("close-label").textContent));
    for (const name of ["b", "c"]) mill.lay(`${name}.eia`, frames, null, `Refused: ${name}`);
    seen.push(mill.summary);
    const shown = () => !find("mill").querySelector(".pictures, .block, .reading").hidden;
    seen.push(shown());
    mill.lay("d.eia", frames, path);
    return [[seen, shown(), mill.name], [[[false, false], [false, false], [true, true], "3", true, "", true, true, "Refused: c", false], true, "d.eia"]];
  },
  "a tab that was hidden while the machine ran tells for how long, each time anew": async () => {
    const said = [];
    const bench = await desk({ tell: (words) => said.push(words) });
    const { Clock } = await get("bench/clock");
    const clock = new Clock(bench, nothing);
    const { now } = performance;
    let time = 1000;
    performance.now = () => time;
    page.title = "desk";
    const hide = (hidden, after) => {
      time += after;
      page.hidden = hidden;
      page.hear("visibilitychange");
      return page.title;
    };
    clock.wake();
    const titles = [hide(true, 0), hide(false, 5000), hide(false, 100)];
    clock.pictures.stop();
    titles.push(hide(true, 100), hide(false, 9000));
    clock.pictures.stop();
    performance.now = now;
    return [[titles, said], [["Stopped: desk", "desk", "desk", "desk", "desk"], ["The tab was hidden; everything stood still for 5 s."]]];
  },
  "a frame that began before the row of pictures counts no time, and none is counted twice": async () => {
    const { Pictures } = await get("pictures");
    const before = { setTimeout: globalThis.setTimeout, requestAnimationFrame: globalThis.requestAnimationFrame };
    const { now } = performance;
    const frames = [], passed = [];
    Object.assign(globalThis, { setTimeout: (act) => act(), requestAnimationFrame: (act) => frames.push(act) });
    performance.now = () => 1000;
    new Pictures((milliseconds) => passed.push(milliseconds) < 5).start();
    for (const began of [900, 990, 1100, 1050, 1600]) frames.pop()(began);
    Object.assign(globalThis, before);
    performance.now = now;
    return [[passed, frames], [[0, 0, 100, 0, 250], []]];
  },
  "the speed that is kept is written as it is": async () => {
    const clock = new (await get("bench/clock")).Clock({}, nothing);
    const seen = [0, 0.01, 0.5, 0.89, 0.9, 1, 9.44, 9.5, 120].map((measured) => ((clock.measured = measured), clock.kept));
    return [seen, ["", "1 : 100", "1 : 2", "1 : 1", "0.9 x", "1.0 x", "9.4 x", "10 x", "120 x"]];
  },
  "a hand at a machine that stands does nothing but its own": async () => {
    const { Switches } = await get("bench/switches");
    const bench = await desk();
    page.querySelectorAll = () => [];
    const keys = { __proto__: Switches.prototype, bench, card: { allows: () => true } };
    bench.machine.processor.deposit(0o200, 0o7001);
    bench.machine.pc = 0o200;
    const { processor } = bench.machine;
    keys.press("sing step");
    const seen = [processor.instructions, processor.sing_step, processor.mem_prot];
    keys.press("mem prot");
    keys.press("sing step");
    seen.push(processor.sing_step, processor.mem_prot);
    return [seen, [0, 1, 0, 0, 1]];
  },
  "a machine taken over plays no more, and the way back is there": async () => {
    const made = await afternoon();
    const adopted = [];
    made.bench.adopt = (of, stops) => adopted.push(stops);
    Object.assign(made.bench, { teletype: { name: nothing } });
    Object.assign(made.made, { mounted: "", day: { tapes: new Map() } });
    const { setTimeout: real } = globalThis, due = [], said = [];
    globalThis.setTimeout = (act) => due.push(act);
    Object.assign(made.bench, { tell: (words) => said.push(words) }).switches.panel.words = "lamps";
    made.go(3);
    due.pop()();
    made.go(4); // nothing is said of an instant that was left
    made.playing = true;
    made.takeOver();
    due.pop()();
    globalThis.setTimeout = real;
    const first = [made.on, made.playing, made.way.source.includes("afternoon.back")];
    made.takeOver();
    Object.assign(made, { on: true, playing: false });
    made.takeOver();
    return [[first, adopted, said], [[false, false, true], [false, true], ["1:00:00 pm, . lamps"]]];
  },
  "a key shows as pressed for a moment, an instant is in the address": async () => {
    const made = await afternoon();
    const second = 20_000_000;
    made.made.action = { at: 10 * second, key: "start" };
    const shown = [10, 10.39, 10.4, 11].map((now) => ((made.made.now = now * second), made.pressed));
    made.on = false;
    made.made.now = 10 * second;
    shown.push(made.pressed);
    const asked = ["#t=5", "#t=0", "#workbench&t=2.5", "#workbench", "#t=x", ""].map((hash) => ((location.hash = hash), made.asked));
    const missed = Array.from({ length: 999 }, (_, at) => 6e10 + 31 * at).filter((tick) => ((location.hash = `#t=${tick / second}`), made.asked !== tick));
    location.hash = "";
    return [[shown, asked, missed], [["start", "start", null, null, null], [5 * second, 0, 2.5 * second, null, null, null], []]];
  },
  "a word of core that changed is marked, until it is looked at again": async () => {
    const { Core } = await get("bench/core");
    const [heads, cells] = [rows(16), rows(128)];
    find("words").querySelectorAll = (kind) => (kind === "th" ? heads : cells);
    find("debugger").hidden = false;
    find("page").value = "1";
    const bench = await desk();
    const core = new Core(bench);
    const state = () => [cells[8].value, cells[8].classes.has("changed")];
    const seen = [state()];
    bench.machine.processor.deposit(0o210, 0o1234);
    core.write();
    seen.push(state());
    core.write();
    seen.push(state());
    for (const value of ["7777", "8", "12345", ""]) core.set(Object.assign(cells[8], { value }));
    core.write();
    seen.push(state(), heads[1].textContent, cells[127].ariaLabel);
    find("page").value = "31";
    core.turn();
    seen.push(cells[127].ariaLabel, cells[8].classes.has("changed"));
    delete find("words").querySelectorAll;
    return [seen, [["0000", false], ["1234", true], ["1234", false], ["7777", false], "0210", "core 0377", "core 7777", false]];
  },
  "registers take octal words as wide as they are": async () => {
    const { Registers } = await get("bench/registers");
    const made = Object.assign(Object.create(Registers.prototype), { bench: await desk() });
    const input = (ariaLabel, value) => made.set({ ariaLabel, value, blur: () => (blurred += 1) });
    const { machine: own } = made.bench;
    let blurred = 0;
    const seen = [["AC", "7777"], ["AC", "10000"], ["AC", "8"], ["L", "1"], ["L", "2"], ["PC", "200"], ["PC", ""], ["PC", "10000"]].map(([name, value]) => (input(name, value), [own.ac, own.link, own.pc]));
    made.bench.machine = new own.constructor(null, 0o20000);
    input("PC", "10200");
    return [[seen, blurred, made.bench.machine.pc], [[[4095, 0, 0], [4095, 0, 0], [4095, 0, 0], [4095, 1, 0], [4095, 1, 0], [4095, 1, 128], [4095, 1, 128], [4095, 1, 128]], 9, 0o10200]];
  },
  "a link's state is whole again, and no longer than it may be": async () => {
    const { LONGEST, opened, shortened, whole } = await get("bench/sharing");
    const tapes = new Map([["a.bin", "001 002 003 004"], ["b.bin", "007 007"]]);
    const usual = { ac: 0, punch: [], deep: { on: 1, off: 0 } };
    const states = [usual, { ac: 5, punch: ["002", "003"], deep: { on: 1, off: 0 } }, { ac: 0, punch: ["007", "006"], deep: { on: 0, off: 0 } }];
    const short = states.map((state) => shortened(state, usual, tapes));
    const back = short.map((state) => ({ ...usual, ...whole(state, tapes) }));
    let refused = "";
    try { whole({ punch: { $tape: ["c.bin", 0, 3] } }, tapes); } catch (error) { refused = error.message; }
    const lengths = [];
    for (const length of [2 * LONGEST, 2 * LONGEST + 1]) {
      location.hash = `#s=${"a".repeat(length)}`;
      lengths.push(await opened().catch(({ message }) => message.split(" ")[1]));
    }
    location.hash = "#exercise=add%20up";
    const named = await opened();
    location.hash = "";
    return [[short, back[1].punch, back[2].punch, refused, lengths, named, await opened()], [
      [{}, { ac: 5, punch: { $tape: ["a.bin", 4, 11] } }, { punch: ["007", "006"], deep: { on: 0 } }],
      ["002 003"], ["007", "006"], "no tape c.bin is bundled", ["is", "has"], { exercise: "add up" }, null]];
  },
  "an exercise has a bundled one's link if it is that one": async () => {
    const { Exercises } = await get("bench/exercises");
    const exercises = { add: {} }, given = [];
    const made = Object.assign(Object.create(Exercises.prototype), { name: "add", bench: { record: { exercises }, give: (link) => given.push(link.slice(0, 3)) } });
    for (made.all of [new Map(Object.entries(exercises)), new Map([["add", {}]])]) await made.link();
    return [given, ["#ex", "#s="]];
  },
  "work apart goes from question to question; only one that is late is ended": async () => {
    const { Apart } = await get("bench/apart");
    const apart = new Apart();
    page.querySelectorAll = () => [];
    const said = ({ message }) => message;
    const [late, waits, fails] = [apart.ask("a", [], 0.01), apart.ask("b", [1], 0.05), apart.ask("c", [], 9)].map((each) => each.catch(said));
    const first = apart.worker, seen = [await late, apart.worker !== first, apart.asked.length];
    await soon(30); // the second has its time from its turn on
    for (const data of [["made"], [null, "why not"]]) apart.worker.onmessage({ data });
    await soon(60);
    seen.push(await waits, await fails, apart.worker !== null, apart.asked.length);
    const { Worker } = globalThis;
    globalThis.Worker = class { constructor() { throw new Error("forbidden"); } };
    const barred = new Apart(), refused = await Promise.all([0, 1].map(() => barred.ask("d", [], 9).catch(said)));
    globalThis.Worker = Worker;
    const blocked = [0, 1].map(() => apart.ask("e", [], 9).catch((why) => [said(why), apart.unable]));
    for (const answer of blocked) seen.push(...(apart.worker.onerror({}), await answer));
    seen.push(barred.unable);
    return [[...seen, refused], ["it took more than 0.01 s, and was ended", true, 2, "made", "why not", true, 0, ...Array(2).fill(["this browser lets no Worker run", true]).flat(), true, ["forbidden", "forbidden"]]];
  },
  "a tab above the window is brought there, but not while the afternoon plays": async () => {
    const { Tabs } = await get("bench/tabs");
    const panes = rows(2), tabs = rows(2), list = find("tabs");
    for (const [at, pane] of panes.entries()) Object.assign(pane, { id: `pane ${at}`, dataset: { tab: `tab ${at}` } });
    for (const [at, tab] of tabs.entries()) tab.dataset.opens = `pane ${at}`;
    page.querySelectorAll = () => panes;
    Object.assign(list, { children: tabs, top: 0, brought: 0, getBoundingClientRect: () => ({ top: list.top }), scrollIntoView: () => (list.brought += 1) });
    const bench = await desk();
    const made = new Tabs(bench);
    const seen = [];
    for (const [top, on] of [[0, false], [-1, true], [-1, false]]) {
      list.top = top;
      bench.afternoon.on = on;
      made.open("pane 1");
      seen.push([list.brought, panes.map(({ hidden }) => hidden), made.kept]);
    }
    made.only(["pane 0"]); // in the frame of another page: what was open at the desk is not there
    seen.push(...[nothing, () => (made.kept = "pane 1"), () => made.open("pane 1")].map((act) => (act(), panes.map(({ hidden }) => hidden))));
    page.querySelectorAll = () => [];
    return [seen, [...[0, 0, 1].map((brought) => [brought, [true, false], "pane 1"]), ...Array(3).fill([false, true])]];
  },
  "a drawing takes the colours of the day and of the night": async () => {
    const { Sheet } = await get("sheet");
    const { matchMedia, getComputedStyle } = globalThis;
    const context = { setTransform: nothing, fillRect: nothing };
    const canvas = Object.assign(new Element(), { checkVisibility: () => true, getContext: () => context });
    let turn = nothing, now = "day";
    globalThis.matchMedia = (query) => ({ addEventListener: (_, act) => query.includes("dark") && (turn = act) });
    globalThis.getComputedStyle = () => ({ getPropertyValue: (name) => `${now}'s ${name}` });
    const made = Object.assign(new Sheet(canvas, nothing), { width: 10, height: 10 });
    const seen = [];
    const draw = () => made.draw("as before", (_, width, height, { ink }) => seen.push(ink));
    draw();
    now = "night";
    draw();
    turn();
    draw();
    Object.assign(globalThis, { matchMedia, getComputedStyle });
    return [[seen, context.fillStyle], [["day's --ink", "night's --ink"], "night's --sheet"]];
  },
  "a machine is kept without the breakpoint of its goal, and found again in the room at rest": async () => {
    globalThis.pack = { record: new Promise(nothing) }; // the page does not begin
    const { kept } = Object.getOwnPropertyDescriptors((await get("workbench")).Bench.prototype);
    const running = await machine();
    for (const address of [0o200, 0o300]) running.watch.breakpoints.add(address);
    running.processor.run = 1;
    const drives = { bare: () => "as it is", restored: () => running }, room = { open: true, keep: (found) => (room.found = found) };
    const before = kept.get.call({ until: { added: 0o300 }, own: running, drives, teletype: { leverWaits: true, called: (of) => of === running && "a" } });
    kept.set.call({ drives, room }, { state: "as it was", breakpoints: [0o201, 0o10202] });
    Object.defineProperty(running, "memory", { value: 0o20000 });
    kept.set.call({ drives, room }, { state: "as it was", breakpoints: [0o10201] });
    return [[before, room.found === running, running.processor.run, [...running.watch.breakpoints]], [{ state: "as it is", breakpoints: [0o200], tape: { leverWaits: true, name: "a" } }, true, 0, [0o200, 0o300, 0o201, 0o10201]]];
  },
  "a session is found again part by part": async () => {
    const { Session } = await get("bench/session");
    page.heard = {};
    const bench = { editor: { keep: nothing }, exercises: { answers: {}, marks: {} }, programs: {} };
    const got = {};
    const part = (name, kept) => Object.defineProperty({}, "kept", { get: () => kept, set: (of) => { if (of === "bad") throw new Error("x"); got[name] = of; } });
    const session = new Session(bench, { a: part("a", 1), b: part("b", "bad"), c: part("c", null), d: part("d", 0) });
    page.hidden = true;
    page.hear("visibilitychange");
    page.hidden = false;
    const found = session.open();
    return [[found, got], [true, { a: 1, d: 0 }]];
  },
  "a list offers what it can take": async () => {
    const { free, Shelf } = await get("bench/shelf");
    const shelf = new Shelf({ "hello.pal": "HLT\n" });
    const eia = [...Array(2000).fill(0), ...(await import("./tapes/eia.mjs")).encode("1234567\n1234567\n1234567\n")]; // a long leader
    const list = (of) => Object.assign(new Element(), { dataset: { tapes: of }, options: ["first"], replaceChildren(...names) { this.names = names.length; } });
    const lists = [list("any"), list("eia")];
    page.querySelectorAll = () => lists;
    for (const [name, frames] of Object.entries({ "a.asc": [0o301, 0o215, 0o212], "dropped on the reader.pal": [0o301, 0o215], "b.eia": eia })) shelf.put(name, frames);
    page.querySelectorAll = () => [];
    const taken = (name, ...names) => free(name, (each) => names.includes(each));
    const names = [taken("a.eia"), taken("a.eia", "a.eia"), taken("a.eia", "a.eia", "a 2.eia"), taken("a", "a"), taken("a.b.c", "a.b.c")];
    return [[lists.map((each) => each.names), names], [[4, 2], ["a.eia", "a 2.eia", "a 3.eia", "a 2", "a.b 2.c"]]];
  },
  "the lever waits for START where the machine stands, and is thrown once": async () => {
    const { bytes } = await import("./pdp8/web/translator/runtime.mjs");
    const { Teletype } = await get("bench/teletype");
    const bench = await desk({ shelf: { get: () => ({ frames: bytes([0o301, 0o302]), code: anything }) } });
    const { reader } = bench.machine.teletype;
    const made = Object.assign(new Teletype(bench), { leverWaits: false });
    reader.lever(false);
    made.mount("a");
    const seen = [[reader.on, made.leverWaits, reader.tape.length]];
    reader.lever(true);
    made.mount("a");
    seen.push([reader.on, made.leverWaits]);
    made.started();
    seen.push([reader.on, made.leverWaits]);
    reader.lever(false);
    made.started();
    seen.push([reader.on, made.leverWaits]);
    bench.machine.processor.run = 1;
    reader.lever(true);
    made.mount("b");
    seen.push([reader.on, made.leverWaits]);
    made.leverWaits = true;
    made.lever();
    seen.push([reader.on, made.leverWaits]);
    return [seen, [[false, false, 2], [false, true], [true, false], [false, false], [true, false], [false, false]]];
  },
  "a step back leads to the tape before, by its name": async () => {
    const { bytes } = await import("./pdp8/web/translator/runtime.mjs");
    const { History } = await import("./pdp8/computer/past/history.mjs"), { instructions } = await import("./pdp8/computer/past/rewind.mjs");
    const { Teletype } = await get("bench/teletype");
    const bench = await desk({ shelf: { get: () => ({ frames: bytes([0o301, 0o302]) }) } });
    const history = new History(bench.machine), made = new Teletype(bench);
    made.mount("a");
    bench.machine.run(null, 2);
    made.mount("b"); // the same frames
    const seen = [made.called()];
    bench.machine.run(null, 2);
    instructions(history, 3);
    return [[...seen, made.called()], ["b", "a"]];
  },
  "counts are of fetches, and of the turns of a loop that is passed over": async () => {
    const { Counts } = await get("bench/counts");
    const counts = new Counts();
    const seen = [];
    for (const field of [0, 0o10000]) {
      for (const state of [0, 1, 2, 0]) counts.cycle({ state, ma: 0o200, extension: { field } });
      counts.waited({ pc: 0o7777, extension: { inst_field: field } }, 10);
      seen.push([0o200, 0o7777, 0, 1].map((address) => counts.executed[field + address]));
    }
    return [seen, [[2, 5, 5, 0], [2, 5, 5, 0]]];
  },
  "a source that takes too long is not assembled by the page instead; another machine is counted anew": async () => {
    const { Editor } = await get("bench/editor");
    const bench = await desk({ programs: new (await get("bench/store")).Store("late"), shelf: { sources: [] }, apart: { ask: () => Promise.reject(new Error("it took more than 5 s")) } });
    const editor = new Editor(bench), seen = [];
    for (const unable of [false, true]) {
      Object.assign(bench.apart, { unable });
      editor.put(`${unable}.pal`, "*200\nHLT\n$\n");
      await soon(300);
      seen.push(editor.assembly.summary, editor.assemble());
    }
    find("counts").checked = true;
    for (const count of [1, 0]) {
      Object.assign(bench, { machine: await machine() });
      for (let times = 0; times < 2; times++) editor.write();
      editor.counts.executed[0o200] += count;
    }
    find("counts").checked = false;
    return [[seen, editor.counts.executed[0o200]], [["Not assembled: it took more than 5 s.", false, "1 word, a tape of 137 frames.", true], 0]];
  },
  "an error is brought under the eye where it stands": async () => {
    const { Editor } = await get("bench/editor");
    const marked = [];
    const area = Object.assign(new Element(), { value: "AB\nCDE\nF", scrollTop: 0, clientHeight: 240, setSelectionRange: (...range) => marked.push(range) });
    const editor = Object.assign(new Editor(await desk({ programs: {}, shelf: {} })), { area, lines: area.value.split("\n") });
    for (const [line, start, end] of [[1, 0, 2], [2, 1, 3], [3, 0, 1]]) editor.goTo({ dataset: { line, start, end } });
    const tops = [1, 8, 9, 40].map((line) => (area.scrollTop = 0, editor.goTo({ dataset: { line, start: 0, end: 0 } }), area.scrollTop));
    return [[marked.slice(0, 3), tops], [[[0, 2], [4, 6], [7, 8]], [-120, 0, 72, 816]]];
  },
  "a program that another tab has changed stays where it is renamed": async () => {
    const { Editor } = await get("bench/editor");
    const programs = new (await get("bench/store")).Store("tabs");
    const editor = new Editor(await desk({ programs, shelf: { sources: [] }, apart: { ask: () => new Promise(nothing) } }));
    editor.put("a.pal", "mine");
    programs.keep("a.pal", "theirs");
    editor.rename({ value: "b.pal" });
    return [[programs.get("a.pal"), programs.get("b.pal")], ["theirs", "mine"]];
  },
  "a play ends with the afternoon, and not before": async () => {
    const made = await afternoon();
    const second = 20_000_000;
    Object.assign(made.made, { now: 0, end: 10 * second });
    made.playing = true;
    const pass = (milliseconds, speed, late) => (made.pass(milliseconds, speed, late), [made.playing, made.made.now / second]);
    const seen = [pass(1000, 1), pass(8900, 1), pass(200, 1)];
    Object.assign(made, { position: 0, playing: true }).made.now = 0;
    seen.push(pass(9, Infinity, 0), pass(9, Infinity, Infinity));
    return [seen, [[true, 1], [true, 9.9], [false, 10.1], [true, 0], [false, 10]]];
  },
  "in the afternoon it is said what the operator did, or what the machine waits for": async () => {
    const made = await afternoon();
    const { processor } = made.made.machine;
    const said = [];
    made.bench.time = { says: (_, { source }) => said.push(/<em>(.*)<\/em>/.exec(source)[1]) };
    const look = (more) => (Object.assign(made.made, more), made.write());
    made.made.act = { name: "", say: "", starts: 100 };
    look({ now: 100 + 8 * 2e7 - 1, action: { at: 100, say: "throws a switch" } });
    [0o6031, 0o5200, 0o6041, 0o5202, 0o7200].forEach((word, at) => processor.deposit(0o200 + at, word));
    for (const run of [1, 0]) {
      Object.assign(processor, { run });
      for (let pc = 0o200; pc < 0o206; pc++) look({ now: 100 + 8 * 2e7, machine: Object.assign(made.made.machine, { pc }) });
    }
    look({ now: 100, action: { at: 99, say: "of the act before" } });
    const [reader, punch] = ["reader", "punch"].map((what) => `It waits for the ${what}.`);
    return [said, ["throws a switch", reader, reader, punch, punch, "", "", ...Array(7).fill("")]];
  },
  "a link holds what it is given, in letters that an address has": async () => {
    const { linked, opened } = await get("bench/sharing");
    const { inflateRawSync } = await import("node:zlib");
    globalThis.pack = { unpacked: async (text) => inflateRawSync(Buffer.from(atob(text), "latin1")).toString() };
    const wrong = [];
    for (let number = 0; number < 40; number++) {
      const given = { program: { name: `${number}.pal`, text: Array.from({ length: 9 * number }, (_, at) => (at * number * 7919 % 4096).toString(8)).join(" ") } };
      const link = await linked(given, "page.html");
      location.hash = link.slice("page.html".length);
      if (!/^#s=[\w-]+$/.test(location.hash) || JSON.stringify(await opened()) !== JSON.stringify(given)) wrong.push(number);
    }
    location.hash = "#s=AAAA";
    const damaged = await opened().catch(({ message }) => message);
    location.hash = "";
    return [[wrong, damaged], [[], "it is damaged or cut short"]];
  },
  "a practice goes on where it was left, one that was done begins": async () => {
    const { Switches } = await get("bench/switches");
    const lines = rows(60);
    find("card").querySelectorAll = () => lines;
    find("computer").querySelectorAll = () => [];
    const { card } = Object.assign(new Switches(await desk()), {});
    const count = card.card.steps.length;
    const now = () => lines.flatMap(({ classes }, at) => (classes.has("now") ? [at] : []));
    const seen = [0, 3, count - 1, count].map((at) => ((card.kept = [at, 2, 5, true]), [card.coach.at, now(), card.kept]));
    card.end();
    seen.push([card.coach, now(), find("drill").ariaPressed, card.allows("start")]);
    card.kept = [0, 0, 0, false];
    seen.push([card.allows("cont"), card.coach.wrong]);
    const clock = globalThis.performance;
    globalThis.performance = { now: () => 0 };
    card.kept = [0, 0, 0, true];
    seen.push([1000, 3000].map((passed) => ((globalThis.performance = { now: () => passed }), card.allows("cont"), card.coach.seconds)));
    globalThis.performance = clock;
    delete find("card").querySelectorAll;
    delete find("computer").querySelectorAll;
    const at = (place) => [place, [place], [place, 2, 5, true]];
    return [seen, [at(0), at(3), at(count - 1), at(0), [null, [], "false", true], [false, 1], [1, 3]]];
  },
  "reels turn with the tape, and a drive has what is mounted on it until it is taken off": async () => {
    const { Drives } = await get("bench/drives");
    const { TC08 } = await import("./pdp8/computer/dectape/tc08.mjs");
    const { LINE, LINES } = await import("./pdp8/computer/dectape/tu55.mjs");
    const { blank } = await import("./tapes/dectape.mjs");
    const made = [];
    for (const row of (find("reels").children = rows(2))) {
      const reels = rows(2);
      for (const reel of reels) reel.setAttribute = (_, text) => (reel.turned = text.replace(/\.\d+\)$/, ")"));
      for (const reel of reels) reel.querySelector("circle").setAttribute = (_, text) => (reel.radius = Number(text));
      row.querySelectorAll = () => reels;
      made.push(reels);
    }
    let remembered = 0;
    const got = [];
    const bench = await desk({ remember: () => (remembered += 1), download: (name, frames) => got.push(name, frames.length) });
    const { watch } = bench.machine;
    bench.like = (own, more, memory) => Object.assign(Object.create(Object.getPrototypeOf(own)), own, { devices: [...own.devices, ...more], held: memory, watch: { breakpoints: new Set() } });
    const drives = new Drives(bench);
    find("reels").children = [];
    const state = () => (drives.show(), [drives.units.map(({ hidden }) => hidden), find("boot-reel").disabled]);
    const seen = [state(), drives.takes("a.TU56", "".encode("ascii")), drives.takes("a.tu5", "".encode("ascii"))];
    const frames = blank().content();
    for (const name of ["a", "b", "c"]) {
      drives.mount(name, frames);
      seen.push([[0, 1].map((unit) => drives.called(unit)).join(), bench.said.at(-1).slice(-6)], state());
    }
    for (const size of [0o10000, 0o100000]) { // one that has more than 8K keeps it
      const large = await desk({ remember: nothing, machine: new bench.machine.constructor([], size), like: (own, more, held) => (seen.push(held), bench.like(own, more, held)) });
      new Drives(large).mount("a", frames);
    }
    seen.push(bench.machine.held, bench.machine.devices.filter((each) => each instanceof TC08).length, bench.machine.watch.breakpoints === watch.breakpoints);
    const [drive] = drives.control.drives;
    const shown = [0, 0.5, 1].map((part) => {
      drive.position = () => Math.round(part * LINES) * LINE;
      drives.show();
      return [...made[0].flatMap(({ turned, radius }) => [turned, radius]), drives.units[0].querySelector(".name").textContent];
    });
    drives.lock({ checked: true, value: "0" });
    drives.show();
    seen.push(drives.units.map((row) => row.querySelector("input").checked));
    drives.save({ value: "1" });
    seen.push([...got], remembered);
    drives.takeOff({ value: "0" });
    seen.push(state(), remembered);
    drives.save({ value: "0" });
    drives.takeOff({ value: "1" });
    seen.push(state(), got.length);
    seen.push(bench.said.filter((line) => line.includes("in place of")).map((line) => line.split(";")[0]));
    const all = "0: a, ", [none, one, both] = [[true, true], [false, true], [false, false]];
    const area = Math.sqrt((9 ** 2 + 4 ** 2) / 2), half = Math.floor((180 * 360 * 9 * 0.5) / area);
    return [[seen, shown], [
      [[none, true], true, false, ["a,a reel", "rive 0"], [one, false], ["a,b", "f core"], [both, false], ["a,c", "f core"], [both, false], 0o20000, 0o100000, 8192, 1, true, [true, false],
        ["c", 2 * 129 * 1474], 3, [[true, false], true], 4, [none, true], 2,
        ["c is on DECtape drive 1 in place of b"]],
      [["translate(10 10) rotate(0)", 9, "translate(30 10) rotate(0)", 4, `${all}end zone, at rest`],
        [`translate(10 10) rotate(${half})`, 6.96, `translate(30 10) rotate(${half})`, 6.96, `${all}block 1341, at rest`],
        ["translate(10 10) rotate(145800)", 4, "translate(30 10) rotate(64800)", 9, `${all}end zone, at rest`]]]];
  },
};
