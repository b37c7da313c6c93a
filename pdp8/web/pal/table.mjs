// The symbol table of PAL III as it stands in core, four words for each symbol: pal/table.py in JavaScript.

import { PAL_III, PSEUDO_OPERATORS, SYMBOLS } from "../facts.mjs";
import { codes, SIGNIFICANT, spelled } from "./symbols.mjs";

export const ENTRY = 4; // words of a symbol
export const VALUE = 3; // the last of them
export const UNDEFINED = 0o4000;

const NAMES = [...Object.entries(PSEUDO_OPERATORS), ...Object.entries(SYMBOLS).map(([name, [word]]) => [name, word])];
export const PSEUDO = Object.keys(PSEUDO_OPERATORS).length * ENTRY; // where the pseudo-operators end
const PERMANENT_END = NAMES.length * ENTRY;
const BOUNDARY = PSEUDO + Object.values(SYMBOLS).filter(([, , reference]) => reference).length * ENTRY;
const BEYOND = 0o10000; // a boundary after any symbol
const { CORE, SPILL, LEFT_THERE } = PAL_III;
const WORDS = NAMES.flatMap(([name, value]) => [...codes(name), value]);
const INDEX = NAMES.map(([name], number) => [name.slice(0, SIGNIFICANT), number * ENTRY]);

/** PAL III goes no further: the table is full, or it writes over itself or never ends. */
export class Stop extends Error {}

/** The symbol table, with room for `capacity` symbols of the source. */
export class SymbolTable {
  constructor(capacity) {
    this.words = [...WORDS, ...new Array((capacity + 1) * ENTRY).fill(0)];
    this.index = new Map(INDEX); // {name: where its symbol begins}
    this.first = this.end = PERMANENT_END; // where those begin that are listed; where the table ends
    this.boundary = BOUNDARY; // where the memory references end
    this.safe = 0; // up to which address of page zero PAL III does not mind what is stored
    this.room = PERMANENT_END + capacity * ENTRY;
  }

  /** The index of a word of page zero. */
  static pageZero(address) {
    return address - CORE;
  }

  get full() {
    return this.end + ENTRY > this.room;
  }

  /** Enter a symbol, undefined; return where. */
  enter(name, value) {
    const entry = this.end;
    const [first, second, third] = codes(name);
    [first | UNDEFINED, second, third, value].forEach((word, place) => (this.words[entry + place] = word));
    this.index.set(name, entry);
    this.end += ENTRY;
    return entry;
  }

  /** The words of a name, without the mark of an undefined one. */
  name(entry) {
    return [this.word(entry) & ~UNDEFINED, this.word(entry + 1), this.word(entry + 2)];
  }

  word(at) {
    if (at < 0) return LEFT_THERE[at + CORE] ?? 0;
    return this.words[at] ?? 0;
  }

  /** Store a word; throw Stop where that breaks PAL III. */
  store(at, word) {
    if (at + CORE <= this.safe) return;
    if (at < 0 || at >= this.words.length) {
      throw new Stop(`PAL III writes over itself, at ${((at + CORE) & 0o7777).toString(8).padStart(4, "0")}`);
    }
    const changed = this.words[at] ^ word;
    this.words[at] = word;
    const place = at % ENTRY;
    if (place !== VALUE && changed & ~(place ? 0 : UNDEFINED)) this.#rename();
  }

  /** Add what follows an illegal character in a name to words of the table. */
  spill(characters) {
    [...characters].forEach((character, number) => {
      const at = SPILL + number;
      this.store(at, (this.word(at) + ((character.charCodeAt(0) & 0o77) << 6)) & 0o7777);
    });
  }

  /** Forget all but the pseudo-operators; what is entered next is a memory reference, until FIXMRI. */
  expunge() {
    this.first = this.end = PSEUDO;
    this.boundary = BEYOND;
    this.#rename();
  }

  /** Leave what is in the table now out of the listing. */
  fix() {
    this.first = this.end;
  }

  /** Move the boundary by one symbol. */
  fixReference() {
    this.boundary = (this.boundary === BEYOND ? PSEUDO : this.boundary) + ENTRY;
  }

  /** Where the symbols stand that are listed, in the order of their names; of equal ones one. */
  listed() {
    const entries = new Map();
    for (let entry = this.end - ENTRY; entry >= this.first; entry -= ENTRY) {
      entries.set(this.name(entry).reduce((key, word) => key * 0o10000 + word), entry);
    }
    return [...entries.keys()].sort((one, other) => one - other).map((key) => entries.get(key));
  }

  #rename() {
    this.index.clear();
    for (let entry = this.end - ENTRY; entry >= 0; entry -= ENTRY) this.index.set(spelled(this.name(entry)), entry);
  }
}
