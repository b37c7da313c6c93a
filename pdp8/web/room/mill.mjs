// The Hydra-Point, 19 by 12 inches: the table with the plate slides under the spindle, which stands still.

import { inches } from "../written.mjs";
import { box, shade, words } from "./ink.mjs";

export const MILL = { w: 19, h: 12 };
const CENTRE = { x: 9.5, y: 7 };
const WIDE = 8.8; // inches that the plate takes
export const TILT = 0.62; // how much of its height a plate keeps, seen from before and above; 1: from above

export function drawMill(/** @type {Canvas} */ c) {
  box(c, 0, 0, MILL.w, MILL.h, 0.3, shade(c, 0, 12, ["#20262a", "#2a3236", "#171b1d"]), 1.2);
}

/** How many inches of the room are a thousandth on a plate of that size. */
export function fitted(/** @type {Bounds} */ { left, right, bottom, top }) {
  return WIDE / Math.max(right - left, top - bottom);
}

/** Let places be those on the plate, in thousandths, Y up; `place` is under the spindle. */
export function lay(/** @type {Canvas} */ c, /** @type {number} */ fit, /** @type {Place} */ place, /** @type {number} */ tilt) {
  c.translate(CENTRE.x, CENTRE.y);
  c.scale(fit, -fit * tilt);
  c.translate(-place.x, -place.y);
}

/** The table under the plate, with its slots, and the plate's edge; `above` is how far it is seen from above, 0 to 1.
 *  Places are those on the plate.
 */
export function drawTable(/** @type {Canvas} */ c, /** @type {Bounds} */ { left, right, bottom, top }, /** @type {number} */ above) {
  const [w, h] = [right - left, top - bottom];
  slab(c, left - 3 * w, bottom - h * 0.32, 7 * w, h * 1.64, w * 0.03 * (1 - above), "#33393c", "#15191b");
  c.fillStyle = "rgba(0,0,0,.45)";
  for (const part of [-0.2, 0.5, 1.2]) c.fillRect(left - 3 * w, bottom + h * part - h * 0.02, 7 * w, h * 0.04);
  c.fillStyle = "rgba(0,0,0,.24)";
  for (const far of [0.02, 0.035, 0.05]) c.fillRect(left + w * far, bottom - h * (0.06 + far), w, h);
  slab(c, left, bottom, w, h, w * 0.055 * (1 - above), "#9aa3a6", "#5c6568");
  c.fillStyle = "rgba(255,255,255,.5)";
  c.fillRect(left, bottom, w, h * 0.008);
}

function slab(/** @type {Canvas} */ c, /** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ w, /** @type {number} */ h, /** @type {number} */ thick, /** @type {string} */ colour, /** @type {string} */ edge) {
  c.fillStyle = edge;
  c.fillRect(x, y - thick, w, thick + 1);
  c.fillStyle = colour;
  c.fillRect(x, y, w, h);
}

/** The ideal curve of a part over what was milled, and a ruler in inches below it and at its left, to eighths. */
export function drawMeasured(/** @type {Canvas} */ c, /** @type {[number, number][]} */ ideal, /** @type {string} */ part) {
  const [xs, ys] = [0, 1].map((axis) => ideal.map((point) => point[axis]));
  const [left, right, bottom, top] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const [width, height, x, y] = [right - left, top - bottom, (left + right) / 2, (bottom + top) / 2];
  const size = Math.max(width, height) / 24; // of the letters
  const label = (/** @type {string} */ text, /** @type {number} */ lx, /** @type {number} */ ly, /** @type {string} */ colour, larger = 1) => {
    c.save();
    c.translate(lx, ly);
    c.scale(size, -size);
    words(c, text, 0, 0, larger, { align: "center", colour, weight: 600, spread: 0 });
    c.restore();
  };
  Object.assign(c, { strokeStyle: "#ffb43b", lineWidth: size / 10, lineJoin: "round" });
  c.beginPath();
  for (const [px, py] of ideal) c.lineTo(px, py);
  c.stroke();
  label(`the ideal ${["circle", "ellipse"].includes(part) ? part : "curve"}`, x, y + size * 0.6, "#8a4b00", 1.3);
  label(`${inches(width)} by ${inches(height)} inches`, x, y - size * 1.3, "#33383a");
  for (const [long, turned] of /** @type {[number, boolean][]} */ ([[width, false], [height, true]])) {
    c.save();
    c.translate(left - (turned ? size * 4.6 : 0), bottom - (turned ? 0 : size * 4.6));
    c.fillStyle = "#d9d3c2";
    c.fillRect(0, 0, turned ? size * 2 : long + size, turned ? long + size : size * 2);
    c.fillStyle = "#2b2620";
    for (let at = 0; at <= long; at += 125) {
      const mark = size * (at % 1000 ? (at % 500 ? 0.4 : 0.6) : 0.9);
      c.fillRect(turned ? size * 2 - mark : at - 3, turned ? at - 3 : size * 2 - mark, turned ? mark : 6, turned ? 6 : mark);
      if (at % 1000 === 0) label(String(at / 1000), turned ? size * 0.55 : at + (at ? 0 : size * 0.4), turned ? at - (at ? size * 0.35 : 0) : size * 0.25, "#2b2620");
    }
    c.restore();
  }
}

/** A cutter of `radius` inches from above, down or up, turned so many times. */
export function drawCutter(/** @type {Canvas} */ c, /** @type {number} */ radius, /** @type {boolean} */ down, /** @type {number} */ turns) {
  const { x, y } = CENTRE;
  c.save();
  c.translate(x, y);
  c.rotate(turns * 2 * Math.PI);
  box(c, -radius, -radius, 2 * radius, 2 * radius, radius, shade(c, 0, 1, ["#e9eeee", "#7b8487", "#2c3133"], [-radius, -radius, radius, radius]), down ? radius / 2 : 2 * radius);
  c.fillStyle = "rgba(20,24,26,.75)";
  for (const [w, h] of [[radius, radius / 10], [radius / 10, radius]]) c.fillRect(-w, -h, 2 * w, 2 * h);
  c.restore();
}

/** The far end of the light. */
export function drawDusk(/** @type {Canvas} */ c) {
  const dusk = c.createRadialGradient(CENTRE.x, CENTRE.y, 3.4, CENTRE.x, 6.4, 11.5);
  dusk.addColorStop(0, "rgba(10,11,12,0)");
  dusk.addColorStop(1, "rgba(10,11,12,.86)");
  c.fillStyle = dusk;
  c.fillRect(0, 0, MILL.w, MILL.h);
}

/** The spindle with a cutter of `radius` inches, down or up, turned so many times; `up` is how far all of it is lifted away. */
export function drawSpindle(/** @type {Canvas} */ c, /** @type {number} */ radius, /** @type {boolean} */ down, /** @type {number} */ turns, /** @type {number} */ up) {
  const { x, y } = CENTRE;
  const tip = y + (down ? 0.12 : -0.9) - up;
  c.fillStyle = `rgba(0,0,0,${0.4 / (1 + up)})`;
  c.beginPath();
  if (down) c.ellipse(x + radius * 0.5, y + 0.1, radius * 1.5, radius * 0.7, 0, 0, 7);
  else c.ellipse(x + 0.35, y + 0.25, radius * 1.25, radius * 0.75, 0, 0, 7);
  c.fill();
  const round = (/** @type {number} */ half, /** @type {any[]} */ ...colours) => shade(c, 0, 1, colours, [x - half, 0, x + half, 0]);
  box(c, x - radius, tip - 2.2, 2 * radius, 2.2, [0, 0, radius * 0.5, radius * 0.5], round(radius, "#3a4042", "#e9eeee", "#7b8487", "#2c3133"));
  c.save();
  c.beginPath();
  c.rect(x - radius, tip - 2.1, 2 * radius, 2.05);
  c.clip();
  c.strokeStyle = "rgba(20,24,26,.6)";
  c.lineWidth = radius * 0.34;
  for (let flute = -6; flute < 4; flute++) {
    const from = tip + (flute + (turns % 1)) * 0.55;
    c.beginPath();
    c.moveTo(x - radius, from + 0.5);
    c.lineTo(x + radius, from);
    c.stroke();
  }
  c.restore();
  const metal = (/** @type {number} */ half) => round(half, "#2d3437", "#cfd6d7", "#8a9396", "#22282a");
  box(c, x - 0.95, tip - 3.3, 1.9, 1.25, 0.1, metal(0.95));
  box(c, x - 1.25, tip - 3.9, 2.5, 0.75, 0.1, metal(1.25));
  box(c, x - 2.6, -2, 5.2, tip - 1.8, [0, 0, 0.4, 0.4], metal(2.6));
  words(c, "HYDRA-POINT", x, tip - 5.6 + 0.85, 0.4, { align: "center", colour: "#1d2224", weight: 700, spread: 0.14 });
  words(c, "MOOG", x, tip - 5.1 + 0.85, 0.28, { align: "center", colour: "#1d2224", weight: 700, spread: 0.3 });
}
