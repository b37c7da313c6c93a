// Chapter 3's slope: one instruction misses it, pieces come near, steps stay in the band whatever the feeds do.

import { XY_FEED } from "../../../tapes/hydrapoint.mjs";
import { SLOPE } from "../method.mjs";
import { Figure, grownBack, inch, minutes, straightened } from "./drawing.mjs";
import { made } from "./made.mjs";
import { html } from "../html.mjs";
import { text, View } from "../svg.mjs";

const [FROM, TO] = SLOPE;
const BAND = 5;

/** A slope from A to B: its length; a place as its band's, how far along it and how far off to its left; and back. */
function sloping(/** @type {Place} */ to) {
  const length = Math.hypot(to.x - FROM.x, to.y - FROM.y);
  const [east, north] = [(to.x - FROM.x) / length, (to.y - FROM.y) / length]; // of a step along it
  return {
    to,
    length,
    beside: (/** @type {Place} */ { x, y }) => ({ x: (x - FROM.x) * east + (y - FROM.y) * north, y: (y - FROM.y) * east - (x - FROM.x) * north }),
    at: (/** @type {number} */ along, off = 0) => ({ x: FROM.x + along * east - off * north, y: FROM.y + along * north + off * east }),
  };
}

const CHAPTER_3 = sloping(TO);
const { at, beside, length: LENGTH } = CHAPTER_3;

/** How far the furthest place of a way is from the slope; with that place. */
function furthest(/** @type {Place[]} */ way, line = CHAPTER_3) {
  const offs = way.map((place) => Math.abs(line.beside(place).y));
  const worst = Math.max(...offs);
  return { worst, where: way[offs.indexOf(worst)] };
}

/** Where the slope stands, and how high the drawing is.
 * @returns {[View, number]} */
function plan(/** @type {number} */ width, right = TO.x, top = TO.y) {
  const height = Math.round(Math.min(330, width * 0.56));
  const room = width / 30 + 14;
  return [new View({ left: FROM.x, right, bottom: FROM.y, top }, { x: room, y: room, width: width - 2 * room, height: height - 2 * room }), height];
}

function ends(/** @type {View} */ view, /** @type {Place} */ to = TO) {
  return view.line([FROM, to], 'class="intended"') + named(view, FROM, "A", -14, 14) + named(view, to, "B", 6, -4);
}

function named(/** @type {View} */ view, /** @type {Place} */ place, /** @type {string} */ name, /** @type {number} */ dx, /** @type {number} */ dy) {
  return view.dot(place, 3.2, 'class="stop"') + text(view.x(place.x) + dx, view.y(place.y) + dy, name, 'class="name"');
}

/** Every ratio of two feeds, by the slowest pair that has it: the codes of X and Y, and the angle. */
const PAIRS = [...XY_FEED.items()].flatMap(([x, across]) => [...XY_FEED.items()].map(([y, up]) => ({ x, y, angle: Math.atan2(up, across) })))
  .filter(({ angle }, n, all) => all.findIndex((pair) => Math.abs(pair.angle - angle) < 1e-9) === n)
  .sort((one, other) => one.angle - other.angle);

export function one() {
  return new Figure("one", ({ pair, error }, width) => {
    const [view, height] = plan(width);
    const { x, y, angle } = PAIRS[pair];
    const cut = (/** @type {number} */ by) => made("pieces", 1, x, y, by / 100, -by / 100).way;
    const way = cut(error);
    const cone = view.line([FROM, cut(20)[1], TO, cut(-20)[1]], 'class="cone"', true);
    const { worst, where } = furthest(way);
    const leaves = Math.atan2(way[1].y - FROM.y, way[1].x - FROM.x);
    const miss = worst < 0.5 ? "" : view.line([where, at(beside(where).x)], 'class="miss"');
    const content = cone + ends(view) + miss + (error ? view.line([FROM, cut(0)[1]], 'class="way thin"') : "") + view.line(way, 'class="way"');
    const aimed = (/** @type {Place} */ place) => Math.atan2(view.y(FROM.y) - place.y, Math.max(1, place.x - view.x(FROM.x)));
    const holds = {
      pair: { x: view.x(FROM.x + 2400 * Math.cos(angle)), y: view.y(FROM.y + 2400 * Math.sin(angle)), to: (/** @type {Place} */ place) => nearest(aimed(place)) },
      error: { x: view.x(way[1].x), y: view.y(way[1].y), to: (/** @type {Place} */ place) => wrong(Math.tan(angle) / Math.tan(Math.max(0.01, aimed(place)))) },
    };
    return [content, height, html`It leaves A at <b>${((leaves * 180) / Math.PI).toFixed(1)}°</b>; the slope is 30.0°. When one axis has arrived it is <b>${inch(worst)}</b> off; then the other goes on alone.`, holds];
  }, { pair: (/** @type {number} */ number) => [PAIRS[number].x, PAIRS[number].y].map((code) => XY_FEED.at(code).toFixed(1)).join(" over ") });
}

/** The pair of feeds that goes nearest to an angle. */
function nearest(/** @type {number} */ aimed) {
  return PAIRS.reduce((best, { angle }, n) => (Math.abs(angle - aimed) < Math.abs(PAIRS[best].angle - aimed) ? n : best), 0);
}

/** By how many percent X is too fast and Y too slow, if X over Y is so many times what it should be. */
const wrong = (/** @type {number} */ times) => (100 * (times - 1)) / (times + 1);

export function piecewise(/** @type {any} */ { fewest: frames }) {
  return new Figure("piecewise", ({ pieces: asked, error, fewest: proved }, width) => {
    const [view, height] = plan(width);
    const cut = (/** @type {number} */ by) => (proved ? made("fewest", frames, by / 100, -by / 100) : made("pieces", asked, 2, 1, by / 100, -by / 100));
    const { way, stops, minutes: took } = cut(error);
    const count = proved ? stops.length : asked;
    const dots = count < 60 ? stops.map((place) => view.dot(place, 3, 'class="stop"')).join("") : "";
    const { worst } = furthest(way);
    const flat = way.map(beside);
    const reach = Math.max(1.7 * BAND, 1.15 * furthest(cut(20).way).worst);
    const box = { x: 8, y: height + 24, width: width - 62, height: 120 };
    const content = ends(view) + view.line(way, 'class="way"') + dots + title(box, reach) + straightened(box, LENGTH, BAND, reach, [[flat, "way"]]);
    const inside = worst <= BAND;
    const middle = flat.filter(({ x }) => Math.abs(x - LENGTH / 2) <= LENGTH / count);
    const bend = middle.reduce((most, place) => (Math.abs(place.y) > Math.abs(most.y) ? place : most));
    const next = /** @type {Place} */ (stops.find(({ x }) => x > FROM.x));
    const holds = /** @type {Record<string, unknown>} */ ({ error: { x: box.x + (box.width * bend.x) / LENGTH, y: box.y + (box.height / 2) * (1 - bend.y / reach), to: (/** @type {Drag} */ { dy, start }) => start + dy / 2 } });
    if (!proved) holds.pieces = { x: view.x(next.x), y: view.y(next.y), to: (/** @type {Place} */ { x, y }) => grownBack(LENGTH / Math.max(1, beside(view.place(x, y)).x), 250) };
    const verdict = inside ? html`<b class="good">inside the band</b>` : html`<b class="bad">outside the band</b>`;
    return [content, box.y + box.height + 8, html`${count} ${count === 1 ? "piece" : "pieces"}: at most <b>${inch(worst)}</b> off, ${verdict} of ±.005 in; ${minutes(took)}.`, holds];
  }, { pieces: (/** @type {number} */ count, /** @type {any} */ { fewest: proved }) => (proved ? "as proved" : String(count)) });
}

function title(/** @type {Box} */ box, /** @type {number} */ reach, length = LENGTH) {
  const times = Math.round(box.height / (2 * reach) / (box.width / length));
  return text(box.x, box.y - 7, `the band made straight${times > 1 ? `, its height ${times} times as large` : ""}`, 'class="small"');
}

export function stepwise() {
  return new Figure("stepwise", ({ tolerance, dx, angle }, width) => {
    const [view, height] = plan(width, FROM.x + 4830, FROM.y + 3536);
    const { way, stops, blocks, reading, milling, minutes: took } = made("slope", tolerance, dx / 100, -dx / 100, angle);
    const line = sloping(way.at(-1));
    const { to, length } = line;
    const [left, right] = [tolerance, -tolerance].map((off) => [line.at(0, off), line.at(length, off)]);
    const sides = view.line(left, 'class="limit"') + view.line(right, 'class="limit"');
    const few = stops.length <= 14;
    const names = few ? stops.slice(0, -1).map((place, n) => named(view, place, "CDEFGHIJKLMNO"[n], n % 2 ? 5 : -13, n % 2 ? 14 : -5)).join("") : "";
    const box = { x: 8, y: height + 24, width: width - 62, height: 120 };
    const reach = 1.5 * tolerance + 1;
    const content = view.line([...left, ...right.toReversed()], 'class="band"', true) + sides + ends(view, to) + view.line(way, 'class="way"') + names + title(box, reach, length) + straightened(box, length, tolerance, reach, [[way.map(line.beside), "way"]]);
    const edge = line.at(length / 3, tolerance);
    const holds = {
      tolerance: { x: view.x(edge.x), y: view.y(edge.y), to: (/** @type {Drag} */ { dy, start }) => start - dy / 3 },
      angle: { x: view.x(to.x), y: view.y(to.y), to: (/** @type {Place} */ { x, y }) => (Math.atan2(view.y(FROM.y) - y, x - view.x(FROM.x)) * 180) / Math.PI },
    };
    return [content, box.y + box.height + 8, html`<b>${blocks - 6} blocks</b> and the six that open the tape. Reading them takes ${minutes(reading)}, cutting ${minutes(milling)}: <b>${minutes(took)}</b>. Furthest off: ${inch(furthest(way, line).worst)}.`, holds];
  });
}
