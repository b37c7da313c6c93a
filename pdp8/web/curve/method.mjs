// What the figures compute, by our own Python: the stops of a technique, its tape, and what the machine makes of it.
//
//   curve ──► cuts ──► printout, a line of 19 characters a block ──► EIA tape ──► Hydra-Point ──► moves, minutes
//
// Lengths are thousandths of an inch.

import { cut, Settings } from "../../../nc/machine.mjs";
import { MoveKind } from "../../../nc/path.mjs";
import { THESIS } from "../../../programs/header.mjs";
import { Milling, _print } from "../../../programs/milling.mjs";
import { Printout } from "../../../programs/printout.mjs";
import { cuts, staircase } from "../../../programs/stepwise.mjs";
import { arc, line, oval, Point } from "../../../programs/stretches.mjs";
import { encode } from "../../../tapes/eia.mjs";
import { Block } from "../../../tapes/hydrapoint.mjs";

export const CENTRE = 4000;
export const RADIUS = 1750; // of the path of the cutter's centre, in the listing of Appendix C
const ERRORS = (x, y) => new Settings([x, y, 0]);

/** The tape of a printout: what the PDP-8/L makes of it, in which a space is a zero. */
export function punched(text) {
  return encode(text.replaceAll(" ", "0"));
}

/** What the machine does with a printout, its feeds wrong by the parts `x` and `y`. */
export function carriedOut(text, x = 0, y = 0) {
  const path = cut(punched(text), false, ERRORS(x, y));
  const { reading, milling } = path.contour;
  const milled = path.moves.filter(({ kind }) => kind === MoveKind.MILL);
  const way = milled.length ? [milled[0].start, ...milled.map(({ end }) => end)] : [];
  const stops = path.steps.filter(({ block }) => block.preparatory === 6).map(({ at }) => at);
  return { text, path, way, stops, blocks: path.length, reading: reading / 60, milling: milling / 60, minutes: path.contour.total / 60 };
}

/** Chapter 3's slope, 30 degrees and 5 in long. */
export const SLOPE = [new Point(1000, 1000), new Point(5330, 3500)];

/** The slope in `pieces` equal parts, each a block with both axes moving, at the feeds of two codes of Table 2.4. */
export function pieces(count, xCode, yCode, xError, yError) {
  const [from, to] = SLOPE;
  const printout = opened(from);
  feeds(printout, from, xCode, yCode);
  for (let piece = 1; piece <= count; piece++) {
    const at = (a, b) => Math.round(a + ((b - a) * piece) / count);
    mill(printout, at(from.x, to.x), at(from.y, to.y), yCode, 85);
  }
  return carriedOut(printout.text, xError, yError);
}

function feeds(printout, { x, y }, xCode, yCode) {
  mill(printout, x, y, xCode, 84);
  mill(printout, x, y, yCode, 85);
}

function mill(printout, x, y, code, axis) {
  printout.digits(new Block((printout.blocks + 1) % 1000, 6, x, y, 0, code, axis));
}

function opened(start) {
  const printout = new Printout();
  printout.header(THESIS, start.x, start.y);
  return printout;
}

/** How far the furthest place of a way is from the slope, at right angles; with that place. */
export function furthest(way) {
  const [from, to] = SLOPE;
  const [across, up] = [to.x - from.x, to.y - from.y];
  let [worst, where] = [0, way[0]];
  for (const place of way) {
    const off = Math.abs(across * (place.y - from.y) - up * (place.x - from.x)) / Math.hypot(across, up);
    if (off > worst) [worst, where] = [off, place];
  }
  return { worst, where };
}

/** The slope by either technique, as the part program makes its blocks. */
export function slope(tolerance, technique = "step", xError = 0, yError = 0, allowed = 0.2) {
  const curve = line(...SLOPE, tolerance);
  const printout = opened(curve.start);
  new Milling(technique, 1, 5, "boundary", allowed).print(printout, curve);
  return carriedOut(printout.text, xError, yError);
}

/** A quarter of the circle, from 9 o'clock to 12, to its very end. */
export function quarter(tolerance, feed) {
  const curve = arc(new Point(CENTRE, CENTRE), RADIUS, 180, -90, tolerance);
  const printout = opened(curve.start);
  new Milling("step", feed).print(printout, curve);
  return carriedOut(printout.text);
}

/** The whole circle; not `close`, as the listing leaves it, with its last cut missing. */
export function circle(tolerance, feed = 1, close = false) {
  const limits = (off) => [RADIUS + off, RADIUS + off];
  const curve = oval(new Point(CENTRE, CENTRE), RADIUS, limits(-tolerance), limits(tolerance));
  const printout = opened(curve.start);
  const all = close ? cuts(curve) : staircase(curve.start, "Y", curve.stretches);
  for (const { axis, stop } of all) _print(printout, stop, feed, axis);
  return carriedOut(printout.text);
}
