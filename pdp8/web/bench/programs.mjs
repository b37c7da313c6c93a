// What this browser keeps for the page: programs by their names, and a few settings. One that keeps nothing for a page from
// disk does no harm. No program is ever written over by another: what comes from elsewhere under a name that is taken
// gets a free one.

import { RESTS } from "./alone.mjs";
import { free } from "./shelf.mjs";

const PROGRAM = "pdp8 program: ";

/** Keep a setting, as long as the page is open at least; return why no longer. */
export function keep(name, text) {
  try {
    if (text === null) localStorage.removeItem(name);
    else if (!RESTS) localStorage.setItem(name, text);
    return "";
  } catch (error) {
    return String(error.message ?? error);
  }
}

export function kept(name) {
  try {
    return RESTS ? null : localStorage.getItem(name);
  } catch {
    return null;
  }
}

export class Programs {
  constructor() {
    this.texts = new Map();
    this.refused = keep("pdp8", ""); // why this browser keeps nothing
    const keys = this.refused || RESTS ? [] : Object.keys(localStorage).filter((key) => key.startsWith(PROGRAM));
    for (const key of keys) this.texts.set(key.slice(PROGRAM.length), kept(key));
  }

  names() {
    return [...this.texts.keys()].sort();
  }

  get(name) {
    return this.texts.get(name);
  }

  /** Keep a program, in place of what it was. */
  keep(name, text) {
    this.texts.set(name, text);
    this.refused = keep(PROGRAM + name, text);
  }

  remove(name) {
    this.texts.delete(name);
    keep(PROGRAM + name, null);
  }

  /** Keep a program that comes from elsewhere, under a free name if its own is another's; return the name. */
  take(name, text) {
    const called = free(name, (each) => this.texts.has(each) && this.texts.get(each) !== text);
    this.keep(called, text);
    return called;
  }
}
