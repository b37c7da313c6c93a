// What this browser keeps for the page, by name: programs, marks, answers, a teacher's exercises; and a few settings. One that
// keeps nothing for a page from disk does no harm. The store is read anew each time: another tab may have written there.
// Panes in a frame have settings of their own.

import { EMBED, RESTS } from "./alone.mjs";
import { free } from "./shelf.mjs";

const OF = EMBED && ` of ${EMBED}`;

/** Keep a setting, for this tab's next reload and for the next visit; return why this browser does not. */
export function keep(/** @type {string} */ name, /** @type {string} */ text) {
  try {
    if (!RESTS) for (const store of [sessionStorage, localStorage]) store.setItem(name + OF, text);
    return "";
  } catch (/** @type {any} */ error) {
    return String(error.message ?? error);
  }
}

export function kept(/** @type {string} */ name) {
  try {
    return RESTS ? null : sessionStorage.getItem(name + OF) ?? localStorage.getItem(name + OF);
  } catch {
    return null;
  }
}

export class Store {
  /** `changed` is called when another tab has written or deleted one of this kind, with its name.
   *  @param {string} kind
   *  @param {(name: string) => void} [changed] */
  constructor(kind, changed) {
    this.prefix = `pdp8 ${kind}: `;
    this.held = new Map(); // what the browser does not keep
    this.refused = keep("pdp8", ""); // why not; "" once all is kept
    addEventListener("storage", ({ key }) => key?.startsWith(this.prefix) && changed?.(key.slice(this.prefix.length)));
  }

  names() {
    let keys = /** @type {string[]} */ ([]);
    try {
      if (!RESTS) keys = Object.keys(localStorage).filter((key) => key.startsWith(this.prefix)).map((key) => key.slice(this.prefix.length));
    } catch { /* it keeps nothing */ }
    return [...new Set([...keys, ...this.held.keys()])].sort();
  }

  /** The text of that name; undefined if there is none. */
  get(/** @type {string} */ name) {
    if (this.held.has(name)) return this.held.get(name);
    try {
      return (RESTS ? null : localStorage.getItem(this.prefix + name)) ?? undefined;
    } catch {
      return undefined;
    }
  }

  /** What the text of that name says in JSON; null if it says nothing. */
  read(/** @type {string} */ name) {
    try {
      return JSON.parse(this.get(name) ?? "null");
    } catch {
      return null;
    }
  }

  /** Keep a text, in place of what it was; and what was refused before. */
  keep(/** @type {string} */ name, /** @type {string} */ text) {
    this.held.set(name, text);
    if (RESTS) return;
    this.refused = "";
    for (const [each, there] of this.held) {
      try {
        localStorage.setItem(this.prefix + each, there);
        this.held.delete(each);
      } catch (/** @type {any} */ error) {
        this.refused = String(error.message ?? error);
      }
    }
  }

  remove(/** @type {string} */ name) {
    this.held.delete(name);
    if (!this.held.size) this.refused = "";
    try {
      if (!RESTS) localStorage.removeItem(this.prefix + name);
    } catch { /* it kept nothing */ }
  }

  /** Keep a text that comes from elsewhere, under a free name if its own is another's; return the name. */
  take(/** @type {string} */ name, /** @type {string} */ text) {
    const called = free(name, (each) => (this.get(each) ?? text) !== text);
    this.keep(called, text);
    return called;
  }
}
