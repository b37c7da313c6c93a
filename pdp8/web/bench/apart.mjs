// Work apart from the page, in a Worker that runs the page's own scripts: no loop of a program stops the page.
//
//     page ── [what, given] ──► Worker ── [made, why not] ──► page            a question when the one before is answered

import { scriptAt } from "../html.mjs";

/** What the page's scripts do in a Worker: `work` by its name. */
export function serve(/** @type {Record<string, (...given: any[]) => any>} */ work) {
  globalThis.onmessage = ({ data: [what, given] }) => {
    try {
      globalThis.postMessage([work[what](...given)]);
    } catch (/** @type {any} */ error) {
      globalThis.postMessage([null, String(error.message ?? error)]);
    }
  };
}

export class Apart {
  constructor() {
    this.asked = /** @type {{ what: string; given: unknown[]; seconds: number; resolve: (made: any) => void; reject: (why: Error) => void }[]} */ ([]);
    /** @type {Worker | null} */ this.worker = null;
    this.unable = false; // whether this browser lets none run
  }

  #begin() {
    const { unable } = this;
    this.unable = true;
    const scripts = [...document.querySelectorAll("script.code")].map(({ textContent }) => textContent);
    const url = URL.createObjectURL(new Blob(scripts, { type: "text/javascript" }));
    const worker = this.worker = new Worker(scriptAt(url));
    this.unable = unable;
    worker.onerror = ({ message }) => {
      this.unable = true;
      this.#end(message ?? "this browser lets no Worker run");
    };
    worker.onmessage = ({ data: [made, why] }) => {
      this.unable = false;
      this.#answer(made, why);
    };
    return worker;
  }

  /** What the Worker makes of the arguments `given`. Throws its error, or one that says that it takes too long. */
  ask(/** @type {string} */ what, /** @type {unknown[]} */ given, /** @type {number} */ seconds) {
    return new Promise((resolve, reject) => {
      if (this.asked.push({ what, given, seconds, resolve, reject }) === 1) this.#next();
    });
  }

  /** Give the Worker the first question. */
  #next() {
    const [{ what, given, seconds }] = this.asked;
    try {
      (this.worker ?? this.#begin()).postMessage([what, given]);
      this.late = setTimeout(() => this.#end(`it took more than ${seconds} s, and was ended`), seconds * 1000);
    } catch (/** @type {any} */ error) {
      this.#answer(null, error.message);
    }
  }

  /** Answer the first question, and ask the next. */
  #answer(/** @type {unknown} */ made, why = /** @type {string | undefined} */ (undefined)) {
    clearTimeout(this.late);
    const first = this.asked.shift();
    if (why === undefined) first?.resolve(made);
    else first?.reject(new Error(why));
    if (this.asked.length) this.#next();
  }

  /** End the Worker, and what it is at; the next question begins another. */
  #end(/** @type {string} */ why) {
    this.worker?.terminate();
    this.worker = null;
    this.#answer(null, why);
  }
}
