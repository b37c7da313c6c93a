// What a reload or the next visit restores: of each part its property `kept`, which can be set.
//
//     the page is left ──► {part: kept} ──► this tab's store, for its reload, and the browser's, for the next visit
//
// What the browser refuses to keep, it asks about before the page is left; also blocks of a reel that are in no file.

import { keep, kept } from "./store.mjs";

const SESSION = "pdp8 session";

export class Session {
  /** `parts` by their names, in the order in which they are found again. */
  constructor(/** @type {Bench} */ bench, /** @type {Record<string, any>} */ parts) {
    this.bench = bench;
    this.parts = parts;
    addEventListener("pagehide", () => this.keep());
    document.addEventListener("visibilitychange", () => document.hidden && this.keep());
    addEventListener("beforeunload", (event) => {
      const { exercises: { answers, given, marks }, programs, drives } = this.bench;
      const refused = this.keep() || [programs, answers, given, marks].some((store) => store.refused);
      if (refused || drives.units.some((_, unit) => drives.unsaved(unit))) event.preventDefault();
    });
  }

  /** Keep all; return why the browser does not. */
  keep() {
    this.bench.editor.keep();
    const parts = Object.entries(this.parts).map(([name, part]) => [name, part.kept]);
    return keep(SESSION, JSON.stringify(Object.fromEntries(parts)));
  }

  /** Find again what was kept; what cannot be is as in a new page. Return whether there was anything. */
  open() {
    let found = null;
    try {
      found = JSON.parse(String(kept(SESSION)));
    } catch { /* it is damaged */ }
    for (const [name, part] of Object.entries(this.parts)) {
      try {
        if (found?.[name] !== undefined && found[name] !== null) part.kept = found[name];
      } catch { /* it was kept by another page */ }
    }
    return Boolean(found);
  }
}
