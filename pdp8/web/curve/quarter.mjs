// The step-wise technique on a curve: what the tolerance, the cutter and the feed change, and what they cost.

import { CENTRE, RADIUS } from "../method.mjs";
import { Figure, grownBack, mils, minutes, onCircle, straightened } from "./drawing.mjs";
import { CIRCLE, made as madeOf } from "./made.mjs";
import { html } from "../html.mjs";
import { clipped, rect, text, View } from "../svg.mjs";
import { troughToPeak } from "./walls.mjs";

const ARC = (RADIUS * Math.PI) / 2;
const STATIONS = 1800;
const SLOWEST = 1; // the code of the slowest feed, by which the chart is scaled
const RIM = 16; // pixels from the cutter's rim to the ring that makes it larger
const COMPARED = [1, 2, 3, 5, 7, 10, 15, 20, 30, 50]; // tolerances of the chart
const quarter = (/** @type {number} */ tolerance, /** @type {number} */ feed) => madeOf("quarter", tolerance, feed);

export function curved() {
  return new Figure("curved", ({ tolerance, cutter, place }, width) => {
    const made = quarter(tolerance, 1);
    const wall = madeOf("quarterWalls", tolerance, cutter, STATIONS);
    const wide = width >= 560;
    const side = wide ? (width - 16) / 2 : width;
    const tall = Math.min(side, 300);
    const whole = { x: 0, y: 20, width: side, height: tall };
    const close = wide ? { ...whole, x: side + 16 } : { ...whole, y: tall + 50 };
    const strip = { x: 8, y: close.y + tall + 28, width: width - 66, height: 110 };
    const [content, holds] = pictured(made, cutter, tolerance, place, whole, close);
    return [content + unrolled(made, wall, tolerance, place, strip), strip.y + strip.height + 8, said(made, wall, tolerance), holds];
  });
}

/** What a tolerance costs: a bar for each, to be taken by its top. */
export function costs() {
  return new Figure("costs", ({ tolerance, feed: code }, width) => {
    const chart = { x: 40, y: 50, width: width - 60, height: 170 };
    const all = [...new Set([...COMPARED, tolerance])].sort((a, b) => a - b);
    const { blocks, reading, milling, minutes: took } = quarter(tolerance, code);
    const most = quarter(all[0], SLOWEST).minutes;
    const wide = chart.width / all.length;
    const to = (/** @type {Place} */ { x }) => grownBack(all[Math.max(0, Math.min(all.length - 1, Math.floor((x - chart.x) / wide)))], 50);
    const [x, floor] = [chart.x + (all.indexOf(tolerance) + 0.5) * wide, chart.y + chart.height];
    const holds = { tolerance: { x, y: floor + 28, to }, feed: { x, y: floor - (chart.height * took) / most, to: (/** @type {Drag} */ { dy, start }) => start + dy / 5 } };
    return [compared(all, tolerance, code, most, chart), chart.y + chart.height + 42, html`±${mils(tolerance)} in: <b>${blocks} blocks</b>, reading ${minutes(reading)} + cutting ${minutes(milling)} = <b>${minutes(took)}</b>.`, holds];
  });
}

function said(/** @type {Made} */ { blocks }, /** @type {Walls} */ { outer, inner }, /** @type {number} */ tolerance) {
  const tenth = STATIONS / 9, middle = STATIONS / 2, five = STATIONS / 18;
  const furthest = Math.max(...[outer, inner].map((errors) => errors.reduce((most, error) => Math.max(most, Math.abs(error) || 0), 0)));
  const diagonal = Math.max(...[outer, inner].map((errors) => troughToPeak(errors.subarray(middle - five, middle + five))));
  const apex = Math.max(...[outer, inner].map((errors) => troughToPeak(errors.subarray(STATIONS - tenth))));
  return html`<b>${blocks} blocks</b>. The wall is at most <b>${mils(furthest, 4)} in</b> off; promised are ${mils(tolerance + 1)}. Trough to peak it is ${mils(apex, 4)} near the top, ${mils(diagonal, 4)} at 45°.`;
}

function pictured(/** @type {Made} */ { way }, /** @type {number} */ cutter, /** @type {number} */ tolerance, /** @type {number} */ place, /** @type {Box} */ whole, /** @type {Box} */ close) {
  const at = onCircle(180 - place);
  const outward = { x: (at.x - CENTRE) / RADIUS, y: (at.y - CENTRE) / RADIUS };
  const room = 320;
  const far = new View({ left: CENTRE - RADIUS - room, right: CENTRE + room, bottom: CENTRE - room, top: CENTRE + RADIUS + room }, whole);
  const radius = (cutter * 1000) / 32;
  const groove = far.line(way, `class="groove" style="stroke-width:${2 * radius * far.sx}"`);
  const half = Math.max(4 * tolerance, 0.7 * longest(around(way, at, 10 * tolerance)));
  const near = new View({ left: at.x - half, right: at.x + half, bottom: at.y - half, top: at.y + half }, close);
  const ring = (/** @type {number} */ off, /** @type {string} */ attributes) => near.circle({ ...CIRCLE, radius: RADIUS + off }, attributes);
  const seen = around(way, at, 3 * half);
  const drawn = ring(0, `class="ring" style="stroke-width:${2 * tolerance * near.sx}"`) + ring(tolerance, 'class="limit"') + ring(-tolerance, 'class="limit"') + ring(0, 'class="intended"') + near.line(seen, 'class="way"') + seen.map((stop) => near.dot(stop, 3.2, 'class="stop"')).join("");
  const times = Math.round(near.sx / far.sx);
  const aside = radius * far.sx + RIM;
  const holds = {
    cutter: { x: far.x(at.x) - outward.x * aside, y: far.y(at.y) + outward.y * aside, to: (/** @type {Place} */ { x, y }) => ((Math.hypot(x - far.x(at.x), y - far.y(at.y)) - RIM) / far.sx) * (32 / 1000) },
    place: { x: far.x(at.x), y: far.y(at.y), to: (/** @type {Place} */ { x, y }) => (Math.atan2(far.y(CENTRE) - y, far.x(CENTRE) - x) * 180) / Math.PI },
    tolerance: { x: near.x(at.x) + outward.x * tolerance * near.sx, y: near.y(at.y) - outward.y * tolerance * near.sy, to: (/** @type {Drag} */ { dx, dy, start }) => start + (dx * outward.x - dy * outward.y) / 3 },
  };
  return [
    text(whole.x, whole.y - 6, "the cut, and the cutter", 'class="small"') + clipped(whole, groove + far.line(way, 'class="way"') + far.circle({ ...at, radius }, 'class="tool"') + far.dot(at, 2.5, 'class="stop"')) + rect(whole, 'class="frame"') +
    text(close.x, close.y - 6, `its centre's way there, ${times} times nearer`, 'class="small"') + clipped(close, drawn) + rect(close, 'class="frame"'),
    holds,
  ];
}

function longest(/** @type {Place[]} */ way) {
  return Math.max(0, ...way.slice(1).map(({ x, y }, index) => Math.abs(x - way[index].x) + Math.abs(y - way[index].y)));
}

/** The part of a way that is near a place, with a stop more at each end. */
function around(/** @type {Place[]} */ way, /** @type {Place} */ at, /** @type {number} */ reach) {
  const passes = (/** @type {Place} */ { x, y }, /** @type {number} */ index) => {
    const from = way[Math.max(0, index - 1)];
    return Math.min(x, from.x) < at.x + reach && Math.max(x, from.x) > at.x - reach && Math.min(y, from.y) < at.y + reach && Math.max(y, from.y) > at.y - reach;
  };
  const first = way.findIndex(passes);
  return first < 0 ? [] : way.slice(Math.max(0, first - 1), way.findLastIndex(passes) + 1);
}

function unrolled(/** @type {Made} */ { way }, /** @type {Walls} */ { outer, inner }, /** @type {number} */ tolerance, /** @type {number} */ place, /** @type {Box} */ box) {
  const flat = way.map(({ x, y }) => ({ x: (Math.PI - Math.atan2(y - CENTRE, x - CENTRE)) * RADIUS, y: Math.hypot(x - CENTRE, y - CENTRE) - RADIUS }));
  const wall = (/** @type {ArrayLike<number>} */ errors) => Array.from(errors, (error, station) => ({ x: (ARC * station) / STATIONS, y: error })).filter(({ y }) => !Number.isNaN(y));
  const reach = 1.7 * tolerance + 1;
  const times = Math.round(box.height / (2 * reach) / (box.width / ARC));
  const at = box.x + (box.width * place) / 90;
  const legend = box.width > 450 ? `the band made straight, ${times} times higher: ` : `the band, ${times} times higher: `;
  return (
    `<text x="${box.x}" y="${box.y - 7}" class="small">${legend}<tspan class="t-way">way</tspan>, <tspan class="t-outer">outer wall</tspan>, <tspan class="t-inner">inner wall</tspan></text>` +
    straightened(box, ARC, tolerance, reach, [[flat, "way thin"], [wall(outer), "outer"], [wall(inner), "inner"]]) + `<path d="M${at} ${box.y}v${box.height}" class="miss"/>`
  );
}

/** Minutes for each tolerance: the reading below, the cutting above it. */
function compared(/** @type {number[]} */ all, /** @type {number} */ tolerance, /** @type {number} */ code, /** @type {number} */ most, /** @type {Box} */ box) {
  const made = all.map((each) => quarter(each, code));
  const wide = box.width / all.length;
  const up = (/** @type {number} */ value) => (box.height * value) / most;
  const bars = made.map(({ reading, milling, blocks }, n) => {
    const x = box.x + n * wide + wide * 0.12, width = wide * 0.76, floor = box.y + box.height;
    const now = all[n] === tolerance ? " now" : "";
    const middle = x + width / 2;
    return rect({ x, y: floor - up(reading), width, height: up(reading) }, `class="reading${now}"`) + rect({ x, y: floor - up(reading + milling), width, height: up(milling) }, `class="cutting${now}"`) +
      text(middle, floor + 13, mils(all[n]), `class="small${now}" text-anchor="middle"`) + text(middle, floor - up(reading + milling) - (now ? 15 : 4), String(blocks), `class="small${now}" text-anchor="middle"`);
  });
  const floor = box.y + box.height;
  const axis = `<path d="M${box.x} ${box.y}V${floor}H${box.x + box.width}" class="axis"/>` + text(box.x - 5, box.y + 6, most.toFixed(0), 'class="small" text-anchor="end"') + text(box.x - 5, floor, "0", 'class="small" text-anchor="end"');
  const legend = `<text x="0" y="${box.y - 34}" class="small">minutes: <tspan class="t-reading">reading</tspan> and <tspan class="t-cutting">cutting</tspan>; above, blocks; below, tolerance</text>`;
  return legend + axis + bars.join("");
}
