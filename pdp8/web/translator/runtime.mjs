// What Python has and JavaScript has not, as far as the translated modules need it.
//
// A str is a string, a list or tuple an Array, a bytearray an Array of its own class, bytes a Uint8Array, an
// array("H") a Uint16Array, a number a number. Python's methods are put beside JavaScript's own, under Python's names;
// where both have one that means something else, Python's ends in _ (pop_, replace_, sort_, split_).

// @ts-nocheck: what it takes has any of Python's types

const NUMBER = "number";

export class Exception extends Error {
  constructor(...args) {
    super();
    this.__init__(...args);
    Object.defineProperty(this, "message", { get: () => str(this) });
  }
  __init__(...args) {
    this.args = args;
  }
  __str__() {
    return this.args.map(str).join(", ");
  }
  toString() {
    return this.__str__();
  }
}
export class ValueError extends Exception {}
export class LookupError extends Exception {}
export class KeyError extends LookupError {
  __str__() {
    return repr(this.args[0]);
  }
}
export class IndexError extends LookupError {}
export class TypeError extends Exception {}
export class OSError extends Exception {}
export class RuntimeError extends Exception {}
export class NotImplementedError extends RuntimeError {}
export class RecursionError extends RuntimeError {}
export class ArithmeticError extends Exception {}
export class ZeroDivisionError extends ArithmeticError {}
export class OverflowError extends ArithmeticError {}
export class UnicodeError extends ValueError {}
export class UnicodeDecodeError extends UnicodeError {}
export class UnicodeEncodeError extends UnicodeError {}
export class StopIteration extends Exception {}
export const BaseException = Error;

/** What was thrown, as Python has it. */
export const raised = (e) => (e instanceof RangeError && /call stack/.test(e.message) ? new RecursionError(e.message) : e);

// Classes whose instances are what their fields are.

export class Record {
  _asdict() {
    return dict(this.constructor.$fields.map((name) => [name, this[name]]));
  }
}
export class NamedTuple extends Record {
  *[Symbol.iterator]() {
    for (const name of this.constructor.$fields) yield this[name];
  }
}
export class Enumeration {
  static *[Symbol.iterator]() {
    for (const name of Object.keys(this)) yield this[name];
  }
  static of(value) {
    if (![...this].includes(value)) throw new ValueError(`${repr(value)} is not a valid ${this.name}`);
    return value;
  }
}
/** The same record but for some fields. */
export const replaced = (of, fields) => new of.constructor(...of.constructor.$fields.map((name) => fields[name] ?? of[name]));
/** The arguments of a call whose keywords are in a Dict. */
export const spread = (args, places, given) => {
  for (const [name, value] of given.items()) args[places.indexOf(name)] = value;
  return args;
};
export const kept = (of, name, value) => {
  Object.defineProperty(of, name, { value, writable: true, configurable: true, enumerable: true });
  return value;
};

// Sequences of bytes and words.

const give = (kind, methods) => {
  for (const [name, value] of Object.entries(methods)) {
    Object.defineProperty(kind.prototype, name, { value, writable: true, configurable: true });
  }
};
const SPACE = [9, 10, 11, 12, 13, 32];
const latin = (of) => {
  let text = "";
  for (let at = 0; at < of.length; at += 8192) text += String.fromCharCode.apply(null, of.slice(at, at + 8192));
  return text;
};
const unlatin = (text) => Bytes.from(text, (c) => c.charCodeAt(0));
const found = (at) => {
  if (at < 0) throw new ValueError("not found");
  return at;
};

export class Bytes extends Uint8Array {
  find(what, from = 0) {
    return typeof what === NUMBER ? super.indexOf(what, from) : latin(this).indexOf(latin(what), from);
  }
  join(of) {
    const parts = [...of].flatMap((each, at) => (at && this.length ? [this, each] : [each]));
    const made = new Bytes(parts.reduce((length, each) => length + each.length, 0));
    let end = 0;
    for (const each of parts) {
      made.set(each, end);
      end += each.length;
    }
    return made;
  }
  translate(table, gone = []) {
    const made = new Bytes(this.length), drop = new Bytes(256);
    for (const each of gone) drop[each] = 1;
    let count = 0;
    for (let at = 0; at < this.length; at++) {
      if (!drop[this[at]]) made[count++] = table === null ? this[at] : table[this[at]];
    }
    return made.slice(0, count);
  }
  decode(coding = "utf-8") {
    if (coding === "latin-1") return latin(this);
    if (coding === "ascii") {
      if (!this.isascii()) throw new UnicodeDecodeError("ascii");
      return latin(this);
    }
    try {
      return new TextDecoder("utf-8", { fatal: true, ignoreBOM: coding !== "utf-8-sig" }).decode(this);
    } catch {
      throw new UnicodeDecodeError(coding);
    }
  }
}
export class ByteArray extends Array {}
export class Words extends Uint16Array {}

give(Bytes, {
  rfind(what) {
    return typeof what === NUMBER ? this.lastIndexOf(what) : latin(this).lastIndexOf(latin(what));
  },
  count(what) {
    return typeof what === NUMBER ? this.filter((each) => each === what).length : latin(this).count(latin(what));
  },
  isascii() {
    return this.every((each) => each < 128);
  },
  hex() {
    return [...this].map((each) => each.toString(16).padStart(2, "0")).join("");
  },
  tobytes() {
    return this;
  },
});
for (const name of ["startswith", "endswith", "isdigit"]) {
  give(Bytes, { [name](...args) { return latin(this)[name](...args.map(latin)); } });
}
for (const name of ["replace_", "ljust"]) {
  give(Bytes, { [name](...args) { return unlatin(latin(this)[name](...args.map((a) => (typeof a === NUMBER ? a : latin(a))))); } });
}
for (const name of ["split_", "partition"]) {
  give(Bytes, { [name](...args) { return latin(this)[name](...args.map(latin)).map(unlatin); } });
}
give(Bytes, {
  index(what, from) {
    return found(this.find(what, from));
  },
  rindex(what) {
    return found(this.rfind(what));
  },
});
give(Words, {
  tobytes() {
    return new Bytes(this.slice().buffer);
  },
  tolist() {
    return [...this];
  },
});

/** Strip what is in `chars` (null: white space) from the ends of a string or bytes. */
const strip = (of, chars, left, right) => {
  const text = typeof of === "string";
  const out = (each) => (chars === null ? (text ? /\s/.test(each) : SPACE.includes(each)) : chars.includes(each));
  let [start, end] = [0, of.length];
  while (left && start < end && out(of[start])) start++;
  while (right && end > start && out(of[end - 1])) end--;
  return of.slice(start, end);
};
for (const kind of [String, Bytes]) {
  give(kind, {
    strip(chars = null) {
      return strip(this.valueOf(), chars, true, true);
    },
    lstrip(chars = null) {
      return strip(this.valueOf(), chars, true, false);
    },
    rstrip(chars = null) {
      return strip(this.valueOf(), chars, false, true);
    },
  });
}
const matching = (pattern) => function () { return pattern.test(this); };

give(String, {
  join: function (of) {
    return [...of].join(this);
  },
  split_(by = null, most = -1) {
    if (by === null) return this.split(/\s+/).filter((each) => each);
    const parts = this.split(by);
    return most < 0 || parts.length <= most ? parts : [...parts.slice(0, most), parts.slice(most).join(by)];
  },
  splitlines(keep = false) {
    const lines = this.match(/[^\r\n]*(?:\r\n|\r|\n)|[^\r\n]+$/g) ?? [];
    return keep ? lines : lines.map((line) => line.replace(/\r?\n$|\r$/, ""));
  },
  partition(by) {
    const at = this.indexOf(by);
    return at < 0 ? [this.valueOf(), "", ""] : [this.slice(0, at), by, this.slice(at + by.length)];
  },
  replace_(from, to) {
    return this.replaceAll(from, () => to);
  },
  find(what, from) {
    return this.indexOf(what, from);
  },
  rfind(what, from = 0, to = this.length) {
    const at = this.slice(0, to).lastIndexOf(what);
    return at < from ? -1 : at;
  },
  index(what, from) {
    return found(this.indexOf(what, from));
  },
  count(what, from = 0, to = this.length) {
    return this.slice(from, to).split(what).length - 1;
  },
  startswith(what) {
    return Array.isArray(what) ? what.some((each) => this.startsWith(each)) : this.startsWith(what);
  },
  endswith(what) {
    return Array.isArray(what) ? what.some((each) => this.endsWith(each)) : this.endsWith(what);
  },
  upper: String.prototype.toUpperCase,
  lower: String.prototype.toLowerCase,
  ljust: String.prototype.padEnd,
  rjust: String.prototype.padStart,
  removesuffix(what) {
    return what && this.endsWith(what) ? this.slice(0, -what.length) : this.valueOf();
  },
  removeprefix(what) {
    return this.startsWith(what) ? this.slice(what.length) : this.valueOf();
  },
  expandtabs(width = 8) {
    let text = "";
    for (const each of this) text += each === "\t" ? " ".repeat(width - (text.length % width)) : each;
    return text;
  },
  translate(table) {
    let text = "";
    for (const each of this) {
      const to = table.get(each.codePointAt(0), each);
      text += to === null ? "" : typeof to === NUMBER ? chr(to) : to;
    }
    return text;
  },
  encode(coding = "utf-8", errors = "strict") {
    if (coding === "utf-8") return Bytes.from(new TextEncoder().encode(this));
    const most = coding === "ascii" ? 127 : 255, made = new Bytes(this.length);
    let count = 0;
    for (let at = 0; at < this.length; at++) {
      const code = this.codePointAt(at);
      if (code > most && errors === "strict") throw new UnicodeEncodeError(coding);
      if (code > 0xffff) at++;
      made[count++] = code > most ? 63 : code;
    }
    return count < made.length ? made.slice(0, count) : made;
  },
  isascii: matching(/^[\x00-\x7f]*$/),
  isdigit: matching(/^\d+$/),
  isdecimal: matching(/^\d+$/),
  isalpha: matching(/^\p{L}+$/u),
  isalnum: matching(/^[\p{L}\p{N}]+$/u),
  isspace: matching(/^\s+$/),
  isprintable: matching(/^[^\p{C}\p{Zl}\p{Zp}]*$/u),
  islower() {
    return this !== this.toUpperCase() && this.valueOf() === this.toLowerCase() && /\p{L}/u.test(this);
  },
});
give(Array, {
  append(item) {
    this.push(item);
  },
  extend(of) {
    for (const each of of) this.push(each);
  },
  insert(at, item) {
    this.splice(at, 0, item);
  },
  pop_(at = -1) {
    if (!this.length) throw new IndexError("pop from an empty list");
    return at === -1 ? this.pop() : at === 0 ? this.shift() : this.splice(at, 1)[0];
  },
  index(item, from = 0) {
    for (let at = from; at < this.length; at++) if (eq(this[at], item)) return at;
    throw new ValueError(`${repr(item)} is not in list`);
  },
  count(item) {
    let count = 0;
    for (const each of this) if (eq(each, item)) count++;
    return count;
  },
  remove(item) {
    this.splice(this.index(item), 1);
  },
  clear() {
    this.length = 0;
  },
  copy() {
    return this.slice();
  },
  sort_(key, reverse) {
    const all = sorted(this, key, reverse);
    for (let at = 0; at < all.length; at++) this[at] = all[at];
  },
});
give(Number, {
  bit_length() {
    return this.valueOf() === 0 ? 0 : Math.abs(this).toString(2).length;
  },
  bit_count() {
    return this.toString(2).count("1");
  },
  is_integer() {
    return Number.isInteger(this.valueOf());
  },
});

// Dicts and sets: a tuple, bytes and a record are keys by what they hold.

const key = (of) => {
  if (typeof of === "boolean") return +of;
  if (of === null || typeof of !== "object") return of;
  if (of instanceof PySet) return `\0s${[...of].map(key).sort().join("\0,")}`;
  if (of instanceof Record) of = of.constructor.$fields.map((name) => of[name]);
  return typeof of.length === NUMBER ? `\0(${Array.from(of, key).join("\0,")})` : of;
};

export class Dict {
  constructor(pairs) {
    this.map = new Map();
    this.update(pairs);
  }
  get length() {
    return this.map.size;
  }
  *[Symbol.iterator]() {
    for (const [each] of this.map.values()) yield each;
  }
  has(k) {
    return this.map.has(key(k));
  }
  get(k, otherwise = null) {
    const pair = this.map.get(key(k));
    return pair ? pair[1] : otherwise;
  }
  at(k) {
    const pair = this.map.get(key(k));
    if (!pair) throw new KeyError(k);
    return pair[1];
  }
  set(k, value) {
    const old = this.map.get(key(k));
    if (old) old[1] = value;
    else this.map.set(key(k), [k, value]);
  }
  keys() {
    return set(this);
  }
  values() {
    return [...this.map.values()].map(([, value]) => value);
  }
  items() {
    return [...this.map.values()].map(([k, value]) => [k, value]);
  }
  setdefault(k, value = null) {
    if (!this.has(k)) this.set(k, value);
    return this.get(k);
  }
  update(pairs) {
    for (const [k, value] of pairs instanceof Dict ? pairs.items() : pairs) this.set(k, value);
  }
  pop_(k, otherwise) {
    const value = otherwise === undefined ? this.at(k) : this.get(k, otherwise);
    this.map.delete(key(k));
    return value;
  }
  remove(k) {
    this.pop_(k);
  }
  clear() {
    this.map.clear();
  }
}
export class PySet {
  constructor(of) {
    this.map = new Map();
    this.update(of);
  }
  get length() {
    return this.map.size;
  }
  [Symbol.iterator]() {
    return this.map.values();
  }
  has(item) {
    return this.map.has(key(item));
  }
  add(item) {
    if (!this.has(item)) this.map.set(key(item), item);
  }
  discard(item) {
    return this.map.delete(key(item));
  }
  remove(item) {
    if (!this.discard(item)) throw new KeyError(item);
  }
  update(of) {
    for (const each of of) this.add(each);
  }
  clear() {
    this.map.clear();
  }
  isdisjoint(of) {
    return ![...of].some((each) => this.has(each));
  }
  pop_() {
    const [first] = this;
    this.remove(first);
    return first;
  }
}
export const dict = (of = []) => new Dict(of);
dict.fromkeys = (of, value = null) => dict(Array.from(of, (each) => [each, value]));
export const set = (of = []) => new PySet(of);
export const frozenset = set;
class Counts extends Dict {
  at(k) {
    return this.get(k, 0);
  }
}
export const Counter = (of) => {
  const counts = new Counts([]);
  for (const each of of) counts.set(each, counts.at(each) + 1);
  return counts;
};

// Operators, where the types are not known before.

const num = (of) => typeof of === NUMBER || typeof of === "boolean";
const sequence = (of) => Array.isArray(of) || ArrayBuffer.isView(of);
const like = (of, items) => (of instanceof Bytes ? bytes(items) : of instanceof ByteArray ? ByteArray.from(items) : items);
const HALF = 2 ** 32;
const bits = (by) => (a, b) => {
  if ((a | 0) === a && (b | 0) === b) return by(a, b);
  return by(Math.floor(a / HALF), Math.floor(b / HALF)) * HALF + (by(a, b) >>> 0);
};
const [low_and, low_or, low_xor] = [bits((a, b) => a & b), bits((a, b) => a | b), bits((a, b) => a ^ b)];

export const add = (a, b) => {
  if (num(a) && (num(b) || b instanceof Rational)) return a + b;
  if (typeof a === "string" && typeof b === "string") return a + b;
  if (a?.__add__) return a.__add__(b);
  if (a instanceof Bytes) return EMPTY.join([a, b]);
  return like(a, [...a, ...b]);
};
export const sub = (a, b) => (a?.__sub__ ? a.__sub__(b) : a instanceof PySet || a instanceof Dict ? set([...a].filter((each) => !has(b, each))) : a - b);
export const mul = (a, b) => {
  if (num(a) && (num(b) || b instanceof Rational)) return a * b;
  if (a?.__mul__) return a.__mul__(b);
  const [of, times] = num(a) ? [b, Math.max(0, a)] : [a, Math.max(0, b)];
  if (typeof of === "string") return of.repeat(times);
  if (of.length === 1 && !(of instanceof Bytes)) return like(of, new Array(+times).fill(of[0]));
  return like(of, Array.from({ length: of.length * times }, (_, at) => of[at % of.length]));
};
const divisor = (b) => {
  if (b === 0) throw new ZeroDivisionError("division by zero");
  return b;
};
export const div = (a, b) => (a?.__truediv__ ? a.__truediv__(b) : a / divisor(b));
export const mod = (a, b) => {
  const rest = a % divisor(b);
  return rest !== 0 && rest < 0 !== b < 0 ? rest + b : rest;
};
export const floordiv = (a, b) => (a - mod(a, b)) / b;
export const divmod = (a, b) => [floordiv(a, b), mod(a, b)];
export const pow = (a, b) => (a?.__pow__ ? a.__pow__(b) : a ** b);
export const shl = (a, b) => (typeof a === "bigint" ? a << BigInt(b) : a * 2 ** b);
export const shr = (a, b) => Math.floor(a / 2 ** b);
export const and_ = (a, b) => {
  if (a instanceof PySet) return set([...a].filter((each) => b.has(each)));
  return typeof a === "boolean" && typeof b === "boolean" ? a && b : low_and(a, b);
};
export const or_ = (a, b) => {
  if (typeof a === NUMBER && typeof b === NUMBER) return low_or(a, b);
  if (a instanceof PySet) return set([...a, ...b]);
  if (a instanceof Dict) return dict([...a.items(), ...b.items()]);
  return typeof a === "boolean" && typeof b === "boolean" ? a || b : low_or(+a, +b);
};
export const xor = (a, b) => low_xor(a, b);
export const neg = (a) => -a;
/** a += b, a |= b: a list, a set and a Dict grow. */
export const grown = (a, b) => {
  if (Array.isArray(a)) a.extend(b);
  else if (a instanceof PySet || a instanceof Dict) a.update(b);
  else return sequence(a) || typeof a === "string" ? add(a, b) : typeof a === "boolean" ? a || b : a + b;
  return a;
};
export const eq = (a, b) => {
  if (a === b || (num(a) && num(b))) return a === b || Number(a) === Number(b);
  if (a?.__eq__) return a.__eq__(b);
  if (typeof a !== "object" || typeof b !== "object" || a === null || b === null) return false;
  if (ArrayBuffer.isView(a) && ArrayBuffer.isView(b)) return a.length === b.length && a.every((each, at) => each === b[at]);
  if (a instanceof Dict) return b instanceof Dict && a.length === b.length && a.items().every(([k, v]) => b.has(k) && eq(v, b.get(k)));
  if (a instanceof PySet) return b instanceof PySet && a.length === b.length && [...a].every((each) => b.has(each));
  if (a instanceof Record && !(a instanceof NamedTuple)) {
    return a.constructor === b.constructor && a.constructor.$fields.every((name) => eq(a[name], b[name]));
  }
  if (!a[Symbol.iterator] || !b[Symbol.iterator]) return false;
  const [one, other] = [sequence(a) ? a : [...a], sequence(b) ? b : [...b]];
  if (one.length !== other.length) return false;
  for (let at = 0; at < one.length; at++) if (!eq(one[at], other[at])) return false;
  return true;
};
export const lt = (a, b) => {
  if (a instanceof Rational || b instanceof Rational) return rational(a).__sub__(b).numerator < 0n;
  if (typeof a !== "object") return a < b;
  if (a instanceof PySet) return a.length < b.length && [...a].every((each) => b.has(each));
  const [one, other] = [[...a], [...b]];
  const at = one.findIndex((each, index) => index >= other.length || !eq(each, other[index]));
  return at < 0 ? one.length < other.length : at < other.length && lt(one[at], other[at]);
};
export const gt = (a, b) => lt(b, a);
export const le = (a, b) => lt(a, b) || eq(a, b);
export const ge = (a, b) => lt(b, a) || eq(a, b);
export const truth = (of) => (typeof of === "object" && of !== null ? of.__bool__?.() ?? (of.length === undefined || of.length > 0) : Boolean(of));
export const has = (all, item) => {
  if (typeof all === "string") return all.includes(item);
  if (all.has) return all.has(item);
  if (all.__contains__) return all.__contains__(item);
  if (all instanceof Bytes && typeof item === "object") return all.find(item) >= 0;
  for (const each of all) if (eq(each, item)) return true;
  return false;
};
export const at = (of, index) => {
  if (of.__getitem__) return of.__getitem__(index);
  if (of instanceof Dict) return of.at(index);
  const all = of instanceof NamedTuple ? [...of] : of;
  const item = all.at(+index);
  if (item === undefined) throw new IndexError("index out of range");
  return item;
};
export const put = (of, index, value) => {
  if (Array.isArray(of) && index >= 0 && index < of.length) of[index] = value;
  else if (of.__setitem__) of.__setitem__(index, value);
  else if (of instanceof Dict) of.set(index, value);
  else if (index < -of.length || index >= of.length) throw new IndexError("assignment index out of range");
  else of[index < 0 ? index + of.length : index] = value;
};
export const remove = (of, index) => {
  if (of instanceof Dict) of.remove(index);
  else of.splice(index, 1);
};
export const slice = (of, start, stop, step = null) => {
  if (of.__getitem__) return of.__getitem__(new Slice(start, stop));
  if (step === null || step === 1) return of.slice(start ?? 0, stop ?? undefined);
  const [length, back] = [of.length, step < 0];
  const clamp = (x) => Math.min(Math.max(x < 0 ? x + length : x, back ? -1 : 0), back ? length - 1 : length);
  const end = stop === null ? (back ? -1 : length) : clamp(stop);
  const items = [];
  for (let at = start === null ? (back ? length - 1 : 0) : clamp(start); back ? at > end : at < end; at += step) items.push(of[at]);
  return typeof of === "string" ? items.join("") : like(of, items);
};
export const put_slice = (of, start, stop, items) => {
  const clamp = (x) => Math.min(Math.max(x < 0 ? x + of.length : x, 0), of.length);
  const [from, all] = [clamp(start ?? 0), [...items]];
  const to = Math.max(from, clamp(stop ?? of.length));
  if (all.length === to - from) for (let at = 0; at < all.length; at++) of[from + at] = all[at];
  else if (from === 0 && to === of.length) { of.length = 0; of.extend(all); }
  else of.splice(from, to - from, ...all);
};
export class Slice {
  constructor(start, stop) {
    Object.assign(this, { start, stop });
  }
}
export const slice$ = Slice;

// Text.

/** A float, where that is to be seen though it may be whole. */
class Floating extends Number {
  toString() {
    const of = this.valueOf();
    if (!Number.isFinite(of)) return Number.isNaN(of) ? "nan" : of < 0 ? "-inf" : "inf";
    if (of !== 0 && !(Math.abs(of) >= 1e-4 && Math.abs(of) < 1e16)) return of.toExponential().replace(/([+-])(\d)$/, "$10$2");
    return Number.isInteger(of) ? `${Object.is(of, -0) ? "-" : ""}${of}.0` : String(of);
  }
}
export const floating = (of) => new Floating(of);
const digits = (of) => (Number.isInteger(of) ? String(BigInt(of)) : String(new Floating(of)));
const CONTROLS = { "\n": "\\n", "\r": "\\r", "\t": "\\t", "\\": "\\\\" };
const escaped = (c) => CONTROLS[c] ?? `\\x${c.charCodeAt(0).toString(16).padStart(2, "0")}`;
export const str = (of) => {
  if (typeof of === "string") return of;
  return of?.__str__ ? of.__str__() : repr(of);
};
export const repr = (of) => {
  if (of === null || of === undefined) return "None";
  if (typeof of === "boolean") return of ? "True" : "False";
  if (typeof of === NUMBER) return digits(of);
  if (typeof of === "string") {
    const quote = of.includes("'") && !of.includes('"') ? '"' : "'";
    return quote + of.replace(/[\\\x00-\x1f\x7f-\xa0]/g, escaped).replaceAll(quote, `\\${quote}`) + quote;
  }
  if (of.__repr__) return of.__repr__();
  if (of instanceof Record) return `${of.constructor.name}(${of.constructor.$fields.map((name) => `${name}=${repr(of[name])}`).join(", ")})`;
  if (of instanceof Dict) return `{${of.items().map(([k, value]) => `${repr(k)}: ${repr(value)}`).join(", ")}}`;
  return Array.isArray(of) ? `[${of.map(repr).join(", ")}]` : String(of);
};
/** A number to so many places, half to even as CPython does it: what JavaScript rounds is exact but for ties. */
const fixed = (of, places) => {
  const made = of.toFixed(places);
  if (of >= 1e15 || places > 70) return made;
  const rest = of.toFixed(places + 25);
  const [kept_, tail] = [rest.slice(0, rest.length - 25), rest.slice(-25)];
  return /^50*$/.test(tail) && Number(kept_.replace(/\.$/, "").at(-1)) % 2 === 0 ? kept_.replace(/\.$/, "") : made;
};
const general = (of, places) => {
  const [mantissa, power] = of.toExponential((places || 1) - 1).split("e");
  if (of !== 0 && (power < -4 || power >= (places || 1))) {
    const short = mantissa.includes(".") ? mantissa.replace(/\.?0+$/, "") : mantissa;
    return `${short}e${power.replace(/^([+-])(\d)$/, "$10$2")}`;
  }
  const text = fixed(of, Math.max(0, (places || 1) - 1 - power));
  return text.includes(".") ? text.replace(/\.?0+$/, "") : text;
};
const SPEC = /^(?:(.)?([<>=^]))?([-+ ])?(0)?(\d+)?([,_])?(?:\.(\d+))?([a-zA-Z%])?$/su;
export const format = (of, spec = "") => {
  const [, fill, align, plus = "-", zero, width = 0, comma, places, kind = ""] = SPEC.exec(spec);
  const number = typeof of === NUMBER || of instanceof Number || (typeof of === "boolean" && kind);
  let sign = "", body;
  if (number) {
    const size = Math.abs(of);
    const float = of instanceof Number || "fFgGeE%".includes(kind || " ") || places !== undefined;
    sign = of < 0 || (float && Object.is(+of, -0)) ? "-" : plus === "-" ? "" : plus;
    const radix = { o: 8, x: 16, X: 16, b: 2 }[kind];
    if (radix) body = kind === "X" ? size.toString(radix).toUpperCase() : size.toString(radix);
    else if (!Number.isFinite(size)) body = digits(size);
    else if (kind === "f") body = fixed(size, +(places ?? 6));
    else if (kind === "%") body = `${fixed(size * 100, +(places ?? 6))}%`;
    else if (kind === "g" || (!kind && places !== undefined)) body = general(size, +(places ?? 6));
    else body = of instanceof Number ? String(new Floating(size)) : digits(size);
    if (comma) body = body.replace(/^\d+/, (whole) => whole.replace(/\B(?=(\d{3})+$)/g, comma));
  } else body = places === undefined ? str(of) : str(of).slice(0, +places);
  const room = Math.max(0, width - sign.length - body.length);
  const how = align ?? (zero && number ? "=" : number ? ">" : "<");
  const pad = fill ?? (zero ? "0" : " ");
  if (how === "=") return sign + pad.repeat(room) + body;
  const left = how === ">" ? room : how === "^" ? room >> 1 : 0;
  return pad.repeat(left) + sign + body + pad.repeat(room - left);
};

// Python's own functions.

export const len = (of) => of.length;
export const bool = (of = false) => truth(of);
export const chr = (code) => String.fromCodePoint(code);
export const ord = (of) => (typeof of === "string" ? of.codePointAt(0) : of[0]);
export const iter = (of) => of[Symbol.iterator]();
export const next = (of, otherwise) => {
  const { value, done } = (of.next ? of : iter(of)).next();
  if (!done) return value;
  if (otherwise === undefined) throw new StopIteration();
  return otherwise;
};
export const list = (of = []) => [...of];
export const tuple = (of = []) => [...of];
/** @type {(of?: any) => Bytes} */
export const bytes = (of = []) => (of instanceof Bytes ? of : new Bytes(of));
const EMPTY = new Bytes(0);
bytes.fromhex = (text) => Bytes.from(text.replace(/\s/g, "").match(/../g) ?? [], (two) => parseInt(two, 16));
bytes.maketrans = (a, b) => {
  const table = Bytes.from(Array(256).keys());
  a.forEach((each, index) => (table[each] = b[index]));
  return table;
};
str.maketrans = (a, b, gone = "") => {
  if (a instanceof Dict) return dict(a.items().map(([k, to]) => [typeof k === "string" ? ord(k) : k, to]));
  return dict([...Array.from(a, (c, index) => [ord(c), b[index]]), ...Array.from(gone, (c) => [ord(c), null])]);
};
export const bytearray = (of = []) => ByteArray.from(typeof of === NUMBER ? new Array(of).fill(0) : of);
export const array = (_, of) => (of instanceof Uint8Array ? new Words(of.slice().buffer) : Words.from(of));
export const int = (of = 0, base = 10) => {
  if (num(of.valueOf())) return Math.trunc(+of);
  const text = (typeof of === "string" ? of : latin(of)).trim().replace(/_/g, "");
  const form = base === 10 ? /^[-+]?\d+$/ : base === 8 ? /^[-+]?(0o)?[0-7]+$/ : /^[-+]?[0-9a-zA-Z]+$/;
  if (!form.test(text)) throw new ValueError(`invalid literal for int() with base ${base}: ${repr(of)}`);
  return parseInt(text.replace("0o", ""), base);
};
export const float = (of = 0) => {
  const made = Number(typeof of === "string" ? of.trim().replace(/^([-+]?)inf(?:inity)?$/i, "$1Infinity") || NaN : of);
  if (Number.isNaN(made) && !/^[-+]?nan$/i.test(String(of).trim())) throw new ValueError(`could not convert string to float: ${repr(of)}`);
  return made;
};
export const object = Object;
const KINDS = new Map([
  [str, (of) => typeof of === "string"], [bool, (of) => typeof of === "boolean"], [float, (of) => typeof of === NUMBER || of instanceof Floating],
  [int, (of) => Number.isInteger(of) || typeof of === "boolean"], [bytes, (of) => of instanceof Bytes],
  [bytearray, (of) => of instanceof ByteArray], [list, (of) => of?.constructor === Array], [set, (of) => of instanceof PySet],
  [tuple, (of) => of?.constructor === Array || of instanceof NamedTuple], [dict, (of) => of instanceof Dict],
]);
export const isinstance = (of, kind) => {
  if (Array.isArray(kind)) return kind.some((each) => isinstance(of, each));
  return KINDS.has(kind) ? KINDS.get(kind)(of) : of instanceof kind;
};
/** type(of)(value). */
export const made = (of, value) => {
  for (const kind of [bool, int, float, str, bytes, bytearray, list]) if (isinstance(of, kind)) return kind(value);
  return new of.constructor(value);
};
export const getattr = (of, name, otherwise = null) => {
  const value = of[name];
  return value === undefined ? otherwise : typeof value === "function" ? value.bind(of) : value;
};
export const setattr = (of, name, value) => { of[name] = value; };
export class Range {
  constructor(start, stop, step) {
    Object.assign(this, { start, stop, step, length: Math.max(0, Math.ceil((stop - start) / step)) });
  }
  *[Symbol.iterator]() {
    for (let at = 0, value = this.start; at < this.length; at++, value += this.step) yield value;
  }
  includes(value) {
    const steps = (value - this.start) / this.step;
    return Number.isInteger(steps) && steps >= 0 && steps < this.length;
  }
  at(index) {
    return this.start + (index < 0 ? index + this.length : index) * this.step;
  }
  __getitem__(index) {
    if (!(index instanceof Slice)) return this.at(index);
    return range(this.start + (index.start ?? 0) * this.step, index.stop === null ? this.stop : this.start + index.stop * this.step, this.step);
  }
}
export const range = (a, b, step = 1) => (b === undefined ? new Range(0, a, 1) : new Range(a, b, step));
const best = (wins) => (of, by = null, _, otherwise) => {
  let [winner, most] = [undefined, undefined];
  for (const each of of) {
    const value = by ? by(each) : each;
    if (winner === undefined || wins(value, most)) [winner, most] = [each, value];
  }
  if (winner !== undefined) return winner;
  if (otherwise === undefined) throw new ValueError("nothing to choose from");
  return otherwise;
};
export const min = best(lt);
export const max = best(gt);
export const sum = (of, start = 0) => {
  for (const each of of) start = add(start, each);
  return start;
};
export const abs = Math.abs;
export const any = (of) => {
  for (const each of of) if (truth(each)) return true;
  return false;
};
export const all = (of) => !any(Array.from(of, (each) => !truth(each)));
export const sorted = (of, by = null, reverse = false) => {
  const keyed = Array.from(of, (each) => [by ? by(each) : each, each]);
  keyed.sort(([a], [b]) => (lt(a, b) ? -1 : lt(b, a) ? 1 : 0) * (reverse ? -1 : 1));
  return keyed.map(([, each]) => each);
};
export const reversed = (of) => [...of].reverse();
export const enumerate = function* (of, start = 0) {
  for (const each of of) yield [start++, each];
};
export const zip = function* (...of) {
  const iterators = of.map(iter);
  for (;;) {
    const items = iterators.map((each) => each.next());
    if (items.some(({ done }) => done)) return;
    yield items.map(({ value }) => value);
  }
};
const callable = (f) => (/^class/.test(Function.prototype.toString.call(f)) ? (...args) => new f(...args) : f);
export const map = (f, ...of) => Array.from(zip(...of), (args) => callable(f)(...args));
export const filter = (f, of) => [...of].filter((each) => truth(f ? f(each) : each));
export const round = (of, places = null) => {
  if (places !== null) return Number(format(of, `.${places}f`));
  const whole = Math.floor(of), rest = of - whole;
  return rest < 0.5 || (rest === 0.5 && whole % 2 === 0) ? whole : whole + 1;
};

// The standard library.

export const pairwise = (of) => {
  const items = [...of];
  return items.slice(1).map((each, index) => [items[index], each]);
};
export const accumulate = (of, by = add, initial) => {
  const made_ = initial === undefined ? [] : [initial];
  for (const each of of) made_.push(made_.length ? by(made_.at(-1), each) : each);
  return made_;
};
export const groupby = (of, by = (each) => each) => {
  const groups = [];
  for (const each of of) {
    if (!groups.length || !eq(groups.at(-1)[0], by(each))) groups.push([by(each), []]);
    groups.at(-1)[1].push(each);
  }
  return groups;
};
export const attrgetter = (...names) => (names.length === 1 ? (of) => of[names[0]] : (of) => names.map((name) => of[name]));
export const itemgetter = (index) => (of) => at(of, index);
export const bisect_left = (of, value, low = 0, high = of.length, by = (each) => each) => {
  while (low < high) {
    const middle = (low + high) >> 1;
    if (lt(by(of[middle] ?? at(of, middle)), value)) low = middle + 1;
    else high = middle;
  }
  return low;
};
export const suppress = function* (...kinds) {
  try {
    yield;
  } catch (error) {
    if (!isinstance(error, kinds)) throw error;
  }
};
const ENTITIES = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#x27;" };
export const escape = (text) => text.replace(/[&<>"']/g, (c) => ENTITIES[c]);
export const monotonic = () => performance.now() / 1000;
export const floor = Math.floor;
export const ceil = Math.ceil;
export const sqrt = Math.sqrt;
export const cos = Math.cos;
export const sin = Math.sin;
export const radians = (degrees) => degrees * (Math.PI / 180);
export const acos = Math.acos;
export const asin = Math.asin;
export const atan = Math.atan;
export const cosh = Math.cosh;
export const exp = Math.exp;
export const log = Math.log;
export const sinh = Math.sinh;
export const tan = Math.tan;
export const tanh = Math.tanh;
/** The whole root of a whole number, a BigInt, by Newton's steps from above. */
export const isqrt = (of) => {
  const square = BigInt(of);
  let root = BigInt(Math.ceil(Math.sqrt(Number(square))));
  for (let next_ = root + (root >> 50n) + 1n; next_ < root || root * root > square; ) {
    root = next_;
    next_ = (root + square / root) >> 1n;
  }
  return root;
};
const gcd = (a, b) => (b ? gcd(b, a % b) : a);
/** An exact quotient, in lowest terms. At the left of it a number is a float, at its right a whole one. */
class Rational {
  constructor(over, under) {
    const common = gcd(over, under) * (under < 0n ? -1n : 1n);
    const sign = common < 0n === under < 0n ? 1n : -1n;
    this.numerator = (sign * over) / common;
    this.denominator = (sign * under) / common;
  }
  __add__(of) {
    const { numerator, denominator } = rational(of);
    return new Rational(this.numerator * denominator + numerator * this.denominator, this.denominator * denominator);
  }
  __sub__(of) {
    const { numerator, denominator } = rational(of);
    return this.__add__(new Rational(-numerator, denominator));
  }
  __mul__(of) {
    const { numerator, denominator } = rational(of);
    return new Rational(this.numerator * numerator, this.denominator * denominator);
  }
  __truediv__(of) {
    const { numerator, denominator } = rational(of);
    return new Rational(this.numerator * denominator, this.denominator * numerator);
  }
  __pow__(of) {
    return new Rational(this.numerator ** BigInt(of), this.denominator ** BigInt(of));
  }
  __eq__(of) {
    return this.__sub__(of).numerator === 0n;
  }
  /** The nearest float: of 128 bits after the point the last says whether there are more. */
  valueOf() {
    const long = this.numerator << 128n;
    const bits_ = long / this.denominator | (long % this.denominator ? 1n : 0n);
    return Number(bits_) / 2 ** 128;
  }
}
const rational = (of) => (of instanceof Rational ? of : Fraction(of));
export const Fraction = (of, under = 1) => {
  if (typeof of !== "string") return new Rational(BigInt(of), BigInt(under));
  const [digits, power = 0] = of.split("e");
  const [whole, part = ""] = digits.split(".");
  const places = Number(power) - part.length;
  return new Rational(BigInt(whole + part) * 10n ** BigInt(Math.max(0, places)), 10n ** BigInt(Math.max(0, -places)));
};
export const isfinite = Number.isFinite;
/** CPython's way, to the last place: the squares and what they round off added apart, and a step of Newton's. */
export const hypot = (...of) => {
  const top = Math.max(...of.map(Math.abs));
  if (top === 0 || !Number.isFinite(top)) return top;
  const scale = 2 ** -Math.ceil(Math.log2(top));
  let [total, rest, low] = [1, 0, 0];
  const plus = (value, sign) => {
    const split = 134217729 * value, high = split - (split - value), tail = value - high, square = value * value;
    const next_ = total + sign * square;
    rest += sign * square - (next_ - total);
    low += sign * (high * high - square + 2 * high * tail + tail * tail);
    total = next_;
  };
  for (const each of of) plus(each * scale, 1);
  let root = Math.sqrt(total - 1 + (rest + low));
  plus(root, -1);
  root += (total - 1 + (rest + low)) / (2 * root);
  return root / scale;
};
export const dist = (a, b) => {
  const to = [...b];
  return hypot(...Array.from(a, (each, index) => each - to[index]));
};
export const copysign = (a, b) => (b < 0 || Object.is(b, -0) ? -1 : 1) * Math.abs(a);
export const json = {
  dumps(of, indent, pad = indent ? "\n" : "") {
    const deep = pad && pad + " ".repeat(indent);
    const all_ = (parts, [open, close]) => (parts.length ? open + deep + parts.join(pad ? `,${deep}` : ", ") + pad + close : open + close);
    if (of instanceof Dict) return all_(of.items().map(([k, value]) => `${JSON.stringify(k)}: ${json.dumps(value, indent, deep)}`), "{}");
    if (Array.isArray(of)) return all_(of.map((each) => json.dumps(each, indent, deep)), "[]");
    if (typeof of === NUMBER || of instanceof Number) return str(of);
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
class Match {
  constructor(match) {
    Object.assign(this, { match });
  }
  group(number = 0) {
    return this.match[number] ?? null;
  }
  start(number = 0) {
    return this.match.indices[number]?.[0] ?? -1;
  }
  end(number = 0) {
    return this.match.indices[number]?.[1] ?? -1;
  }
}
class Pattern {
  constructor(source) {
    this.source = source.replaceAll("(?P<", "(?<");
  }
  *finditer(text, from = 0) {
    const pattern = new RegExp(this.source, "dgu");
    pattern.lastIndex = from;
    for (const match of text.matchAll(pattern)) yield new Match(match);
  }
  findall(text) {
    return Array.from(text.matchAll(new RegExp(this.source, "gu")), ([whole, ...parts]) => (parts.length > 1 ? parts : parts[0] ?? whole));
  }
  split_(text) {
    return text.split(new RegExp(this.source, "u"));
  }
}
export const re = { compile: (source) => new Pattern(source), finditer: (source, text) => new Pattern(source).finditer(text) };
