// The tour through an afternoon: how long each act is shown, from when on it hurries, what the light falls on, where the camera
// looks. What is told of an act is the afternoon's own (pdp8/replay/story.py).

import { Kind } from "../../replay/day.mjs";
import { TICKS_PER_SECOND as SECOND } from "../../computer/hardware/signals.mjs";

/** Where things stand, in a window that is wider than high, and in one that is higher. */
const PLACES = {
  wide: { mill: { x: 24, y: 12.05 }, panel: { x: 24, y: 2.4 }, teletype: { x: 0, y: 0 } },
  tall: { mill: { x: 1.5, y: 26.4 }, panel: { x: 1.5, y: 0 }, teletype: { x: 0, y: 0.6 } },
};
const ALL = { wide: { x: -1.4, y: 1.5, w: 45.8, h: 23.2 }, tall: { x: -0.5, y: -0.6, w: 23, h: 39.6 } };
const seen = (/** @type {string} */ of, /** @type {any[]} */ ...boxes) => ({ of, boxes: boxes.map(([x, y, w, h]) => ({ x, y, w, h })) });
const PANEL = seen("panel", [-0.6, -0.6, 20.2, 10]);
const EVERYTHING = { of: "", boxes: [] };

/** The acts: seconds, those at the pace of 1971, what is lit, shots as [from which part on, what is seen: wide, narrow].
 *  @type {any[]} */
const ACTS = [
  [6, 6, "panel teletype mill", [0, EVERYTHING]],
  [13, 5, "teletype", [0, seen("teletype", [0.2, 8.9, 17.4, 7.6], [0.2, 5.4, 10.6, 9.6])], [0.34, seen("teletype", [7.8, 7.6, 7.2, 4.9], [7.9, 6.6, 5.6, 6.2])], [0.62, seen("teletype", [-0.5, -0.2, 23, 24.4])]],
  [12, 0, "panel", [0, PANEL], [0.3, seen("panel", [0.3, 0.3, 12.4, 8.4], [0.4, 0.3, 11.4, 8.4])], [0.72, PANEL]],
  [8, 3, "panel teletype", [0, seen("teletype", [0.2, 12.4, 8.4, 6.4], [0.4, 11.6, 6.4, 8.4])], [0.5, PANEL]],
  [7, 2, "panel teletype", [0, PANEL], [0.45, EVERYTHING]],
  [17, 8, "panel teletype", [0, seen("teletype", [-0.6, 9.2, 13, 9.2], [0.1, 9, 6.6, 9.8])], [0.48, PANEL], [0.72, EVERYTHING]],
  [16, 5, "mill", [0, seen("mill", [4.6, 2.6, 9.8, 8], [5, 1.4, 9, 10])], [0.5, seen("mill", [0.4, 0.6, 18.2, 11.2], [3, 0, 13, 12])]],
  [11, 0, "mill", [0, seen("mill", [2.8, 1.9, 13.4, 10.1], [4.2, 1.6, 10.6, 10.4])]],
];
const HURRIES = [3.2, 2.4]; // how steeply an act hurries that was long at its own pace, or short
const LONG = 5; // seconds
const [RISES, ABOVE] = [0.3, 0.44]; // parts of the act of cutting: before anything of the curve is cut, the camera rises above the plate
const PAUSE = 0.4; // seconds between two acts
const BEFORE = { [Kind.TOGGLE]: 58, [Kind.LOAD]: 24, [Kind.TRANSLATE]: 24 }; // seconds of walking and mounting, passed over
const NEAR = 3; // seconds before the cutter goes down

export class Tour {
  constructor(/** @type {import("../../replay/day.mjs").Course} */ day, /** @type {number} */ middle) {
    this.day = day;
    this.middle = middle; // the tick that comes before the story
    this.go(0);
  }

  /** How many acts there are, with what comes before. */
  get length() {
    return ACTS.length;
  }

  /** Go to an act, its first second or a later one. */
  go(/** @type {number} */ turn, part = 0) {
    /** @type {number} */ this.turn = turn;
    /** @type {number} */ this.wall = part * ACTS[turn][0];
  }

  /** Go where a tick is shown; where it is passed over, to what comes next. */
  at(/** @type {number} */ tick) {
    const acts = /** @type {Act[]} */ (this.day.acts);
    const turn = acts.findIndex(({ ends }) => tick < ends);
    this.go(turn < 0 ? acts.length : turn + 1);
    while (this.tick < tick && this.part < 1) this.wall += 0.01;
  }

  /** Let seconds pass; return whether there is more to be seen. */
  pass(/** @type {number} */ seconds) {
    this.wall += seconds;
    if (this.wall <= ACTS[this.turn][0] + PAUSE) return true;
    if (this.turn + 1 === ACTS.length) return false;
    this.go(this.turn + 1);
    return true;
  }

  /** How much of the act is over, 0 to 1. */
  get part() {
    return Math.min(1, this.wall / ACTS[this.turn][0]);
  }

  get #act() {
    return this.day.acts[this.turn - 1];
  }

  /** The afternoon's tick: as it was at first, then ever faster. */
  get tick() {
    if (!this.turn) return this.middle + Math.floor(this.wall * SECOND);
    const [seconds, calm] = ACTS[this.turn];
    const act = this.#act, starts = this.#starts(act);
    const all = (act.ends - starts) / SECOND;
    const wall = Math.min(this.wall, seconds);
    if (wall <= calm) return Math.floor(starts + wall * SECOND);
    const part = (wall - calm) / (seconds - calm);
    const power = calm ? HURRIES[calm > LONG ? 0 : 1] : 1;
    const done = calm ? part ** power * 0.97 + part * 0.03 : part;
    return Math.floor(Math.min(act.ends - 1, starts + (calm + (all - calm) * done) * SECOND));
  }

  /** Where an act begins to be worth looking at. */
  #starts(/** @type {Act} */ { kind, starts }) {
    const { path, mill_starts: mill } = this.day;
    if (kind === Kind.MILL) return mill + ((path.knots.find(({ down }) => down)?.second ?? NEAR) - NEAR) * SECOND;
    return starts + (BEFORE[kind] ?? 0) * SECOND;
  }

  /** How far the camera is above the plate, 0 to 1: it stays there. */
  get above() {
    const cutting = this.turn - (ACTS.length - 2);
    if (cutting) return Math.max(0, cutting);
    const at = Math.max(0, Math.min(1, (this.part - RISES) / (ABOVE - RISES)));
    return at * at * (3 - 2 * at);
  }

  /** Whether the light falls on a thing. */
  lights(/** @type {any} */ name) {
    return ACTS[this.turn][2].includes(name);
  }

  /** What the camera sees now, in inches of the room. */
  box(/** @type {boolean} */ tall) {
    const shots = ACTS[this.turn].slice(3);
    const [, shot] = shots.findLast((/** @type {[number]} */ [from]) => from <= this.part);
    return shot === EVERYTHING ? everything(tall) : framed(shot, tall);
  }
}

export const places = (/** @type {boolean} */ tall) => PLACES[tall ? "tall" : "wide"];
export const everything = (/** @type {boolean} */ tall) => ALL[tall ? "tall" : "wide"];

function framed(/** @type {ReturnType<typeof seen>} */ { of, boxes }, /** @type {boolean} */ tall) {
  const { x, y } = /** @type {Record<string, Place>} */ (places(tall))[of];
  const box = (tall && boxes[1]) || boxes[0];
  return { x: x + box.x, y: y + box.y, w: box.w, h: box.h };
}

/** The panel, as it is seen when it is taken, where there is space for all of it. */
export const atThePanel = (/** @type {boolean} */ tall) => framed(PANEL, tall);

const TAPE = seen("teletype", [0.3, 8.7, 12.4, 5.4], [0.2, 8.4, 10.4, 6]);

/** Punch and paper, while the visitor types. */
export const atTheTape = (/** @type {boolean} */ tall) => framed(TAPE, tall);
