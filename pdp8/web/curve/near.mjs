// The circle, looked at from nearer and nearer: round from afar, a staircase at last.

import { CENTRE, circle, RADIUS } from "./method.mjs";
import { clipped, Figure, mils, text, View } from "./drawing.mjs";

const TURN = (146 * Math.PI) / 180;
const NEAREST = 250;

export function near() {
  const { way } = circle(5, 1, true);
  const at = { x: CENTRE + RADIUS * Math.cos(TURN), y: CENTRE + RADIUS * Math.sin(TURN) };
  const times = (step) => NEAREST ** (step / 100);
  const words = { near: (step) => `${times(step).toFixed(times(step) < 10 ? 1 : 0)} ×` };
  return new Figure("near", ({ near: step }, width) => picture(way, at, times(step), width), words);
}

function picture(way, at, times, width) {
  const height = Math.min(420, Math.round(width * 0.72));
  const half = 2000 / times;
  const pull = 1 - 1 / times ** 2; // from the circle's centre to the place
  const middle = { x: CENTRE + (at.x - CENTRE) * pull, y: CENTRE + (at.y - CENTRE) * pull };
  const wide = (half * width) / height;
  const box = { x: 0, y: 0, width, height };
  const view = new View({ left: middle.x - wide, right: middle.x + wide, bottom: middle.y - half, top: middle.y + half }, box);
  const seen = way.filter(({ x, y }) => Math.abs(x - middle.x) < wide + 200 && Math.abs(y - middle.y) < half + 200);
  const ring = (off, name) => view.dot({ x: CENTRE, y: CENTRE }, (RADIUS + off) * view.sx, `class="${name}"`);
  const thick = `<circle cx="${view.x(CENTRE)}" cy="${view.y(CENTRE)}" r="${RADIUS * view.sx}" class="ring" style="stroke-width:${Math.max(0.5, 10 * view.sx)}"/>`;
  const dots = times > 25 ? seen.map((place) => view.dot(place, 3, 'class="stop"')).join("") : "";
  const bar = scale(view, width, height);
  const drawn = thick + ring(5, "limit") + ring(-5, "limit") + view.line(times < 4 ? way : seen, 'class="way"') + dots;
  const stops = way.filter(({ x, y }) => Math.abs(x - middle.x) < wide && Math.abs(y - middle.y) < half);
  return [clipped(box, drawn) + bar, height, said(times, stops.length)];
}

function scale(view, width, height) {
  const long = [1000, 500, 200, 100, 50, 20, 10].find((length) => length * view.sx < width / 3) ?? 10;
  const x = width - 16 - long * view.sx;
  return `<path d="M${x} ${height - 14}h${long * view.sx}" class="bar"/>` + text(width - 16, height - 20, `${mils(long)} in`, 'class="small" text-anchor="end"');
}

function said(times, stops) {
  if (times < 6) return "A circle of 3.500 in, the way of the cutter's centre.";
  if (times < 20) return "Something is not quite smooth. The pale ring is the band: .010 in wide.";
  return `Every corner is a stop: here are ${stops} of its 662. Between two stops the cutter moves along X or along Y, never along both.`;
}
