// The tapes at hand: the bundled ones, those dropped on the page, those punched.

import { ASCII, EIA, LEADER } from "../facts.mjs";

export class Shelf {
  constructor(bundled) {
    this.tapes = new Map();
    this.changed = [];
    for (const [name, frames] of Object.entries(bundled)) {
      this.#add(name, Uint8Array.from(atob(frames), (character) => character.charCodeAt(0)));
    }
  }

  #add(name, frames) {
    this.tapes.set(name, { frames, code: this.codeOf(frames) });
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

  /** The code in which a tape is shown: by its first frames that say something. */
  codeOf(frames) {
    const some = [...frames.slice(0, 200)].filter((frame) => frame !== 0 && frame !== LEADER);
    if (frames[0] === LEADER || (frames.length > 2 && frames[1] === LEADER)) return "bin";
    const share = (test) => some.filter(test).length / (some.length || 1);
    if (share((frame) => frame in EIA) > 0.9 && share((frame) => frame & 0o200) < 0.5) return "eia";
    return share((frame) => (frame & 0o177) >= ASCII.space || [ASCII.CR, ASCII.LF].includes(frame & 0o177)) > 0.9 ? "ascii" : "bin";
  }
}
