// The circle, looked at from nearer and nearer: round from afar, a staircase at last.

import { CENTRE, RADIUS } from "../method.mjs";
import { Figure, grownBack, mils, onCircle } from "./drawing.mjs";
import { CIRCLE, made } from "./made.mjs";
import { clipped, text, View } from "../svg.mjs";

const PLACE = onCircle(146);
const NEAREST = 250;

export function near() {
  return new Figure("near", ({ near: times }, width) => picture(made("circle", 5, true).way, times, width));
}

function picture(/** @type {Place[]} */ way, /** @type {number} */ times, /** @type {number} */ width) {
  const height = Math.min(420, Math.round(width * 0.72));
  const half = 2000 / times;
  const afar = 1 - grownBack(times, NEAREST) / 100;
  const pull = 1 - afar / times; // from the circle's centre to the place, which comes to the middle evenly
  const middle = { x: CENTRE + (PLACE.x - CENTRE) * pull, y: CENTRE + (PLACE.y - CENTRE) * pull };
  const wide = (half * width) / height;
  const box = { x: 0, y: 0, width, height };
  const view = new View({ left: middle.x - wide, right: middle.x + wide, bottom: middle.y - half, top: middle.y + half }, box);
  const inside = (/** @type {number} */ room) => way.filter(({ x, y }) => Math.abs(x - middle.x) < wide + room && Math.abs(y - middle.y) < half + room);
  const seen = inside(200);
  const limit = (/** @type {number} */ off) => view.circle({ ...CIRCLE, radius: RADIUS + off }, 'class="limit"');
  const band = view.circle(CIRCLE, `class="ring" style="stroke-width:${Math.max(0.5, 10 * view.sx)}"`);
  const dots = times > 25 ? seen.map((place) => view.dot(place, 3, 'class="stop"')).join("") : "";
  const drawn = band + limit(5) + limit(-5) + view.line(times < 4 ? way : seen, 'class="way"') + dots;
  const hold = { x: view.x(PLACE.x), y: view.y(PLACE.y), to: (/** @type {Place} */ { x }) => 100 * (1 - (x - width / 2) / (((PLACE.x - CENTRE) * height) / 4000)) };
  return [clipped(box, drawn) + scale(view, width, height), height, said(times, inside(0).length), { near: hold }];
}

function scale(/** @type {View} */ view, /** @type {number} */ width, /** @type {number} */ height) {
  const long = [1000, 500, 200, 100, 50, 20, 10].find((length) => length * view.sx < width / 3) ?? 10;
  const x = width - 16 - long * view.sx;
  return `<path d="M${x} ${height - 14}h${long * view.sx}" class="bar"/>` + text(width - 16, height - 20, `${mils(long)} in`, 'class="small" text-anchor="end"');
}

function said(/** @type {number} */ times, /** @type {number} */ stops) {
  if (times < 6) return "A circle of 3.500 in, the way of the cutter's centre.";
  if (times < 20) return "Something is not quite smooth. The pale ring is the band: .010 in wide.";
  return `Every corner is a stop: here are ${stops} of its 662. Between two stops the cutter moves along X or along Y, never along both.`;
}
