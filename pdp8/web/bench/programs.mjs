// The programs that are kept, by their names, in this browser (IndexedDB). None is ever written over by another: what
// comes from elsewhere under a name that is taken gets a free one.

import { keep, kept } from "./kept.mjs";

const NAME = "pdp8";
const LEFT = "pdp8 left"; // what was typed as the page was left, when IndexedDB has no time

/** Keep a program while the page is being left. */
export function leave(name, text) {
  keep(LEFT, JSON.stringify([name, text]));
}

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

  /** Keep what was typed as the page was left; it is not needed again. */
  resume() {
    const left = kept(LEFT);
    if (left) this.keep(...JSON.parse(left));
    keep(LEFT, "");
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
    return this.#write((store) => store.put(text, name));
  }

  remove(name) {
    this.texts.delete(name);
    return this.#write((store) => store.delete(name));
  }

  /** Keep a program that comes from elsewhere, under a free name if its own is another's; return the name. */
  take(name, text) {
    const [, stem, ending = ""] = /^(.*?)(\.\w+)?$/s.exec(name || "program.pal");
    let free = name;
    for (let number = 2; this.texts.has(free) && this.texts.get(free) !== text; number++) free = `${stem} ${number}${ending}`;
    this.keep(free, text);
    return free;
  }

  async #write(change) {
    try {
      if (this.base) await done(change(this.#store("readwrite")));
    } catch (error) {
      this.refused = String(error?.message ?? error);
    }
  }
}
