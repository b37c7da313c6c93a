// What the figures compute, by our own Python: the stops of a technique, its tape, and what the machine makes of it.
//
//   curve ──► cuts ──► printout, a line of 19 characters a block ──► EIA tape ──► Hydra-Point ──► moves, minutes
//
// Lengths are thousandths of an inch.

import { cut, Settings } from "../../../nc/machine.mjs";
import { part as listed } from "../../../programs/circle.mjs";
import { THESIS } from "../../../programs/header.mjs";
import { Milling, SLOWEST } from "../../../programs/milling.mjs";
import { Printout } from "../../../programs/printout.mjs";
import { pieces as inPieces } from "../../../programs/slope.mjs";
import { arc, line, oval, Point } from "../../../programs/stretches.mjs";
import { encode } from "../../../tapes/eia.mjs";

export const CENTRE = 4000;
export const RADIUS = 1750; // of the path of the cutter's centre, in the listing of Appendix C
export const CIRCLE = { x: CENTRE, y: CENTRE, radius: RADIUS };

/** The place on the circle at so many degrees, from 3 o'clock against the clock's hands. */
export function onCircle(degrees) {
  const angle = (degrees * Math.PI) / 180;
  return { x: CENTRE + RADIUS * Math.cos(angle), y: CENTRE + RADIUS * Math.sin(angle) };
}

/** What the machine does with a printout, in which a space is a zero; its feeds wrong by the parts `x` and `y`. */
function carriedOut(text, x = 0, y = 0) {
  const path = cut(encode(text.replaceAll(" ", "0")), false, new Settings([x, y, 0]));
  const { reading, milling, total } = path.contour;
  const way = [path.cuts[0].start, ...path.cuts.map(({ end }) => end)];
  const stops = path.steps.filter(({ block }) => block.preparatory === 6).map(({ at }) => at);
  return { text, path, way, stops, blocks: path.length, reading: reading / 60, milling: milling / 60, minutes: total / 60 };
}

/** What the machine makes of a curve that is milled by a technique. */
function milled(curve, technique, x = 0, y = 0) {
  const printout = new Printout();
  printout.header(THESIS, curve.start.x, curve.start.y);
  technique.print(printout, curve);
  return carriedOut(printout.text, x, y);
}

/** Chapter 3's slope, 30 degrees and 5 in long. */
export const SLOPE = [new Point(1000, 1000), new Point(5330, 3500)];

/** The slope in `count` equal pieces, at the feeds of two codes of Table 2.4. */
export function pieces(count, xCode, yCode, xError, yError) {
  return carriedOut(inPieces(...SLOPE, count, xCode, yCode), xError, yError);
}

/** The slope by either technique. */
export function slope(tolerance, technique = "step", xError = 0, yError = 0) {
  return milled(line(...SLOPE, tolerance), new Milling(technique), xError, yError);
}

/** `make`, but nothing is made twice. */
export function remembered(make) {
  const made = new Map();
  return (...given) => {
    const key = String(given);
    if (!made.has(key)) made.set(key, make(...given));
    return made.get(key);
  };
}

/** A quarter of the circle, from 9 o'clock to 12, to its very end. */
export const quarter = remembered((tolerance, feed) =>
  milled(arc(new Point(CENTRE, CENTRE), RADIUS, 180, -90, tolerance), new Milling("step", feed)));

/** The whole circle; not `close`, as the listing leaves it, with its last cut missing. */
export function circle(tolerance, close = false) {
  if (!close) return carriedOut(listed(RADIUS, tolerance));
  const limits = (off) => [RADIUS + off, RADIUS + off];
  return milled(oval(new Point(CENTRE, CENTRE), RADIUS, limits(-tolerance), limits(tolerance)), SLOWEST);
}
