// The tapes at hand: the bundled ones, those dropped on the page, those punched.

import { bytes } from "../translator/runtime.mjs";
import * as kinds from "../../../tapes/kinds.mjs";

const LOOK = 1000; // frames that say in which code a tape is shown

/** The code in which frames are shown: "ascii", "eia" or "bin". */
export function codeOf(frames) {
  const kind = kinds.classify(bytes(frames.slice(0, LOOK)));
  return kind === kinds.EIA || kind === kinds.ASCII ? kind : "bin";
}

export class Shelf {
  constructor(bundled) {
    this.tapes = new Map();
    this.changed = [];
    for (const [name, frames] of Object.entries(bundled)) this.#add(name, frames.encode("latin-1"));
  }

  #add(name, frames) {
    this.tapes.set(name, { frames, code: codeOf(frames) });
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
    this.#add(free, bytes(frames));
    this.changed.forEach((changed) => changed());
    return free;
  }
}
