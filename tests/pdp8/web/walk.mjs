/* global document, history, localStorage, location, workbench */
// What a page on the small document shows and keeps, as {name: text}; and what a step of walked.txt changes of it (walk.py).

const DIGITS = 4, WIDE = 36, MANY = 4;
const PASSES = 400; // ms after a step: what was typed has been looked at, what stands still has been said
const TURNS = 400; // of 50 ms, in which what a step begins has to end

/** A few digits of a text. */
function digest(text) {
  let sum = 5381;
  for (const character of text) sum = (Math.imul(sum, 33) ^ character.codePointAt(0)) >>> 0;
  return sum.toString(36).padStart(DIGITS, "0").slice(-DIGITS);
}

const tidy = (text) => String(text).replace(/\s+/g, " ").trim();
/** A text, or its beginning and its digest. */
const short = (text) => (text.length > WIDE ? `${tidy(text.slice(0, WIDE))}…${digest(text)}` : tidy(text));

/** What of an element is its own: words, attributes, value, style. */
function* own(element) {
  const words = tidy(element.childNodes.filter((each) => "data" in each).map(({ data }) => data).join(" "));
  if (words) yield ["", words];
  for (const name of element.getAttributeNames()) if (!/^(id|data-|clip-path)/.test(name)) yield [`@${name}`, element.getAttribute(name)];
  const { checked, localName, value } = element;
  if (checked !== undefined) yield ["=", String(checked)];
  else if (/^(input|select|textarea)$/.test(localName)) yield ["=", value];
  const style = Object.entries(element.style).map(([name, text]) => `${name}:${text}`).join(" ");
  if (style) yield ["~", style];
}

/** Notes of an element and of all in it: {path: text}. */
function look(element, path, found) {
  for (const [name, text] of own(element)) found[path + name] = text;
  const count = {};
  for (const each of element.children) {
    const { id, localName } = each, number = (count[localName] = (count[localName] ?? 0) + 1);
    look(each, id && !/^clip/.test(id) ? `#${id}` : `${path} ${localName}${number > 1 ? number : ""}`, found);
  }
}

const plain = (value) => (value?.[Symbol.iterator] && typeof value !== "string" ? digest([...value].join(" ")) : String(value));
const UNSTEADY = /clock|until|due|begun|waiting|started|instructions|ticks|ready|start$|end$/; // depends on how long the pictures took

/** What is to be seen of the page's objects. */
function objects(found) {
  const { afternoon, clock, editor, machine, room, sound, teletype, until } = workbench;
  for (const [name, value] of machine.values().items()) if (!UNSTEADY.test(name)) found[`machine ${name}`] = plain(value);
  const { breakpoints, observer } = machine.watch;
  const of = { led: afternoon.on, playing: afternoon.playing, act: afternoon.on && afternoon.script.act.name, speed: clock.speed, moves: clock.pictures.running, breakpoints: [...breakpoints].sort().join(), counted: observer !== null,
    until: until.constructor.name, lever: teletype.leverWaits, name: teletype.called(), sound: sound.on, own: room.own !== null, turn: room.tour?.turn, live: room.live, plays: room.playing, paper: room.page.paper.lines.join(" "), program: editor.name };
  for (const [name, value] of Object.entries(of)) found[`.${name}`] = String(value);
}

/** What the page, its stores and the browser around it have. */
export function state() {
  const { dom } = globalThis, found = {};
  look(document.body, "", found);
  if (globalThis.workbench?.ready) objects(found);
  for (const name of Object.keys(localStorage)) if (name !== "pdp8 session") found[`kept ${name}`] = localStorage[name];
  const { activeElement: focus } = document;
  found.focus = focus === document.body ? "" : focus.id || focus.ariaLabel || focus.dataset.key || focus.textContent.slice(0, 20);
  if (document.scrolled) found.scrolled = document.scrolled.id || document.scrolled.textContent.slice(0, 20);
  found.title = document.title;
  found.address = location.hash.replace(/#s=.+/, "#s=…");
  found.pages = String(history.entries.length);
  dom.copied.forEach((text, at) => (found[`copied ${at}`] = text.replace(/^.*(?=#)/, "").replace(/#s=.+/, "#s=…")));
  dom.saved.forEach(([name], at) => (found[`saved ${at}`] = name));
  Object.assign(found, dom.sounded);
  return found;
}

/** A line that says what differs; of many notes of one element the first, and their digest. */
function differing(before, now) {
  const changed = new Map();
  for (const name of new Set([...Object.keys(before), ...Object.keys(now)])) {
    if (before[name] === now[name]) continue;
    const [, owner] = /^(#[\w-]+|\w+|\.\w+|)/.exec(name);
    changed.set(owner, [...(changed.get(owner) ?? []), name in now ? `${name} ${short(now[name])}` : `no ${name}`]);
  }
  return [...changed.values()].map((notes) => (notes.length > MANY ? `${notes[0]} and ${notes.length - 1} ${digest(notes.join("\n"))}` : notes.join("; "))).join("; ");
}

/** A digest of what is drawn on canvases while `act` is done, wherever and however often. */
export async function drawn(act) {
  const lines = await globalThis.dom.drawn(act);
  return digest([...new Set(lines.filter((line) => !/ransform|^drawImage|^translate/.test(line)))].sort().join("\n"));
}

/** Whether something that was begun goes on of itself. */
function busy() {
  const { apart, afternoon, machine, mill, parts } = globalThis.workbench ?? {};
  if (!apart) return false;
  return apart.asked.length > 0 || parts.translating || mill.pictures.running || (afternoon.on ? afternoon.playing : machine.processor.run && !machine.waiting.endless);
}

const on = (selector) => {
  const [, plainly, at] = /^(.*?)(?: >> (\d+))?$/.exec(selector);
  const found = [...document.querySelectorAll(plainly)][Number(at ?? 0)];
  if (!found) throw new Error(`nothing is ${selector}`);
  return found;
};
const usable = (selector) => {
  const found = on(selector);
  if (found.disabled || !found.checkVisibility()) throw new Error(`${selector} cannot be used`);
  return found;
};
const keys = (element, [...names]) => names.join("").split(" ").forEach((name) => {
  const held = name.split("+"), key = held.pop() || "+";
  element.press(key === "Space" ? " " : key, Object.fromEntries(held.filter(Boolean).map((each) => [`${each.toLowerCase().replace("control", "ctrl")}Key`, true])));
});
/** The ways to work the page: each with what it is for and what it is given. */
const WAYS = {
  click: (selector) => usable(selector).point(),
  choose: (selector, value) => usable(selector).choose(value),
  fill: (selector, value) => {
    const field = usable(selector);
    field.fill(value.replaceAll("|", "\n"));
    if (field.localName === "input") field.commit();
  },
  slide: (selector, value) => {
    Object.assign(usable(selector), { value });
    on(selector).emit("input");
  },
  drop: (selector) => on(selector).emit("change"),
  key: (selector, value) => keys(selector === "*" ? document.activeElement : (usable(selector).focus(), on(selector)), value),
  drag: (selector, value) => {
    const places = value.split(", ").map((place) => place.split(" ").map(Number)).map(([clientX, clientY]) => ({ clientX, clientY, pointerId: 1 }));
    const from = on(selector), svg = from.closest("svg");
    from.emit("pointerdown", places[0]);
    for (const place of places.slice(1)) svg.emit("pointermove", place);
    svg.emit("pointerup", places.at(-1));
  },
  do: (_, value) => (0, eval)(`(async () => { const { workbench, curve } = globalThis; ${value} })()`),
  pass: () => undefined,
};
let before = {};

/** Begin from here, or from what was before. */
export function begin(from = state()) {
  before = from;
}

/** What another page has changed here. */
export function since() {
  const now = state(), said = differing(before, now);
  before = now;
  return said;
}

/** Do a step, [way, selector, value], let what it begins end, or so many milliseconds pass; return what it changed. */
export async function step([way, selector, value], milliseconds) {
  const { dom } = globalThis;
  document.scrolled = null;
  delete before.scrolled;
  const made = await WAYS[way](selector, value);
  await dom.pass(milliseconds ?? PASSES);
  for (let turn = 0; milliseconds === null && busy(); turn++) {
    if (turn > TURNS) throw new Error("it goes on");
    await dom.pass(50);
  }
  return [...(way === "do" && made !== undefined ? [`is ${made}`] : []), since()].filter(Boolean).join("; ");
}
