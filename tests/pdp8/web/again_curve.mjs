/* global performance */
// The figures of "A curve in ten minutes" by themselves (again.mjs): what is kept, dragged, written and said.

import { Element, find, get, nothing, page, soon } from "./again.mjs";

const SVG = { x: 0, y: 0, width: 1000 };

/** A figure's place on the page with inputs {name: [value, more]}; `at` is where a pointer is over it. */
function inputs(id, given) {
  const made = Object.entries(given).map(([name, [value, more = {}]]) => Object.assign(new Element(), { name, value: String(value), dataset: {}, ...more }));
  find(id).querySelectorAll = () => made;
  find(id).held = {};
  const svg = find(id).querySelector("svg");
  svg.parentElement.clientWidth = 1000;
  svg.viewBox = { baseVal: { width: SVG.width } };
  svg.getBoundingClientRect = () => ({ left: 0, top: 0, width: SVG.width });
  page.activeElement = null;
  return Object.fromEntries(made.map((each) => [each.name, each]));
}

/** The Workers begun, and what they are asked; each answers what it is told to. */
function working() {
  const begun = [];
  globalThis.Worker = class {
    constructor() { this.asked = []; begun.push(this); }
    postMessage(message) { this.asked.push(message); }
    terminate() {}
    answer(...made) {
      this.asked.shift();
      this.onmessage({ data: made });
    }
  };
  page.querySelectorAll = () => [];
  return begun;
}

let copies = 0;
/** A copy of the module of what is made, with nothing kept. */
const fresh = async () => import(`./pdp8/web/curve/made.mjs?${(copies += 1)}`);

export const cases = {
  "of what was made the newest is kept, and each is asked once": async () => {
    const begun = working();
    const { made, Wanted } = await fresh();
    const get_ = (number) => {
      try { return made("quarter", number, 1); } catch (wanted) { return wanted instanceof Wanted ? "wanted" : String(wanted.message); }
    };
    const seen = [];
    for (let number = 0; number < 203; number++) {
      const first = [get_(number), get_(number)];
      begun[0].answer({ number });
      await soon();
      if (String(first) !== "wanted,wanted" || get_(number).number !== number) seen.push(number);
    }
    const [old, middle] = [get_(0), get_(100).number];
    begun[0].answer(null, "no");
    await soon();
    return [[seen, old, middle, get_(0), get_(0), begun.length], [[], "wanted", 100, "no", "wanted", 1]];
  },
  "a tape is asked for before its printout is there, and again where it is not made": async () => {
    const begun = working();
    const button = find("translate"), { computer } = await get("curve/block"), { WORK } = await get("curve/made");
    computer({ words: [], listing: [] });
    const seen = [];
    for (const answers of [[[WORK.circle(5, false)], [null, "late"]], [[{ frames: [0, 1], minutes: 2 }]]]) {
      button.hear("click");
      for (const answer of answers) {
        await soon(5);
        begun.find(({ asked }) => asked.length).answer(...answer);
      }
      await soon(5);
      seen.push([button.disabled, find("translated").textContent]);
    }
    for (const worker of begun) worker.onerror({}); // the next question begins another
    return [seen, [[false, "late"], [false, "666 blocks: 2.0 minutes at the computer; 1 frames and a blank one came out."]]];
  },
  "what is printed is made at once, and afterwards it waits again": async () => {
    const begun = working();
    const { made, withoutWaiting, Wanted } = await fresh();
    const tried = (tolerance) => { try { return made("quarter", tolerance, 1).blocks > 0; } catch (wanted) { return wanted instanceof Wanted ? "wanted" : "broken"; } };
    const seen = [tried(50)];
    withoutWaiting(() => seen.push(tried(50), tried(30)));
    try { withoutWaiting(() => { throw new Error("x"); }); } catch { /* it was thrown on */ }
    seen.push(tried(50), tried(20), begun.length);
    return [seen, ["wanted", true, true, true, "wanted", 1]];
  },
  "an answer is waited for, and why there is none is thrown": async () => {
    const begun = working();
    const { answered } = await fresh();
    const [good, bad] = [answered("quarter", 1, 1), answered("quarter", 2, 1).catch(({ message }) => message)];
    begun[0].answer("made");
    begun[0].answer(null, "refused");
    return [[await good, await bad], ["made", "refused"]];
  },
  "an input's steps grow, and its value is written in its unit": async () => {
    const { Figure } = await get("curve/drawing");
    const shown = [];
    const at = (value, unit, more) => [value, { dataset: { unit, ...more } }];
    const of = inputs("units", {
      a: at(0, "times", { most: "250" }), b: at(50, "times", { most: "250" }), c: at(100, "count", { most: "250" }), d: at(50, "count", { most: "250" }),
      e: at(5, "band"), f: at(30, "degrees"), g: at(125, "part"), h: at(20, "percent"), i: at(-20, "percent"), j: at(0, "percent"), k: at(8, "sixteenths"),
      l: ["on", { type: "checkbox", checked: true, dataset: {} }], m: at(7),
    });
    const figure = new Figure("units", (values) => (shown.push(values), ["", 1, ""]), { m: (value, { k }) => `${value} and ${k}` });
    const outputs = Object.values(of).map((input) => (input.parentElement.querySelector("output")));
    figure.now();
    const values = Object.values(shown[0]).map((value) => (typeof value === "number" ? Number(value.toFixed(2)) : value));
    return [[values, outputs.map(({ textContent }) => textContent)], [
      [1, 15.81, 250, 16, 5, 30, 125, 20, -20, 0, 8, true, 7], ["1.0 ×", "16 ×", "250", "16", "±.005 in", "30°", "13 %", "+20 %", "−20 %", "0 %", "0.5 in", "", "7 and 8"]]];
  },
  "a hold is dragged until the pointer is lifted, or lost": async () => {
    const { Figure } = await get("curve/drawing");
    const { size } = inputs("held", { size: [10] });
    const figure = new Figure("held", () => ["", 1, "", { size: { x: 0, y: 0, to: ({ x, dx, dy, start }) => start + dx - dy + x * 0 } }]);
    figure.now();
    const { svg } = figure;
    const came = [];
    figure.holds.size.to = ({ x, y, dx, dy, start }) => (came.push([x, y]), start + dx - dy);
    svg.getBoundingClientRect = () => ({ left: 10, top: 20, width: 500 }); // half as large as it is drawn
    const target = (hold) => ({ closest: () => (hold ? { dataset: { hold } } : null) });
    const move = (x, y = 0, pointerId = 1) => (svg.hear("pointermove", { clientX: x, clientY: y, pointerId }), size.value);
    const take = (hold, x, pointerId = 1) => svg.hear("pointerdown", { target: target(hold), clientX: x, clientY: 0, pointerId, preventDefault: nothing });
    const seen = [move(5)];
    take("", 0);
    seen.push(move(7));
    take("size", 100);
    seen.push(move(103), move(105, 1));
    take("size", 50, 2); // another finger
    move(30, 0, 2);
    svg.hear("pointerup", { pointerId: 2 });
    seen.push(size.value);
    svg.hear("pointerup", { pointerId: 1 });
    seen.push(move(150));
    take("size", 50);
    seen.push(move(51));
    svg.hear("pointercancel", { pointerId: 1 });
    seen.push(move(99));
    return [[seen, came], [["10", "10", "16", "18", "18", "18", "20", "20"], [[186, -40], [190, -38], [82, -40]]]];
  },
  "a figure far away is drawn for paper only, one near is drawn once for all changes": async () => {
    const { Figure } = await get("curve/drawing");
    const { size } = inputs("far", { size: [1] });
    let drawn = 0;
    const watched = [];
    globalThis.IntersectionObserver = class { constructor(act) { watched.push(act); } observe() {} };
    const figure = new Figure("far", () => ((drawn += 1), ["", 1, ""]));
    size.value = "2";
    figure.later();
    await soon(5);
    const seen = [drawn];
    watched[0]([{ isIntersecting: true }]);
    figure.set("size", 3);
    figure.set("size", 4);
    await soon(5);
    seen.push(drawn);
    watched[0]([{ isIntersecting: false }]);
    figure.set("size", 5);
    await soon(5);
    seen.push(drawn);
    globalThis.IntersectionObserver = Element;
    page.heard.beforeprint.at(-1)();
    return [[...seen, drawn], [0, 1, 1, 2]];
  },
  "lengths and minutes are written as in 1971": async () => {
    const { grownBack, inch, mils, minutes, onCircle } = await get("curve/drawing");
    const { CENTRE, RADIUS } = await get("method");
    const { x, y } = onCircle(90);
    return [
      [[5, 10.6, 1000, 0, 999.96].map((of) => mils(of, 4)), mils(5), inch(1250), [9.994, 10, 9.9].map(minutes), [1, 250].map((many) => Math.round(grownBack(many, 250))), [Math.round(x - CENTRE), Math.round(y - CENTRE) === RADIUS]],
      [[".0050", ".0106", "1.0000", ".0000", "1.0000"], ".005", "1.250 in", ["9.99 min", "10.0 min", "9.90 min"], [0, 100], [0, true]]];
  },
  "a block is said to be what it is, with its lengths and its feed": async () => {
    const { holes } = await get("curve/block");
    const { withoutWaiting } = await get("curve/made");
    inputs("holes", { block: [1] });
    const figure = holes();
    const said = [1, 2, 3, 4, 5, 6, 7, 8, 9, 666].map((block) => {
      let drawn;
      withoutWaiting(() => (drawn = figure.draw({ block }, 700)));
      return drawn[2].source.replace(/<.?b>|Block |, one of.*|A row.*/g, "");
    });
    const mills = ["2.250, Y 4.133 in, with the Y", "2.261, Y 4.133 in, with the X", "2.261, Y 4.237 in, with the Y"].map((place, at) => `00${at + 7}: mill to X ${place} feed at code 01. `);
    return [said, [...[1, 2, 3, 4, 5].map((number) => `00${number}: position`), "006: depths: feed from Z 3 in down to 3.5 in.", ...mills, "666: mill to X 2.251, Y 3.844 in, with the X feed at code 01. "]];
  },
  "the circle near by says what is seen": async () => {
    const { near } = await get("curve/near");
    const { withoutWaiting } = await get("curve/made");
    inputs("near", { near: [0] });
    const figure = near();
    const said = [5.9, 6, 19.9, 20, 25, 25.1].map((times) => {
      let drawn;
      withoutWaiting(() => (drawn = figure.draw({ near: times }, 700)));
      return [drawn[2].slice(0, 9), drawn[0].includes('class="stop"')];
    });
    return [said, [["A circle ", false], ["Something", false], ["Something", false], ["Every cor", false], ["Every cor", false], ["Every cor", true]]];
  },
  "both sides are drawn, each once, and nothing undefined, whatever the sliders say": async () => {
    const { withoutWaiting } = await get("curve/made");
    const wrong = [], names = new Set(), slopes = Array.from({ length: 20 }, (_, at) => ["slopes", "stepwise", { tolerance: 150 + 3 * at, dx: 0, angle: 30 }]);
    for (const [from, name, values] of [["near", "near", { near: 1 }], ["near", "near", { near: 250 }], ["roundness", "roundness", { times: 100, closed: true, cutter: 8 }], ...slopes]) {
      let content = (inputs(name, {}), "");
      const figure = (await get(`curve/${from}`))[name]();
      withoutWaiting(() => ([content] = figure.draw(values, 700)));
      const all = content.match(/<[a-z][^>]*class="(limit|division|heavy|outer|inner)[^>]*>/g) ?? [];
      const [outer, inner] = ["outer", "inner"].map((side) => content.match(new RegExp(`(?<=t-${side}"[^>]*>)[^<]+`, "g"))?.join());
      for (const [, each] of content.matchAll(/class="name">(.)/g)) names.add(each);
      if (new Set(all).size < all.length || (outer && outer === inner) || /undefined|NaN/.test(content)) wrong.push([name, values]);
    }
    return [[wrong, [...names].sort().join("")], [[], "ABCDEFGHIJKLMNO"]];
  },
  "the whole circle begins with its first block, reads, cuts, and is done": async () => {
    const { whole } = await get("curve/whole");
    const { withoutWaiting } = await get("curve/made");
    inputs("whole", { time: [0] });
    const figure = whole(new Element());
    const seen = [0, 1, 500, 1000].map((time) => {
      let drawn;
      withoutWaiting(() => (drawn = figure.draw({ time }, 700)));
      const [content, , said, { time: hold }] = drawn;
      const back = Math.abs(hold.to(hold) - time);
      return [/<b>(\d+)<\/b> of (\d+)/.exec(said.source).slice(1).map(Number), /done|stands still|cuts along/.exec(content)[0], time === 0 || time === 1000 || back < 4];
    });
    const [[[first, all], reads, ...more], , [[middle]], [[last, end], done]] = seen;
    return [[first < 10, reads, more, middle > first && middle < all, last === end, done], [true, "stands still", [true], true, true, "done"]];
  },
  "Cut plays on from where it stands, Stop stops, a hand on the slider or in the drawing too": async () => {
    const { whole } = await get("curve/whole");
    const { time } = inputs("whole", { time: [0] });
    const button = new Element();
    const asked = [];
    globalThis.requestAnimationFrame = (act) => (asked.push(act), asked.length);
    const later = globalThis.setTimeout;
    globalThis.setTimeout = (act) => void act();
    whole(button);
    time.value = "999";
    button.hear("click");
    asked.pop()(performance.now() + 100);
    globalThis.setTimeout = later;
    const seen = [button.textContent, time.value];
    time.value = "400";
    button.hear("click");
    seen.push(button.textContent, time.value);
    button.hear("click");
    seen.push(button.textContent);
    for (const place of [time, find("whole").querySelector("svg")]) {
      button.hear("click");
      place.hear("pointerdown", { target: { closest: () => null } });
      seen.push(button.textContent, time.value);
    }
    const { matchMedia } = globalThis;
    globalThis.matchMedia = () => ({ matches: true });
    for (const at of ["400", "1000"]) {
      time.value = at;
      button.hear("click");
      seen.push(button.textContent, time.value);
    }
    globalThis.matchMedia = matchMedia;
    return [seen, ["Cut", "1000", "Stop", "400", "Cut", "Cut", "400", "Cut", "400", "Cut", "428", "Cut", "28"]];
  },
  "a band made straight names its sides where there is space between them": async () => {
    const { straightened } = await get("curve/drawing");
    const box = { x: 0, y: 0, width: 100, height: 100 };
    const labels = [13, 14, 15].map((half) => straightened(box, 100, half, 100, []).match(/[+−±]\.\d+/g).map((label) => label[0]).join(""));
    return [labels, ["±", "±", "+−"]];
  },
  "an own curve is translated as it is last, and saved only then": async () => {
    const begun = working();
    const { setTimeout: real } = globalThis;
    globalThis.setTimeout = (act, after = 0) => real(act, after / 40);
    const { own } = await get("curve/own");
    const { tolerance } = inputs("own", { tolerance: [20], place: [500] });
    const [save, open] = [Object.assign(new Element(), { disabled: true }), Object.assign(new Element(), { removeAttribute() { delete this.href; } })];
    const { svg } = Object.assign(find("own"), { svg: find("own").querySelector("svg") });
    const figure = own({ words: [], workbench: "bench.html" }, save, open);
    const state = () => [save.disabled, Boolean(open.href)];
    const until = async (holds) => { for (let turns = 0; turns < 2000 && !holds(); turns++) await soon(100); };
    const asked = () => begun.at(-1)?.asked.length;
    figure.now();
    await until(asked);
    const machines = begun.at(-1);
    const seen = [state(), asked()];
    machines.answer(null, "late");
    await until(() => figure.svg.innerHTML && /late/.test(figure.draw({ tolerance: 20, place: 500 }, 700)[2].source));
    seen.push(state());
    tolerance.value = "30";
    figure.now();
    await until(asked);
    machines.answer({ frames: Uint8Array.of(1, 2), minutes: 3, same: true });
    await until(() => !save.disabled);
    seen.push(state());
    tolerance.value = "40";
    figure.now();
    seen.push(state());
    await until(asked);
    tolerance.value = "60";
    figure.now(); // the answer that comes is the one of before
    machines.answer({ frames: Uint8Array.of(1), minutes: 2, same: true });
    await until(asked);
    await soon(800);
    seen.push(state());
    machines.answer({ frames: Uint8Array.of(1), minutes: 1, same: false });
    await until(() => !save.disabled);
    seen.push(state());
    figure.now();
    const said = figure.draw({ tolerance: 60, place: 500 }, 700)[2].source;
    const along = [0, 1, 500, 999, 1000].map((place) => {
      const { to, x, y } = figure.draw({ tolerance: 60, place }, 700)[3].place;
      return Math.abs(to({ x, y }) - place) < 40 && [to({ x: x - 900 }), to({ x: x + 900 })].join();
    });
    for (const [event, clientX] of [["pointerdown", 300], ["pointermove", 320]]) svg.hear(event, { target: { closest: () => null }, clientX, clientY: 100, preventDefault: nothing });
    figure.now();
    seen.push(state(), figure.said.innerHTML);
    svg.hear("pointerup");
    const { Wanted, withoutWaiting } = await get("curve/made");
    let wide, narrow, waits, refused;
    try { figure.draw({ tolerance: 33, place: 0 }, 700); } catch (wanted) { waits = wanted instanceof Wanted; }
    withoutWaiting(() => ([, , refused] = figure.draw({ tolerance: 0, place: 0 }, 700)));
    withoutWaiting(() => ([wide, narrow] = [60, 20].map((within) => figure.draw({ tolerance: within, place: 0 }, 700)[3].tolerance)));
    const band = [wide.y < narrow.y, wide.x === narrow.x, wide.to({ dy: 0, start: 20 }), wide.to({ dy: -30, start: 20 })];
    globalThis.setTimeout = real;
    return [[seen, said.includes("goes another way"), along, band, waits, refused.slice(0, 30)], [[[true, false], 1, [true, false], [false, true], [true, false], [true, false], [false, true], [true, false], "Lift the finger, and it is cut."], true, Array(5).fill("0,1000"), [true, true, 20, 30], true, "It cannot be cut: tolerance 0 "]];
  },
  "a stroke of the finger is taken from end to end, what lies beside it meets it, and a tap draws nothing": async () => {
    const { Pad } = await get("pad");
    const svg = find("pad");
    Object.assign(svg, { viewBox: { baseVal: { width: 1000 } }, getBoundingClientRect: () => ({ left: 0, top: 0, width: 1000 }) });
    let changes = 0;
    const pad = new Pad(svg, () => (changes += 1));
    const view = pad.fit({ x: 0, y: 0, width: 1000, height: 640 });
    const event = (name, x, y, hold = null, pointerId = 1) => svg.hear(name, { target: { closest: () => hold }, clientX: view.x(x), clientY: view.y(y), pointerId, preventDefault: nothing });
    const stroke = (...places) => {
      event("pointerdown", ...places[0]);
      for (const name of ["pointerdown", "pointermove", "pointerup"]) event(name, 4000, 4400, null, 2); // another finger
      for (const place of places.slice(1)) event("pointermove", ...place);
      event("pointerup");
      return pad.heights.filter((_, at) => at % 25 === 0);
    };
    pad.text = Array(101).fill("5").join(" ");
    const seen = [stroke([1950, 5500], [6050, 5500]), stroke([6050, 4000], [1950, 9000]), stroke([2990, 5100], [3010, 5100], [2990, 5100]), stroke([3000, 4000])];
    event("pointerdown", 3000, 5000, {});
    event("pointermove", 3000, 4000);
    event("pointerdown", 3000, 1000);
    event("pointermove", 3000, 4000);
    for (const words of ["5 5", `${Array(100).fill("4").join(" ")} x`, Array(102).fill("4").join(" ")]) pad.text = words;
    seen.push(changes, pad.heights[0], pad.text.split(" ").length);
    pad.text = Array.from({ length: 101 }, (_, at) => 4 + at / 50).join("\n");
    seen.push([[2000, 4000], [4000, 5100], [6100, 6000]].map(([x, y]) => Object.values(pad.beside({ x, y })).map(Math.round)));
    return [seen, [Array(5).fill(5500), [6173, 5637, 5100, 4563, 4027], [5615, 5100, 4585, 4048, 3800], [5615, 5100, 4585, 4048, 3800], 8, 5615, 101, [[0, 0], [2000, 89], [4100, -45]]]];
  },
  "a ring is lit while its input has the focus": async () => {
    const { Figure } = await get("curve/drawing");
    const { size } = inputs("lit", { size: [10] });
    const figure = new Figure("lit", () => ["", 1, "", { size: { x: 0, y: 0, to: nothing } }]);
    figure.near = true;
    const seen = [];
    for (const [event, focus] of [["focusin", size], ["focusout", null], ["input", null]]) {
      page.activeElement = focus;
      find("lit").hear(event);
      await soon(5);
      seen.push(figure.svg.innerHTML.includes('class="hold on"'));
    }
    return [seen, [true, false, false]];
  },
  "what is made of a path has its times": async () => {
    const { plain } = await get("curve/made");
    const method = await get("method");
    const times = [method.circle(50, false), method.quarter(20, 3), method.slope(20, 0, 0, 30)].map((made) => {
      const { steps, stops, milling, way } = plain(made);
      const cutting = stops.reduce((sum, { seconds }) => sum + seconds, 0) / 60;
      return [Math.abs(cutting - milling) < 0.02 * milling, stops.length <= steps.length, way.length > 1, stops.every(({ axis, mills }) => mills && "XY".includes(axis))];
    });
    return [times, Array(3).fill([true, true, true, true])];
  },
  "a cost stands by its tolerance, in their order": async () => {
    const { costs, curved } = await get("curve/quarter");
    const { withoutWaiting } = await get("curve/made");
    inputs("costs", { tolerance: [10], feed: [1] });
    inputs("curved", { tolerance: [10], cutter: [8], place: [45] });
    let places, heights, ends;
    withoutWaiting(() => {
      const { draw } = costs();
      ends = [-900, 9000].map((x) => draw({ tolerance: 10, feed: 5 }, 700)[3].tolerance.to({ x }));
      places = [1, 2, 4, 10, 20, 50].map((tolerance) => draw({ tolerance, feed: 5 }, 700)[3].tolerance.x);
      heights = [559, 560, 561].map((width) => curved().draw({ tolerance: 50, cutter: 8, place: 45 }, width)[1]);
    });
    return [[places.every((x, at) => !at || x > places[at - 1]), heights.map((high) => high > 500), ends], [true, [true, false, false], [0, 100]]];
  },
};
