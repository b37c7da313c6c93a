// The Hydra-Point, 19 by 12 inches: the table with the plate slides under the spindle, which stands still.

import { box, shade, words } from "./ink.mjs";

export const MILL = { w: 19, h: 12 };
const CENTRE = { x: 9.5, y: 7 };
const WIDE = 8.8; // inches that the plate takes
export const TILT = 0.62; // how much of its height a plate keeps, seen from before and above; 1: from above

export function drawMill(c) {
  box(c, 0, 0, MILL.w, MILL.h, 0.3, shade(c, 0, 12, ["#20262a", "#2a3236", "#171b1d"]), 1.2);
}

/** How many inches of the room are a thousandth on a plate of that size. */
export function fitted({ left, right, bottom, top }) {
  return WIDE / Math.max(right - left, top - bottom);
}

/** Let places be those on the plate, in thousandths, Y up; `place` is under the spindle. */
export function lay(c, fit, place, tilt) {
  c.translate(CENTRE.x, CENTRE.y);
  c.scale(fit, -fit * tilt);
  c.translate(-place.x, -place.y);
}

/** The table under the plate, with its slots, and the plate's edge. Places are those on the plate. */
export function drawTable(c, { left, right, bottom, top }) {
  const [w, h] = [right - left, top - bottom];
  slab(c, left - 3 * w, bottom - h * 0.32, 7 * w, h * 1.64, w * 0.03, "#33393c", "#15191b");
  c.fillStyle = "rgba(0,0,0,.45)";
  for (const part of [-0.2, 0.5, 1.2]) c.fillRect(left - 3 * w, bottom + h * part - h * 0.02, 7 * w, h * 0.04);
  c.fillStyle = "rgba(0,0,0,.24)";
  for (const far of [0.02, 0.035, 0.05]) c.fillRect(left + w * far, bottom - h * (0.06 + far), w, h);
  slab(c, left, bottom, w, h, w * 0.055, "#9aa3a6", "#5c6568");
  c.fillStyle = "rgba(255,255,255,.5)";
  c.fillRect(left, bottom, w, h * 0.008);
}

function slab(c, x, y, w, h, thick, colour, edge) {
  c.fillStyle = edge;
  c.fillRect(x, y - thick, w, thick + 1);
  c.fillStyle = colour;
  c.fillRect(x, y, w, h);
}

/** The far end of the light. */
export function drawDusk(c) {
  const dusk = c.createRadialGradient(CENTRE.x, CENTRE.y, 3.4, CENTRE.x, 6.4, 11.5);
  dusk.addColorStop(0, "rgba(10,11,12,0)");
  dusk.addColorStop(1, "rgba(10,11,12,.86)");
  c.fillStyle = dusk;
  c.fillRect(0, 0, MILL.w, MILL.h);
}

/** The spindle with a cutter of `radius` inches, down or up, turned so many times; `up` is how far all of it is lifted away. */
export function drawSpindle(c, radius, down, turns, up) {
  const { x, y } = CENTRE;
  const tip = y + (down ? 0.12 : -0.9) - up;
  c.fillStyle = `rgba(0,0,0,${0.4 / (1 + up)})`;
  c.beginPath();
  if (down) c.ellipse(x + radius * 0.5, y + 0.1, radius * 1.5, radius * 0.7, 0, 0, 7);
  else c.ellipse(x + 0.35, y + 0.25, radius * 1.25, radius * 0.75, 0, 0, 7);
  c.fill();
  const round = (half, ...colours) => shade(c, 0, 1, colours, [x - half, 0, x + half, 0]);
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
  const metal = (half) => round(half, "#2d3437", "#cfd6d7", "#8a9396", "#22282a");
  box(c, x - 0.95, tip - 3.3, 1.9, 1.25, 0.1, metal(0.95));
  box(c, x - 1.25, tip - 3.9, 2.5, 0.75, 0.1, metal(1.25));
  box(c, x - 2.6, -2, 5.2, tip - 1.8, [0, 0, 0.4, 0.4], metal(2.6));
  words(c, "HYDRA-POINT", x, tip - 5.6 + 0.85, 0.4, { align: "center", colour: "#1d2224", weight: 700, spread: 0.14 });
  words(c, "MOOG", x, tip - 5.1 + 0.85, 0.28, { align: "center", colour: "#1d2224", weight: 700, spread: 0.3 });
}
