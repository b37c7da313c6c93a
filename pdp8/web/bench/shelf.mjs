// The tapes at hand: the bundled ones, those dropped on the page, those punched.

import * as kinds from "./kinds.mjs";

export class Shelf {
  constructor(bundled) {
    this.tapes = new Map();
    this.changed = [];
    for (const [name, frames] of Object.entries(bundled)) {
      this.#add(name, Uint8Array.from(atob(frames), (character) => character.charCodeAt(0)));
    }
  }

  #add(name, frames) {
    this.tapes.set(name, { frames, code: kinds.codeOf(frames) });
  }

  names() {
    return [...this.tapes.keys()];
  }

  get(name) {
    return this.tapes.get(name);
  }

  /** Put a tape onto the shelf, under another name if that is taken by another tape; return the name. */
  put(name, frames) {
    const [, stem, ending] = /^(.*?)(\.\w+)?$/.exec(name);
    let free = name;
    for (let number = 2; this.tapes.has(free); number++) free = `${stem} ${number}${ending ?? ""}`;
    this.#add(free, frames);
    this.changed.forEach((changed) => changed());
    return free;
  }
}
