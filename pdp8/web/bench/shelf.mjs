// The tapes at hand: the bundled ones, those dropped on the page, those punched.

import { bytes } from "../translator/runtime.mjs";
import { translation } from "../translation.mjs";
import { recognise } from "../../../tapes/codes.mjs";

const NEWEST = 20; // tapes that are kept
const LOOK = 1000; // frames that say in which code a tape is shown
const LEADER = 100; // as many before them, if there are

/** The code in which frames are shown. */
export function codeOf(/** @type {Bytes | number[] | Uint8Array} */ frames) {
  const first = frames.findIndex((frame) => (frame & 0o177) % 0o177 > 0); // blanks, leader and RUBOUTs may be yards long
  const at = Math.max(0, first - LEADER);
  return recognise(bytes(frames.slice(at, at + LOOK)));
}

const codes = /** @type {WeakMap<Bytes, Code>} */ (new WeakMap());
/** The same, of a tape that nobody punches any more. */
export function codeFor(/** @type {Bytes} */ tape) {
  if (!codes.has(tape)) codes.set(tape, codeOf(tape));
  return /** @type {Code} */ (codes.get(tape));
}

/** `name`, or the first free one of "name 2", "name 3" ... */
export function free(/** @type {string} */ name, /** @type {(name: string) => boolean} */ taken) {
  const [, stem, ending = ""] = /** @type {RegExpExecArray} */ (/^(.*?)(\.\w+)?$/s.exec(name));
  let found = name;
  for (let number = 2; taken(found); number++) found = `${stem} ${number}${ending}`;
  return found;
}

/** What the lists of the page offer that name some tapes: data-tapes. */
const OFFERED = { any: (/** @type {string} */ name, /** @type {Shelf} */ { sources }) => !sources.includes(name), eia: (/** @type {string} */ name, /** @type {Shelf} */ shelf) => shelf.get(name).code.name === "eia" };

/** Whether two tapes have the same frames. */
const same = (/** @type {Bytes} */ one, /** @type {Uint8Array} */ other) => one.length === other.length && one.every((/** @type {number} */ frame, /** @type {number} */ at) => frame === other[at]);

/** A tape, as a text, its frames, or a function that makes them: what it is, is asked when it is wanted. */
class Tape {
  constructor(/** @type {any} */ content) {
    this.content = content;
  }

  get frames() {
    if (typeof this.content === "string") this.content = this.content.encode("latin-1");
    else if (typeof this.content === "function") this.content = this.content();
    return this.content;
  }

  get code() {
    return codeFor(this.frames);
  }
}

export class Shelf {
  constructor(/** @type {Record<string, string | null>} */ bundled) {
    this.tapes = new Map();
    this.bundled = Object.keys(bundled);
    for (const [name, frames] of Object.entries(bundled)) this.#add(name, frames ?? (() => translation(this.get(name.replace(".eia", ".asc")).frames)));
  }

  #add(/** @type {string} */ name, /** @type {string | Uint8Array | (() => Bytes)} */ frames) {
    this.tapes.set(name, new Tape(frames));
  }

  offer() {
    /** @type {NodeListOf<HTMLSelectElement>} */
    const lists = document.querySelectorAll("select[data-tapes]");
    for (const list of lists) {
      const { value } = list;
      const names = this.names().filter((name) => /** @type {any} */ (OFFERED)[String(list.dataset.tapes)](name, this));
      list.replaceChildren(list.options[0], ...names.map((name) => new Option(name, name)));
      list.value = value;
    }
  }

  /** The bundled programs, which are opened. */
  get sources() {
    return this.bundled.filter((name) => name.endsWith(".pal"));
  }

  /** The tapes that are not bundled, the newest of them, a character a frame. */
  get kept() {
    const own = this.names().filter((name) => !this.bundled.includes(name)).slice(-NEWEST);
    return own.map((name) => [name, Array.from(this.get(name).frames, (frame) => String.fromCharCode(frame)).join("")]);
  }

  set kept(own) {
    for (const [name, frames] of own) this.#add(name, frames);
    this.offer();
  }

  names() {
    return [...this.tapes.keys()];
  }

  get(/** @type {string} */ name) {
    return this.tapes.get(name);
  }

  /** Put a tape onto the shelf, under another name if that is taken by another tape; return the name. */
  put(/** @type {string} */ name, /** @type {Uint8Array} */ frames) {
    const called = free(name, (each) => this.tapes.has(each) && !same(this.get(each).frames, frames));
    if (!this.bundled.includes(called)) {
      this.tapes.delete(called); // it is the newest
      this.#add(called, bytes(frames));
    }
    this.offer();
    return called;
  }
}
