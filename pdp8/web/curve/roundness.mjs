// What the Talyrond sees: the walls of the circle's groove, their errors magnified and nothing else.

import { RADIUS } from "../method.mjs";
import { Figure, mils } from "./drawing.mjs";
import { made } from "./made.mjs";
import { html } from "../html.mjs";
import { clipped, text } from "../svg.mjs";
import { troughToPeak } from "./walls.mjs";

const ASLANT = Math.SQRT1_2;
const WORK = 0.06; // of the drawing's height, the radius of the work in its middle
const PAPER = 10000; // thousandths of an inch that the drawing is wide, at the instrument
/** @type {[string, number, number][]} */
const PLACES = [["+X", 0, 10], ["45°", 45, 5], ["+Y", 90, 10], ["135°", 135, 5], ["−X", 180, 10], ["225°", 225, 5], ["−Y", 270, 10], ["315°", 315, 5]];

export function roundness() {
  return new Figure("roundness", ({ times, closed, cutter }, width) => {
    const wall = made("circleWalls", closed, cutter);
    const height = Math.min(width, 560);
    const mean = height * 0.29;
    const scale = (times * height) / PAPER;
    const content = rings(width / 2, height / 2, mean, scale, height) + trace(wall.outer, width, height, mean, scale, "outer") + trace(wall.inner, width, height, mean, scale, "inner") + places(wall, width, height);
    const ring = 5 * scale + mean;
    const holds = {
      times: { x: width / 2 + ring * ASLANT, y: height / 2 - ring * ASLANT, to: (/** @type {Drag} */ { dx, dy, start }) => start + ((dx - dy) * ASLANT * PAPER) / (5 * height) },
      cutter: { x: width / 2 - height * WORK, y: height / 2, to: (/** @type {Drag} */ { dx, start }) => start + dx / 4 },
    };
    return [clipped({ x: 0, y: 0, width, height }, content + plan(width, height, cutter)), height, said(wall, closed), holds];
  });
}

/** The work from above, in the middle: the groove and the cutter where it begins. */
function plan(/** @type {number} */ width, /** @type {number} */ height, /** @type {number} */ cutter) {
  const radius = height * WORK;
  const size = (cutter * 1000 * radius) / 32 / RADIUS;
  const circle = (/** @type {number} */ x, /** @type {number} */ r, /** @type {string} */ attributes) => `<circle cx="${x.toFixed(1)}" cy="${height / 2}" r="${r.toFixed(1)}" ${attributes}/>`;
  const groove = circle(width / 2, radius, `class="groove" style="stroke-width:${2 * size}"`);
  const walls = circle(width / 2, radius + size, 'class="outer"') + circle(width / 2, radius - size, 'class="inner"');
  return groove + walls + circle(width / 2 - radius, size, 'class="tool"');
}

function rings(/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ mean, /** @type {number} */ scale, /** @type {number} */ height) {
  const rings_ = [];
  for (let off = -20; off <= 20; off++) {
    const radius = mean + off * scale;
    if (radius < height * 0.1 || radius > height * 0.42 || (scale < 3 && off % 5)) continue;
    rings_.push(`<circle cx="${x}" cy="${y}" r="${radius.toFixed(1)}" class="${off === 0 ? "intended" : off % 5 ? "division" : "heavy"}"/>`);
  }
  return rings_.join("");
}

function trace(/** @type {Float64Array} */ errors, /** @type {number} */ width, /** @type {number} */ height, /** @type {number} */ mean, /** @type {number} */ scale, /** @type {string} */ name) {
  let d = "";
  let down = false;
  for (let station = 0; station <= errors.length; station += 12) {
    const some = errors.subarray(station, station + 12);
    const error = extreme(some.length ? some : errors.subarray(0, 12));
    if (Number.isNaN(error)) { down = false; continue; }
    const angle = (2 * Math.PI * station) / errors.length;
    const radius = Math.max(0, mean + error * scale);
    d += `${down ? "L" : "M"}${(width / 2 + radius * Math.cos(angle)).toFixed(1)} ${(height / 2 - radius * Math.sin(angle)).toFixed(1)}`;
    down = true;
  }
  return `<path d="${d}" class="${name}"/>`;
}

/** The error that is furthest from 0: a peak must not be lost between two points of the drawing. */
function extreme(/** @type {Float64Array} */ errors) {
  return errors.reduce((most, error) => (Math.abs(error) > Math.abs(most) ? error : most), errors[0]);
}

function readingAt(/** @type {Float64Array} */ errors, /** @type {number} */ degrees, /** @type {number} */ reach) {
  const [from, to] = [degrees - reach, degrees + reach].map((angle) => Math.round((angle * errors.length) / 360));
  const seen = [];
  for (let station = from; station <= to; station++) seen.push(errors[(station + errors.length) % errors.length]);
  return troughToPeak(seen);
}

function places(/** @type {Walls} */ { outer, inner }, /** @type {number} */ width, /** @type {number} */ height) {
  const far = height * 0.46;
  return PLACES.map(([, angle, reach]) => {
    const turn = (angle * Math.PI) / 180;
    const [x, y] = [width / 2 + (far - 6) * Math.cos(turn), height / 2 - (far - 6) * Math.sin(turn)];
    return text(x, y - 2, mils(readingAt(outer, angle, reach), 4), 'class="small t-outer" text-anchor="middle"') + text(x, y + 11, mils(readingAt(inner, angle, reach), 4), 'class="small t-inner" text-anchor="middle"');
  }).join("");
}

function said(/** @type {Walls} */ { outer, inner }, /** @type {boolean} */ closed) {
  const at = (/** @type {number} */ angle, /** @type {number} */ reach) => Math.max(readingAt(outer, angle, reach), readingAt(inner, angle, reach));
  const diagonals = Math.max(...[45, 135, 225, 315].map((angle) => at(angle, 5)));
  const start = `${mils(at(180, 10), 4)} in at −X, ${closed ? "where it starts and ends" : "where the last cut is missing"}`;
  return html`Trough to peak: <b>${mils(at(90, 10), 4)} in</b> at +Y and −Y; <b>${start}</b>; at most ${mils(diagonals, 4)} at 45°. The thesis measured .009 at the axes and about .001 at 45°.`;
}
