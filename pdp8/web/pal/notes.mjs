// Where a source means something else to PAL III than it says: pal/notes.py in JavaScript.
//
// The Python module is the authority. Names, order and words are the same here; a test holds both together, byte for
// byte.

import { ISA, PSEUDO_OPERATORS } from "../facts.mjs";
import { octal } from "../written.mjs";
import { Assembler, WORD } from "./assembler.mjs";
import { spelled } from "./symbols.mjs";
import { ENTRY, PSEUDO, UNDEFINED, VALUE } from "./table.mjs";

const { ADDRESS, PAGE } = ISA;
const POINTER = "PAL III takes the symbol it looked up last; write the symbol directly before";
const LOST_OPERATOR = "a space is an operator too, and the last one counts; leave no space after + or -";

/** What is to be noted of a source of so many tapes, each {at, message, advice}: at which item, and what to do. */
export function notes(source, tapes, capacity) {
  const watched = new Watched(source, capacity);
  for (const number of [1, 2, 3]) {
    watched.run(number);
    if (watched.stopped) return watched.notes;
  }
  const { ended } = watched;
  return [...watched.notes, ...lostOperators(source.items.slice(0, ended)), ...ofTheEnd(source, tapes, ended)];
}

function lostOperators(items) {
  const found = [];
  for (let at = 1; at < items.length - 1; at++) {
    const [before, blank, after] = items.slice(at - 1, at + 2);
    if ("+-".includes(before[1]) && blank[0] === "" && " \t".includes(blank[1]) && (after[0] || after[1] === ".")) {
      found.push({ at, message: "this makes an inclusive OR of it", advice: LOST_OPERATOR });
    }
  }
  return found;
}

function ofTheEnd(source, tapes, ended) {
  if (ended === source.items.length - 1) {
    const advice = "PAL III would wait for more tape; it is taken as if there were one";
    return [{ at: Math.max(ended - 1, 0), message: "no $ at the end", advice }];
  }
  const unread = tapes - 1 - source.place(ended).tape;
  if (!unread) return [];
  const message = `${unread} more tape${unread > 1 ? "s" : ""} not read`;
  return [{ at: ended, message, advice: "$ ends the source; on a tape that others follow, PAUSE stands instead" }];
}

/** The assembler with an eye on what it makes of a source: `notes`, and the item where it `ended`. */
class Watched extends Assembler {
  #twice = new Set();
  #assigned = 0;
  #expunged = null;
  #onTape = [];
  #begun = 0;
  #applied = false;
  #operated = false;
  #swallowed = null;
  #kept = null;

  constructor(source, capacity) {
    super(source, capacity);
    this.notes = [];
    this.ended = 0;
  }

  /** Run a pass, then look at what it made. */
  run(number) {
    const output = super.run(number);
    if (this.stopped) return output;
    this.ended = this.at;
    if (number === 1) {
      this.#lookAtReferences();
    } else if (number === 2) {
      this.#onTape = output.filter(({ punched }) => punched === WORD).map(({ value }) => value);
      if (this.made || this.#applied) this.#note("what stands before this $ is lost", "put the $ on its own line");
    } else {
      this.#compare(output.filter(({ listed, word }) => listed !== undefined && word !== null));
    }
    return output;
  }

  #lookAtReferences() {
    if (this.#expunged !== null && this.symbols.boundary > this.symbols.end && this.table.length) {
      const advice = "define the memory references first after EXPUNGE, each with FIXMRI";
      const message = "with EXPUNGE and no FIXMRI every symbol is a memory reference";
      this.notes.push({ at: this.#expunged, message, advice });
    }
  }

  /** Note the first word that pass 2 and pass 3 see differently. */
  #compare(listed) {
    const index = listed.findIndex(({ word }, number) => number < this.#onTape.length && word !== this.#onTape[number]);
    if (index < 0) return;
    const { word, at } = listed[index];
    const message = `this is ${octal(this.#onTape[index])} on the tape and ${octal(word)} in the listing`;
    this.notes.push({ at, message, advice: "each pass assigns again, with the values that the last one left" });
  }

  /** Note something once, in pass 2, when all values are known. */
  #note(message, advice) {
    if (this.number === 2) this.notes.push({ at: this.at, message, advice });
  }

  get #name() {
    return this.items[this.at][0];
  }

  /** Whether a symbol stands before the mark just read, if with blanks between. */
  get #hasSymbol() {
    let { at } = this;
    while (at > this.#begun && !this.items[at][0] && " \t".includes(this.items[at - 1][1])) at--;
    return this.items[at][0].slice(0, 1) > "9";
  }

  get #soFar() {
    return this.word | this.address;
  }

  clear() {
    super.clear();
    this.#begun = this.at + 1;
    this.#applied = this.#operated = false;
    this.#swallowed = null;
    this.#kept = null;
  }

  say(code, subject) {
    super.say(code, subject);
    if (code === "DT" || code === "RD") this.#twice.add(this.pointer);
  }

  act(mark) {
    const routine = Object.keys(PSEUDO_OPERATORS)[this.pointer / ENTRY];
    if (this.number === 1 && routine === "EXPUNGE") this.#lookAtForgotten();
    if (this.number === 1 && routine === "FIXTAB") this.#lookAtUndefined();
    if (this.#applied && !["I", "FIELD", "FIXMRI"].includes(routine)) this.#swallowed = [this.at, routine];
    if (["FIELD", "FIXMRI"].includes(routine) && !" \t".includes(mark)) {
      const what = "\r;".includes(mark) ? "the next statement" : `what follows the ${mark}`;
      this.#note(`${routine} takes ${what}`, `write a space and the operand after ${routine}`);
    }
    return super.act(mark);
  }

  #lookAtForgotten() {
    this.#expunged = this.at;
    if (this.symbols.end > this.symbols.first) {
      const message = "EXPUNGE forgets the symbols that the source has used before";
      this.notes.push({ at: this.at, message, advice: "put it first" });
    }
  }

  #lookAtUndefined() {
    const { words } = this.symbols;
    const names = [];
    for (let entry = this.symbols.first; entry < this.symbols.end; entry += ENTRY) {
      if (words[entry] & UNDEFINED) names.push(spelled(this.symbols.name(entry)));
    }
    if (names.length) {
      const message = `FIXTAB keeps what is not defined yet: ${names.join(" ")}`;
      const advice = "it is in no symbol table and gets no UA; put FIXTAB after the definitions";
      this.notes.push({ at: this.at, message, advice });
    }
  }

  apply() {
    if (this.refers && this.pointer >= PSEUDO) {
      this.#operated = true;
      if (this.address && this.#kept === null) {
        this.#note(
          `what stands before ${this.#name} is part of its address`,
          "write what belongs to the address after the instruction, and nothing else beside it",
        );
      }
    }
    this.#applied = true;
    super.apply();
  }

  point() {
    if (this.made && this.operator && this.#name) {
      const sign = this.operator > 0 ? "+" : "-";
      const message = `the ${sign} is used for ${this.#name} and for the location`;
      this.#note(message, "write the location first, or a space before the point");
    }
    super.point();
  }

  makeWord() {
    if (this.referring && !this.#operated) {
      const message = "I without a memory-reference symbol makes an AND";
      this.#note(message, "write the instruction before I");
    }
    const page = this.address & PAGE;
    if (this.referring && this.zeros && page && page === (this.location & PAGE)) {
      const message = `Z makes this refer to ${octal(this.address & ADDRESS)} on page zero`;
      this.#note(message, `for ${octal(this.address)}, on this page, leave out Z`);
    }
    super.makeWord();
  }

  write() {
    if (this.number === 2 && this.#swallowed && !this.made) {
      const [at, routine] = this.#swallowed;
      const message = `${routine} at the end of a statement leaves no word`;
      const advice = routine !== "Z" ? "put it on its own line" : "write Z before the address";
      this.notes.push({ at, message, advice });
    }
    if (this.number === 2 && this.#kept !== null && this.made) {
      const message = "what stands before this comma is part of the word";
      const advice = "a space puts even the tag there; write the tag first, the comma directly after it";
      this.notes.push({ at: this.#kept, message, advice });
    }
    super.write();
  }

  tag() {
    if (this.#soFar) this.#kept = this.at;
    if (!this.#hasSymbol) this.#note("no symbol stands before this comma", POINTER);
    const value = this.symbols.word(this.pointer + VALUE);
    if (this.#name.slice(0, 1) > "9" && value !== this.location && !this.#twice.has(this.pointer)) {
      const message = `${this.#name} is ${octal(value)} from pass 1, and stands at ${octal(this.location)} in pass 2`;
      this.#note(message, "an origin depends on a symbol that is defined after it; define it first");
    }
    super.tag();
  }

  assign() {
    if (!this.#hasSymbol) {
      this.#note("no symbol stands before this equals sign", POINTER);
    } else if (this.#soFar) {
      const message = `what stands before the equals sign, ${octal(this.#soFar)}, is part of the value`;
      this.#note(message, "a space puts even the symbol there; write the equals sign directly after it");
    }
    this.#assigned = this.pointer;
    super.assign();
  }

  wait(kind, pointer) {
    if (kind === "*" && this.#name) {
      this.#note(`${this.#name} before the asterisk has no effect`, "put the origin on its own line");
    } else if ((kind === "*" || kind === "FIELD") && this.#soFar) {
      const message = `what stands before it, ${octal(this.#soFar)}, is part of the operand`;
      this.#note(message, "put it on its own line");
    }
    super.wait(kind, pointer);
  }

  actUpon(routine) {
    const { boundary } = this.symbols;
    super.actUpon(routine);
    const moved = this.symbols.boundary;
    if (moved === boundary || moved === this.#assigned + ENTRY) return;
    const name = spelled(this.symbols.name(moved - ENTRY));
    const message = `FIXMRI makes ${name} a memory reference, whatever it defines`;
    this.notes.push({ at: this.at, message, advice: "use it for the first definitions after EXPUNGE" });
  }

  lose() {
    super.lose();
    const [first, after] = this.lost.at(-1);
    if (this.items.slice(first, after).some(([name, mark]) => name || !" \t\r".includes(mark))) {
      this.#note("what follows PAUSE on its line is lost", "end the line after PAUSE");
    }
  }
}
