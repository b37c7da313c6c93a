/* global history, URL, window */
// The room by itself (again.mjs): its pictures, sounds, keys and what the visitor types.

import { crossed, drawing } from "./canvas.mjs";
import { anything, Element, find, get, machine, nothing, page, room, worked } from "./again.mjs";

const known = new Map();
const plain = (of) => (of === null || typeof of !== "object" ? of : `picture ${known.set(of, known.get(of) ?? known.size).get(of)}`);

/** What is done to a canvas, as [name, ...numbers, texts and pictures]; an inch has `sharp` pixels. */
const strokes = (draw, sharp = 1) => {
  const done = [];
  const context = new Proxy({}, {
    get: (_, name) => (name === "getTransform" ? () => ({ a: sharp }) : (...given) => (done.push([String(name), ...given.map(plain)]), anything)),
    set: (_, name, value) => (done.push([String(name), String(value)]), true),
  });
  draw(context);
  return done;
};

/** A room that is drawn: `pass(seconds)` lets a picture come, `seen` has what the last one drew of each thing. */
async function drawn() {
  const frames = [];
  globalThis.requestAnimationFrame = (act) => frames.push(act);
  Object.assign(find("room"), { clientWidth: 1000, clientHeight: 800, hidden: false });
  Object.assign(page, { hidden: false, heard: {} });
  const made = await room();
  const { bench, bench: { afternoon, afternoon: { script } } } = made;
  const day = Object.assign(script.day, { path: { knots: [], at: nothing, first: {} }, mill_starts: 0, tapes: new Map(), part: "circle" });
  Object.assign(script, { machine: bench.led, done: 0, mounted: "", to(tick) { this.now = tick; } });
  afternoon.lead = function lead(tick) {
    this.on = true;
    bench.machine = bench.led;
    script.to(tick);
    script.act = day.acts.find(({ ends }) => tick < ends) ?? day.acts.at(-1);
  };
  Object.assign(bench, { writer: { text: (element, text) => (element.textContent = text), label: nothing }, sound: { on: false, hum: (...loud) => (made.hum = loud), strike: (kind) => made.struck.push(kind) } });
  Object.assign(made, { frames, struck: [], seen: {} });
  made.scene.draw = (camera, where, live, lit) => {
    made.seen = { panel: strokes(live.panel), teletype: strokes(live.teletype), lit: ["panel", "teletype", "mill"].filter(lit) };
    return false;
  };
  made.pass = (seconds) => frames.splice(0).forEach((act) => act(made.before + 1000 * seconds));
  made.texts = () => find("room").querySelector(".when").children.map(({ textContent }) => textContent);
  find("room").querySelector(".when").children = [new Element(), new Element()];
  const chapters = Array.from({ length: 7 }, () => Object.assign(new Element(), { toggleAttribute(name, on) { this[name] = on; } }));
  find("room").querySelectorAll = (selector) => (selector === ".chapters button" ? chapters : [new Element()]);
  return made;
}

/** The visitor is at the switches. */
async function taken() {
  const made = await drawn();
  made.enter();
  made.hands = LATER;
  made.take();
  return made;
}
const LATER = null;

export const cases = {
  "at the pace of 1971 it stays there": async () => {
    const made = await drawn();
    made.enter();
    made.go({ value: 1 });
    const paces = Array.from({ length: 80 }, () => (made.pass(0.04), made.speed)).filter((pace) => pace);
    return [[paces.length > 30, Math.round(Math.max(...paces)), Math.round(Math.min(...paces))], [true, 1, 1]];
  },
  "a tab that nobody sees asks for no picture until it is seen, and is silent": async () => {
    const made = await drawn();
    page.hidden = true;
    made.enter();
    const asked = made.frames.length;
    page.hidden = false;
    page.hear("visibilitychange");
    page.hear("visibilitychange");
    made.pass(0.09);
    const heard = [made.hum];
    page.hidden = true;
    page.hear("visibilitychange");
    heard.push(made.hum);
    return [[asked, made.frames.length, heard], [0, 1, [[1, 0], [0, 0]]]];
  },
  "the operator's key is pressed in the story, not at the visitor's switches": async () => {
    const made = await drawn();
    made.enter();
    const panel = (key) => {
      made.bench.afternoon.pressed = key;
      made.show();
      made.pass(0.04);
      return JSON.stringify(made.seen.panel);
    };
    const differs = () => (panel("start"), panel("start") !== panel(null));
    const story = differs();
    made.take();
    return [[story, differs(), made.seen.lit], [true, false, ["panel", "teletype"]]];
  },
  "the story ends in its last act and stands, each act is told": async () => {
    const made = await drawn();
    made.enter();
    const told = [];
    for (let pictures = 0; made.playing && pictures < 3000; pictures++) {
      made.pass(0.09);
      const marked = made.chapters.map((button) => button["aria-current"]).indexOf(true);
      const now = [made.tour.turn, marked, find("room").querySelector(".story").textContent];
      if (String(now) !== String(told.at(-1))) told.push(now);
    }
    made.pass(0.09);
    return [[told, made.playing, made.texts()[1], find("pause").textContent], [Array.from({ length: 8 }, (_, turn) => [turn, turn - 1, `act ${turn}`]), false, "stands still", "Play"]];
  },
  "how fast it goes is said": async () => {
    const made = await drawn();
    made.enter();
    made.playing = true;
    const said = [1, 1.5, 1.6, 9.6, 30, 44, 46, 1236].map((speed) => {
      made.said = 1;
      made.tour.wall = 0;
      made.since = -1; // no step, which would measure it
      made.speed = speed;
      made.pass(0.01);
      return made.texts()[1].replace(" times as fast", "");
    });
    const own = "at the pace of 1971";
    return [said, [own, own, "2", "10", "30", "40", "50", "1\u202f240"]];
  },
  "in a hurry a picture that comes too slowly has fewer pixels, until there is no hurry": async () => {
    const made = await drawn();
    made.enter();
    const parts = [];
    made.scene.resize = (...[, , , part]) => parts.push(part);
    const look = (speed, seconds, more = {}) => (Object.assign(made, { speed, playing: true, since: -1, live: false, hands: anything }, more), (made.tour.wall = 0), made.pass(seconds), made.coarse);
    const slow = () => [1, 2, 3, 4].map(() => look(30, 0.09)).at(-1);
    const seen = [look(30, 0.09), look(30, 0.09), look(30, 0.09), look(30, 0.001), look(20, 0.09), look(20, 0.001), look(30, 0.001), slow()];
    seen.push(look(30, 0.09, { playing: false }), (made.show(), slow()), look(30, 0.09, { live: true }));
    return [[seen, parts], [[false, false, true, true, false, false, false, true, false, true, false], [0.75, 1, 0.75, 1, 0.75, 1]]];
  },
  "the finer the window, the more pixels, but for a telephone and a wall of screens": async () => {
    const made = await drawn();
    const look = (width, devicePixelRatio) => (Object.assign(window, { devicePixelRatio }), (made.place.clientWidth = width), made.enter(), [made.scene.fine, made.fine]);
    const seen = [[699, 3], [700, 3], [2600, 3], [2601, 3], [1200, 1], [1201, 1], [1000, 0]].map((given) => look(...given));
    Object.assign(window, { devicePixelRatio: 1 });
    return [seen, [[1.6, 1000], [2, 1800], [2, 1800], [1, 1800], [1, 1000], [1, 1800], [1, 1000]]];
  },
  "what is lit is what the act is about": async () => {
    const made = await drawn();
    made.enter();
    const lit = [0, 1, 2, 3, 6].map((value) => (made.go({ value }), made.pass(0.01), made.seen.lit.join(" ")));
    return [lit, ["panel teletype mill", "teletype", "panel", "panel teletype", "mill"]];
  },
  "buttons of the story and of the switches change places": async () => {
    const made = await drawn();
    const state = () => [find("room").querySelector(".yours").hidden, find("speak").hidden, find("write").hidden, find("pause").hidden, find("pause").textContent, find("take").textContent];
    made.enter();
    const seen = [state()];
    made.toggle();
    seen.push(state());
    made.take();
    seen.push(state().filter((_, at) => at !== 4));
    made.take();
    seen.push(state());
    made.still = true; // nothing shall move
    for (made.bench.led.ac of [0, 0o7777]) { made.enter(); made.pass(0.01); }
    seen.push([...state().slice(2), made.filaments.moves]);
    return [seen, [
      [true, true, false, false, "Pause", "Take the switches"], [true, true, false, false, "Play", "Take the switches"],
      [false, false, true, true, "Back to the story"], [true, true, false, false, "Play", "Go on at the switches"], [false, true, "Play", "Go on at the switches", false]]];
  },
  "a pause gives the address of its instant, a play none": async () => {
    const made = await drawn();
    const given = [];
    history.replaceState = (_, __, address) => given.push(address);
    made.enter(30 * 2e7);
    given.length = 0;
    made.toggle();
    made.toggle();
    history.replaceState = nothing;
    return [[given.length, given[0], /^#t=\d/.test(given[1])], [2, "", true]];
  },
  "one picture of the tape is kept at a time": async () => {
    const made = await taken();
    const given = [];
    Object.assign(made.guide, { seen: { frames: [0o301], made: "A B!" } });
    globalThis.OffscreenCanvas.prototype.convertToBlob = async () => ({});
    let count = 0;
    const { createObjectURL, revokeObjectURL } = URL;
    Object.assign(URL, { createObjectURL: () => `blob:${(count += 1)}`, revokeObjectURL: (url) => given.push(url) });
    await made.see();
    await made.see();
    made.guide.seen.made = "";
    await made.see();
    Object.assign(URL, { createObjectURL, revokeObjectURL });
    const link = find("tape").querySelector("a");
    return [[given, link.href, link.download], [["blob:1"], "blob:2", "A-B-.png"]];
  },
  "strikes of a kind come apart, those of others beside them": async () => {
    const { Sound } = await get("room/sound");
    const sound = Object.assign(new Sound(), { on: true, context: { currentTime: 1 }, noise: {} });
    const started = [];
    const node = (of) => class { constructor() { this.gain = anything; } connect() { return this; } start(when) { started.push([of, when.toFixed(2)]); } stop() {} };
    Object.assign(globalThis, { AudioBufferSourceNode: node("burst"), GainNode: node(""), BiquadFilterNode: node(""), OscillatorNode: node("tone") });
    for (const [kind, at] of [["key", 1], ["key", 1.06], ["read", 1.06], ["key", 1.08], ["bell", 1.08], ["print", 1.08]]) {
      sound.context.currentTime = at;
      sound.strike(kind);
    }
    sound.strike("key", 0.5);
    const loud = [];
    Object.assign(sound.context, { suspend: nothing });
    sound.motor = sound.cutter = { setTargetAtTime: (to) => loud.push(to) };
    sound.turn(false);
    sound.strike("key", 1);
    const wanted = [["burst", 1.05], ["burst", 1.11], ["burst", 1.13], ["tone", 1.13], ["tone", 1.13], ["burst", 1.13], ["burst", 1.13], ["burst", 1.63]];
    return [[started, loud], [wanted.map(([of, when]) => [of, when.toFixed(2)]), [0, 0]]];
  },
  "a wide window has the whole panel, a telephone its parts": async () => {
    const { APART, formed, least, WHOLE } = await get("room/panel");
    const forms = [[1600, 900], [1250, 600], [390, 600], [340, 380]].map(([w, h]) => formed({ w, h }));
    const name = (form) => (form === WHOLE ? "whole" : form === APART ? "apart" : "little");
    return [[forms.map(name), Math.round(least(WHOLE, 390)), Math.round(least(APART, 3900))], [["whole", "whole", "apart", "little"], 193, 489]];
  },
  "a switch lies where its piece of the panel lies": async () => {
    const { APART, SWITCHES, WHOLE, within } = await get("room/panel");
    const out = [WHOLE, APART].map((form) => SWITCHES.filter((place) => {
      const { x, y, w, h } = within(form, place);
      return x < 0 || y < 0 || x + w > form.w + 0.01 || y + h > form.h + 0.01;
    }).length);
    const { Hands } = await get("room/hands");
    const buttons = SWITCHES.map(() => ({ style: { setProperty(side, share) { this[side] = parseFloat(share); } } }));
    const laid = [WHOLE, APART].map((form) => {
      Object.assign(Object.create(Hands.prototype), { buttons }).lay(form);
      const { left, top, width, height } = buttons[0].style;
      return [left, top, width, height, buttons.filter(({ style }) => style.left + style.width > 100.1 || style.top + style.height > 100.1).length];
    });
    const places = SWITCHES.map((place) => { const { x, y } = within(APART, place); return `${x.toFixed(1)} ${y.toFixed(1)}`; });
    return [[out, new Set(places).size, laid], [[0, 0], 20, [[12.68, 70.29, 3.58, 20, 0], [1.23, 33.09, 7.6, 12.73, 0]]]];
  },
  "paper is drawn anew where it is seen larger": async () => {
    const { Page } = await get("room/teletype");
    const paper = new Page();
    for (const frame of [0o301, 0o215, 0o212]) paper.take(frame);
    const wide = [4, 4, 16, 4].map((sharp) => {
      strokes((c) => paper.draw(c, 0, 0), sharp);
      return [paper.sharp, paper.ended - paper.drawn, paper.picture.getContext("2d").filled.length > 0];
    });
    return [wide, [[4, 0, true], [4, 0, true], [16, 0, true], [4, 0, true]]];
  },
  "filaments follow and rest": async () => {
    const { Filaments } = await get("room/panel");
    const lamps = (await machine()).panel.lamps;
    const off = new Filaments();
    off.follow([lamps]);
    const rests = off.moves;
    const other = await machine();
    other.processor.lac = 0o7777;
    off.follow([other.panel.lamps], 0.5);
    const half = [off.moves, off.lit.get("ac")[0]];
    for (let times = 0; times < 9; times++) off.follow([other.panel.lamps], 0.5);
    return [[rests, half, off.moves, off.lit.get("ac")[0] > 0.99], [false, [true, 0.5], false, true]];
  },
  "an act passes as fast as is said, ever forward, to its last tick": async () => {
    const { tour } = await drawn().then((made) => (made.enter(), made));
    const wrong = [];
    for (let turn = 1; turn < 8; turn++) {
      const act = tour.day.acts[turn - 1];
      tour.go(turn);
      let before = tour.tick;
      if (before < act.starts) wrong.push([turn, "early"]);
      while (tour.part < 1) {
        tour.pass(0.05);
        if (tour.turn !== turn || tour.tick < before || tour.tick >= act.ends) wrong.push([turn, tour.part]);
        before = tour.tick;
      }
      if (before !== act.ends - 1) wrong.push([turn, before]);
      if (!tour.pass(0.3) || tour.turn !== turn) wrong.push([turn, "no pause"]);
      if (tour.pass(0.2) !== (turn < 7) || (turn < 7 && (tour.turn !== turn + 1 || tour.wall))) wrong.push([turn, "goes on"]);
    }
    return [wrong, []];
  },
  "the camera rises in the act of cutting, and stays": async () => {
    const { tour } = await drawn().then((made) => (made.enter(), made));
    const above = [[5, 1], [6, 0.3], [6, 0.37], [6, 0.44], [6, 1], [7, 0], [7, 1]].map(([turn, part]) => (tour.go(turn, part), Number(tour.above.toFixed(2))));
    return [above, [0, 0, 0.5, 1, 1, 1, 1]];
  },
  "the camera comes to rest where it looks, and at once where nothing shall move": async () => {
    const { Camera } = await get("room/camera");
    const [box, frame] = [{ x: 10, y: 20, w: 20, h: 5 }, { left: 100, top: 50, w: 800, h: 400 }];
    const camera = new Camera();
    camera.look({ x: 0, y: 0, w: 20, h: 20 }, frame, false);
    const first = camera.scale;
    camera.look(box, frame, false);
    camera.glide(0.1);
    const glides = [camera.moves, camera.scale === first];
    for (let times = 0; times < 60; times++) camera.glide(0.1);
    const at = ({ scale, origin: { x, y } }) => [scale, x, y].map((each) => Math.round(each));
    const other = new Camera();
    other.look({ x: 0, y: 0, w: 10, h: 10 }, frame, false);
    other.look(box, frame, true);
    return [[Math.round(first), glides, camera.moves, at(camera), at(other)], [20, [true, false], false, [40, -300, -650], [40, -300, -650]]];
  },
  "who has turned from the punch stays at the panel while the program waits": async () => {
    const made = await taken();
    const due = [];
    const step = { say: "s", key: "", switches: -1 };
    const seen = { frames: [], made: "", run: 1, sr: 0o17, waits: false };
    made.hands = Object.assign(made.hands, { due: (key, bits) => due.push([key, bits]), seek: nothing });
    made.guide = { next: () => step, seen, did: "", start: 0 };
    const look = (waits, how = nothing) => {
      seen.waits = waits;
      how();
      made.show();
      return [made.typing, find("help").hidden, find("turn").hidden, find("see").hidden, find("turn").textContent];
    };
    const views = [look(false), look(true), look(true, () => made.turn()), look(true), look(true, () => (seen.made = "A")), look(false), look(true)];
    Object.assign(step, { switches: 0o7, key: "" });
    made.show();
    Object.assign(step, { switches: -1, key: "dep" });
    made.show();
    const [panel, punch] = ["To the panel", "To the punch"];
    return [[views, due.slice(-2)], [[
      [false, false, true, true, punch], [true, true, false, true, panel], [false, true, false, true, punch], [false, true, false, true, punch],
      [false, true, false, false, punch], [false, false, true, false, punch], [true, true, false, false, panel]], [["", 0o10], ["dep", 0]]]];
  },
  "each character is struck once, a space and a return are not": async () => {
    const made = await taken();
    made.struck.length = 0;
    const { printer } = made.bench.machine.teletype;
    const moved = [];
    const type = (...codes) => {
      for (const code of codes) printer.frames.append(code);
      made.show();
      made.pass(0.001);
      made.show();
      made.pass(0.001);
      moved.push([made.moved.struck > 0.5, made.moved.fed > 0.5]);
      Object.assign(made.moved, { struck: 0, fed: 0 });
    };
    type(0o301, 0o240, 0o215);
    type(0o212);
    type(0o207, 0o302);
    printer.frames.clear();
    type(0o303);
    return [[made.struck, moved, made.typed, made.page.paper.lines], [["print", "feed", "bell", "print", "print"], [[true, false], [false, true], [true, false], [true, false]], 1, ["C"]]];
  },
  "in any window all of the panel can be scrolled out from behind the words": async () => {
    const made = await taken();
    const { place } = made, rooms = [];
    for (const [wide, high, beside] of [[1366, 768, true], [2600, 1000, true], [390, 844, false], [340, 380, false], [600, 300, true]]) {
      Object.assign(place, { clientWidth: wide, clientHeight: high });
      place.querySelector(".when").getBoundingClientRect = () => ({ bottom: 40 });
      place.querySelector(".told").getBoundingClientRect = () => (beside ? { left: 0.7 * wide, top: 0 } : { left: 0, top: 0.7 * high });
      made.speak(new Element());
      const { frame: { top, h } } = made, behind = beside ? 0 : 0.3 * high, all = parseFloat(place.querySelector("canvas").style.height);
      rooms.push([top, all > high, Math.abs(all - Math.max(high, top + h + behind)) < 1]);
    }
    for (const name of [".when", ".told"]) delete place.querySelector(name).getBoundingClientRect;
    return [rooms, [[40, false, true], [40, false, true], [40, false, true], [40, true, true], [40, true, true]]];
  },
  "an act is the same wherever one comes from": async () => {
    const detours = {
      nothing,
      "it played": (made) => (made.go({ value: 5 }), made.toggle(), [1, 2, 3].forEach(() => made.pass(0.09))),
      "it was in a hurry": (made) => (made.go({ value: 5 }), made.toggle(), Array.from({ length: 99 }, () => made.pass(0.09))),
      "it was at its end": (made) => (made.go({ value: 7 }), made.toggle(), Array.from({ length: 200 }, () => made.pass(0.09))),
      "the switches were taken": (made) => (made.take(), made.pass(0.09), made.take()),
      "a name was typed": (made) => {
        made.take();
        made.guide = { next: () => ({ say: "s", key: "", switches: -1 }), seen: { frames: [1], made: "A", run: 1, sr: 0, waits: true }, did: "did", start: 0 };
        made.bench.machine.teletype.printer.frames.append(0o301);
        made.show();
        made.pass(0.09);
        made.go({ value: 0 });
      },
      "one was at the desk": (made) => (made.leave(), made.enter()),
    };
    const differs = [];
    for (const turn of [1, 4, 7]) {
      let wanted;
      for (const [name, detour] of Object.entries(detours)) {
        const made = await drawn();
        const { bench: { afternoon: { script }, led } } = made;
        script.to = function to(tick) {
          this.now = tick;
          led.processor.lac = Math.floor(tick / 2e7) & 0o7777;
        };
        for (const code of [0o302, 0o303]) led.teletype.printer.frames.append(code);
        made.bench.machine = await worked(1);
        made.enter();
        made.toggle();
        detour(made);
        made.playing = false;
        made.go({ value: turn });
        for (let times = 0; times < 20; times++) made.pass(0.1);
        const texts = [".story", ".did", ".lamps"].map((each) => find("room").querySelector(each).textContent), buttons = ["pause", "write", "speak", "take"].map((id) => [find(id).hidden, find(id).textContent]);
        const { at, filaments, live, page: { paper }, playing, tour, typing, waits } = made, lamps = [...filaments.lit.values()].flat().map(Math.round).join("");
        const now = { at, buttons, hum: made.hum, chapter: made.chapters.findIndex((each) => each["aria-current"]), frames: made.frames.length, lamps, lit: made.seen.lit, live, paper: paper.lines, playing, texts, tick: tour.tick, typing, waits: Boolean(waits), when: made.texts() };
        wanted ??= { ...now, hum: [0, 0] };
        for (const [what, is] of Object.entries(now)) if (JSON.stringify(is) !== JSON.stringify(wanted[what])) differs.push([turn, name, what, is, wanted[what]]);
      }
    }
    return [differs, []];
  },
  "what does not move crosses no edge": async () => {
    const things = [["panel", "drawPanel", "PANEL"], ["teletype", "drawTeletype", "TELETYPE"], ["mill", "drawMill", "MILL"]];
    const seen = [];
    for (const [module, name, size] of things) {
      const { [name]: draw, [size]: { w, h } } = await get(`room/${module}`);
      const { filled, texts } = drawing(draw);
      const out = filled.filter(([, left, top, right, bottom]) => left < -0.01 || top < -0.01 || right > w + 0.01 || bottom > h + 0.01);
      seen.push([filled.length > 0, crossed(filled, 0.07), out, texts.filter(([, x, y]) => x <= 0 || y <= 0 || x >= w || y >= h)]);
    }
    return [seen, Array(3).fill([true, [], [], []])];
  },
  "a plate is milled no further than one goes back, also in the midst of a cut": async () => {
    const { Plate } = await get("room/plate");
    const knots = [0, 1000, 2000].map((x) => ({ x, y: 0, down: x > 0 }));
    const plate = new Plate(knots, 250, { left: -500, right: 2500, bottom: -500, top: 500 }, 100, false);
    let begun = 0;
    plate.rim.clearRect = () => (begun += 1);
    const seen = [[0, 500], [1, 1200], [1, 1800], [1, 1800], [1, 1300], [1, 1900], [0, 900]].map(([knot, x]) => (plate.to({ knot, x, y: 0, down: true }), begun));
    return [seen, [0, 0, 0, 0, 1, 1, 2]];
  },
  "a lamp is lit in its socket, a rocker that is up is one that is down upside down": async () => {
    const { drawLamps, drawPanel, Filaments, SWITCHES } = await get("room/panel");
    const sockets = drawing(drawPanel).filled.filter(([name, left, , right]) => name === "fill" && Math.abs(right - left - 0.3) < 0.001);
    const off = new Filaments();
    off.follow([(await machine()).panel.lamps]);
    const all = (level) => new Map(Array.from(off.lit, ([field, bits]) => [field, bits.map(() => level)]));
    const pictures = (level, sr, held = null) => drawing((c) => drawLamps(c, all(level), { sr, mem_prot: 1, sing_step: 0 }, held)).filled;
    const middle = ([, left, top, right, bottom]) => `${((left + right) / 2).toFixed(3)} ${((top + bottom) / 2).toFixed(3)}`;
    const levels = [0, 0.01, 0.02, 0.5, 1].map((level) => pictures(level, 0).length - 20);
    const lit = pictures(1, 0).slice(0, -20);
    const round = lit.every(([, left, top, right, bottom], at) => Math.abs(right - left - (at % 2 ? 0.6 : 1.24)) + Math.abs(bottom - top - (at % 2 ? 0.6 : 1.24)) < 0.001);
    const own = new Set(sockets.map(middle)), shone = lit.map(middle);
    const rockers = pictures(0, 0o4001);
    const inside = rockers.every(([, left, top, right, bottom], at) => left >= SWITCHES[at].x && right <= SWITCHES[at].x + SWITCHES[at].w && top === SWITCHES[at].y && bottom <= top + 1.75);
    const made = rockers.map(([, , , , , picture]) => picture.context);
    const kinds = (of) => of.map(([, , , , , picture]) => [...new Set(made)].indexOf(picture.context)).join("");
    const flipped = [[0, 3], [1, 10]].map(([up, down]) => [crossed(made[up].filled, 0.03 * 160), made[up].filled.length - made[down].filled.length]);
    const sides = ({ filled }) => filled.map(([, , top, , bottom]) => [Math.round(top), Math.round(bottom)]).sort((one, other) => one[0] - other[0] || one[1] - other[1]);
    const upside = sides(made[0]).map(([top, bottom]) => [Math.round(1.64 * 160) - bottom, Math.round(1.64 * 160) - top]).sort((one, other) => one[0] - other[0] || one[1] - other[1]);
    return [
      [levels, round, shone.filter((place) => !own.has(place)), [...own].filter((place) => !shone.includes(place)), inside, flipped, upside, kinds(rockers), kinds(pictures(0, 0o4001, "start"))],
      [[0, 0, 102, 102, 102], true, [], [], true, [[[], 0], [[], 0]], sides(made[6]), "01122211122345555555", "01122211122344555555"]];
  },
  "a tape lies with its frame at the head, and ends where its paper does": async () => {
    const { drawTape, PITCH, TRACKS } = await get("room/tape");
    const code = { paper: "#fff", caption: String };
    const rows = (strip, of) => {
      const { filled } = drawing((c) => drawTape(c, strip, { code, ...of }), 100);
      const paper = filled.find(([name, , , , , colour]) => name === "fillRect" && colour === "#fff");
      const pictures = filled.filter(([name]) => name === "picture");
      const at = pictures.map(([, left, top, right, bottom]) => [left, Math.round((top + bottom) / 2), Math.round(bottom - top), right - left]);
      return [paper?.slice(1, 5).map(Math.round), at.length, at[0], at.at(-1)];
    };
    const frames = new Uint8Array(40).fill(1);
    const strip = { x: 2, head: 5, from: 0, until: 9 };
    const seen = [
      rows(strip, { frames, at: 10 }), rows({ ...strip, way: -1 }, { frames, at: 10 }), rows({ ...strip, from: 4.5, until: 5.5 }, { frames, at: 10 }),
      rows(strip, { frames, at: 0, last: 3 }), rows(strip, { frames, at: 120 }),
    ];
    const { context } = drawing((c) => drawTape(c, strip, { frames: [0o205], code, at: 0 }), 100).filled.at(-1)[5];
    const holes = context.filled.map(([, left, top, right, bottom]) => [((left + right) / 2 / 128).toFixed(2), ((top + bottom) / 2 / 128).toFixed(2), ((right - left) / 128).toFixed(3)]);
    const hole = (channel, wide) => [((TRACKS.indexOf(channel) + 1) * PITCH).toFixed(2), "0.05", wide];
    const onTheDesk = (await get("tape")).drawTape, numbers = [false, true].map((punching) => drawing((c) => onTheDesk(c, { frames, head: 15, code, punching }, 200, 400, { ratio: 1, ink: "", soft: "", rust: "" })).texts.map(([text]) => Number(text)).filter((text) => text > 9));
    return [[seen, holes, numbers], [
      [[[200, 165, 300, 645], 40, [200, 600, 10, 100], [200, 210, 10, 100]], [[200, 355, 300, 835], 40, [200, 400, 10, 100], [200, 790, 10, 100]],
        [[200, 450, 300, 550], 11, [200, 550, 10, 100], [200, 450, 10, 100]], [[200, 435, 300, 545], 3, [200, 500, 10, 100], [200, 480, 10, 100]], [undefined, 0, undefined, undefined]],
      [hole(8, "0.072"), hole(0, "0.046"), hole(3, "0.072"), hole(1, "0.072")], [[10, 15, 20], [10, 15]]]];
  },
  "the reader's lever is at one end of its slot or the other": async () => {
    const { drawHeads, drawSign } = await get("room/teletype");
    const [on, off] = [true, false].map((reading) => drawing((c) => drawHeads(c, reading)).filled);
    const [slot, up] = on.slice(-2), down = off.at(-1);
    const signs = ["", "A", "LONG"].map((said) => drawing((c) => drawSign(c, { x: 5, head: 8 }, 0, { caption: () => said })));
    const cards = signs.map(({ filled, texts: [text] }) => filled.map(([, left, top, right, bottom]) => [left < text[1] && text[1] < right, top < text[2] && text[2] < bottom, right < 5]));
    return [
      [crossed(on.slice(0, -1), 0.45), up[2] > slot[2] && up[4] < down[2], down[4] < slot[4], up[1] + up[3] - slot[1] - slot[3] < 0.01, on.length === off.length, cards],
      [[], true, true, true, true, [[], [Array(3).fill(true)], [Array(3).fill(true)]]]];
  },
  "a ruler has a mark each eighth, and a place of the plate is under the spindle": async () => {
    const { drawCutter, drawMeasured, drawSpindle, drawTable, fitted, lay } = await get("room/mill");
    const { filled, texts, lines } = drawing((c) => drawMeasured(c, [[1000, 2000], [3250, 2000], [3250, 3125]], "die"));
    const [across, up] = filled.flatMap(([, , , , , colour], at) => (colour === "#d9d3c2" ? at : []));
    const labels = texts.map(([text]) => text);
    for (const part of ["ellipse", "circle"]) labels.push(drawing((c) => drawMeasured(c, [[0, 0], [9, 9]], part)).texts[0][0]);
    const marks = filled.slice(across + 1, up), long = (of, low, high) => of.map((mark) => (mark[high] - mark[low]) / 93.75).map((part) => part.toFixed(1));
    const place = (tilt) => {
      let at;
      drawing((c) => { c.save(); lay(c, 0.002, { x: 4000, y: 5000 }, tilt); at = [c.place(4000, 5000), c.place(4500, 6000)]; c.restore(); });
      return at.map((each) => each.map((number) => Number(number.toFixed(2))));
    };
    const bottoms = [[true, 0], [false, 0], [false, 2]].map(([down, lifted]) => drawing((c) => drawSpindle(c, 0.25, down, 3.3, lifted)).filled[1][4].toFixed(2));
    const cutter = drawing((c) => drawCutter(c, 0.5, true, 0)).filled;
    const table = drawing((c) => drawTable(c, { left: 0, right: 100, bottom: 0, top: 50 }, 1)).filled;
    return [
      [marks.length, filled.length - up - 1, long(marks, 2, 4).slice(0, 9), labels, lines, fitted({ left: 0, right: 4400, bottom: 0, top: 1000 }), place(1), place(0.5), bottoms, cutter.map((of) => of.slice(1, 5).map((at) => Number(at.toFixed(2)))), table.filter((of) => of[1] < -300 || of[3] > 400).length],
      [19, 10, ["0.9", "0.4", "0.4", "0.4", "0.6", "0.4", "0.4", "0.4", "0.9"], ["the ideal curve", "2.250 by 1.125 inches", "0", "1", "2", "0", "1", "the ideal ellipse", "the ideal circle"], 1, 0.002,
        [[9.5, 7], [10.5, 5]], [[9.5, 7], [10.5, 6]], ["7.12", "6.10", "4.10"], [[9, 6.5, 10, 7.5], [9, 6.95, 10, 7.05], [9.45, 6.5, 9.55, 7.5]], 0]];
  },
};
