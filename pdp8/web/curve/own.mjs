// Draw your own: a finger's curve through the part program, eia.pal on the PDP-8/L and the Hydra-Point.

import * as ascii from "../../../tapes/ascii.mjs";
import { cut } from "../../../nc/machine.mjs";
import { drawn, started } from "../method.mjs";
import { html } from "../html.mjs";
import { clipped, rect, text, View } from "../svg.mjs";
import { Figure, mils, minutes, straightened } from "./drawing.mjs";

const [FROM, STEP, COUNT, LOW, HIGH] = [2000, 40, 101, 3600, 6400]; // X of the table, and what Y may be, thousandths
const CUTTER = 125; // its radius
const AGAIN = 400; // milliseconds after a change until the computer begins

export function own(record, save) {
  const heights = Array.from({ length: COUNT }, (_, n) => 5000 + 800 * Math.sin(n / 13) * Math.exp(-n / 90));
  let [tape, told, waits, last, view] = [null, "", 0, null, null];

  const figure = new Figure("own", ({ tolerance, place }, width) => {
    const box = { x: 0, y: 0, width, height: Math.round(width * 0.66) };
    view = new View({ left: FROM - 100, right: FROM + STEP * (COUNT - 1) + 100, bottom: LOW, top: HIGH }, box);
    const made = drawn(heights, tolerance);
    const { way } = made;
    const at = way[Math.min(way.length - 1, Math.round((place / 1000) * (way.length - 1)))];
    const shape = heights.map((y, n) => ({ x: FROM + STEP * n, y }));
    const strip = { x: 8, y: box.height + 26, width: width - 62, height: 90 };
    const off = way.map(({ x, y }) => ({ x: x - FROM, y: y - height(heights, x) }));
    const worst = way.slice(1).reduce((most, { x, y }) => Math.max(most, Math.abs(y - height(heights, x)) / steepness(heights, x)), 0);
    const content = view.line(way, `class="groove" style="stroke-width:${2 * CUTTER * view.sx}"`) + view.line(shape, 'class="intended"') + view.line(way, 'class="way"') + view.circle({ ...at, radius: CUTTER }, 'class="tool"');
    const to = ({ x }) => (1000 * Math.max(0, way.findIndex((stop) => view.x(stop.x) >= x))) / (way.length - 1);
    const holds = { place: { x: view.x(at.x), y: view.y(at.y), to } };
    if (made.text !== last) translate(made, (last = made.text));
    const said = html`<b>${made.blocks} blocks</b>: reading ${minutes(made.reading)} + cutting ${minutes(made.milling)} = <b>${minutes(made.minutes)}</b>. A stop is at most <b>${mils(worst, 4)} in</b> off your curve. ${told}`;
    return [clipped(box, content) + rect(box, 'class="frame"') + text(strip.x, strip.y - 7, "the band made straight", 'class="small"') + straightened(strip, STEP * (COUNT - 1), tolerance, 1.6 * tolerance + 1, [[off, "way"]]), strip.y + strip.height + 8, said, holds];
  });

  /** Have eia.pal translate the tape, some seconds of the machine at a time, and the Hydra-Point read what it punched. */
  function translate(made, printout) {
    clearTimeout(waits);
    [tape, told] = [null, ""];
    save.disabled = true;
    const begin = () => {
      const machine = started(record.words, ascii.encode(printout));
      const goOn = () => {
        const until = performance.now() + 12;
        let stop = machine.run(2);
        while (stop.reason === "limit" && performance.now() < until) stop = machine.run(2);
        if (stop.reason === "limit") return (waits = setTimeout(goOn));
        const frames = machine.teletype.punch.tape;
        const same = cut(frames).steps.every((step, n) => step.at.x === made.path.steps[n].at.x && step.at.y === made.path.steps[n].at.y);
        tape = frames;
        save.disabled = false;
        told = `The PDP-8/L took ${minutes(stop.elapsed / 60)} to make its EIA tape, ${frames.length} frames; the Hydra-Point ${same ? "goes the same way by it" : "goes another way by it"}.`;
        figure.later();
      };
      goOn();
    };
    waits = setTimeout(begin, AGAIN);
  }

  let before = null;
  const point = (event) => {
    const { left, top, width } = figure.svg.getBoundingClientRect();
    const scale = figure.svg.viewBox.baseVal.width / width;
    return { n: ((event.clientX - left) * scale - view.ox) / view.sx / STEP - FROM / STEP, y: Math.min(HIGH - 200, Math.max(LOW + 200, (view.oy - (event.clientY - top) * scale) / view.sy)) };
  };
  figure.svg.addEventListener("pointerdown", (event) => {
    if (event.target.closest("[data-hold]") || point(event).y === LOW + 200) return;
    event.preventDefault();
    figure.svg.setPointerCapture(event.pointerId);
    before = point(event);
  });
  figure.svg.addEventListener("pointermove", (event) => {
    if (!before) return;
    const now = point(event);
    const [one, other] = before.n < now.n ? [before, now] : [now, before];
    for (let n = Math.max(0, Math.ceil(one.n)); n <= Math.min(COUNT - 1, other.n); n++) heights[n] = one.y + ((other.y - one.y) * (n - one.n)) / (other.n - one.n || 1);
    before = now;
    figure.later();
  });
  const done = () => {
    if (before) smooth(heights);
    before = null;
    figure.later();
  };
  for (const event of ["pointerup", "pointercancel"]) figure.svg.addEventListener(event, done);
  save.addEventListener("click", () => {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([Uint8Array.from(tape)]));
    link.download = "mine.eia";
    link.click();
  });
  return figure;
}

/** The height of the curve at an X of the table. */
function height(heights, x) {
  const part = Math.min(COUNT - 1, Math.max(0, (x - FROM) / STEP)), n = Math.min(COUNT - 2, Math.floor(part));
  return heights[n] + (heights[n + 1] - heights[n]) * (part - n);
}

/** How much longer a way straight up to the curve is there than one square to it. */
function steepness(heights, x) {
  return Math.hypot(1, (height(heights, x + STEP / 2) - height(heights, x - STEP / 2)) / STEP);
}

/** Let a finger's shake go. */
function smooth(heights) {
  const was = heights.slice();
  for (let n = 1; n < COUNT - 1; n++) heights[n] = (was[n - 1] + 2 * was[n] + was[n + 1]) / 4;
}
