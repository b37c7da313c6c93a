/* global Blob, Response, URL, structuredClone */
// A small document in Node.js, on which the pages' modules run as they do in a browser: elements, selectors, events, what a
// form's controls hold, two stores. Time passes when it is told to (`pass`), chance is the same each time.
//
// Not there: style, layout (all is 1000 by 600), pictures (a canvas keeps the words that are written on it).

import { inflateRawSync } from "node:zlib";

const VOID = new Set("area br col hr img input link meta".split(" "));
const ENDS = { li: ["li"], option: ["option"], optgroup: ["option", "optgroup"], dt: ["dt", "dd"], dd: ["dt", "dd"], tr: ["td", "th", "tr"], td: ["td", "th"], th: ["td", "th"] };
const PIECE = /<!--.*?-->|<!\w[^>]*>|<(\/?)([a-zA-Z][\w-]*)((?:[^>"']|"[^"]*"|'[^']*')*?)(\/?)>|[^<]+|</gs;
const NAMED = { amp: "&", lt: "<", gt: ">", quot: '"', nbsp: "\u00a0" };
const plain = (text) => text.replace(/&(?:#(\d+)|#x([\da-f]+)|(\w+));/gi, (whole, number, hex, name) => (name ? NAMED[name] ?? whole : String.fromCodePoint(hex ? parseInt(hex, 16) : number)));
const written = (text) => text.replace(/[&<>"]/g, (each) => `&#${each.charCodeAt(0)};`);
const camel = (name) => name.replace(/-(\w)/g, (_, letter) => letter.toUpperCase());
const kebab = (name) => name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);

export class Event {
  constructor(type, more = {}) { Object.assign(this, { type, bubbles: false, cancelable: false, defaultPrevented: false, ended: false, target: null }, more); }
  preventDefault() { this.defaultPrevented = true; }
  stopPropagation() { this.ended = true; }
  stopImmediatePropagation() { this.ended = true; }
}

class Target {
  #heard = [];
  addEventListener(type, act, options) { this.#heard.push({ type, act, captures: options === true || options?.capture === true, once: options?.once }); }
  removeEventListener(type, act) { this.#heard = this.#heard.filter((each) => each.type !== type || each.act !== act); }
  hear(event, captures) {
    for (const each of [...this.#heard]) {
      if (each.type !== event.type || (captures !== undefined && each.captures !== captures)) continue;
      if (each.once) this.removeEventListener(each.type, each.act);
      try {
        (each.act.handleEvent ?? each.act).call(this, event);
      } catch (error) {
        complaints.push(error);
      }
    }
  }
  dispatchEvent(event) {
    event.target ??= this;
    const path = [];
    for (let at = this.parentNode; at; at = at.parentNode) path.push(at);
    if (this !== view && (this === document || path.includes(document))) path.push(view);
    const above = [...path].reverse().map((each) => [each, true]);
    for (const [each, captures] of [...above, [this], ...(event.bubbles ? path.map((at) => [at, false]) : [])]) if (!event.ended) each.hear(event, captures);
    return !event.defaultPrevented;
  }
}
export const complaints = []; // what was thrown where nobody caught it
const view = new Target();

class Text {
  constructor(data) { this.data = data; }
  get textContent() { return this.data; }
  get outerHTML() { return written(this.data); }
  get isConnected() { return Boolean(this.parentNode?.isConnected); }
}

/** The chain of compound selectors of each alternative, the last first: [[tests, how the one before is related], ...]. */
const chains = new Map();
const PART = /([\w-]+|\*)|#([\w-]+)|\.([\w-]+)|\[([\w-]+)(?:([~^$*|]?=)(?:"((?:\\.|[^"\\])*)"|'([^']*)'|([^\]]*)))?\]|:([\w-]+)(?:\(((?:[^()]|\([^()]*\))*)\))?|\s*([>+,])\s*|(\s+)/gy;
const EQUAL = { "=": (has, is) => has === is, "~=": (has, is) => has.split(/\s+/).includes(is), "^=": (has, is) => has.startsWith(is), "$=": (has, is) => has.endsWith(is), "*=": (has, is) => has.includes(is), "|=": (has, is) => has === is || has.startsWith(`${is}-`) };
const PSEUDO = {
  checked: (each) => (each.localName === "option" ? each.closest("select")?.selectedOptions.includes(each) : each.checked === true), disabled: (each) => each.disabled, enabled: (each) => !each.disabled, "first-child": (each) => !each.previousElementSibling,
  "last-child": (each) => !each.nextElementSibling, not: (each, of) => !each.matches(of), is: (each, of) => each.matches(of), has: (each, of) => each.querySelector(of) !== null, visible: (each) => each.checkVisibility(), "has-text": (each, of) => each.textContent.includes(of), named: (each, of) => (each.ariaLabel ?? each.textContent).trim() === of,
};
function chain(selector) {
  if (chains.has(selector)) return chains.get(selector);
  const found = [[[[], ""]]];
  PART.lastIndex = 0;
  while (PART.lastIndex < selector.length) {
    const match = PART.exec(selector.trim());
    if (!match) throw new Error(`no selector here: ${selector}`);
    const [, tag, id, name, attribute, how, quoted, single, bare, pseudo, given, relation, space] = match;
    const value = (quoted ?? single ?? bare ?? "").replace(/\\(.)/g, "$1");
    const test = tag ? (each) => tag === "*" || each.localName === tag.toLowerCase() : id ? (each) => each.id === id : name ? (each) => each.classList.contains(name)
      : attribute ? (each) => (how ? each.hasAttribute(attribute) && EQUAL[how](each.getAttribute(attribute), value) : each.hasAttribute(attribute)) : pseudo ? (each) => PSEUDO[pseudo](each, given) : null;
    if (test) found.at(-1)[0][0].push(test);
    else if (relation === ",") found.push([[[], ""]]);
    else found.at(-1).unshift([[], space ? " " : relation]);
    if (PART.lastIndex >= selector.trim().length) break;
  }
  for (const each of found) each.forEach((part, at) => (part[1] = each[at][1]));
  chains.set(selector, found);
  return found;
}
function fits(element, [[tests, relation], ...before]) {
  if (!tests.every((test) => test(element))) return false;
  if (!before.length) return true;
  if (relation === "+") return Boolean(element.previousElementSibling) && fits(element.previousElementSibling, before);
  for (let at = element.parentElement; at; at = at.parentElement) {
    if (fits(at, before)) return true;
    if (relation === ">") return false;
  }
  return false;
}

class Node extends Target {
  childNodes = [];
  parentNode = null;
  get children() { return this.childNodes.filter((each) => each instanceof Element); }
  get firstElementChild() { return this.children[0] ?? null; }
  get lastElementChild() { return this.children.at(-1) ?? null; }
  get parentElement() { return this.parentNode instanceof Element ? this.parentNode : null; }
  #beside(by) { const all = this.parentNode?.children ?? []; return all[all.indexOf(this) + by] ?? null; }
  get nextElementSibling() { return this.#beside(1); }
  get previousElementSibling() { return this.#beside(-1); }
  get isConnected() { return this === document || Boolean(this.parentNode?.isConnected); }
  get textContent() { return this.childNodes.map((each) => each.textContent).join(""); }
  set textContent(text) { this.replaceChildren(...(text === "" || text === null ? [] : [String(text)])); }
  /** The text as it is read: what lies beside or below other things is apart from them. */
  get innerText() {
    const apart = /^(div|li|ol|ul|tr|section|figure|dl|select|optgroup|form)$/.test(this.localName);
    return this.childNodes.map((each) => (each instanceof Text ? (this.closest("pre, code, li") ? each.data : each.data.replace(/[ \t\n]+/g, " ")) : each.checkVisibility() || /^opt/.test(each.localName) ? each.innerText : "")).join(apart ? " " : "");
  }
  get innerHTML() { return this.childNodes.map((each) => each.outerHTML).join(""); }
  set innerHTML(source) { this.replaceChildren(); parse(String(source), this); }
  #put(at, nodes) {
    const flat = nodes.flatMap((each) => (each instanceof Fragment ? each.childNodes.splice(0) : [each instanceof Text || each instanceof Node ? each : new Text(String(each))]));
    for (const each of flat) each.parentNode?.removeChild(each);
    this.childNodes.splice(at, 0, ...flat);
    for (const each of flat) each.parentNode = this;
  }
  append(...nodes) { this.#put(this.childNodes.length, nodes); }
  appendChild(node) { this.append(node); return node; }
  prepend(...nodes) { this.#put(0, nodes); }
  before(...nodes) { this.parentNode.#put(this.parentNode.childNodes.indexOf(this), nodes); }
  replaceChildren(...nodes) {
    for (const each of this.childNodes) each.parentNode = null;
    this.childNodes = [];
    this.append(...nodes);
  }
  removeChild(node) {
    this.childNodes = this.childNodes.filter((each) => each !== node);
    node.parentNode = null;
  }
  remove() { this.parentNode?.removeChild(this); }
  contains(node) { return node === this || Boolean(node?.parentNode && this.contains(node.parentNode)); }
  *all() { for (const each of this.childNodes) if (each instanceof Element) { yield each; yield* each.all(); } }
  querySelectorAll(selector) {
    const wanted = chain(selector);
    return [...this.all()].filter((each) => wanted.some((one) => fits(each, one)));
  }
  querySelector(selector) {
    const wanted = chain(selector);
    for (const each of this.all()) if (wanted.some((one) => fits(each, one))) return each;
    return null;
  }
}
class Fragment extends Node {
  getElementById(id) { return this.querySelector(`#${id}`); }
}

class Style {
  setProperty(name, value) { this[name] = value; }
  removeProperty(name) { delete this[name]; }
  getPropertyValue(name) { return this[name] ?? ""; }
}
let HIGH = 600, WIDE = 1000;
/** Let all be as large. */
export function size(wide, high) {
  [WIDE, HIGH] = [wide, high];
  for (const each of Observer.all) each.see();
}
const area = (left, top, right, bottom) => ({ left, top, right, bottom, width: right - left, height: bottom - top, x: left, y: top });
/** Of the room: the hour is above, what is told at the right, or below. */
const LAID = { when: () => area(0, 0, WIDE, 40), told: () => (WIDE > HIGH ? area(0.7 * WIDE, 0, WIDE, HIGH) : area(0, 0.7 * HIGH, WIDE, HIGH)) };
const LINES = /^(text|password|search|)$/;

export class Element extends Node {
  #attributes = new Map();
  #context = null;
  style = new Style();
  scrollTop = 0;
  scrollLeft = 0;
  offsetTop = 0;
  constructor(name) {
    super();
    this.localName = name;
    if (name === "template") this.content = new Fragment();
  }
  get tagName() { return this.localName.toUpperCase(); }
  getAttribute(name) { return this.#attributes.get(name) ?? null; }
  hasAttribute(name) { return this.#attributes.has(name); }
  getAttributeNames() { return [...this.#attributes.keys()]; }
  setAttribute(name, value) { this.#attributes.set(name, String(value)); }
  removeAttribute(name) { this.#attributes.delete(name); }
  toggleAttribute(name, on = !this.hasAttribute(name)) {
    if (!on) this.removeAttribute(name);
    else if (!this.hasAttribute(name)) this.setAttribute(name, "");
    return on;
  }
  get outerHTML() {
    const start = `<${this.localName}${[...this.#attributes].map(([name, value]) => ` ${name}="${written(value)}"`).join("")}>`;
    return VOID.has(this.localName) ? start : `${start}${this.innerHTML}</${this.localName}>`;
  }
  get classList() {
    const held = () => (this.getAttribute("class") ?? "").split(/\s+/).filter(Boolean);
    const toggle = (name, on = !held().includes(name)) => (this.setAttribute("class", [...held().filter((each) => each !== name), ...(on ? [name] : [])].join(" ")), on);
    return { contains: (name) => held().includes(name), toggle, add: (...names) => names.forEach((name) => toggle(name, true)), remove: (...names) => names.forEach((name) => toggle(name, false)) };
  }
  get dataset() {
    return new Proxy({}, {
      get: (_, name) => this.getAttribute(`data-${kebab(String(name))}`) ?? undefined, set: (_, name, value) => (this.setAttribute(`data-${kebab(name)}`, value), true), has: (_, name) => this.hasAttribute(`data-${kebab(String(name))}`),
      ownKeys: () => this.getAttributeNames().filter((name) => name.startsWith("data-")).map((name) => camel(name.slice(5))), getOwnPropertyDescriptor: () => ({ enumerable: true, configurable: true }),
    });
  }
  matches(selector) { return chain(selector).some((one) => fits(this, one)); }
  closest(selector) { return this.matches(selector) ? this : this.parentElement?.closest(selector) ?? null; }

  // What a form's control holds
  get options() { return this.querySelectorAll("option"); }
  get label() { return this.getAttribute("label") ?? (this.localName === "option" ? this.textContent : ""); }
  get form() { return this.closest("form"); }
  get type() { return this.getAttribute("type") ?? { button: "submit", select: "select-one", input: "text", textarea: "textarea" }[this.localName] ?? ""; }
  get #range() {
    const of = (name, other) => (Number.isFinite(parseFloat(this.getAttribute(name))) ? parseFloat(this.getAttribute(name)) : other);
    const low = of("min", 0), high = Math.max(low, of("max", 100)), step = this.getAttribute("step") === "any" ? 0 : of("step", 1);
    const asked = parseFloat(this.held ?? this.getAttribute("value"));
    const value = Math.max(low, Math.min(high, Number.isFinite(asked) ? asked : (low + high) / 2));
    return String(step ? Math.min(low + Math.round((value - low) / step) * step, low + Math.floor((high - low) / step) * step) : value);
  }
  get value() {
    switch (this.localName) {
      case "select": return this.selectedOptions[0]?.value ?? "";
      case "option": return this.getAttribute("value") ?? this.textContent.trim().replace(/\s+/g, " ");
      case "textarea": return this.held ?? this.textContent;
      case "input": return this.type === "range" ? this.#range : this.held ?? this.getAttribute("value") ?? (/checkbox|radio/.test(this.type) ? "on" : "");
      default: return this.getAttribute("value") ?? (this.localName === "button" ? "" : undefined);
    }
  }
  set value(value) {
    if (this.localName === "select") this.chosen = this.options.find((each) => each.value === String(value)) ?? null;
    else if (/^(input|textarea)$/.test(this.localName)) {
      this.held = String(value ?? "").replaceAll("\r\n", "\n");
      this.selectionStart = this.selectionEnd = this.held.length;
    } else this.setAttribute("value", value);
  }
  get selectedOptions() {
    const { chosen, options } = this;
    if (chosen === null || options.includes(chosen)) return chosen ? [chosen] : [];
    return [options.find((each) => each.hasAttribute("selected")) ?? options[0]].filter(Boolean);
  }
  get selectedIndex() { return this.options.indexOf(this.selectedOptions[0]); }
  set selectedIndex(at) { this.chosen = this.options[at] ?? null; }
  get checked() { return /checkbox|radio/.test(this.type) ? this.marked ?? this.hasAttribute("checked") : undefined; }
  set checked(on) {
    if (on && this.type === "radio") for (const each of document.querySelectorAll(`input[name="${this.name}"]`)) each.marked = false;
    this.marked = Boolean(on);
  }
  setSelectionRange(from, until) { Object.assign(this, { selectionStart: Math.min(from, this.value.length), selectionEnd: Math.min(until, this.value.length) }); }
  setRangeText(text, from, until) {
    this.held = this.value.slice(0, from) + text + this.value.slice(until);
    this.edited = true;
    this.selectionStart = this.selectionEnd = from + text.length;
  }

  // What a hand does
  emit(type, more = {}) { return this.dispatchEvent(new Event(type, { bubbles: true, cancelable: true, ...more })); }
  focus() {
    if (document.activeElement === this || this.disabled || !this.checkVisibility()) return;
    document.activeElement?.blur();
    document.focused = this;
    this.emit("focus", { bubbles: false });
    this.emit("focusin");
  }
  blur() {
    if (document.focused !== this) return;
    document.focused = null;
    this.commit();
    this.emit("blur", { bubbles: false });
    this.emit("focusout");
  }
  point() {
    this.emit("pointerdown");
    if (this.tabIndex >= 0 || this.hasAttribute("tabindex")) this.focus();
    else document.activeElement.blur();
    this.click();
  }
  click() {
    if (this.disabled) return;
    const { marked, type } = this, box = this.localName === "input" && /checkbox|radio/.test(type);
    const was = this.checked;
    if (box) this.checked = type === "radio" || !was;
    if (!this.emit("click")) {
      if (box) this.marked = marked;
      return;
    }
    if (box && was !== this.checked) for (const each of ["input", "change"]) this.emit(each);
    const { localName, parentElement } = this;
    if (localName === "button" && type === "submit" && this.form) this.form.requestSubmit();
    if (localName === "summary") parentElement.open = !parentElement.open;
    const link = this.closest("a");
    if (link?.hasAttribute("download")) saved.push([link.download, link.href]);
    else if (link?.getAttribute("href")?.startsWith("#")) globalThis.location.hash = link.getAttribute("href");
    else if (localName === "label" || (parentElement?.localName === "label" && localName === "span")) this.closest("label").querySelector("input, select")?.click();
  }
  requestSubmit() { if (this.emit("submit") && this.getAttribute("method") === "dialog") this.closest("dialog").close(); }
  showModal() { this.open = true; }
  close() {
    this.open = false;
    this.emit("close", { bubbles: false });
  }
  /** Type text, or press one key with `more`, at this element. */
  press(key, more = {}) {
    if (!this.emit("keydown", { key, ctrlKey: false, altKey: false, metaKey: false, shiftKey: false, ...more })) return;
    if (key === "Tab") {
      const stops = document.querySelectorAll("a, button, input, select, summary, textarea, [tabindex]").filter((each) => each === this || (each.tabIndex >= 0 && !each.disabled && each.checkVisibility() && (each.type !== "radio" || each.checked)));
      stops[stops.indexOf(this) + (more.shiftKey ? -1 : 1)]?.focus();
    }
    const typed = key.length === 1 && !more.ctrlKey && !more.altKey && !more.metaKey;
    const field = this.localName === "textarea" || (this.localName === "input" && LINES.test(this.getAttribute("type") ?? ""));
    if (field && key === "Home") this.setSelectionRange(0, 0);
    else if (field && key === "a" && more.ctrlKey) this.setSelectionRange(0, this.value.length);
    else if (field && !this.readOnly && (typed || key === "Backspace" || (key === "Enter" && this.localName === "textarea"))) {
      const { selectionStart: from = this.value.length, selectionEnd: until = this.value.length } = this;
      this.setRangeText(key === "Backspace" ? "" : key === "Enter" ? "\n" : key, key === "Backspace" && from === until ? Math.max(0, from - 1) : from, until);
      this.emit("input");
    } else if (field && key === "Enter") {
      this.commit();
      this.form?.requestSubmit();
    } else if (/^(button|summary|a)$/.test(this.localName) && (key === "Enter" || key === " ")) this.click();
    else if (this.type === "checkbox" && key === " ") this.click();
    const beside = { ArrowRight: 1, ArrowLeft: -1 }[key];
    if (this.type === "radio" && beside) {
      const all = document.querySelectorAll(`input[name="${this.name}"]`);
      const next = all.at((all.indexOf(this) + beside) % all.length);
      next.focus();
      next.click();
    }
  }
  commit() {
    if (this.edited) this.emit("change");
    this.edited = false;
  }
  fill(text) {
    this.focus();
    this.value = text;
    this.emit("input");
    this.edited = true;
  }
  choose(value) {
    this.value = value;
    for (const each of ["input", "change"]) this.emit(each);
  }

  // Where it is
  checkVisibility() {
    if (!this.isConnected) return false;
    for (let at = this; at; at = at.parentElement) {
      if (at.hidden || at.classList.contains("out") || (at.localName === "dialog" && !at.open)) return false;
      if (at.localName === "section" && at.parentElement?.classList.contains("one") && !at.classList.contains("alone")) return false;
      if (at !== this && at.localName === "details" && !at.open && !at.querySelector("summary")?.contains(this)) return false;
    }
    return true;
  }
  get clientWidth() { return WIDE; }
  get clientHeight() { return HIGH; }
  get scrollHeight() { return HIGH; }
  get viewBox() { const [x, y, width, height] = (this.getAttribute("viewBox") ?? "0 0 0 0").split(" ").map(Number); return { baseVal: { x, y, width, height } }; }
  getBoundingClientRect() { return (LAID[this.className] ?? (() => area(0, 0, WIDE, HIGH)))(); }
  scrollIntoView() { document.scrolled = this; }
  setPointerCapture() {}
  releasePointerCapture() {}
  getContext() { return (this.#context ??= context(this)); }
}
for (const name of ["id", "name", "title", "href", "src", "alt", "download", "placeholder", "rel"]) {
  Object.defineProperty(Element.prototype, name, { get() { return this.getAttribute(name) ?? ""; }, set(value) { this.setAttribute(name, value); } });
}
for (const [name, attribute] of [["hidden"], ["disabled"], ["open"], ["multiple"], ["readOnly", "readonly"]]) {
  Object.defineProperty(Element.prototype, name, { get() { return this.hasAttribute(attribute ?? name); }, set(on) { this.toggleAttribute(attribute ?? name, Boolean(on)); } });
}
for (const name of ["role", "ariaLabel", "ariaPressed", "ariaChecked", "ariaSelected", "ariaCurrent"]) {
  const attribute = name.replace("aria", "aria-").toLowerCase();
  Object.defineProperty(Element.prototype, name, { get() { return this.getAttribute(attribute); }, set(value) { if (value === null) this.removeAttribute(attribute); else this.setAttribute(attribute, value); } });
}
for (const name of ["max", "min", "step"]) Object.defineProperty(Element.prototype, name, { get() { return this.getAttribute(name) ?? ""; }, set(value) { this.setAttribute(name, value); } });
Object.defineProperty(Element.prototype, "className", { get() { return this.getAttribute("class") ?? ""; }, set(value) { this.setAttribute("class", value); } });
Object.defineProperty(Element.prototype, "tabIndex", { get() { return Number(this.getAttribute("tabindex") ?? (/^(a|button|input|select|summary|textarea)$/.test(this.localName) ? 0 : -1)); }, set(value) { this.setAttribute("tabindex", value); } });

/** Make the elements that a source describes, within `place`. */
function parse(source, place) {
  let at = place.content ?? place;
  const open = [at];
  for (PIECE.lastIndex = 0; PIECE.lastIndex < source.length;) {
    const [whole, ends, tag, attributes, closed] = PIECE.exec(source);
    if (!tag) {
      if (!whole.startsWith("<!") ) at.append(new Text(plain(whole)));
      continue;
    }
    const name = tag.toLowerCase();
    if (ends) {
      const back = open.findLastIndex((each) => each.localName === name);
      if (back > 0) at = open[(open.length = back) - 1];
      continue;
    }
    while (ENDS[name]?.includes(at.localName) && open.length > 1) at = open[(open.length -= 1) - 1];
    const made = new Element(name);
    for (const [, key, double, single, bare] of attributes.matchAll(/([^\s=/"']+)(?:\s*=\s*(?:"([^"]*)"|'([^']*)'|([^\s"']+)))?/g)) made.setAttribute(key, plain(double ?? single ?? bare ?? ""));
    at.append(made);
    if (closed || VOID.has(name)) continue;
    if (/^(script|style|textarea|title)$/.test(name)) {
      const start = PIECE.lastIndex, end = source.toLowerCase().indexOf(`</${name}`, start);
      const text = source.slice(start, end);
      made.append(new Text(/^s/.test(name) ? text : plain(text.replace(/^\n/, ""))));
      PIECE.lastIndex = source.indexOf(">", end) + 1;
      continue;
    }
    open.push((at = made));
    if (made.content) open.push((at = made.content));
  }
}

// What is drawn

let strokes = null;
const brief = (of) => (typeof of === "number" ? Number(of.toPrecision(5)) : Array.isArray(of) ? `[${of.map(brief)}]` : of !== null && typeof of === "object" ? of.constructor.name : of);
const note = (name, given) => strokes?.push(`${name} ${given.map(brief).join(" ")}`);
/** What is drawn on canvases while something is done, a line each. */
export async function drawn(act) {
  strokes = [];
  await act();
  const found = strokes;
  strokes = null;
  return found;
}
const nothing = () => undefined;
function context(canvas) {
  let now = [1, 0, 0, 1, 0, 0];
  const kept = [];
  const times = ([a, b, c, d, e, f]) => {
    const [A, B, C, D, E, F] = now;
    now = [A * a + C * b, B * a + D * b, A * c + C * d, B * c + D * d, A * e + C * f + E, B * e + D * f + F];
  };
  const done = {
    canvas, globalAlpha: 1, save: () => kept.push(now), restore: () => (now = kept.pop() ?? now), scale: (x, y) => times([x, 0, 0, y, 0, 0]), translate: (x, y) => times([1, 0, 0, 1, x, y]), rotate: (by) => times([Math.cos(by), Math.sin(by), -Math.sin(by), Math.cos(by), 0, 0]),
    transform: (...by) => times(by), setTransform: (...to) => (now = to.length > 1 ? to : Object.values(to[0])), resetTransform: () => (now = [1, 0, 0, 1, 0, 0]), getTransform: () => ({ a: now[0], b: now[1], c: now[2], d: now[3], e: now[4], f: now[5] }), measureText: (text) => ({ width: 6 * String(text).length }),
    createImageData: (width, height) => ({ data: new Uint8ClampedArray(4 * width * height) }), getImageData: (_x, _y, width, height) => ({ data: new Uint8ClampedArray(4 * width * height) }),
  };
  for (const kind of ["createLinearGradient", "createRadialGradient", "createPattern"]) done[kind] = () => new Path2D("shade");
  return new Proxy(done, {
    get: (_, name) => (name in done && typeof done[name] !== "function" ? done[name] : (...given) => (note(String(name), given), (done[name] ?? nothing)(...given))),
    set: (_, name, value) => (note(name, [value]), (done[name] = value), true),
  });
}
class Path2D {
  constructor(kind = "path") { return new Proxy(this, { get: (of, name) => (name === "constructor" ? Path2D : (...given) => note(`${kind}.${String(name)}`, given)) }); }
}
class OffscreenCanvas {
  constructor(width, height) { Object.assign(this, { width, height }); }
  getContext() { return (this.made ??= context(this)); }
  async convertToBlob() { return new Blob(["picture"]); }
  transferToImageBitmap() { return this; }
}
/** The nodes of a sound: `sounded` has how many contexts were made, whether they sound, and how loud what lasts is. */
export const sounded = {};
let lasting = 0;
class Loudness {
  setTargetAtTime(value) { sounded[`hum ${this.number ??= (lasting += 1)}`] = String(value); }
  setValueAtTime() {} linearRampToValueAtTime() {} exponentialRampToValueAtTime() {} cancelScheduledValues() {}
}
const sounding = (kind) => class Sounding {
  constructor() {
    if (kind === "AudioContext") sounded.contexts = String(Number(sounded.contexts ?? 0) + 1);
    const act = (name) => (name === "connect" ? (to) => to : name === "resume" || name === "suspend" ? () => void (sounded.sound = name) : () => undefined);
    return new Proxy(this, { get: (_, name) => (/^(connect|start|stop|resume|suspend)$/.test(String(name)) ? act(name) : name === "currentTime" ? now / 1000 : name === "sampleRate" ? 8000 : name === "getChannelData" ? () => new Float32Array(8000) : /^(then|constructor)$/.test(String(name)) ? undefined : new Loudness()) });
  }
};

// Time and chance

let now = 0, count = 0, chance = 1;
const due = new Map();
const later = (act, after = 0, ...given) => (due.set((count += 1), { at: now + Math.max(0, Number(after) || 0), act: () => act(...given), count }), count);
const turn = globalThis.setImmediate;
let reading = 0; // what the machine below reads or packs, in its own time
const counted = ({ arrayBuffer }) => function read() { reading += 1; return arrayBuffer.call(this).finally(() => (reading -= 1)); };
for (const { prototype } of [Blob, Response]) prototype.arrayBuffer = counted(prototype);
export const settle = async () => { for (let times = 0; times < 3; times = reading ? 0 : times + 1) await new Promise((done) => turn(done)); };
/** Let so many milliseconds pass, and do what is due in them. */
export async function pass(milliseconds) {
  const end = now + milliseconds;
  await settle();
  for (;;) {
    const next = [...due.values()].filter(({ at }) => at <= end).sort((a, b) => a.at - b.at || a.count - b.count)[0];
    if (!next) break;
    now = Math.max(now, next.at);
    due.delete(next.count);
    try {
      next.act();
    } catch (error) {
      complaints.push(error);
    }
    await settle();
  }
  now = Math.max(now, end);
}

// What else a page finds

export const saved = []; // files that were given: [name, address]
export const copied = []; // what was put on the clipboard
const blobs = new Map();
class Storage {
  getItem(name) { return Object.hasOwn(this, name) ? this[name] : null; }
  setItem(name, text) { this[name] = String(text); }
  removeItem(name) { delete this[name]; }
}
class Observer {
  static all = [];
  targets = [];
  constructor(act) { this.act = act; Observer.all.push(this); }
  see(targets = this.targets) { later(() => targets.forEach((target) => this.act([{ target, contentRect: area(0, 0, WIDE, HIGH), isIntersecting: true }]))); }
  observe(target) { this.targets.push(target); this.see([target]); }
}

class Document extends Node {
  title = "";
  hidden = false;
  focused = null;
  scrolled = null;
  get activeElement() { return this.focused?.isConnected ? this.focused : this.body; }
  get body() { return this.querySelector("body"); }
  get head() { return this.querySelector("head"); }
  get documentElement() { return this.firstElementChild; }
  #found = new Map();
  getElementById(id) {
    const kept = this.#found.get(id);
    if (kept?.isConnected && kept.id === id) return kept;
    for (const each of this.all()) if (each.id === id) { this.#found.set(id, each); return each; }
    return null;
  }
  createElement(name) { return new Element(name.toLowerCase()); }
  createElementNS(_, name) { return new Element(name); }
  createTextNode(text) { return new Text(text); }
}
const document = new Document();

/** Open a page of that HTML at an address, with what its browser and its tab have kept. `work`: what its Worker answers by. */
export function open(source, address, { kept = {}, own = {}, reduced = false, state = null, work = null } = {}) {
  parse(source, document);
  let here = new URL(address);
  const history = [here.href];
  const go = (href, pushes) => { here = new URL(href, here); if (pushes) history.push(here.href); else history[history.length - 1] = here.href; };
  const location = {
    get href() { return here.href; }, get hash() { return here.hash; }, get search() { return here.search; }, get protocol() { return here.protocol; }, get pathname() { return here.pathname; },
    set hash(hash) {
      const before = here.hash;
      globalThis.history.state = null;
      go(hash.startsWith("#") ? hash : `#${hash}`, true);
      if (before !== here.hash) later(() => view.dispatchEvent(new Event("hashchange")));
    },
    reload: () => (location.reloaded = true),
  };
  const unpacked = async (packed) => inflateRawSync(Buffer.from(packed, "base64")).toString();
  const record = async (id) => JSON.parse(await unpacked(document.getElementById(id).textContent));
  const media = (query) => ({ matches: reduced && query.includes("reduced-motion"), addEventListener() {} });
  class Worker {
    postMessage(message) {
      const given = structuredClone(message);
      later(() => {
        globalThis.postMessage = (answer) => this.onmessage?.({ data: structuredClone(answer) });
        if (!this.ended) work({ data: given });
      });
    }
    terminate() { this.ended = true; }
  }
  URL.createObjectURL = (blob) => { const url = `blob:${blobs.size}`; blobs.set(url, blob); return url; };
  URL.revokeObjectURL = (url) => blobs.delete(url);
  Math.random = () => (chance = (chance * 16807) % 2147483647) / 2147483647;
  const navigator = { clipboard: { writeText: async (text) => void copied.push(text) }, userAgent: "small" };
  Object.defineProperty(globalThis, "navigator", { value: navigator, configurable: true });
  Object.defineProperty(globalThis, "performance", { value: { now: () => (now += 0.02) }, configurable: true });
  class Option extends Element {
    constructor(text = "", value = undefined, chosen = false) {
      super("option");
      this.append(text);
      this.toggleAttribute("selected", chosen);
      if (value !== undefined) this.setAttribute("value", value);
    }
  }
  Object.assign(globalThis, {
    window: globalThis, document, location, Event, CustomEvent: Event, KeyboardEvent: Event, HTMLElement: Element, Storage, Option, Worker, OffscreenCanvas, Path2D,
    ResizeObserver: Observer, IntersectionObserver: Observer, MutationObserver: Observer, CSS: { escape: (text) => String(text).replace(/[^\w-]/g, "\\$&"), supports: () => true },
    history: { state, pushState(made, _, href) { this.state = made; go(href, true); }, replaceState(made, _, href) { this.state = made; go(href, false); }, entries: history },
    localStorage: Object.assign(new Storage(), kept), sessionStorage: Object.assign(new Storage(), own), matchMedia: media, getComputedStyle: (each) => ({ getPropertyValue: () => "", color: each.parentElement?.className }), getSelection: () => "", innerWidth: WIDE, innerHeight: HIGH, devicePixelRatio: 1,
    setTimeout: later, clearTimeout: (number) => due.delete(number), requestAnimationFrame: (act) => later(() => act(now), 1), cancelAnimationFrame: (number) => due.delete(number), requestIdleCallback: (act) => later(act),
    addEventListener: (...given) => view.addEventListener(...given), removeEventListener: (...given) => view.removeEventListener(...given), dispatchEvent: (event) => view.dispatchEvent(event),
    pack: { record: record("record"), early: () => [], more: async () => record("more"), unpacked },
    ...Object.fromEntries("AudioContext AudioBuffer AudioBufferSourceNode BiquadFilterNode DynamicsCompressorNode GainNode OscillatorNode".split(" ").map((kind) => [kind, sounding(kind)])),
  });
  Map.groupBy ??= (all, of) => [...all].reduce((found, each) => found.set(of(each), [...(found.get(of(each)) ?? []), each]), new Map()); // Node.js 20 has none
  document.title = document.querySelector("title")?.textContent ?? "";
}
/** What a file that was given holds. */
export const contents = async (url) => new Uint8Array(await blobs.get(url).arrayBuffer());
