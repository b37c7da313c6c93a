// Chapter 3's slope: one instruction misses it, pieces come near, steps stay in the band whatever the feeds do.

import { SLOPE } from "../method.mjs";
import { Figure, grownBack, inch, minutes, straightened } from "./drawing.mjs";
import { made } from "./made.mjs";
import { html } from "../html.mjs";
import { text, View } from "../svg.mjs";

const [FROM, TO] = SLOPE;
const BAND = 5;

/** A slope from A to B: its length; a place as its band's, how far along it and how far off to its left; and back. */
function sloping(to) {
  const length = Math.hypot(to.x - FROM.x, to.y - FROM.y);
  const [east, north] = [(to.x - FROM.x) / length, (to.y - FROM.y) / length]; // of a step along it
  return {
    to,
    length,
    beside: ({ x, y }) => ({ x: (x - FROM.x) * east + (y - FROM.y) * north, y: (y - FROM.y) * east - (x - FROM.x) * north }),
    at: (along, off = 0) => ({ x: FROM.x + along * east - off * north, y: FROM.y + along * north + off * east }),
  };
}

const CHAPTER_3 = sloping(TO);
const { at, beside, length: LENGTH } = CHAPTER_3;

/** How far the furthest place of a way is from the slope; with that place. */
function furthest(way, line = CHAPTER_3) {
  const offs = way.map((place) => Math.abs(line.beside(place).y));
  const worst = Math.max(...offs);
  return { worst, where: way[offs.indexOf(worst)] };
}

/** Where the slope stands, and how high the drawing is.
 * @returns {[View, number]} */
function plan(width, right = TO.x, top = TO.y) {
  const height = Math.round(Math.min(330, width * 0.56));
  const room = width / 30 + 14;
  return [new View({ left: FROM.x, right, bottom: FROM.y, top }, { x: room, y: room, width: width - 2 * room, height: height - 2 * room }), height];
}

function ends(view, to = TO) {
  return view.line([FROM, to], 'class="intended"') + named(view, FROM, "A", -14, 14) + named(view, to, "B", 6, -4);
}

function named(view, place, name, dx, dy) {
  return view.dot(place, 3.2, 'class="stop"') + text(view.x(place.x) + dx, view.y(place.y) + dy, name, 'class="name"');
}

export function one() {
  return new Figure("one", ({ x, y, dx, dy }, width) => {
    const [view, height] = plan(width);
    const { way } = made("pieces", 1, x, y, dx / 100, dy / 100);
    const extreme = [[0.2, -0.2], [-0.2, 0.2]].map(([a, b]) => furthest(made("pieces", 1, x, y, a, b).way).where);
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
    const { way, stops, minutes: took } = proved ? made("fewest", frames, error / 100, -error / 100) : made("pieces", asked, 2, 1, error / 100, -error / 100);
    const count = proved ? stops.length : asked;
    const dots = count < 60 ? stops.map((place) => view.dot(place, 3, 'class="stop"')).join("") : "";
    const { worst } = furthest(way);
    const reach = Math.max(1.7 * BAND, 1.15 * worst);
    const box = { x: 8, y: height + 24, width: width - 62, height: 120 };
    const content = ends(view) + view.line(way, 'class="way"') + dots + title(box, reach) + straightened(box, LENGTH, BAND, reach, [[way.map(beside), "way"]]);
    const inside = worst <= BAND;
    const next = stops.find(({ x }) => x > FROM.x);
    const first = { x: view.x(next.x), y: view.y(next.y), to: ({ x, y }) => grownBack(LENGTH / Math.max(1, beside(view.place(x, y)).x), 250) };
    const verdict = inside ? html`<b class="good">inside the band</b>` : html`<b class="bad">outside the band</b>`;
    return [content, box.y + box.height + 8, html`${count} ${count === 1 ? "piece" : "pieces"}: at most <b>${inch(worst)}</b> off, ${verdict} of ±.005 in; ${minutes(took)}.`, proved ? {} : { pieces: first }];
  }, { pieces: (count, { fewest: proved }) => (proved ? "as proved" : String(count)) });
}

function title(box, reach, length = LENGTH) {
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
      tolerance: { x: view.x(edge.x), y: view.y(edge.y), to: ({ dy, start }) => start - dy / 3 },
      angle: { x: view.x(to.x), y: view.y(to.y), to: ({ x, y }) => (Math.atan2(view.y(FROM.y) - y, x - view.x(FROM.x)) * 180) / Math.PI },
    };
    return [content, box.y + box.height + 8, html`<b>${blocks - 6} blocks</b> and the six that open the tape. Reading them takes ${minutes(reading)}, cutting ${minutes(milling)}: <b>${minutes(took)}</b>. Furthest off: ${inch(furthest(way, line).worst)}.`, holds];
  });
}
