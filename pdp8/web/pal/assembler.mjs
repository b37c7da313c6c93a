// PAL III: the mechanism of DEC-08-ASB1, three passes over the same reading: pal/assembler.py in JavaScript.
//
// The Python module is the authority and says how it works. Names and order are the same here; a test holds both
// together, byte for byte. A method without # is one that notes.mjs extends.

import { PAL_III, PSEUDO_OPERATORS } from "../facts.mjs";
import { octal } from "../written.mjs";
import { SIGNIFICANT, spelled, typed } from "./symbols.mjs";
import { PSEUDO, Stop, SymbolTable, UNDEFINED, VALUE } from "./table.mjs";

export const WORD = "word";
export const ORIGIN = "origin";
export const FIELD = "field";
const CHECKSUM = "checksum";
const { START, PLACES, PUSHED, SAFE } = PAL_III;
const MASK = 0o7777, PAGE = 0o7600, ON_PAGE = 0o177, CURRENT_PAGE = 0o200, INDIRECT = 0o400;
const OPERATORS = new Map([[" ", 0], ["\t", 0], ["+", 1], ["-", -1]]);
const ROUTINES = new Map(Object.entries(PSEUDO_OPERATORS).map(([name, address]) => [address, name]));
const RESUMED = "!"; // a number that goes on after an illegal character begins so

/** One run of PAL III over a source: `run` pass 1, 2 and 3, in this order. */
export class Assembler {
  constructor(source, capacity) {
    this.items = source.items;
    this.feeds = source.feeds;
    this.readsAhead = capacity === PAL_III.HIGH_SPEED_SYMBOLS;
    this.symbols = new SymbolTable(capacity);
    this.pointer = SymbolTable.pageZero(0);
    this.made = false;
    this.letter = false; // whether there was one in the number being read
    this.seen = new Map();
    this.table = [];
    this.lost = [];
    this.stopped = null; // [why it went no further, at which item]
  }

  /** Run pass `number`: {code, subject, location, at}, {punched, location, value} and {listed, word, at}, in order. */
  run(number) {
    this.number = number;
    this.symbols.safe = SAFE[number];
    this.consumed = 0;
    this.output = [];
    this.location = START;
    this.radix = 8;
    this.broken = ""; // the item in which there was an illegal character
    this.checksum = 0;
    this.line = 0; // the first item of the line
    this.pending = [];
    this.places = 1;
    this.table = [];
    this.lost = [];
    try {
      if (number === 2) this.#punch(ORIGIN, START);
      this.#read();
      if (number === 2) this.#punch(CHECKSUM, this.checksum & MASK);
      else this.#listSymbols();
    } catch (error) {
      if (!(error instanceof Stop)) throw error;
      this.stopped = [error.message, this.at];
    }
    return this.output;
  }

  #read() {
    this.clear();
    while (this.consumed < this.items.length) {
      const [item, mark] = this.items[this.consumed++];
      const name = this.broken ? this.#goOn(item) : item;
      if (!name) {
        this.item = 0;
        this.refers = false;
      } else if (!this.#lookUp(name, mark)) {
        continue;
      }
      if (OPERATORS.has(mark)) {
        if (this.made) this.apply();
        this.operator = OPERATORS.get(mark);
      } else if (mark === "\r" || mark === ";") {
        if (this.made) this.apply();
        this.makeWord();
        if (this.pending.length) this.#finish();
        this.write();
        this.clear();
      } else if (mark === ",") {
        this.tag();
      } else if (mark === ".") {
        this.point();
      } else if (mark === "=") {
        this.assign();
      } else if (mark === "*") {
        this.wait("*", 0);
      } else if (mark === "$") {
        break;
      } else {
        this.say("IC", octal(mark.charCodeAt(0) | 0o200));
        this.broken = name;
      }
    }
  }

  clear() {
    this.word = this.address = this.item = this.operator = this.zeros = 0;
    this.made = this.referring = false;
  }

  /** Look an item up; return whether its mark is still to be acted upon. */
  #lookUp(name, mark) {
    this.made = true;
    const { symbols } = this;
    let pointer = symbols.index.get(name);
    if (pointer === undefined) {
      if (name[0] <= "9") {
        this.item = this.#numeral(name);
        this.refers = false;
        return true;
      }
      pointer = symbols.index.get(name.slice(0, SIGNIFICANT));
    }
    if (pointer === undefined) {
      this.pointer = this.#enter(name.slice(0, SIGNIFICANT));
      this.refers = false;
      return true;
    }
    this.pointer = pointer;
    this.item = symbols.words[pointer + VALUE];
    this.refers = pointer < symbols.boundary;
    return pointer >= PSEUDO || this.act(mark);
  }

  /** Do what the pseudo-operator just read says; return whether its mark is still to be acted upon. */
  act(mark) {
    this.#roomFor(1);
    this.made = false;
    const routine = ROUTINES.get(this.item);
    if (routine === "I") {
      this.item = INDIRECT;
      this.made = true;
    } else if (routine === "Z") {
      this.zeros++;
    } else if (routine === "FIELD" || routine === "FIXMRI") {
      this.wait(routine, 0);
      return false;
    } else if (routine === "DECIMAL") {
      this.radix = 10;
    } else if (routine === "OCTAL") {
      this.radix = 8;
    } else if (routine === "PAUSE") {
      if (this.readsAhead && mark !== "\r") this.lose();
    } else if (routine === undefined) {
      throw new Stop(`PAL III goes on at ${octal(this.item)}, where there is no routine`);
    } else if (this.number === 1) {
      if (routine === "EXPUNGE") this.symbols.expunge();
      else this.symbols.fix();
    }
    return true;
  }

  /** Put the item where it belongs: into the word, or by the operator into the address. */
  apply() {
    if (this.places === PLACES) this.#roomFor(1);
    if (this.refers) {
      this.word |= this.item;
      this.referring = true;
    } else if (!this.operator) {
      this.address |= this.item;
    } else {
      this.address = (this.address + this.operator * this.item) & MASK;
    }
  }

  /** `.`: the item is the location, after what was read; the operator stands for both. */
  point() {
    if (this.made) this.apply();
    this.item = this.location;
    this.refers = false;
    this.made = true;
    this.apply();
    this.operator = 0;
  }

  /** Give the word to those that wait for it, the last one first. */
  #finish() {
    this.#roomFor(1);
    while (this.pending.length) {
      const [kind, pointer] = this.pending.pop();
      this.places -= PUSHED[kind];
      this.made = false;
      if (kind === "=") {
        this.symbols.store(pointer + VALUE, this.word);
      } else if (kind === "*") {
        this.location = this.word;
        if (this.number === 2) this.#punch(ORIGIN, this.word);
      } else {
        this.actUpon(kind);
        this.makeWord();
      }
    }
  }

  /** FIELD in pass 2, FIXMRI in pass 1: do it with the word. */
  actUpon(routine) {
    if (routine === "FIELD" && this.number === 2) {
      this.output.push({ punched: FIELD, location: this.location, value: this.word & 7 });
    } else if (routine === "FIXMRI" && this.number === 1) {
      this.symbols.fixReference();
    }
  }

  /** Put word and address together. */
  makeWord() {
    const { address } = this;
    if (!this.referring) {
      this.word = address;
      return;
    }
    this.referring = false;
    const page = address & PAGE;
    if (!page) {
      this.zeros++;
    } else if (this.number !== 1 && page !== (this.location & PAGE)) {
      this.#roomFor(3);
      this.output.push({ code: "IR", subject: octal(address), location: this.location, at: this.at });
    }
    this.address = address & ON_PAGE;
    this.word = (this.word + this.address + (this.zeros ? 0 : CURRENT_PAGE)) & MASK;
  }

  /** Punch or list the statement, and move on by a word if it makes one. */
  write() {
    if (this.number === 3) {
      this.#list(this.at);
    } else if (this.made && this.number === 2) {
      this.#punch(WORD, this.word);
    }
    if (this.made) this.location = (this.location + 1) & MASK;
  }

  #list(at) {
    this.output.push({ listed: this.location, word: this.made ? this.word : null, at });
    let fed = false;
    if (this.items[at][1] === "\r") {
      fed = this.feeds.some((feed) => this.line <= feed && feed <= at);
      this.line = at + 1;
    }
    if (fed || !this.made) this.pointer = SymbolTable.pageZero(0);
  }

  #punch(kind, value) {
    this.output.push({ punched: kind, location: this.location, value });
    this.checksum += (value >> 6) + (value & 0o77) + (kind === ORIGIN ? 0o100 : 0);
    this.pointer = SymbolTable.pageZero(value & 0o77);
  }

  /** `,`: define what the pointer points to as the location. */
  tag() {
    this.made = false;
    if (this.number !== 1) return;
    const { pointer, symbols } = this;
    const first = symbols.word(pointer);
    if (!(first & UNDEFINED)) {
      this.say("DT", typed(spelled(symbols.name(pointer))));
      return;
    }
    symbols.store(pointer, first ^ UNDEFINED);
    this.pointer += VALUE;
    symbols.store(this.pointer, this.location);
  }

  /** `=`: what the pointer points to is defined, and waits for its value. */
  assign() {
    const { pointer, symbols } = this;
    const first = symbols.word(pointer);
    if (!(first & UNDEFINED)) this.say("RD", typed(spelled(symbols.name(pointer))));
    symbols.store(pointer, first & ~UNDEFINED);
    this.wait("=", pointer);
  }

  wait(kind, pointer) {
    this.#roomFor(PUSHED[kind]);
    this.places += PUSHED[kind];
    this.pending.push([kind, pointer]);
  }

  #roomFor(places) {
    if (this.places + places > PLACES) {
      throw new Stop("expressions within expressions take more than the seven places of the push-down list");
    }
  }

  /** Type a message, in pass 1. */
  say(code, subject) {
    this.#roomFor(2);
    if (this.number === 1) this.output.push({ code, subject, location: this.location, at: this.at });
  }

  /** Read on after an illegal character in an item; return the item. */
  #goOn(rest) {
    const name = this.broken;
    this.broken = "";
    if (name[0] <= "9") {
      this.letter &&= !/^\d+$/.test(name);
      return RESUMED + rest;
    }
    this.symbols.spill(rest);
    return name;
  }

  /** The value of a number; 8 and 9 count as 8 and 9 in octal too, and letters are illegal. */
  #numeral(name) {
    const plain = this.radix === 8 ? /^[0-7]+$/ : /^\d+$/;
    if (!plain.test(name) && name[0] !== RESUMED) this.letter = false;
    let value = 0;
    for (const character of name.replace(/^!+/, "")) {
      if (character <= "9" && (!this.letter || plain.test(name))) {
        value = (value * this.radix + Number(character)) & MASK;
        continue;
      }
      if (character > "9") {
        if (this.letter) throw new Stop("PAL III never ends at a second letter in a number");
        this.letter = true;
      }
      this.say("IC", octal(character.charCodeAt(0) & 0o77));
    }
    return value;
  }

  /** Enter a symbol that is not in the table; return where. */
  #enter(name) {
    if (this.symbols.full) {
      this.say("ST", typed(name));
      throw new Stop(`the symbol table is full: there is no room for ${name}`);
    }
    const entry = this.symbols.enter(name, this.location);
    this.seen.set(entry, this.at);
    return entry;
  }

  /** PAUSE: lose what the high-speed reader has read ahead. */
  lose() {
    const first = this.consumed;
    while (this.items[this.consumed++][1] !== "\r");
    this.lost.push([first, this.consumed]);
  }

  /** End the pass; pass 1 gives what is undefined the last address of its page. */
  #listSymbols() {
    const { words } = this.symbols;
    for (const entry of this.symbols.listed()) {
      const value = words[entry + VALUE];
      const undefinedYet = words[entry] & UNDEFINED;
      this.table.push({ name: spelled(this.symbols.name(entry)), value, defined: !undefinedYet, at: this.seen.get(entry) });
      if (undefinedYet) this.#roomFor(2);
      if (undefinedYet && this.number === 1) {
        words[entry] ^= UNDEFINED;
        words[entry + VALUE] = (value & PAGE) | ON_PAGE;
      }
    }
  }

  /** The item read last; what PAUSE loses is not read. */
  get at() {
    const at = this.consumed - 1;
    const last = this.lost.at(-1);
    return last && at === last[1] - 1 ? last[0] - 1 : at;
  }
}
