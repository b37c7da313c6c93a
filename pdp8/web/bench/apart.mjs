// Work apart from the page, in a Worker that runs the page's own scripts: no loop of a program stops the page.
//
//     page ── [number, what, given] ──► Worker ── [number, made, why not] ──► page

import { scriptAt } from "../html.mjs";

/** What the page's scripts do in a Worker: `work` by its name. */
export function serve(/** @type {Record<string, (...given: any[]) => any>} */ work) {
  globalThis.onmessage = ({ data: [number, what, given] }) => {
    try {
      globalThis.postMessage([number, work[what](...given)]);
    } catch (/** @type {any} */ error) {
      globalThis.postMessage([number, null, String(error.message ?? error)]);
    }
  };
}

export class Apart {
  constructor() {
    this.asked = new Map();
    this.number = 0;
    /** @type {Worker | null} */ this.worker = null;
    this.unable = false; // whether this browser lets none run
  }

  #begin() {
    this.unable = true;
    const scripts = [...document.querySelectorAll("script.code")].map(({ textContent }) => textContent);
    const url = URL.createObjectURL(new Blob(scripts, { type: "text/javascript" }));
    const worker = this.worker = new Worker(scriptAt(url));
    this.unable = false;
    worker.onerror = ({ message }) => {
      this.unable = true;
      this.#end(message ?? "this browser lets no Worker run");
    };
    worker.onmessage = ({ data: [number, made, why] }) => {
      const { resolve, reject } = this.asked.get(number) ?? {};
      this.asked.delete(number);
      if (why === undefined) resolve?.(made);
      else reject?.(new Error(why));
    };
    return worker;
  }

  /** What the Worker makes of the arguments `given`. Throws its error, or one that says that it takes too long. */
  ask(/** @type {string} */ what, /** @type {unknown[]} */ given, /** @type {number} */ seconds) {
    const worker = this.worker ?? this.#begin();
    const number = this.number++;
    const now = performance.now();
    const due = Math.max(now, ...[...this.asked.values()].map((each) => each.due)) + seconds * 1000; // after what was asked before
    const made = new Promise((resolve, reject) => this.asked.set(number, { due, resolve, reject }));
    worker.postMessage([number, what, given]);
    const late = setTimeout(() => this.#end(`it took more than ${seconds} s, and was ended`), due - now);
    return made.finally(() => clearTimeout(late));
  }

  /** End the Worker, and all that is asked of it; the next question begins another. */
  #end(/** @type {string} */ why) {
    this.worker?.terminate();
    this.worker = null;
    for (const { reject } of this.asked.values()) reject(new Error(why));
    this.asked.clear();
  }
}
