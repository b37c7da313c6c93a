// What Python has and JavaScript has not, as far as the translated modules need it.
//
// A str is a string, a list or tuple an Array, a bytearray an Array of its own class, bytes a Uint8Array, an
// array("H") a Uint16Array, a number a number. Python's methods are put beside JavaScript's own, under Python's names;
// where both have one that means something else, Python's ends in _ (pop_, replace_, split_).

// @ts-nocheck: what it takes has any of Python's types

export class Exception extends Error {
  constructor(...args) {
    super();
    this.__init__(...args);
  }
  get message() { return this.__str__(); }
  __init__(...args) { this.args = args; }
  __str__() { return this.args.map(str).join(", "); }
  toString() { return this.__str__(); }
}
export class ValueError extends Exception {}
export class IndexError extends Exception {}
export class KeyError extends Exception {
  __str__() { return repr(this.args[0]); }
}
export class ArithmeticError extends Exception {}
export class ZeroDivisionError extends ArithmeticError {}
export class NotImplementedError extends Exception {}
export class RecursionError extends Exception {}
export const BaseException = Error;

/** What was thrown, as Python has it. */
export const raised = (e) => (e instanceof RangeError && /call stack/.test(e.message) ? new RecursionError(e.message) : e);

// Classes.

export class Instance {
  constructor(...args) { this.__init__(...args); }
  __init__() {}
}
/** What its fields are. */
export class Record {
  __post_init__() {}
}
export class NamedTuple extends Record {
  *[Symbol.iterator]() {
    for (const name of this.constructor.$fields) yield this[name];
  }
}
export class StrEnum {
  static [Symbol.iterator]() { return Object.values(this).values(); }
}
export const IntEnum = StrEnum;
/** The same record but for some fields. */
export const replaced = (of, fields) => new of.constructor(...of.constructor.$fields.map((name) => fields[name] ?? of[name]));
/** Keep the value of a cached property. */
export const kept = (of, name, value) => Object.defineProperty(of, name, { value })[name];

// Text and sequences.

const give = (kind, methods) => {
  for (const [name, value] of Object.entries(methods)) {
    Object.defineProperty(kind.prototype, name, { value, writable: true, configurable: true });
  }
};
const PIECE = 8192; // as many arguments are few enough
const latin = (of) =>
  of.length > PIECE ? latin(of.slice(0, PIECE)) + latin(of.slice(PIECE)) : String.fromCharCode.apply(null, of);

export class Bytes extends Uint8Array {
  join(of) {
    const parts = [...of].flatMap((each, at) => (at && this.length ? [this, each] : [each]));
    const made = new Bytes(sum(map(len, parts)));
    parts.reduce((at, each) => (made.set(each, at), at + each.length), 0);
    return made;
  }
  translate(table, gone = []) {
    const made = new Bytes(this.length), drop = new Bytes(256);
    for (const each of gone) drop[each] = 1;
    let count = 0;
    for (const each of this) if (!drop[each]) made[count++] = table === null ? each : table[each];
    return made.slice(0, count);
  }
  decode(coding = "utf-8") {
    try {
      if (coding !== "ascii" || this.isascii()) return new TextDecoder(coding, { fatal: true, ignoreBOM: true }).decode(this);
    } catch { /* as if it was not ASCII */ }
    throw new ValueError(coding);
  }
}
export class ByteArray extends Array {}
export class Words extends Uint16Array {
  tobytes() { return new Bytes(this.slice().buffer); }
}
/** Strip what is in `chars` (null: a text's white space) from the left or right end, or both. */
const strip = (left, right) => function (chars = null) {
  const out = (each) => (chars === null && typeof each === "string" ? /\s/.test(each) : chars.includes(each));
  let [start, end] = [0, this.length];
  while (left && start < end && out(this[start])) start++;
  while (right && end > start && out(this[end - 1])) end--;
  return this.slice(start, end);
};
for (const kind of [String, Bytes]) give(kind, { strip: strip(true, true), lstrip: strip(true, false), rstrip: strip(false, true) });
/** What bytes do as a text of characters to 0377; a number is one of them. */
for (const name of ["startswith", "endswith", "isdigit", "isascii", "find", "rfind", "count"]) {
  const as_text = (what) => (typeof what === "number" ? chr(what) : what && latin(what));
  give(Bytes, { [name](what, ...from) { return latin(this)[name](as_text(what), ...from); } });
}
const matching = (pattern) => function () { return pattern.test(this); };

give(String, {
  join(of) { return Array.prototype.join.call([...of], this); },
  split_(by) { return by === undefined ? this.split(/\s+/).filter(Boolean) : this.split(by); },
  splitlines(keep = false) {
    const lines = this.match(/[^\r\n]*(?:\r\n|\r|\n)|[^\r\n]+$/g) ?? [];
    return keep ? lines : lines.map((line) => line.replace(/\r?\n$|\r$/, ""));
  },
  partition(by) {
    const at = this.indexOf(by);
    return at < 0 ? [this.valueOf(), "", ""] : [this.slice(0, at), by, this.slice(at + by.length)];
  },
  replace_(from, to) { return this.replaceAll(from, () => to); },
  find: String.prototype.indexOf,
  rfind: String.prototype.lastIndexOf,
  count(what, from, to) { return this.slice(from, to).split(what).length - 1; },
  startswith(what, from = 0) { return [what].flat().some((each) => this.startsWith(each, from)); },
  endswith(what) { return [what].flat().some((each) => this.endsWith(each)); },
  upper: String.prototype.toUpperCase,
  lower: String.prototype.toLowerCase,
  ljust: String.prototype.padEnd,
  rjust: String.prototype.padStart,
  removesuffix(what) { return this.endsWith(what) ? this.slice(0, this.length - what.length) : this.valueOf(); },
  removeprefix(what) { return this.startsWith(what) ? this.slice(what.length) : this.valueOf(); },
  expandtabs(width = 8) {
    return this.split("\t").reduce((text, part) => text.padEnd((Math.floor(text.length / width) + 1) * width) + part);
  },
  translate(table) {
    const to = (each) => table.get(ord(each), each);
    return Array.from(this, (each) => (typeof to(each) === "number" ? chr(to(each)) : to(each) ?? "")).join("");
  },
  encode(coding = "utf-8", errors = "strict") {
    if (coding === "utf-8") return Bytes.from(new TextEncoder().encode(this));
    const most = coding === "ascii" ? 127 : 255;
    const made = new Bytes(this.length);
    let fits = true;
    for (let at = 0; at < made.length; at++) fits = (made[at] = this.charCodeAt(at)) <= most && fits;
    if (fits) return made;
    const codes = Array.from(this, ord);
    if (errors === "strict" && codes.some((code) => code > most)) throw new ValueError(coding);
    return Bytes.from(codes, (code) => (code > most ? 63 : code));
  },
  isascii: matching(/^[\x00-\x7f]*$/),
  isdigit: matching(/^\d+$/),
  isdecimal: matching(/^\d+$/),
  isalpha: matching(/^\p{L}+$/u),
  isalnum: matching(/^[\p{L}\d]+$/u),
  isprintable: matching(/^(?: |[^\p{C}\p{Z}])*$/u),
  isspace: matching(/^\s+$/),
});
give(Array, {
  append(item) { this.push(item); },
  insert(at, item) { this.splice(at, 0, item); },
  extend(of) {
    for (const each of of) this.push(each);
  },
  pop_(at = -1) {
    if (!this.length) throw new IndexError("pop from an empty list");
    return at === -1 ? this.pop() : this.splice(at, 1)[0];
  },
  index(item, from = 0) {
    for (let at = from; at < this.length; at++) if (eq(this[at], item)) return at;
    throw new ValueError(`${repr(item)} is not in list`);
  },
  count(item) { return this.reduce((count, each) => count + eq(each, item), 0); },
  clear() { this.length = 0; },
});
give(Number, {
  bit_length() { return this.valueOf() === 0 ? 0 : this.toString(2).length; },
  bit_count() { return this.toString(2).count("1"); },
});

// Dicts and sets: a key is a number, a text, None or an object that is no other; a tuple is none.

const key = (of) => {
  if (typeof of === "object" && (sequence(of) || of instanceof Record)) throw new TypeError(`${repr(of)} as a key`);
  return of;
};
export class Dict extends Map {
  get length() { return this.size; }
  [Symbol.iterator]() { return super.keys(); }
  get(k, otherwise = null) { return this.has(k) ? super.get(k) : otherwise; }
  at(k) {
    const value = super.get(k);
    if (value === undefined) throw new KeyError(k);
    return value;
  }
  set(k, value) { return super.set(key(k), value); }
  keys() { return set(this); }
  values() { return [...super.values()]; }
  items() { return [...super.entries()]; }
  setdefault(k, value) {
    if (!this.has(k)) this.set(k, value);
    return super.get(k);
  }
  update(of) {
    for (const [k, value] of of.items()) this.set(k, value);
  }
  pop_(k, otherwise) {
    const value = otherwise === undefined ? this.at(k) : this.get(k, otherwise);
    this.delete(k);
    return value;
  }
}
export class PySet extends Set {
  get length() { return this.size; }
  add(item) { return super.add(key(item)); }
  discard(item) { this.delete(item); }
  update(of) {
    for (const each of of) this.add(each);
  }
}
export const dict = (of) => new Dict(of instanceof Dict ? of.items() : of);
dict.fromkeys = (of, value = null) => dict(Array.from(of, (each) => [each, value]));
export const set = (of) => new PySet(of);
export const frozenset = set;

// Operators, where the types are not known before.

const num = (of) => typeof of === "number" || typeof of === "boolean";
const sequence = (of) => Array.isArray(of) || ArrayBuffer.isView(of);
const like = (of, items) => (of instanceof Bytes ? bytes(items) : of instanceof ByteArray ? ByteArray.from(items) : items);
const HALF = 2 ** 32;
/** An operator on numbers to 2^53 and truths, which for sets and Dicts is `other`. */
const bitwise = (by, other) => (a, b) => {
  if ((a | 0) === a && (b | 0) === b) return by(a, b);
  if (typeof a === "object") return other(a, b);
  const made = by(Math.floor(a / HALF), Math.floor(b / HALF)) * HALF + (by(a, b) >>> 0);
  return typeof a === "boolean" && typeof b === "boolean" ? Boolean(made) : made;
};
export const and_ = bitwise((a, b) => a & b, (a, b) => set([...a].filter((each) => b.has(each))));
export const or_ = bitwise((a, b) => a | b, (a, b) => (a instanceof Dict ? dict([...a.items(), ...b.items()]) : set([...a, ...b])));
export const xor = bitwise((a, b) => a ^ b);

export const add = (a, b) => {
  if ((num(a) && (num(b) || b instanceof Rational)) || typeof a === "string") return a + b;
  if (a.__add__) return a.__add__(b);
  return a instanceof Bytes ? EMPTY.join([a, b]) : like(a, [...a, ...b]);
};
export const sub = (a, b) => (a.__sub__ ? a.__sub__(b) : a instanceof PySet ? set([...a].filter((each) => !has(b, each))) : a - b);
export const mul = (a, b) => {
  if (num(a) && (num(b) || b instanceof Rational)) return a * b;
  if (a.__mul__) return a.__mul__(b);
  const [of, times] = num(a) ? [b, Math.max(0, a)] : [a, Math.max(0, b)];
  if (typeof of === "string") return of.repeat(times);
  return like(of, Array.from({ length: of.length * times }, (_, at) => of[at % of.length]));
};
const divisor = (b) => {
  if (b === 0) throw new ZeroDivisionError("division by zero");
  return b;
};
export const div = (a, b) => (a.__truediv__ ? a.__truediv__(b) : a / divisor(b));
export const pow = (a, b) => (a.__pow__ ? a.__pow__(b) : a ** b);
export const mod = (a, b) => {
  const rest = a % divisor(b);
  return rest !== 0 && rest < 0 !== b < 0 ? rest + b : rest;
};
export const floordiv = (a, b) => (a - mod(a, b)) / b;
export const divmod = (a, b) => [floordiv(a, b), mod(a, b)];
export const shl = (a, b) => (typeof a === "bigint" ? a << BigInt(b) : a * 2 ** b);
export const shr = (a, b) => Math.floor(a / 2 ** b);
/** a += b, a |= b: a list, a set and a Dict grow, for anything else it is `by`. */
export const grown = (a, b, by) => {
  if (Array.isArray(a)) a.extend(b);
  else if (a.update) a.update(b);
  else return by(a, b);
  return a;
};
export const eq = (a, b) => {
  if (a === b) return true;
  if (num(a) && num(b)) return +a === +b;
  if (a?.__eq__) return a.__eq__(b);
  if (typeof a !== "object" || typeof b !== "object" || a === null || b === null) return false;
  if (a instanceof Dict || a instanceof PySet) {
    return a.constructor === b.constructor && a.length === b.length && [...a].every((k) => b.has(k) && eq(a.get?.(k), b.get?.(k)));
  }
  if (a instanceof Record && !(a instanceof NamedTuple)) {
    return a.constructor === b.constructor && a.constructor.$fields.every((name) => eq(a[name], b[name]));
  }
  if (!a[Symbol.iterator] || !b[Symbol.iterator]) return false;
  const [one, other] = [a, b].map((of) => (sequence(of) ? of : [...of]));
  return one.length === other.length && one.every((each, at) => eq(each, other[at]));
};
export const lt = (a, b) => {
  if (a instanceof Rational || b instanceof Rational) return rational(a).__sub__(b).numerator < 0n;
  if (typeof a !== "object") return a < b;
  const [one, other] = [[...a], [...b]];
  const at = one.findIndex((each, index) => index >= other.length || !eq(each, other[index]));
  return at < 0 ? one.length < other.length : at < other.length && lt(one[at], other[at]);
};
export const gt = (a, b) => lt(b, a);
export const le = (a, b) => lt(a, b) || eq(a, b);
export const ge = (a, b) => le(b, a);
export const truth = (of) => (typeof of === "object" && of !== null ? of.length === undefined || of.length > 0 : Boolean(of));
export const has = (all, item) => {
  if (typeof all === "string") return all.includes(item);
  if (all.has) return all.has(item);
  if (all instanceof Bytes && typeof item === "object") return all.find(item) >= 0;
  for (const each of all) if (eq(each, item)) return true;
  return false;
};
export const at = (of, index) => {
  if (of.__getitem__) return of.__getitem__(index);
  if (of instanceof Dict) return of.at(index);
  const item = (of instanceof NamedTuple ? [...of] : of).at(+index);
  if (item === undefined) throw new IndexError("index out of range");
  return item;
};
export const put = (of, index, value) => {
  if (of.__setitem__) of.__setitem__(index, value);
  else if (of instanceof Dict) of.set(index, value);
  else if (index < -of.length || index >= of.length) throw new IndexError("assignment index out of range");
  else of[index < 0 ? index + of.length : index] = value;
};

// Text.

/** A float, where that is to be seen though it may be whole. */
class Floating extends Number {
  toString() {
    const of = this.valueOf();
    if (!Number.isFinite(of)) return Number.isNaN(of) ? "nan" : of < 0 ? "-inf" : "inf";
    if (of !== 0 && !(Math.abs(of) >= 1e-4 && Math.abs(of) < 1e16)) return exponent(of.toExponential());
    return Number.isInteger(of) ? `${Object.is(of, -0) ? "-" : ""}${of}.0` : String(of);
  }
}
/** 1e-7 as 1e-07. */
const exponent = (text) => text.replace(/([+-])(\d)$/, "$10$2");
export const floating = (of) => new Floating(of);
const digits = (of) => (Number.isInteger(of) ? String(BigInt(of)) : String(new Floating(of)));
const CONTROLS = { "\n": "\\n", "\r": "\\r", "\t": "\\t", "\\": "\\\\" };
const escaped = (c) => CONTROLS[c] ?? `\\x${c.charCodeAt(0).toString(16).padStart(2, "0")}`;
export const str = (of) => (typeof of === "string" ? of : of?.__str__ ? of.__str__() : repr(of));
export const repr = (of) => {
  if (of === null) return "None";
  if (typeof of === "boolean") return of ? "True" : "False";
  if (typeof of === "number") return digits(of);
  if (typeof of === "string") {
    const quote = of.includes("'") && !of.includes('"') ? '"' : "'";
    return quote + of.replace(/[\\\x00-\x1f\x7f-\xa0]/g, escaped).replaceAll(quote, `\\${quote}`) + quote;
  }
  if (of instanceof Record) return `${of.constructor.name}(${of.constructor.$fields.map((name) => `${name}=${repr(of[name])}`).join(", ")})`;
  if (of instanceof Dict) return `{${of.items().map(([k, value]) => `${repr(k)}: ${repr(value)}`).join(", ")}}`;
  return Array.isArray(of) ? `[${of.map(repr).join(", ")}]` : String(of);
};
/** A number to so many places, half to even as CPython does it: what JavaScript rounds is exact but for ties. */
const fixed = (of, places) => {
  const made = of.toFixed(places);
  if (of >= 1e15) return made;
  const exact = of.toFixed(places + 25);
  const below = exact.slice(0, -25).replace(/\.$/, "");
  return /50{24}$/.test(exact) && below.at(-1) % 2 === 0 ? below : made;
};
const general = (of, places) => {
  const [mantissa, power] = of.toExponential(places - 1).split("e");
  const short = (text) => (text.includes(".") ? text.replace(/\.?0+$/, "") : text);
  if (of !== 0 && (power < -4 || power >= places)) return exponent(`${short(mantissa)}e${power}`);
  return short(fixed(of, Math.max(0, places - 1 - power)));
};
const SPEC = /^([+])?(0)?(\d+)?(,)?(?:\.(\d+))?([oxfg])?$/;
/** A number stands at the right of its width, a text at the left. */
export const format = (of, spec) => {
  const [, plus, zero, width = 0, comma, places = 6, kind] = SPEC.exec(spec);
  if (typeof of !== "number" && !(of instanceof Number)) return str(of).padEnd(width);
  const size = Math.abs(of), float = of instanceof Number || kind === "f" || kind === "g"; // a whole number has no -0
  const sign = of < 0 || (float && Object.is(+of, -0)) ? "-" : plus ?? "";
  let body = float ? String(new Floating(size)) : digits(size);
  if (kind === "o" || kind === "x") body = size.toString(kind === "o" ? 8 : 16);
  else if (kind === "f") body = fixed(size, +places);
  else if (kind === "g") body = general(size, +places);
  if (comma) body = body.replace(/^\d+/, (whole) => whole.replace(/\B(?=(\d{3})+$)/g, ","));
  return zero ? sign + body.padStart(width - sign.length, "0") : (sign + body).padStart(width);
};

// Python's own functions.

export const len = (of) => of.length;
export const bool = (of) => truth(of);
export const type = (of) => of.constructor;
Object.defineProperty(Function.prototype, "__name__", { get() { return this.name; } });
export const chr = (code) => String.fromCodePoint(code);
export const ord = (of) => of.codePointAt(0);
export const iter = (of) => of[Symbol.iterator]();
export const next = (of, otherwise) => {
  const { value, done } = (of.next ? of : iter(of)).next();
  if (done && otherwise === undefined) throw new Exception("nothing follows");
  return done ? otherwise : value;
};
export const list = (of = []) => [...of];
export const tuple = list;
/** @type {(of?: any) => Bytes} */
export const bytes = (of = []) => (of instanceof Bytes ? of : new Bytes(of));
const EMPTY = new Bytes(0);
export const bytearray = (of = []) => ByteArray.from(of);
export const array = (_, of) => (of instanceof Uint8Array ? new Words(of.slice().buffer) : Words.from(of));
export const int = (of, base = 10) => {
  if (num(of.valueOf())) return Math.trunc(+of);
  const text = (typeof of === "string" ? of : latin(of)).trim();
  if (!(base === 8 ? /^[-+]?[0-7]+$/ : /^[-+]?\d+$/).test(text)) throw new ValueError(`invalid literal for int() with base ${base}: ${repr(of)}`);
  return parseInt(text, base);
};
export const float = (of) => {
  const made = Number(typeof of === "string" ? of.trim() || NaN : of);
  if (Number.isNaN(made) && typeof of === "string") throw new ValueError(`could not convert string to float: ${repr(of)}`);
  return made;
};
const KINDS = new Map([
  [str, (of) => typeof of === "string"], [bool, (of) => typeof of === "boolean"],
  [int, (of) => Number.isInteger(of) || typeof of === "boolean"], [list, (of) => of?.constructor === Array],
  [bytes, (of) => of instanceof Bytes], [bytearray, (of) => of instanceof ByteArray], [dict, (of) => of instanceof Dict],
]);
export const isinstance = (of, kind) => {
  if (Array.isArray(kind)) return kind.some((each) => isinstance(of, each));
  return KINDS.has(kind) ? KINDS.get(kind)(of) : of instanceof kind;
};
export const getattr = (of, name) => {
  const value = of[name];
  return typeof value === "function" ? value.bind(of) : value;
};
export class slice {} // nothing is one: a translated slice calls the method of this name
export const setattr = (of, name, value) => { of[name] = value; };
export const range = (a, b, step = 1) => {
  const [start, stop] = b === undefined ? [0, a] : [a, b];
  const made = Array.from({ length: Math.max(0, Math.ceil((stop - start) / step)) }, (_, at) => start + at * step);
  return Object.assign(made, { start, stop });
};
const best = (wins) => (of) => [...of].reduce((most, each) => (wins(each, most) ? each : most));
export const min = best(lt);
export const max = best(gt);
export const sum = (of, start = 0) => {
  for (const each of of) start = add(start, each);
  return start;
};
export const any = (of) => of.some(truth);
export const all = (of) => of.every(truth);
export const sorted = (of, by = (each) => each, reverse = false) => {
  const keyed = Array.from(of, (each) => [by(each), each]);
  keyed.sort(([a], [b]) => (lt(a, b) ? -1 : lt(b, a) ? 1 : 0) * (reverse ? -1 : 1));
  return keyed.map(([, each]) => each);
};
export const reversed = (of) => [...of].reverse();
export const enumerate = function* (of, start = 0) {
  for (const each of of) yield [start++, each];
};
export const zip = (...of) => {
  const [first, ...others] = of.map(list);
  return first.slice(0, Math.min(...others.map(len))).map((each, at) => [each, ...others.map((other) => other[at])]);
};
export const map = (f, of) => Array.from(of, (each) => f(each));
export const round = (of, places = null) => {
  if (places !== null) return Number(format(of, `.${places}f`));
  const whole = Math.floor(of), rest = of - whole;
  return rest < 0.5 || (rest === 0.5 && whole % 2 === 0) ? whole : whole + 1;
};

// The standard library.

export const { abs, acos, asin, atan, atan2, ceil, cos, cosh, exp, floor, log, sin, sinh, sqrt, tan, tanh } = Math;
export const pairwise = (of) => zip(of, list(of).slice(1));
export const bisect_left = (of, value, low = 0, high = of.length, by = (each) => each) => {
  while (low < high) {
    const middle = (low + high) >> 1;
    if (lt(by(at(of, middle)), value)) low = middle + 1;
    else high = middle;
  }
  return low;
};
export const monotonic = () => performance.now() / 1000;
export const radians = (degrees) => degrees * (Math.PI / 180);
export const degrees = (radians) => radians * (180 / Math.PI);
export const isfinite = Number.isFinite;
export const copysign = (a, b) => (b < 0 || Object.is(b, -0) ? -1 : 1) * Math.abs(a);
export const json = {
  dumps(of, indent, pad = indent ? "\n" : "") {
    const deep = pad && pad + " ".repeat(indent);
    const all_ = (parts, [open, close]) => (parts.length ? open + deep + parts.join(pad ? `,${deep}` : ", ") + pad + close : open + close);
    if (of instanceof Dict) return all_(of.items().map(([k, value]) => `${JSON.stringify(k)}: ${json.dumps(value, indent, deep)}`), "{}");
    if (Array.isArray(of)) return all_(of.map((each) => json.dumps(each, indent, deep)), "[]");
    if (typeof of === "number" || of instanceof Number) return str(of);
    return JSON.stringify(of).replace(/[\x7f-\uffff]/g, (c) => `\\u${c.charCodeAt(0).toString(16).padStart(4, "0")}`);
  },
  loads(text) {
    const tokens = /"(?:[^"\\]|\\.)*"|-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?/g;
    const marked = text.replace(tokens, (token) => (/^[^"]*[.eE]/.test(token) ? `{"$float":"${token}"}` : token));
    const read = (of) => ("$float" in of ? new Floating(of.$float) : dict(Object.entries(of)));
    try {
      return JSON.parse(marked, (_, of) => (of?.constructor === Object ? read(of) : of));
    } catch (error) {
      throw new ValueError(error.message);
    }
  },
};
const ENTITIES = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#x27;" };
export const escape = (text) => text.replace(/[&<>"']/g, (c) => ENTITIES[c]);

/** The whole root of a whole number, a BigInt, by Newton's steps from just above. */
export const isqrt = (of) => {
  const square = BigInt(of);
  let root, nearer = BigInt(Math.ceil(Math.sqrt(Number(square)) * (1 + 2 ** -50)));
  do {
    root = nearer;
    nearer = (root + square / (root || 1n)) >> 1n;
  } while (nearer < root);
  return root;
};
const gcd = (a, b) => (b ? gcd(b, a % b) : a);
/** An exact quotient, in lowest terms. At the left of it a number is a float, at its right a whole one. */
class Rational {
  constructor(over, under) {
    const common = gcd(over, under), by = common < 0n === under < 0n ? common : -common;
    this.numerator = over / by;
    this.denominator = under / by;
  }
  __add__(of, sign = 1n) {
    const { numerator, denominator } = rational(of);
    return new Rational(this.numerator * denominator + sign * numerator * this.denominator, this.denominator * denominator);
  }
  __sub__(of) { return this.__add__(of, -1n); }
  __mul__(of) {
    const { numerator, denominator } = rational(of);
    return new Rational(this.numerator * numerator, this.denominator * denominator);
  }
  __truediv__(of) { return this.__mul__(new Rational(rational(of).denominator, rational(of).numerator)); }
  __pow__(of) { return new Rational(this.numerator ** BigInt(of), this.denominator ** BigInt(of)); }
  __eq__(of) { return this.__sub__(of).numerator === 0n; }
  /** The nearest float: of 128 bits after the point the last says whether there are more. */
  valueOf() {
    const long = this.numerator << 128n;
    return Number(long / this.denominator | (long % this.denominator ? 1n : 0n)) / 2 ** 128;
  }
}
const rational = (of) => (of instanceof Rational ? of : Fraction(of));
export const Fraction = (of, under = 1) => {
  if (typeof of !== "string") return new Rational(BigInt(of), BigInt(under));
  const [figures, power = 0] = of.split("e");
  const [whole, part = ""] = figures.split(".");
  const places = BigInt(power) - BigInt(part.length);
  return new Rational(BigInt(whole + part) * 10n ** (places > 0n ? places : 0n), 10n ** (places < 0n ? -places : 0n));
};
class Pattern extends RegExp {
  findall(text) { return Array.from(text.matchAll(this), (found) => (found.length > 2 ? found.slice(1) : found.at(-1) ?? "")); }
  finditer(text) { return Array.from(text.matchAll(this), ({ 0: { length }, index }) => ({ start: () => index, end: () => index + length })); }
  split_(text) { return text.split(this); }
}
export const re = { compile: (source) => new Pattern(source, "gu") };
