// The programs that are kept, by their names, in this browser (IndexedDB). None is ever written over by another: what
// comes from elsewhere under a name that is taken gets a free one.

import { keep, kept } from "./kept.mjs";
import { free } from "./shelf.mjs";

const NAME = "pdp8";
const LEFT = "pdp8 left"; // what was not yet written as the page was left, when IndexedDB has no time

/** What IndexedDB makes of a request. */
function done(request) {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });
}

export class Programs {
  constructor() {
    this.texts = new Map();
    this.unwritten = new Map(); // {name: text, or null for one that goes}: what IndexedDB has not confirmed
    this.refused = ""; // why this browser keeps nothing
  }

  /** Read what is kept. */
  async open() {
    try {
      const asked = indexedDB.open(NAME, 1);
      asked.onupgradeneeded = () => asked.result.createObjectStore("programs");
      this.base = await done(asked);
      const [names, texts] = await Promise.all([done(this.#store("readonly").getAllKeys()), done(this.#store("readonly").getAll())]);
      names.forEach((name, index) => this.texts.set(name, texts[index]));
      this.resume();
    } catch (error) {
      this.base = null;
      this.refused = String(error?.message ?? error);
    }
  }

  /** Keep what was not yet written as the page was left; it is not needed again. */
  resume() {
    for (const [name, text] of JSON.parse(kept(LEFT) || "[]")) {
      if (text === null) this.remove(name);
      else this.keep(name, text);
    }
    keep(LEFT, "");
  }

  /** The page is being left: keep what is not yet written, and `name` if it is not as it is typed. */
  leave(name, text) {
    if (this.get(name) !== text) this.unwritten.set(name, text);
    if (this.unwritten.size) keep(LEFT, JSON.stringify([...this.unwritten]));
  }

  #store(mode) {
    return this.base.transaction("programs", mode).objectStore("programs");
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
    return this.#write(name, text);
  }

  remove(name) {
    this.texts.delete(name);
    return this.#write(name, null);
  }

  /** Keep a program that comes from elsewhere, under a free name if its own is another's; return the name. */
  take(name, text) {
    const called = free(name, (each) => this.texts.has(each) && this.texts.get(each) !== text);
    this.keep(called, text);
    return called;
  }

  async #write(name, text) {
    if (!this.base) return;
    this.unwritten.set(name, text);
    try {
      const { transaction } = text === null ? this.#store("readwrite").delete(name) : this.#store("readwrite").put(text, name);
      await new Promise((resolve, reject) => {
        transaction.oncomplete = resolve;
        transaction.onabort = () => reject(transaction.error);
      });
      if (this.unwritten.get(name) === text) this.unwritten.delete(name);
    } catch (error) {
      this.refused = String(error?.message ?? error);
    }
  }
}
