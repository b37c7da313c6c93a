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
export class LookupError extends Exception {}
export class IndexError extends LookupError {}
export class KeyError extends LookupError {
  __str__() { return repr(this.args[0]); }
}
export class ArithmeticError extends Exception {}
export class ZeroDivisionError extends ArithmeticError {}
export class OverflowError extends ArithmeticError {}
export class AssertionError extends Exception {}
export class RuntimeError extends Exception {}
export class NotImplementedError extends RuntimeError {}
export class RecursionError extends RuntimeError {}
export class StopIteration extends Exception {}
class TypeError extends Exception {}
export const BaseException = Error;
/** Text that a coding has not; what Python says of it has no translation. */
class UnicodeError extends ValueError {
  get message() { return "a codec error"; }
  __str__() { throw new Untranslated("the text of a codec error"); }
}
/** What cannot be as in Python, found only now: no handler catches it. */
class Untranslated extends Error {}
const refuse = (kind, why) => { throw new kind(why); };

// A generator that a loop leaves continues where it was, as Python's does.
Object.getPrototypeOf(function* () {}).prototype.return = (value) => ({ value, done: true });

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
  [Symbol.iterator]() { return fields(this).values(); }
}
const fields = (of) => of.constructor.$fields.map((name) => of[name]);
for (let place = 0; place < 8; place++) // where a tuple is declared a record may come
  Object.defineProperty(NamedTuple.prototype, place, { get() { return this[this.constructor.$fields[place]]; } });
export class StrEnum {
  static [Symbol.iterator]() { return Object.values(this).values(); }
}
export const IntEnum = StrEnum;
/** The same record but for some fields. */
export const replaced = (of, fields) => new of.constructor(...of.constructor.$fields.map((name) => (name in fields ? fields[name] : of[name])));
/** A method of an object as a value. */
export const bound = (of, name) => (...args) => of[name](...args);
/** A function that keeps what it has returned. */
export const cache = (f) => {
  const known = new Map();
  return (of) => {
    if (!known.has(of)) known.set(of, f(of));
    return known.get(of);
  };
};
/** Keep the value of a cached property. */
export const kept = (of, name, value) => Object.defineProperty(of, name, { value })[name];

// Text and sequences.

const give = (kind, methods) => {
  for (const [name, value] of Object.entries(methods)) {
    Object.defineProperty(kind.prototype, name, { value, writable: true, configurable: true });
  }
};
const SPACE = "\\t-\\r\\x1c-\\x20\\x85\\xa0\\u1680\\u2000-\\u200a\\u2028\\u2029\\u202f\\u205f\\u3000";
const BLANK = new RegExp(`[${SPACE}]`);
const BLANKS = new RegExp(`[${SPACE}]+`);
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
    if (coding === "latin-1" || this.isascii()) return latin(this);
    try {
      if (coding !== "ascii") return new TextDecoder(coding, { fatal: true, ignoreBOM: true }).decode(this);
    } catch { /* not UTF-8 */ }
    throw new UnicodeError();
  }
}
const byte = (of, what = "byte") => ((of & 255) === of ? of : refuse(ValueError, `${what} must be in range(0, 256)`));
export class ByteArray extends Array {
  append(item) { this.push(byte(item)); }
  extend(of) { this.push(...Array.from(of, (each) => byte(each))); }
}
const word = (of) => ((of & 65535) === of ? of : refuse(OverflowError, `unsigned short is ${of < 0 ? "less than minimum" : "greater than maximum"}`));
export class Words extends Uint16Array {
  tobytes() { return new Bytes(this.slice().buffer); }
  byteswap() { this.forEach((each, at) => (this[at] = each << 8 | each >> 8)); }
}
/** Strip what is in `chars` (null: a text's white space) from the left or right end, or both. */
const strip = (left, right) => function (chars = null) {
  const out = (each) => (chars === null && typeof each === "string" ? BLANK.test(each) : (chars ?? " \t\n\r\v\f").includes(typeof each === "string" || chars !== null ? each : chr(each)));
  let [start, end] = [0, this.length];
  while (left && start < end && out(this[start])) start++;
  while (right && end > start && out(this[end - 1])) end--;
  return this.slice(start, end);
};
for (const kind of [String, Bytes]) give(kind, { strip: strip(true, true), lstrip: strip(true, false), rstrip: strip(false, true) });
/** What bytes do as a text of characters to 0377; a number is one of them. */
for (const name of ["startswith", "endswith", "isdigit", "isascii", "find", "rfind", "count"]) {
  const as_text = (what) => (typeof what === "number" ? chr(what) : what && latin(what));
  give(Bytes, { [name](what, ...from) { return latin(this)[name](...(what === undefined ? [] : [as_text(what), ...from])); } });
}
const matching = (pattern) => function () { return pattern.test(this); };

const place = (of, at) => (at < 0 ? Math.max(0, at + of.length) : at);
const empty = (by) => (by === "" ? refuse(ValueError, "empty separator") : by);
const DIGITS = "\\p{Nd}²³¹⁰⁴-⁹₀-₉①-⑨⑴-⑼⒈-⒐⓪⓵-⓽⓿❶-❾➀-➈➊-➒፩-፱᧚";
give(String, {
  join(of) { return Array.prototype.join.call([...of], this); },
  split_(by) { return by === undefined ? this.split(BLANKS).filter(Boolean) : this.split(empty(by)); },
  partition(by) {
    const at = this.indexOf(empty(by));
    return at < 0 ? [this.valueOf(), "", ""] : [this.slice(0, at), by, this.slice(at + by.length)];
  },
  replace_(from, to) { return this.replaceAll(from, () => to); },
  find(what, from = 0, to = this.length) {
    const at = place(this, from);
    return at > Math.min(place(this, to), this.length) ? -1 : this.slice(0, to).indexOf(what, at);
  },
  index(what) {
    const at = this.indexOf(what);
    return at < 0 ? refuse(ValueError, "substring not found") : at;
  },
  rfind: String.prototype.lastIndexOf,
  count(what, from, to) {
    if (place(this, from ?? 0) > Math.min(place(this, to ?? Infinity), this.length)) return 0;
    const text = this.slice(from, to);
    return what ? text.split(what).length - 1 : text.length + 1;
  },
  startswith(what, from = 0) {
    const at = place(this, from);
    return at <= this.length && [what].flat().some((each) => this.startsWith(each, at));
  },
  endswith(what) { return [what].flat().some((each) => this.endsWith(each)); },
  upper: String.prototype.toUpperCase,
  lower: String.prototype.toLowerCase,
  ljust: String.prototype.padEnd,
  rjust: String.prototype.padStart,
  removesuffix(what) { return this.endsWith(what) ? this.slice(0, this.length - what.length) : this.valueOf(); },
  removeprefix(what) { return this.startsWith(what) ? this.slice(what.length) : this.valueOf(); },
  expandtabs(width = 8) {
    let column = 0;
    return Array.from(this, (each) => {
      const wide = each === "\t" ? width && width - (column % width) : 1;
      column = each === "\n" || each === "\r" ? 0 : column + wide;
      return each === "\t" ? " ".repeat(wide) : each;
    }).join("");
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
    if (errors === "strict") throw new UnicodeError();
    const codes = Array.from(this, (each) => each.codePointAt(0));
    return Bytes.from(codes, (code) => (code > most ? 63 : code));
  },
  isascii: matching(/^[\x00-\x7f]*$/),
  isdigit: matching(new RegExp(`^[${DIGITS}]+$`, "u")),
  isdecimal: matching(/^\p{Nd}+$/u),
  isalpha: matching(/^\p{L}+$/u),
  isalnum: matching(/^[\p{L}\p{N}]+$/u),
  isprintable: matching(/^(?: |[^\p{C}\p{Z}])*$/u),
  isspace: matching(new RegExp(`^[${SPACE}]+$`)),
});
give(Array, {
  append(item) { this.push(item); },
  insert(at, item) { this.splice(at, 0, item); },
  extend(of) {
    for (const each of of === this ? [...of] : of) this.push(each);
  },
  pop_(at = -1) {
    if (!this.length) throw new IndexError(`pop from empty ${this instanceof ByteArray ? "bytearray" : "list"}`);
    if (at < -this.length || at >= this.length) throw new IndexError("pop index out of range");
    return at === -1 ? this.pop() : this.splice(at, 1)[0];
  },
  index(item, from = 0) {
    for (let at = place(this, from); at < this.length; at++) if (eq(this[at], item)) return at;
    throw new ValueError(`${repr(item)} is not in list`);
  },
  count(item) { return this.reduce((count, each) => count + eq(each, item), 0); },
  clear() { this.length = 0; },
});
const bits = (of) => (of < 0 ? -of : of).toString(2);
for (const kind of [Number, BigInt]) {
  give(kind, {
    bit_length() { return this.valueOf() == 0 ? 0 : bits(this.valueOf()).length; },
    bit_count() { return bits(this.valueOf()).count("1"); },
  });
}

// Dicts and sets: a key is a number, a text, None or an object that is no other; a tuple is none.

const key = (of) => {
  if (typeof of === "object" && (sequence(of) || of instanceof Record)) throw new Untranslated(`${repr(of)} as a key`);
  return of;
};
/** What a Dict or set has, in its order; it may not grow or shrink meanwhile. */
const each = function* (of, items, what) {
  const { size } = of;
  for (const item of items) {
    yield item;
    if (of.size !== size) throw new RuntimeError(`${what} changed size during iteration`);
  }
};
class View {
  constructor(of, items) {
    this.of = of;
    this.items = items;
  }
  get length() { return this.of.size; }
  [Symbol.iterator]() { return each(this.of, this.items.call(this.of), "dictionary"); }
}
class Keys extends View {
  has(item) { return this.of.has(item); }
}
export class Dict extends Map {
  get length() { return this.size; }
  [Symbol.iterator]() { return each(this, super.keys(), "dictionary"); }
  get(k, otherwise = null) { return this.has(k) ? super.get(k) : otherwise; }
  at(k) {
    const value = super.get(k);
    if (value === undefined) throw new KeyError(k);
    return value;
  }
  set(k, value) { return super.set(key(k), value); }
  keys() { return new Keys(this, super.keys); }
  values() { return new View(this, super.values); }
  items() { return new View(this, super.entries); }
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
  [Symbol.iterator]() { return each(this, super.values(), "Set"); }
  add(item) { return super.add(key(item)); }
  discard(item) { this.delete(item); }
  update(of) {
    for (const item of of) this.add(item);
  }
}
export const dict = (of) => new Dict(of instanceof Dict ? of.items() : of);
dict.fromkeys = (of, value = null) => dict(Array.from(of, (each) => [each, value]));
export const set = (of) => new PySet(of);
export const frozenset = set;

// Operators. Whole numbers are exact: beyond 2^53 they are BigInts.

const num = (of) => typeof of === "number" || typeof of === "boolean" || typeof of === "bigint";
const sequence = (of) => Array.isArray(of) || ArrayBuffer.isView(of);
const like = (of, items) => (of instanceof Bytes ? bytes(items) : of instanceof ByteArray ? ByteArray.from(items) : items);
const MOST = Number.MAX_SAFE_INTEGER;
const small = (of) => of <= MOST && of >= -MOST;
const exact = (of) => (small(of) ? Number(of) : of);
/** A whole float as an int. */
const whole = (of) => {
  if (small(of)) return of + 0;
  if (Number.isNaN(of)) throw new ValueError("cannot convert float NaN to integer");
  return Number.isFinite(of) ? exact(BigInt(of)) : refuse(OverflowError, "cannot convert float infinity to integer");
};
/** An operator on whole numbers: of those whose result is small, and of all. */
const wholly = (by, great) => (a, b) => {
  if (typeof a === "number" && typeof b === "number") {
    const made = by(a, b);
    if (small(made)) return made + 0;
  }
  return exact(great(BigInt(a), BigInt(b)));
};
export const plus = wholly((a, b) => a + b, (a, b) => a + b);
export const minus = wholly((a, b) => a - b, (a, b) => a - b);
export const times = wholly((a, b) => a * b, (a, b) => a * b);
export const neg = (a) => minus(0, a);
export const invert = (a) => minus(-1, a);
const HALF = 2 ** 32;
/** An operator on whole numbers and truths, which for sets and Dicts is `other`. */
const bitwise = (by, great, other) => (a, b) => {
  if ((typeof a === "number" && typeof b === "number") || (typeof a === "boolean" && typeof b === "boolean")) {
    if ((a | 0) === a && (b | 0) === b) return by(a, b);
    if (!small(a) || !small(b)) return exact(great(BigInt(a), BigInt(b)));
    const made = by(Math.floor(a / HALF), Math.floor(b / HALF)) * HALF + (by(a, b) >>> 0);
    return typeof a === "boolean" ? Boolean(made) : made;
  }
  return typeof a === "object" ? other(a, b) : exact(great(BigInt(a), BigInt(b)));
};
export const and_ = bitwise((a, b) => a & b, (a, b) => a & b, (a, b) => set([...a].filter((item) => b.has(item))));
export const or_ = bitwise((a, b) => a | b, (a, b) => a | b, (a, b) => (a instanceof Dict ? dict([...a.items(), ...b.items()]) : set([...a, ...b])));
export const xor = bitwise((a, b) => a ^ b, (a, b) => a ^ b);

export const add = (a, b) => {
  if (num(a) && (num(b) || b?.under)) return a + b;
  if (typeof a === "string") return a + b;
  if (a.__add__) return a.__add__(b);
  return a instanceof Bytes ? EMPTY.join([a, b]) : like(a, [...a, ...b]);
};
export const sub = (a, b) => (a.__sub__ ? a.__sub__(b) : a instanceof PySet || a instanceof View ? set([...a].filter((item) => !has(b, item))) : a - b);
export const mul = (a, b) => {
  if (num(a) && (num(b) || b?.under)) return a * b;
  if (a.__mul__) return a.__mul__(b);
  const [of, count] = num(a) ? [b, Math.max(0, Number(a))] : [a, Math.max(0, Number(b))];
  if (typeof of === "string") return of.repeat(count);
  return like(of, Array.from({ length: of.length * count }, (_, at) => of[at % of.length]));
};
/** The float nearest to a quotient: of 128 bits after the point the last says whether there are more. */
const ratio = (over, under) => {
  const long = over << 128n;
  return Number(long / under | (long % under ? 1n : 0n)) / 2 ** 128;
};
const divisor = (b) => (b == 0 ? refuse(ZeroDivisionError, "division by zero") : b);
export const div = (a, b) => {
  if (a.__truediv__) return a.__truediv__(b);
  divisor(b);
  return typeof a === "bigint" || typeof b === "bigint" ? ratio(BigInt(a), BigInt(b)) : a / b;
};
export const div_ = (a, b) => Number(a) / divisor(Number(b));
export const power = (a, b) => {
  if (b < 0) return a == 0 ? refuse(ZeroDivisionError, "0.0 cannot be raised to a negative power") : Number(a) ** Number(b);
  return wholly((x, y) => x ** y, (x, y) => x ** y)(a, b);
};
/** A power of floats, or of what has any type. */
export const power_ = (a, b) => {
  if (a.__pow__) return a.__pow__(b);
  const [x, y] = [Number(a), Number(b)];
  if (x === 0 && y < 0) throw new ZeroDivisionError("0.0 cannot be raised to a negative power");
  if (x === 1 || (x === -1 && !Number.isFinite(y) && !Number.isNaN(y))) return 1;
  if (x < 0 && Number.isFinite(x) && !Number.isInteger(y) && Number.isFinite(y)) throw new Untranslated("a complex number");
  const made = x ** y;
  return Math.abs(made) === Infinity && Number.isFinite(x) && Number.isFinite(y) ? refuse(OverflowError, "(34, 'Numerical result out of range')") : made;
};
const rest = (a, b) => {
  const left = a % b;
  return left != 0 && left < 0 !== b < 0 ? left + b : left;
};
export const mod = (a, b) => wholly(rest, rest)(a, divisor(b));
const quotient = wholly((a, b) => {
  const over = a - rest(a, b);
  return small(over) ? over / b : Infinity;
}, (a, b) => (a - rest(a, b)) / b);
export const floordiv = (a, b) => quotient(a, divisor(b));
const signed = (of, as) => (of === 0 ? copysign(0, as) : of);
const floats = (a, b) => {
  const left = a % b, by = (a - left) / b, other = left !== 0 && b < 0 !== left < 0;
  const near = other ? by - 1 : by, down = Math.floor(near);
  return [near ? (near - down > 0.5 ? down + 1 : down) : copysign(0, a / b), other ? left + b : signed(left, b)];
};
export const floordiv_ = (a, b) => floats(Number(a), divisor(Number(b)))[0];
export const mod_ = (a, b) => floats(Number(a), divisor(Number(b)))[1];
export const divmod = (a, b) => [floordiv(a, b), mod(a, b)];
export const divmod_ = (a, b) => floats(Number(a), divisor(Number(b)));
const shift = (by) => (by < 0 ? refuse(ValueError, "negative shift count") : by);
export const shl = (a, b) => wholly((x, y) => x * 2 ** y, (x, y) => x << y)(a, shift(b));
export const shr = (a, b) => wholly((x, y) => (y > 1023 ? -(x < 0) : Math.floor(x / 2 ** y)), (x, y) => x >> y)(a, shift(b));
/** a += b, a |= b: a list, a set and a Dict grow, for anything else it is `by`. */
export const grown = (a, b, by) => {
  if (Array.isArray(a)) a.extend(b);
  else if (a.update) a.update(b);
  else return by(a, b);
  return a;
};
export const eq = (a, b) => {
  if (a === b) return true;
  if (num(a) && num(b)) return a == b;
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
  if (a?.under || b?.under) return rational(a).__sub__(b).over < 0n;
  if (typeof a !== "object") return a < b;
  const [one, other] = [[...a], [...b]];
  const at = one.findIndex((each, index) => index >= other.length || !eq(each, other[index]));
  return at < 0 ? one.length < other.length : at < other.length && lt(one[at], other[at]);
};
export const gt = (a, b) => lt(b, a);
export const le = (a, b) => lt(a, b) || eq(a, b);
export const ge = (a, b) => le(b, a);
/** How many items it has; undefined for what has none. */
const size = (of) => (of instanceof NamedTuple ? of.constructor.$fields.length : of.__len__ ? of.__len__() : of instanceof Instance || of instanceof Record ? undefined : of.length);
export const truth = (of) => {
  if (typeof of === "number") return of !== 0;
  if (typeof of !== "object" || of === null) return Boolean(of);
  return of.under ? of.over !== 0n : size(of) !== 0;
};
export const has = (all, item) => {
  if (typeof all === "string") return all.includes(item);
  if (all.has) return all.has(item);
  if (all instanceof Bytes && typeof item === "object") return all.find(item) >= 0;
  for (const each of all) if (eq(each, item)) return true;
  return false;
};
const NAMES = [[Words, "array index"], [ByteArray, "bytearray index"], [Bytes, "index"], [Array, "list index"], [String, "string index"]];
const called = (of) => NAMES.find(([kind]) => Object(of) instanceof kind)?.[1] ?? "tuple index";
export const at = (of, index, name = "") => {
  if (of.__getitem__) return of.__getitem__(index);
  if (of instanceof Dict) return of.at(index);
  const item = (of instanceof NamedTuple ? [...of] : of).at(Number(index));
  if (item === undefined) throw new IndexError(`${name || called(of)} out of range`);
  return item;
};
export const put = (of, index, value) => {
  if (of.__setitem__) of.__setitem__(index, value);
  else if (of instanceof Dict) of.set(index, value);
  else if (index < -of.length || index >= of.length) {
    const name = called(of);
    throw new IndexError(`${name.startsWith("b") ? name : name.replace("index", "assignment index")} out of range`);
  } else of[index < 0 ? index + of.length : index] = of instanceof Words ? word(value) : of instanceof ByteArray ? byte(value) : value;
};

// Text.

/** As many items as there are targets; what the starred one takes is a list. */
export const unpack = (of, count, star = -1) => {
  const exact = star < 0, given = sequence(of) ? [...of] : taken(of, exact ? count + 1 : Infinity);
  if (exact && given.length > count) throw new ValueError(`too many values to unpack (expected ${count})`);
  if (given.length < count - !exact) throw new ValueError(`not enough values to unpack (expected ${exact ? count : `at least ${count - 1}`}, got ${given.length})`);
  const end = star + given.length - count + 1;
  return exact ? given : [...given.slice(0, star), given.slice(star, end), ...given.slice(end)];
};
const taken = (of, most) => {
  const found = [];
  for (const item of of) if (found.push(item) >= most) break;
  return found;
};
export const unpacked = function* (of, count, star) {
  for (const item of of) yield unpack(item, count, star);
};

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
const CONTROLS = { "\n": "\\n", "\r": "\\r", "\t": "\\t", "\\": "\\\\" };
const escaped = (c) => {
  const code = c.codePointAt(0);
  const [letter, wide] = code < 256 ? ["x", 2] : code < 65536 ? ["u", 4] : ["U", 8];
  return CONTROLS[c] ?? `\\${letter}${code.toString(16).padStart(wide, "0")}`;
};
export const str = (of) => (typeof of === "string" ? of : of?.__str__ ? of.__str__() : repr(of));
const quoted = (of, unseen) => {
  const quote = of.includes("'") && !of.includes('"') ? '"' : "'";
  return quote + of.replace(unseen, escaped).replaceAll(quote, `\\${quote}`) + quote;
};
export const repr = (of) => {
  if (of === null) return "None";
  if (typeof of === "boolean") return of ? "True" : "False";
  if (typeof of === "number") return String(Number.isInteger(of) ? BigInt(of) : new Floating(of));
  if (typeof of === "string") return quoted(of, /[\\\p{C}\p{Zl}\p{Zp}\xa0\u1680\u2000-\u200a\u202f\u205f\u3000]/gu);
  if (of instanceof Bytes) return `b${quoted(latin(of), /[\\\x00-\x1f\x7f-\xff]/g)}`;
  if (of instanceof Record) return displayed(of, ...fields(of).map(() => repr));
  if (of instanceof Dict) return shown_dict(of, repr, repr);
  return Array.isArray(of) ? shown_list(of, repr) : String(of);
};
export const shown_list = (of, item) => `[${of.map((value) => item(value)).join(", ")}]`;
export const shown_row = (of, item) => shown_tuple(of, of.map(() => item));
export const shown_tuple = (of, items) => `(${of.map((value, place) => items[place](value)).join(", ")}${of.length === 1 ? "," : ""})`;
export const shown_dict = (of, name, value) => `{${Array.from(of.items(), ([k, held]) => `${name(k)}: ${value(held)}`).join(", ")}}`;
export const displayed = (of, ...items) => {
  const parts = of.constructor.$fields.map((name, place) => `${name}=${items[place](of[name])}`);
  return `${of.constructor.name}(${parts.join(", ")})`;
};
/** A number to so many places, half to even as CPython does it: what JavaScript rounds is exact but for ties. */
const fixed = (of, places) => {
  if (of >= 1e21) return `${Number.isFinite(of) ? BigInt(of) : "inf"}${places && Number.isFinite(of) ? `.${"0".repeat(places)}` : ""}`;
  const made = of.toFixed(places);
  if (of >= 5e15) return made;
  const exact = of.toFixed(places + 25);
  const below = exact.slice(0, -25).replace(/\.$/, "");
  return /50{24}$/.test(exact) && below.at(-1) % 2 === 0 ? below : made;
};
const general = (of, places) => {
  if (of === Infinity) return "inf";
  const [mantissa, power] = of.toExponential(places - 1).split("e");
  const short = (text) => (text.includes(".") ? text.replace(/\.?0+$/, "") : text);
  if (of !== 0 && (power < -4 || power >= places)) return exponent(`${short(mantissa)}e${power}`);
  return short(fixed(of, Math.max(0, places - 1 - power)));
};
const SPEC = /^([+])?(0)?(\d+)?(,)?(?:\.(\d+))?([oxfg])?$/;
/** A number is at the right of its width, a text at the left. */
export const format = (of, spec) => {
  const [, plus, zero, width = 0, comma, places = 6, kind] = SPEC.exec(spec) ?? refuse(ValueError, "Invalid format specifier");
  if (!num(of) && !(of instanceof Number)) return str(of).padEnd(width);
  const float = of instanceof Number || kind === "f" || kind === "g"; // a whole number has no -0
  const size = float ? Math.abs(Number(of)) : BigInt(of < 0 ? -of : of);
  if (Number.isNaN(size)) return "nan".padStart(width);
  const sign = of < 0 || (float && Object.is(Number(of), -0)) ? "-" : plus ?? "";
  let body = String(float ? new Floating(size) : size);
  if (kind === "o" || kind === "x") body = size.toString(kind === "o" ? 8 : 16);
  else if (kind === "f") body = fixed(size, +places);
  else if (kind === "g") body = general(size, +places || 1);
  if (comma) body = body.replace(/^\d+/, (whole) => whole.replace(/\B(?=(\d{3})+$)/g, ","));
  return zero ? sign + body.padStart(width - sign.length, "0") : (sign + body).padStart(width);
};

// Python's own functions.

export const len = (of) => size(of);
export const bool = (of) => truth(of);
export const type = (of) => of.constructor;
Object.defineProperty(Function.prototype, "__name__", { get() { return this.name; } });
export const chr = (code) => {
  if (code < 0 || code > 0x10ffff) throw new ValueError("chr() arg not in range(0x110000)");
  if (code > 0xffff || (code >= 0xd800 && code < 0xe000)) throw new Untranslated("a character beyond U+FFFF");
  return String.fromCharCode(code);
};
export const ord = (of) => (of.length === 1 ? of.charCodeAt(0) : of.codePointAt(0) > 0xffff && of.length === 2 ? of.codePointAt(0) : refuse(TypeError, `ord() expected a character, but string of length ${of.length} found`));
export const iter = (of) => of[Symbol.iterator]();
export const next = (of, otherwise) => {
  const { value, done } = (of.next ? of : iter(of)).next();
  if (done && otherwise === undefined) throw new StopIteration();
  return done ? otherwise : value;
};
export const list = (of = []) => [...of];
export const tuple = list;
/** @type {(of?: any) => Bytes} */
export const bytes = (of = []) => {
  if (of instanceof Bytes) return of;
  if (typeof of === "number") return of < 0 ? refuse(ValueError, "negative count") : new Bytes(of);
  const items = sequence(of) ? of : [...of], made = new Bytes(items);
  for (let at = 0; at < made.length; at++) if (made[at] !== items[at]) byte(items[at], "bytes");
  return made;
};
const EMPTY = new Bytes(0);
export const bytearray = (of = []) => ByteArray.from(typeof of === "number" ? bytes(of) : of, (each) => byte(each));
export const array = (_, of) => {
  if (!(of instanceof Uint8Array)) return Words.from(of, word);
  if (of.length % 2) throw new ValueError("bytes length not a multiple of item size");
  return new Words(of.slice().buffer);
};
/** What decimal digits of any script are, as ASCII. */
const decimals = (text) => text.replace(/[^\x00-\x7f]/g, (each) => (each.isdecimal() ? String((ord(each) & 15) - (chr(ord(each) & ~15).isdecimal() ? 0 : 6)) : each));
/** Each base's mark, and the form of its numbers. */
const BASES = Object.fromEntries([[2, "0b", "[01]"], [8, "0o", "[0-7]"], [10, "", "\\d"], [16, "0x", "[\\da-f]"]].map(
  ([base, mark, digit]) => [base, [mark, new RegExp(`^([-+]?)${mark && `(?:${mark}_?)?`}(${digit}+(?:_${digit}+)*)$`, "i")]]));
export const int = (of, base = 10) => {
  if (typeof of === "bigint") return of;
  if (of?.under) return exact(of.over / of.under);
  if (num(of.valueOf())) return whole(Math.trunc(+of));
  const [mark, form] = BASES[base] ?? refuse(Untranslated, `int() with base ${base}`);
  const found = form.exec((typeof of === "string" ? decimals(of) : latin(of)).strip());
  if (!found) throw new ValueError(`invalid literal for int() with base ${base}: ${repr(of)}`);
  const value = exact(BigInt(mark + found[2].replaceAll("_", "")));
  return found[1] === "-" ? neg(value) : value;
};
const FLOAT = /^[-+]?(?:\d+(?:_\d+)*\.?(?:\d+(?:_\d+)*)?|\.\d+(?:_\d+)*)(?:e[-+]?\d+(?:_\d+)*)?$/i;
export const float = (of) => {
  if (typeof of !== "string") {
    const made = Number(of);
    return typeof of === "bigint" && !Number.isFinite(made) ? refuse(OverflowError, "int too large to convert to float") : made;
  }
  const text = decimals(of).strip(), [, sign, word] = /^([-+]?)(.*)$/s.exec(text);
  if (FLOAT.test(text)) return Number(text.replaceAll("_", ""));
  const special = { inf: Infinity, infinity: Infinity, nan: NaN }[word.toLowerCase()];
  return special === undefined ? refuse(ValueError, `could not convert string to float: ${repr(of)}`) : sign === "-" ? -special : special;
};
const integer = (of) => typeof of === "bigint" || typeof of === "boolean" || (typeof of === "number" && Number.isInteger(of));
const KINDS = new Map([
  [str, (of) => typeof of === "string"], [bool, (of) => typeof of === "boolean"], [float, (of) => typeof of.valueOf() === "number"],
  [int, integer], [list, (of) => of?.constructor === Array],
  [bytes, (of) => of instanceof Bytes], [bytearray, (of) => of instanceof ByteArray], [dict, (of) => of instanceof Dict],
]);
export const isinstance = (of, kind) => {
  if (Array.isArray(kind)) return kind.some((each) => isinstance(of, each));
  return KINDS.has(kind) ? of !== null && KINDS.get(kind)(of) : of instanceof kind;
};
export const getattr = (of, name) => {
  const value = of[name];
  return typeof value === "function" ? value.bind(of) : value;
};
export class slice {} // nothing is one: a translated slice calls the method of this name
export const setattr = (of, name, value) => { of[name] = value; };
class Range {
  constructor(start, stop, step) {
    Object.assign(this, { start, stop, step });
    this.length = Math.max(0, Math.ceil((stop - start) / step));
  }
  *[Symbol.iterator]() {
    for (let left = this.length, item = this.start; left > 0; left--, item += this.step) yield item;
  }
  at(index) {
    const place = index < 0 ? index + this.length : index;
    if (!(place >= 0 && place < this.length)) throw new IndexError("range object index out of range");
    return this.start + place * this.step;
  }
  has(item) {
    const place = (item - this.start) / this.step;
    return num(item) && Number.isInteger(place) && place >= 0 && place < this.length;
  }
}
export const range = (a, b, step = 1) => {
  if (step === 0) throw new ValueError("range() arg 3 must not be zero");
  return b === undefined ? new Range(0, a, step) : new Range(a, b, step);
};
const best = (wins, name) => (of) => {
  let most;
  for (const item of of) if (most === undefined || wins(item, most)) most = item;
  return most === undefined ? refuse(ValueError, `${name}() arg is an empty sequence`) : most;
};
export const min = best((a, b) => lt(a, b), "min");
export const max = best((a, b) => lt(b, a), "max");
const summed = (by) => (of) => {
  let found = 0;
  for (const item of of) found = by(found, item);
  return found;
};
export const sum = summed(add);
/** A sum of whole numbers. */
export const total = summed(plus);
const until = (decides) => (of) => {
  for (const item of of) if (truth(item) === decides) return decides;
  return !decides;
};
export const any = until(true);
export const all = until(false);
export const sorted = (of, by = (item) => item, reverse = false) => {
  const keyed = Array.from(of, (item) => [by(item), item]);
  keyed.sort(([a], [b]) => (lt(a, b) ? -1 : lt(b, a) ? 1 : 0) * (reverse ? -1 : 1));
  return keyed.map(([, item]) => item);
};
export const reversed = function* (of) {
  for (let place = of.length - 1; place >= 0; place--) yield of instanceof Range ? of.at(place) : of[place];
};
export const enumerate = function* (of, start = 0) {
  for (const item of of) yield [start++, item];
};
const zipped = (strict) => function* (...of) {
  const parts = of.map(iter);
  for (;;) {
    const found = [];
    for (const part of parts) if (strict || !found.at(-1)?.done) found.push(part.next());
    const short = found.findIndex(({ done }) => done);
    if (short >= 0 && strict && !found.every(({ done }) => done)) {
      const [at, how] = short ? [short, "shorter"] : [found.findIndex(({ done }) => !done), "longer"];
      throw new ValueError(`zip() argument ${at + 1} is ${how} than argument${at > 1 ? "s 1-" : " "}${at}`);
    }
    if (short >= 0) return;
    yield found.map(({ value }) => value);
  }
};
export const zip = zipped(false);
export const zip_strict = zipped(true);
export const map = function* (f, of) {
  for (const item of of) yield f(item);
};
export const round = (of, places = null) => {
  if (typeof of === "bigint") return of;
  if (places === null) {
    const down = Math.floor(of), part = of - down;
    return whole(part < 0.5 || (part === 0.5 && down % 2 === 0) || !Number.isFinite(of) ? down : down + 1);
  }
  if (Number.isInteger(of) || !Number.isFinite(of)) return of;
  return places > 75 ? refuse(Untranslated, "so many places") : (of < 0 ? -1 : 1) * Number(fixed(Math.abs(of), places));
};

// The standard library.

/** A function of Math whose value has to be one: an error as Python's. */
const domain = (f) => (of) => {
  const x = Number(of), made = f(x);
  if (Number.isFinite(made) || !Number.isFinite(x)) return Number.isNaN(made) && !Number.isNaN(x) ? refuse(ValueError, "math domain error") : made;
  return Number.isNaN(made) || f === Math.log ? refuse(ValueError, "math domain error") : refuse(OverflowError, "math range error");
};
export const { acos, asin, cosh, exp, log, sinh, sqrt } = Object.fromEntries("acos asin cosh exp log sinh sqrt".split(" ").map((name) => [name, domain(Math[name])]));
const finite = (f) => (of) => (isfinite(of) ? f(Number(of)) : refuse(ValueError, "math domain error"));
export const { cos, sin, tan } = Object.fromEntries("cos sin tan".split(" ").map((name) => [name, finite(Math[name])]));
export const { atan, atan2, tanh } = Math;
export const abs = (of) => (of < 0 || Object.is(of, -0) ? -of : of);
export const fabs = (of) => Math.abs(Number(of));
export const floor = (of) => (typeof of === "bigint" ? of : whole(Math.floor(of)));
export const ceil = (of) => (typeof of === "bigint" ? of : whole(Math.ceil(of)));
export const pow = (a, b) => {
  try {
    return power_(Number(a), Number(b));
  } catch (error) {
    throw error instanceof OverflowError ? new OverflowError("math range error") : new ValueError("math domain error");
  }
};
export const pairwise = function* (of) {
  let before;
  for (const item of of) {
    if (before) yield [before[0], item];
    before = [item];
  }
};
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
export const isfinite = (of) => Number.isFinite(Number(of));
export const copysign = (a, b) => (b < 0 || Object.is(b, -0) ? -1 : 1) * Math.abs(a);
export const json = {
  dumps(of, indent, pad = indent ? "\n" : "") {
    const deep = pad && pad + " ".repeat(indent);
    const all_ = (parts, [open, close]) => (parts.length ? open + deep + parts.join(pad ? `,${deep}` : ", ") + pad + close : open + close);
    if (of instanceof Dict) return all_(Array.from(of.items(), ([k, value]) => `${JSON.stringify(k)}: ${json.dumps(value, indent, deep)}`), "{}");
    if (Array.isArray(of)) return all_(of.map((each) => json.dumps(each, indent, deep)), "[]");
    if (typeof of === "number" || typeof of === "bigint" || of instanceof Number) return str(of);
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
const PRIMES = Array.from({ length: 310 }, (_, of) => of + 2).filter((of, _, every) => every.every((by) => by >= of || of % by));
const fractions = (root, primes) => primes.map((prime) => ((root(prime) % 1) * 2 ** 32) | 0);
const ROUNDS = fractions(Math.cbrt, PRIMES);
const turned = (of, by) => (of >>> by) | (of << (32 - by));
/** FIPS 180-4: its constants are the fractions of roots of the first primes. */
export const sha256 = (of) => {
  const padded = new DataView(new ArrayBuffer((((of.length + 8) >> 6) + 1) << 6));
  of.forEach((byte, place) => padded.setUint8(place, byte));
  padded.setUint8(of.length, 0x80);
  padded.setUint32(padded.byteLength - 4, of.length << 3);
  const hash = fractions(Math.sqrt, PRIMES.slice(0, 8));
  for (let first = 0; first < padded.byteLength; first += 64) {
    const w = new Int32Array(64);
    let [a, b, c, d, e, f, g, h] = hash;
    ROUNDS.forEach((round, t) => {
      const near = w[t - 15], late = w[t - 2];
      w[t] = t < 16 ? padded.getInt32(first + 4 * t)
        : w[t - 16] + w[t - 7] + (turned(near, 7) ^ turned(near, 18) ^ (near >>> 3)) + (turned(late, 17) ^ turned(late, 19) ^ (late >>> 10));
      const one = h + (turned(e, 6) ^ turned(e, 11) ^ turned(e, 25)) + ((e & f) ^ (~e & g)) + round + w[t];
      const two = (turned(a, 2) ^ turned(a, 13) ^ turned(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
      h = g; g = f; f = e; e = (d + one) | 0; d = c; c = b; b = a; a = (one + two) | 0;
    });
    [a, b, c, d, e, f, g, h].forEach((word, place) => { hash[place] = (hash[place] + word) | 0; });
  }
  return { hexdigest: () => hash.map((word) => (word >>> 0).toString(16).padStart(8, "0")).join("") };
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
  return exact(root);
};
const gcd = (a, b) => (b ? gcd(b, a % b) : a);
/** An exact quotient, in lowest terms. At the left of it a number is a float, at its right a whole one. */
class Rational {
  constructor(over, under) {
    const common = gcd(over, under), by = common < 0n === under < 0n ? common : -common;
    this.over = over / by;
    this.under = under / by;
  }
  get numerator() { return exact(this.over); }
  get denominator() { return exact(this.under); }
  __add__(of, sign = 1n) {
    const { over, under } = rational(of);
    return new Rational(this.over * under + sign * over * this.under, this.under * under);
  }
  __sub__(of) { return this.__add__(of, -1n); }
  __mul__(of) {
    const { over, under } = rational(of);
    return new Rational(this.over * over, this.under * under);
  }
  __truediv__(of) { return this.__mul__(new Rational(rational(of).under, rational(of).over)); }
  __pow__(of) { return new Rational(this.over ** BigInt(of), this.under ** BigInt(of)); }
  __eq__(of) { return this.__sub__(of).over === 0n; }
  valueOf() { return ratio(this.over, this.under); }
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
