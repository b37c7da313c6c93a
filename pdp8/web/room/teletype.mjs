// An ASR-33 from before, 22 by 24 inches: its case, the paper as it grows out of it, reader and punch.

import { Paper } from "../../computer/use/keys.mjs";
import { LATER } from "../written.mjs";
import { box, kept, shade, sharpness, sheet, words } from "./ink.mjs";
import { sign } from "./tape.mjs";
import { TYPE } from "./type.mjs";

export const TELETYPE = { w: 22, h: 24, hangs: 3 }; // inches that a tape hangs below it
export const TAPES = { punch: { x: 1.1, head: 10.9, from: 10.6, until: 27 }, reader: { x: 3.5, head: 15.4, from: 12.9, until: 27 } };
const PAPER = { x: 8.4, width: 8.5, line: 11.3, margin: 0.62 };
const COLUMN = 0.1, LINE = 1 / 6;
const SHOWN = 62; // lines that are to be seen
const WEAR = 9; // ways in which a character may be worn
const INK = "#2c2640";
const BOARD = ["1234567890:-", "QWERTYUIOP", "ASDFGHJKL;", "ZXCVBNM,./"];

export function drawTeletype(/** @type {Canvas} */ c) {
  box(c, 0, 9.4, 22, 14.4, [1.1, 1.1, 0.5, 0.5], shade(c, 9.4, 24, ["#c9c2b2", "#aaa292", "#817a6c", "#5d574c"]), 1.4);
  box(c, 0.25, 9.6, 6.1, 13.6, [0.9, 0.3, 0.2, 0.4], shade(c, 9.6, 23, ["#b7b0a0", "#8f8879", "#6d675b"]));
  box(c, 6.9, 9.7, 14.8, 5.6, [0.6, 0.9, 0.2, 0.2], shade(c, 9.7, 15.3, ["#d6cfbf", "#bdb5a5", "#a29a8a"]));
  box(c, 7.5, 10.1, 10.9, 2.5, 0.3, shade(c, 10.1, 12.6, ["#0d0b0a", "#26211d"])); // the window
  words(c, "TELETYPE", 20.9, 14.7, 0.32, { align: "right", weight: 700, colour: "#5a5347", spread: 0.16 });
  box(c, 6.9, 15.6, 14.8, 7, 0.35, shade(c, 15.6, 22.6, ["#4a453d", "#37332d", "#2b2824"]));
  BOARD.forEach((row, line) => [...row].forEach((letter, index) => drawKey(c, 8.3 + line * 0.36 + index * 1.02, 16.7 + line * 1.08, letter)));
  box(c, 9.8, 20.75, 7.6, 0.7, 0.34, shade(c, 20.75, 21.45, ["#8a8478", "#5b564d"]), 0.15);
  box(c, 0.7, 9.9, 4.6, 2.2, 0.16, shade(c, 9.9, 12.1, ["#6e695f", "#48443c"]), 0.3); // the punch
  ["REL", "B.SP", "OFF", "ON"].forEach((name, index) => {
    const [x, y] = [2.75 + (index % 2) * 1.2, 10.15 + Math.floor(index / 2) * 0.95];
    box(c, x, y, 1.05, 0.62, 0.08, shade(c, 10, 12, ["#d8d1c0", "#a39b8a"]), 0.08);
    words(c, name, x + 0.525, y + 0.39, 0.22, { align: "center", colour: "#3a352e", weight: 700 });
  });
  box(c, 2.75, 13.3, 2.9, 5.2, 0.16, shade(c, 13.3, 18.5, ["#6e695f", "#3d3933"]), 0.3); // the reader
  words(c, "PUNCH", 4.95, 12.52, 0.2, { align: "right", colour: "#4f493f", weight: 700 });
  words(c, "READER", 5.5, 18.98, 0.2, { align: "right", colour: "#4f493f", weight: 700 });
}

function drawKey(/** @type {Canvas} */ c, /** @type {number} */ x, /** @type {number} */ y, /** @type {string} */ letter) {
  c.fillStyle = "rgba(0,0,0,.45)";
  c.beginPath();
  c.arc(x, y + 0.09, 0.43, 0, 7);
  c.fill();
  c.fillStyle = shade(c, y - 0.4, y + 0.4, ["#77808a", "#49525b"]);
  c.beginPath();
  c.arc(x, y, 0.4, 0, 7);
  c.fill();
  words(c, letter, x, y + 0.13, 0.36, { align: "center", colour: "#f1ede2", weight: 600, spread: 0 });
}

/** The paper and what is typed on it. Whole lines are drawn once, on a picture that moves up as they come. */
export class Page {
  constructor() {
    this.clear();
  }

  clear() {
    /** @type {Paper} */ this.paper = new Paper(SHOWN);
    /** @type {number} */ this.ended = 0; // lines that are whole
    /** @type {OffscreenCanvas} */ this.picture = LATER;
    /** @type {number} */ this.drawn = /** @type {number} */ this.sharp = 0; // lines on the picture, and its pixels for an inch
  }

  /** Type a frame; return the character it acts on. */
  take(/** @type {number} */ frame) {
    const character = this.paper.take(frame);
    if (character === "\n") this.ended++;
    return character;
  }

  #whole(/** @type {number} */ sharp) {
    const { paper: { lines } } = this;
    const high = Math.round(LINE * sharp);
    if (sharp !== this.sharp) {
      this.picture = new OffscreenCanvas(PAPER.width * sharp, SHOWN * high);
      [this.sharp, this.drawn] = [sharp, 0];
    }
    const fresh = Math.min(this.ended - this.drawn, SHOWN);
    if (!fresh) return this.picture;
    const c = /** @type {OffscreenCanvasRenderingContext2D} */ (this.picture.getContext("2d"));
    c.globalCompositeOperation = "copy";
    c.drawImage(this.picture, 0, -fresh * high);
    c.globalCompositeOperation = "source-over";
    for (let back = 0; back < Math.min(fresh, lines.length - 1); back++) {
      c.setTransform(sharp, 0, 0, sharp, 0, (SHOWN - 1 - back) * high);
      drawLine(c, lines[lines.length - 2 - back], this.ended - back, sharp);
      c.resetTransform();
    }
    this.drawn = this.ended;
    return this.picture;
  }

  /** Draw it, and the type cylinder at the carriage's column. `struck` is 1 as it strikes, then less; `fed` is how much of
   *  the last line's feed is still to come, 0 to 1.
   */
  draw(/** @type {Canvas} */ c, /** @type {number} */ struck, /** @type {number} */ fed) {
    const { ended, paper: { lines, column } } = this;
    const { x, width, line, margin } = PAPER;
    const torn = Math.max(0.3, line - 1.5 - (ended - fed) * LINE);
    c.save();
    c.fillStyle = shade(c, torn, line, ["#b3a98f", "#e2d8be", "#efe6ce", "#e2d8bf"]);
    c.beginPath();
    c.moveTo(x, line + 0.35);
    for (let step = 0; step <= 34; step++) c.lineTo(x + (width * step) / 34, torn + ((step * 29) % 7) * 0.012 + Math.sin(step / 5) * 0.05);
    c.lineTo(x + width, line + 0.35);
    c.fill();
    c.clip();
    const sharp = sharpness(c, 128);
    const y = line - 0.135 + fed * LINE;
    c.drawImage(this.#whole(sharp), x + margin, y - SHOWN * LINE, width, SHOWN * LINE);
    c.translate(x + margin, y);
    drawLine(c, lines.at(-1), ended + 1, sharp);
    c.restore();
    box(c, x - 0.5, line + 0.06, width + 1, 0.34, 0.17, shade(c, line, line + 0.4, ["#4b453d", "#1b1815", "#0c0b0a"])); // the bar of the platen
    const at = x + margin + column * COLUMN + 0.04;
    box(c, x - 0.5, line + 0.86, width + 1, 0.09, 0.04, "#7d766a");
    box(c, at - 0.5, line + 0.52, 1, 0.62, 0.08, shade(c, line + 0.5, line + 1.2, ["#5d574d", "#2c2823"]));
    box(c, at - 0.17, line + 0.06 - struck * 0.12, 0.34, 0.56, 0.06, shade(c, 0, 1, ["#3d3831", "#d9d2c2", "#6b655a"], [at - 0.17, 0, at + 0.17, 0]));
  }
}

/** Draw a line, its upper left corner at 0, 0: no two strikes are alike. */
function drawLine(/** @type {Canvas} */ c, /** @type {string} */ text, /** @type {number} */ line, /** @type {number} */ sharp) {
  for (let at = 0; at < text.length; at++) {
    if (!TYPE.has(text[at])) continue;
    const wear = (at * 7 + text.charCodeAt(at) * 13 + line * 5) % WEAR;
    const picture = kept(`type ${text[at]} ${wear} ${sharp}`, () => sheet(COLUMN, LINE, sharp, (type) => drawType(type, text[at], wear / WEAR)));
    c.drawImage(picture, at * COLUMN, 0, COLUMN, LINE);
  }
}

function drawType(/** @type {Canvas} */ c, /** @type {string} */ character, /** @type {number} */ wear) {
  Object.assign(c, { lineCap: "round", lineJoin: "round", strokeStyle: INK, lineWidth: 0.0125 + wear * 0.005, globalAlpha: 0.8 + wear * 0.2 });
  c.translate(0.014, 0.03 + (wear - 0.5) * 0.006);
  c.stroke(/** @type {Path2D} */ (TYPE.get(character)));
}

/** What the frame under a head says, on a card beside it. */
export function drawSign(/** @type {Canvas} */ c, /** @type {{ x: number; head: number }} */ { x, head }, /** @type {number} */ frame, /** @type {Code} */ code) {
  const said = sign(frame, code);
  if (!said) return;
  const wide = 0.28 + 0.22 * said.length;
  box(c, x - 0.22 - wide, head - 0.25, wide, 0.5, 0.1, "#14110f");
  words(c, said, x - 0.22 - wide / 2, head + 0.13, 0.36, { colour: "#ffcf87", align: "center", weight: 700, spread: 0 });
}

/** What lies over the tapes: the punch's block, the reader's lid with its light slit, its lever. */
export function drawHeads(/** @type {Canvas} */ c, /** @type {boolean} */ reading) {
  box(c, 0.85, 10.05, 1.5, 0.78, 0.08, shade(c, 10, 10.9, ["#928b7d", "#4b463e"]));
  box(c, 3.25, 15.62, 1.5, 0.42, 0.06, shade(c, 15.6, 16.05, ["#a39b8c", "#5b554b"]));
  box(c, 3.25, 14.72, 1.5, 0.42, 0.06, shade(c, 14.7, 15.15, ["#a39b8c", "#5b554b"]));
  box(c, 3.25, 14.8, 0.14, 1.2, 0.04, "#7b7467");
  box(c, 4.61, 14.8, 0.14, 1.2, 0.04, "#7b7467");
  const y = reading ? 16.1 : 17;
  box(c, 5.12, 15.9, 0.18, 1.7, 0.09, "#15120f");
  box(c, 5, y, 0.42, 0.42, 0.21, shade(c, y, y + 0.4, ["#fff4df", "#9e9480"]));
}
