// Chapter 3's slope: one instruction misses it, pieces come near, steps stay in the band whatever the feeds do.

import { fewest, pieces, SLOPE, slope } from "../method.mjs";
import { Figure, inch, minutes, straightened } from "./drawing.mjs";
import { html } from "../html.mjs";
import { text, View } from "../svg.mjs";

const [FROM, TO] = SLOPE;
const LENGTH = Math.hypot(TO.x - FROM.x, TO.y - FROM.y);
const [EAST, NORTH] = [(TO.x - FROM.x) / LENGTH, (TO.y - FROM.y) / LENGTH]; // of a step along it
const BAND = 5;

/** A place as the band's: how far along the slope, and how far off to its left. */
function beside({ x, y }) {
  return { x: (x - FROM.x) * EAST + (y - FROM.y) * NORTH, y: (y - FROM.y) * EAST - (x - FROM.x) * NORTH };
}

/** The place so far along the slope, and so far off to its left. */
function at(along, off = 0) {
  return { x: FROM.x + along * EAST - off * NORTH, y: FROM.y + along * NORTH + off * EAST };
}

/** How far the furthest place of a way is from the slope; with that place. */
function furthest(way) {
  const offs = way.map((place) => Math.abs(beside(place).y));
  const worst = Math.max(...offs);
  return { worst, where: way[offs.indexOf(worst)] };
}

/** Where the slope stands, and how high the drawing is.
 * @returns {[View, number]} */
function plan(width) {
  const height = Math.round(Math.min(330, width * 0.56));
  const room = width / 30 + 14;
  return [new View({ left: FROM.x, right: TO.x, bottom: FROM.y, top: TO.y }, { x: room, y: room, width: width - 2 * room, height: height - 2 * room }), height];
}

function ends(view) {
  return view.line([FROM, TO], 'class="intended"') + named(view, FROM, "A", -14, 14) + named(view, TO, "B", 6, -4);
}

function named(view, place, name, dx, dy) {
  return view.dot(place, 3.2, 'class="stop"') + text(view.x(place.x) + dx, view.y(place.y) + dy, name, 'class="name"');
}

export function one() {
  return new Figure("one", ({ x, y, dx, dy }, width) => {
    const [view, height] = plan(width);
    const { way } = pieces(1, x, y, dx / 100, dy / 100);
    const extreme = [[0.2, -0.2], [-0.2, 0.2]].map(([a, b]) => furthest(pieces(1, x, y, a, b).way).where);
    const cone = view.line([FROM, extreme[0], TO, extreme[1]], 'class="cone"', true);
    const { worst, where } = furthest(way);
    const angle = (Math.atan2(where.y - FROM.y, where.x - FROM.x) * 180) / Math.PI;
    const miss = worst < 0.5 ? "" : view.line([where, at(beside(where).x)], 'class="miss"');
    const content = cone + ends(view) + miss + view.line(way, 'class="way"');
    return [content, height, html`It leaves A at <b>${angle.toFixed(1)}°</b>; the slope is 30.0°. When one axis has arrived it is <b>${inch(worst)}</b> off; then the other goes on alone.`];
  });
}

export function piecewise({ fewest: frames }) {
  return new Figure("piecewise", ({ pieces: asked, error, fewest: proved }, width) => {
    const [view, height] = plan(width);
    const { way, stops, minutes: took } = proved ? fewest(frames, error / 100, -error / 100) : pieces(asked, 2, 1, error / 100, -error / 100);
    const count = proved ? stops.length : asked;
    const dots = count < 60 ? stops.map((place) => view.dot(place, 3, 'class="stop"')).join("") : "";
    const { worst } = furthest(way);
    const reach = Math.max(1.7 * BAND, 1.15 * worst);
    const box = { x: 8, y: height + 24, width: width - 62, height: 120 };
    const content = ends(view) + view.line(way, 'class="way"') + dots + title(box, reach) + straightened(box, LENGTH, BAND, reach, [[way.map(beside), "way"]]);
    const inside = worst <= BAND;
    const verdict = inside ? html`<b class="good">inside the band</b>` : html`<b class="bad">outside the band</b>`;
    return [content, box.y + box.height + 8, html`${count} ${count === 1 ? "piece" : "pieces"}: at most <b>${inch(worst)}</b> off, ${verdict} of ±.005 in; ${minutes(took)}.`];
  });
}

function title(box, reach) {
  const times = Math.round(box.height / (2 * reach) / (box.width / LENGTH));
  return text(box.x, box.y - 7, `the band made straight${times > 1 ? `, its height ${times} times as large` : ""}`, 'class="small"');
}

export function stepwise() {
  return new Figure("stepwise", ({ tolerance, dx }, width) => {
    const [view, height] = plan(width);
    const { way, stops, blocks, reading, milling, minutes: took } = slope(tolerance, dx / 100, -dx / 100);
    const [left, right] = [tolerance, -tolerance].map((off) => [at(0, off), at(LENGTH, off)]);
    const sides = view.line(left, 'class="limit"') + view.line(right, 'class="limit"');
    const few = stops.length <= 14;
    const names = few ? stops.slice(0, -1).map((place, n) => named(view, place, "CDEFGHIJKLMNO"[n], n % 2 ? 5 : -13, n % 2 ? 14 : -5)).join("") : "";
    const box = { x: 8, y: height + 24, width: width - 62, height: 120 };
    const reach = 1.5 * tolerance + 1;
    const content = view.line([...left, ...right.toReversed()], 'class="band"', true) + sides + ends(view) + view.line(way, 'class="way"') + names + title(box, reach) + straightened(box, LENGTH, tolerance, reach, [[way.map(beside), "way"]]);
    return [content, box.y + box.height + 8, html`<b>${blocks} blocks</b>. Reading them takes ${minutes(reading)}, cutting ${minutes(milling)}: <b>${minutes(took)}</b>. Furthest off: ${inch(furthest(way).worst)}.`];
  });
}
