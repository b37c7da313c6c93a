// What the figures show, made in Workers: the page stays free meanwhile. A page that is printed makes it at once.

import * as ascii from "../../../tapes/ascii.mjs";
import * as eia from "../../../tapes/eia.mjs";
import { cut } from "../../../nc/machine.mjs";
import { MoveKind } from "../../../nc/path.mjs";
import { Apart } from "../bench/apart.mjs";
import * as method from "../method.mjs";
import { walls } from "./walls.mjs";

const SECONDS = 60; // that one may take
const KEPT = 200;

export const CIRCLE = { x: method.CENTRE, y: method.CENTRE, radius: method.RADIUS };

/** What a Worker makes, by its name, of numbers and words; without classes, which do not come out of it. */
export const WORK = {
  characters: (/** @type {any} */ words, /** @type {string} */ line) => method.characters(words, ascii.encode(line)).map(({ character, rows, waited, punched }) => (
    { character, rows: rows.map(({ address, word, ac }) => ({ address, word, ac })), waited, punched })),
  circle: (/** @type {number} */ tolerance, /** @type {boolean} */ closed) => plain(method.circle(tolerance, closed)),
  circleWalls: (/** @type {boolean} */ closed, /** @type {number} */ cutter) => walls(method.circle(5, closed).way, CIRCLE, (cutter * 1000) / 16, 0, 2 * Math.PI, 36000), // as many as nc/inspection.py has
  drawn: (/** @type {any} */ heights, /** @type {number} */ tolerance) => plain(method.drawn(heights, tolerance)),
  fewest: (/** @type {number[]} */ frames, /** @type {[number, number]} */ ...errors) => plain(method.fewest(frames, ...errors)),
  pieces: (/** @type {Parameters<typeof method.pieces>} */ ...given) => plain(method.pieces(...given)),
  quarter: (/** @type {number} */ tolerance, /** @type {number} */ feed) => plain(method.quarter(tolerance, feed)),
  quarterWalls: (/** @type {number} */ tolerance, /** @type {number} */ cutter, /** @type {number} */ stations) => walls(method.quarter(tolerance, 1).way, CIRCLE, (cutter * 1000) / 16, Math.PI, -Math.PI / 2, stations),
  slope: (/** @type {Parameters<typeof method.slope>} */ ...given) => plain(method.slope(...given)),
  translated: (/** @type {any} */ words, /** @type {string} */ text) => {
    const { elapsed, teletype: { punch: { tape } } } = method.translated(words, ascii.encode(text));
    const [punched, meant] = [tape, eia.encode(text.replaceAll(" ", "0"))].map((frames) => cut(frames).steps);
    const same = punched.length === meant.length && punched.every(({ at: { x, y } }, n) => x === meant[n].at.x && y === meant[n].at.y);
    return { frames: Uint8Array.from(tape), minutes: elapsed / 60, same };
  },
};

export function plain(/** @type {import("../method.mjs").Made} */ { text, way, blocks, reading, milling, minutes, path }) {
  const steps = path.steps.map(({ at: { x, y }, block: { digits, miscellaneous, preparatory }, moves }) => {
    const seconds = moves.filter(({ kind }) => kind === MoveKind.MILL).reduce((sum, move) => sum + move.seconds, 0);
    return { x, y, digits: String(digits), axis: miscellaneous === 84 ? "X" : "Y", mills: preparatory === 6, seconds };
  });
  return { text, way: way.map(({ x, y }) => ({ x, y })), blocks, reading, milling, minutes, steps, stops: steps.filter(({ mills }) => mills), read: path.read_seconds };
}

/** What is not made yet is thrown as this; `answer` is kept when it is. */
export class Wanted extends Error {
  constructor(/** @type {Promise<unknown>} */ answer) {
    super("it is being made");
    this.answer = answer;
  }
}

const kept = new Map();
const [apart, machines] = [new Apart(), new Apart()];
let atOnce = false;

/** What has been made of that name, of what was given. Throws Wanted while it is not there; once, what making it threw.
 *  @template {keyof typeof WORK} K @param {K} what @param {Parameters<(typeof WORK)[K]>} given @returns {ReturnType<(typeof WORK)[K]>} */
export function made(what, ...given) {
  const key = JSON.stringify([what, ...given]);
  if (atOnce && !kept.get(key)?.found) kept.set(key, { found: /** @type {any} */ (WORK)[what](...given) });
  const { found, error, answer } = kept.get(key) ?? {};
  if (found) return found;
  if (error) {
    kept.delete(key); // its Worker may have been late only
    throw error;
  }
  if (answer) throw new Wanted(answer);
  const asked = (what === "translated" ? machines : apart).ask(what, given, SECONDS);
  const wanted = new Wanted(asked.then((made_) => kept.set(key, { found: made_ }), (why) => kept.set(key, { error: why })));
  kept.set(key, wanted);
  if (kept.size > KEPT) kept.delete(kept.keys().next().value);
  throw wanted;
}

/** The same, when it is made.
 *  @template {keyof typeof WORK} K @param {K} what @param {Parameters<(typeof WORK)[K]>} given @returns {Promise<ReturnType<(typeof WORK)[K]>>} */
export async function answered(what, ...given) {
  for (;;) {
    try {
      return made(what, ...given);
    } catch (wanted) {
      if (!(wanted instanceof Wanted)) throw wanted;
      await wanted.answer;
    }
  }
}

/** Let `work` be done with all that it wants made here and now. */
export function withoutWaiting(/** @type {() => void} */ work) {
  atOnce = true;
  try {
    work();
  } finally {
    atOnce = false;
  }
}
