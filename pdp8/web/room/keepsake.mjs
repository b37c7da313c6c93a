// The visitor's own tape as a picture to keep: the rows of holes that the punch made, a letter under each.

import { ASCII } from "../../../tapes/codes.mjs";
import { sheet, words } from "./ink.mjs";
import { drawTape, PITCH, sign } from "./tape.mjs";

const [W, H] = [1200, 630];
const [LEAST, MOST] = [44, 60]; // rows that are shown, with those that are blank
const END = 0.1; // inches of paper before the first row and after the last one

/** The picture of the last of these frames, which say `made`. */
export function keepsake(/** @type {Bytes} */ frames, /** @type {any} */ made) {
  const blank = Array.from({ length: Math.max(4, Math.ceil((LEAST - frames.length) / 2)) }, () => 0);
  const rows = [...blank, ...frames.slice(-MOST), ...blank];
  const long = (rows.length - 1) * PITCH + 2 * END;
  const scale = Math.min(260, (W - 80) / long);
  const [left, top] = [(W - long * scale) / 2, 330 - scale / 2];
  const label = (/** @type {Canvas} */ c, /** @type {string} */ text, /** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ size, colour = "#c9bca4") => words(c, text, x, y, size, { align: "center", colour, spread: 0.04 });
  // a tape is drawn upright, and the picture of it turned
  const strip = sheet(1.1, long, scale, (c) => drawTape(c, { x: 0, head: END, from: 0, until: long, way: -1, lift: 0.04 }, { frames: rows, code: ASCII, at: 0 }));
  return sheet(W, H, 1, (c) => {
    c.fillStyle = "#1d1916";
    c.fillRect(0, 0, W, H);
    label(c, made, W / 2, 120, made.length > 12 ? 48 : 80, "#f3e9d6");
    c.save();
    c.translate(left, top + scale);
    c.rotate(-Math.PI / 2);
    c.drawImage(strip, 0, 0);
    c.restore();
    rows.forEach((frame, row) => label(c, sign(frame, ASCII), left + (END + row * PITCH) * scale, top + scale * 1.04 + 40, Math.min(34, scale * 0.12), "#ffcf87"));
    label(c, "Punched by a PDP-8/L, a computer of 1968, emulated to the cycle,", W / 2, H - 74, 36);
    label(c, "with a program of five words that I put in by its switches", W / 2, H - 28, 36);
  });
}
