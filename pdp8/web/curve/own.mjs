// Draw your own: a finger's curve through the part program, eia.pal on the PDP-8/L and the Hydra-Point.

import { linked } from "../bench/sharing.mjs";
import { keep, kept } from "../bench/store.mjs";
import { Figure, mils, minutes, straightened } from "./drawing.mjs";
import { html } from "../html.mjs";
import { Pad } from "../pad.mjs";
import { clipped, rect, text } from "../svg.mjs";
import { answered, made, Wanted } from "./made.mjs";

const CUTTER = 125; // its radius
const AGAIN = 400; // milliseconds after a change until the computer begins
const NAME = "mine.eia";
const KEPT = "pdp8 curve"; // the setting that is it

export function own(/** @type {any} */ record, /** @type {any} */ save, /** @type {any} */ open) {
  let told = "", waits = 0, /** @type {BlobPart & { length: number } | null} */ frames = null, /** @type {string | null} */ last = null;

  const figure = new Figure("own", ({ tolerance, place }, width) => {
    const box = { x: 0, y: 0, width, height: Math.round(width * 0.66) };
    const strip = { x: 8, y: box.height + 26, width: width - 62, height: 90 };
    const view = pad.fit(box);
    const tall = strip.y + strip.height + 8;
    const band = { x: strip.x + strip.width / 2, y: strip.y + strip.height * 0.2, to: (/** @type {Drag} */ { dy, start }) => start - dy / 3 };
    const alone = (/** @type {string} */ said) => [clipped(box, view.line(pad.places, 'class="intended"')) + rect(box, 'class="frame"'), tall, said, { tolerance: band }];
    if (pad.finger) {
      if (last) translate((last = ""), tolerance);
      return alone("Lift the finger, and it is cut.");
    }
    const found = drawn(pad.heights, tolerance);
    if (found.text !== last) translate((last = found.text), tolerance);
    if ("refusal" in found) return alone(found.refusal);
    const { way } = found;
    const at = way[Math.min(way.length - 1, Math.round((place / 1000) * (way.length - 1)))];
    const off = way.map((stop) => pad.beside(stop));
    const worst = off.reduce((most, { y }) => Math.max(most, Math.abs(y)), 0);
    const content = view.line(way, `class="groove" style="stroke-width:${2 * CUTTER * view.sx}"`) + view.line(pad.places, 'class="intended"') + view.line(way, 'class="way"') + view.circle({ ...at, radius: CUTTER }, 'class="tool"');
    const to = (/** @type {Place} */ { x }) => (1000 * Math.max(0, way.findLastIndex((stop) => view.x(stop.x) <= x))) / (way.length - 1);
    const reach = 1.6 * tolerance + 1;
    const holds = { tolerance: { ...band, y: strip.y + (strip.height / 2) * (1 - tolerance / reach) }, place: { x: view.x(at.x), y: view.y(at.y), to } };
    const said = html`<b>${found.blocks} blocks</b>: reading ${minutes(found.reading)} + cutting ${minutes(found.milling)} = <b>${minutes(found.minutes)}</b>. A stop is at most <b>${mils(worst, 4)} in</b> off your curve; promised are ${mils(tolerance + 1)}. ${told}`;
    return [clipped(box, content) + rect(box, 'class="frame"') + text(strip.x, strip.y - 7, "the band made straight", 'class="small"') + straightened(strip, pad.length, tolerance, reach, [[off, "way"]]), tall, said, holds];
  });
  const pad = new Pad(figure.svg, () => {
    if (!pad.finger) keep(KEPT, pad.text);
    figure.later();
  });
  pad.text = kept(KEPT) ?? "";

  /** Have eia.pal translate the tape and the Hydra-Point read what was punched, when nothing has changed for a moment. */
  function translate(/** @type {string} */ printout, /** @type {number} */ tolerance) {
    clearTimeout(waits);
    frames = null;
    told = "";
    save.disabled = true;
    open.removeAttribute("href");
    if (!printout) return;
    waits = setTimeout(async () => {
      const part = { name: "drawn", typed: { heights: pad.text, tolerance: String(tolerance / 1000) }, tape: NAME };
      const [made_, link] = await Promise.all([
        answered("translated", record.words, printout).catch((/** @type {Error} */ { message }) => message), linked({ part }, record.workbench)]);
      if (printout !== last) return;
      if (typeof made_ === "string") {
        told = `Its EIA tape was not made: ${made_}.`;
        return figure.later();
      }
      const { minutes: took, same } = made_;
      ({ frames } = made_);
      save.disabled = false;
      open.href = link;
      told = `The PDP-8/L took ${minutes(took)} to make its EIA tape, ${frames.length} frames; the Hydra-Point ${same ? "goes the same way by it" : "goes another way by it"}.`;
      figure.later();
    }, AGAIN);
  }

  save.addEventListener("click", () => {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([/** @type {BlobPart} */ (frames)]));
    link.download = NAME;
    link.click();
  });
  return figure;
}

/** The curve as it is milled, or why it cannot be: { refusal }. */
function drawn(/** @type {number[]} */ heights, /** @type {number} */ tolerance) {
  try {
    return made("drawn", heights, tolerance);
  } catch (/** @type {any} */ error) {
    if (error instanceof Wanted) throw error;
    return { text: "", refusal: `It cannot be cut: ${error.message}. Widen the band, or draw it less steep there.` };
  }
}
