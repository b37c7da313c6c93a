// The tapes at hand: the bundled ones, those dropped on the page, those punched.

import { bytes } from "../translator/runtime.mjs";
import * as kinds from "../../../tapes/kinds.mjs";

const LOOK = 1000; // frames that say in which code a tape is shown

/** The code in which frames are shown: "ascii", "eia" or "bin". */
export function codeOf(frames) {
  const kind = kinds.classify(bytes(frames.slice(0, LOOK)));
  return kind === kinds.EIA || kind === kinds.ASCII ? kind : "bin";
}

/** `name`, or the first free one of "name 2", "name 3" ... */
export function free(name, taken) {
  const [, stem, ending = ""] = /^(.*?)(\.\w+)?$/s.exec(name);
  let found = name;
  for (let number = 2; taken(found); number++) found = `${stem} ${number}${ending}`;
  return found;
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
    const called = free(name, (each) => this.tapes.has(each));
    this.#add(called, bytes(frames));
    this.changed.forEach((changed) => changed());
    return called;
  }

  /** Let a tape for a reader be chosen in `select`; `mount(name)` puts it in. */
  offer(select, mount) {
    const show = () => {
      const names = this.names().filter((name) => !name.endsWith(".pal"));
      select.replaceChildren(new Option("Put a tape in …", ""), ...names.map((name) => new Option(name, name)));
    };
    select.addEventListener("change", () => {
      if (select.value) mount(select.value);
      select.value = "";
    });
    this.changed.push(show);
    show();
  }
}
