// The circle whole, minute by minute: what is cut, and where the time goes.

import { CENTRE, RADIUS } from "../method.mjs";
import { Pictures } from "../pictures.mjs";
import { Figure, minutes } from "./drawing.mjs";
import { CIRCLE, made } from "./made.mjs";
import { html } from "../html.mjs";
import { clipped, rect, text, View } from "../svg.mjs";

const CUTTER = 250; // its radius
const TAKES = 20; // seconds in which the whole is played

export function whole(/** @type {HTMLButtonElement} */ button) {
  const clock = (/** @type {number} */ part) => `${((clocked().before.at(-1) * part) / 1000 / 60).toFixed(1)} min`;
  const figure = new Figure("whole", ({ time }, width) => picture(clocked(), time / 1000, width), { time: clock });
  playing(figure, button);
  return figure;
}

/** The circle with the second at which each block begins, and the last ends: the contour's alone, as in Chapter 7. */
function clocked() {
  const circle = made("circle", 5, false);
  let now = 0;
  const first = circle.steps.findIndex(({ mills }) => mills);
  const before = [0, ...circle.steps.map(({ seconds }, at) => (now += at < first ? 0 : circle.read + seconds))];
  return { ...circle, first, before };
}

/** Let a button move the slider; where motion is not wanted, a minute a press. */
function playing(/** @type {import("./drawing.mjs").Figure} */ figure, /** @type {HTMLButtonElement} */ button) {
  const go = (/** @type {number} */ by) => {
    const part = Math.min(1000, figure.values.time + by);
    figure.set("time", part);
    if (part === 1000) stop();
    return part < 1000;
  };
  const pictures = new Pictures((passed) => go(passed / TAKES));
  const stop = () => {
    pictures.stop();
    button.textContent = "Cut";
  };
  button.addEventListener("click", () => {
    if (pictures.running) return stop();
    if (figure.values.time >= 1000) figure.set("time", 0);
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) return void go(28);
    pictures.start();
    button.textContent = "Stop";
  });
  for (const place of [figure.inputs[0], figure.svg]) place.addEventListener("pointerdown", stop);
}

function picture(/** @type {ReturnType<typeof clocked>} */ { steps, read: reads, way, before, first }, /** @type {number} */ part, /** @type {number} */ width) {
  const now = before.at(-1) * part;
  const height = Math.min(460, Math.round(width * 0.8) + 64);
  const box = { x: 0, y: 0, width, height: height - 64 };
  const reach = RADIUS + CUTTER + 120;
  const view = new View({ left: CENTRE - reach, right: CENTRE + reach, bottom: CENTRE - reach, top: CENTRE + reach }, box);
  const last = before.findLastIndex((starts) => starts <= now); // steps.length: all is cut
  const done = steps.slice(first, last);
  const step = steps[Math.min(last, steps.length - 1)];
  const into = last < steps.length ? now - before[last] : 0;
  const reading = last < steps.length && into < reads;
  const milled = [way[0], ...done];
  const tip = last < steps.length && !reading ? between(milled.at(-1), step, (into - reads) / (before[last + 1] - before[last] - reads)) : milled.at(-1);
  const cut = [...milled, tip];
  const groove = view.line(cut, `class="groove" style="stroke-width:${2 * CUTTER * view.sx}"`);
  const intended = view.circle(CIRCLE, 'class="intended"');
  const content = intended + groove + view.line(cut, 'class="way"') + view.circle({ ...tip, radius: CUTTER }, `class="tool${reading ? " waits" : ""}"`);
  const [read, cutting] = spent(reads, before, first, last, into);
  const what = last >= steps.length ? "done" : reading ? "stands still: the reader reads a block" : `cuts along ${step.axis}`;
  const digits = text(width / 2, box.height / 2 - 4, step.digits, 'class="digits" text-anchor="middle"') + text(width / 2, box.height / 2 + 16, what, 'class="small" text-anchor="middle"');
  const bars = bar(width, height - 50, "reading", read) + bar(width, height - 24, "cutting", cutting);
  const blocks = last - first;
  const said = html`Block <b>${Math.min(last + 1, steps.length)}</b> of ${steps.length}. Of ${minutes((read + cutting) / 60)} the reader took ${minutes(read / 60)} (${blocks} blocks of 2 s), the cutter ${minutes(cutting / 60)}: it cut <b>${read + cutting ? Math.round((100 * cutting) / (read + cutting)) : 0} %</b> of the time.`;
  const dragged = (/** @type {Place} */ { x, y }) => {
    const turned = (Math.atan2(view.y(CENTRE) - y, view.x(CENTRE) - x) + 2 * Math.PI) % (2 * Math.PI);
    const reached = steps.findIndex((stop, n) => n >= first && (Math.atan2(stop.y - CENTRE, CENTRE - stop.x) + 2 * Math.PI) % (2 * Math.PI) >= turned);
    return (1000 * before[reached < 0 ? steps.length : reached]) / before.at(-1);
  };
  return [clipped(box, content) + digits + bars, height, said, { time: { x: view.x(tip.x), y: view.y(tip.y), to: dragged } }];
}

function between(/** @type {Place} */ from, /** @type {Place} */ to, /** @type {number} */ part) {
  return { x: from.x + (to.x - from.x) * part, y: from.y + (to.y - from.y) * part };
}

/** Seconds of reading and of milling so far. */
function spent(/** @type {number} */ reads, /** @type {number[]} */ before, /** @type {number} */ first, /** @type {number} */ last, /** @type {number} */ into) {
  const read = (last - first) * reads + Math.min(into, reads);
  return [read, before[last] + into - read];
}

function bar(/** @type {number} */ width, /** @type {number} */ y, /** @type {string} */ name, /** @type {number} */ seconds) {
  const room = width - 150;
  const long = (room * seconds) / 60 / 24;
  return text(0, y + 13, name, `class="small t-${name}"`) + rect({ x: 62, y, width: long, height: 17 }, `class="${name}"`) + text(68 + long, y + 13, minutes(seconds / 60), 'class="small"');
}
