// The 8/L's front, 19 by 8.75 inches: what never changes, its lamps and switches, and where these are.
//
//     MA  MB  AC  a row of twelve lamps each        IR, states        twelve rockers        eight keys
//
// Left out: the field switches, the lock. PARITY has its lamp, and never lights.
//
// Source: PDP-8/L Users Handbook, chapter 2 (console). Measures and colours: docs/emulated.md.

import { LAMPS, shares } from "../../computer/hardware/panel.mjs";
import { box, kept, shade, sheet, words } from "./ink.mjs";

export const PANEL = { w: 19, h: 8.75 };
export const KEYS = ["mem prot", "start", "load add", "dep", "exam", "cont", "stop", "sing step"];
/** @type {any} */
const ROWS = { ma: [2.3, "MEMORY ADDRESS"], mb: [3.5, "MEMORY BUFFER"], ac: [4.7, "ACCUMULATOR"] };
const SIGNS = ["fetch", "defer", "execute", "word_count", "current_address", "break_", "ion", "parity", "protect", "run"];
/** @type {Record<string, string>} */ const NAMES = { word_count: "WORD COUNT", current_address: "CURR ADDR", break_: "BREAK" };
const HIGH = 1.75; // of a switch with its legend
const LEAST = 9; // pixels of a letter, if there is room
const bit = (/** @type {number} */ index) => 2.75 + index * 0.68 + Math.floor(index / 3) * 0.2;
const key = (/** @type {number} */ index) => 12.05 + index * 0.8;
const LIT = [...[...LAMPS.items()].flatMap(([field]) => lamps(field)), ["ema", 0, 1.7, 2.3]];

/** The lamps of a field of Panel.lamps: [field, bit, x, y]. */
function lamps(/** @type {string} */ field) {
  if (ROWS[field]) return Array.from({ length: 12 }, (_, index) => [field, index, bit(index), ROWS[field][0]]);
  if (field === "link") return [[field, 0, 1.7, ROWS.ac[0]]];
  if (field === "ir") return [0, 1, 2].map((index) => [field, index, 13 + index * 0.68, ROWS.ma[0]]);
  const sign = SIGNS.indexOf(field);
  return [[field, 0, 13 + (sign % 2) * 2.7, 3.1 + Math.floor(sign / 2) * 0.43]];
}

/** Where the switches are: { x, y, w, h }, the twelve rockers and then the keys, for the buttons that lie over them. */
export const SWITCHES = [
  ...Array.from({ length: 12 }, (_, index) => ({ x: bit(index) - 0.34, y: 6.15, w: 0.68, h: HIGH })),
  ...KEYS.map((_, index) => ({ x: key(index), y: 6.15, w: 0.8, h: HIGH })),
];

/** The panel as it is shown: whole, or, where it is too narrow for that, its right part below its left one; where little is to
 *  be had, without the lamps that say least.
 *  A piece is what is seen of it, { x, y, w, h }, and where, { dx, dy }; `w` and `h` are the size of all of it.
 */
export const WHOLE = { w: PANEL.w, h: PANEL.h, pieces: [{ x: 0, y: 0, ...PANEL, dx: 0, dy: 0 }] };
export const APART = {
  w: 8.95, h: 13.75,
  pieces: [
    { x: 2.3, y: 1.6, w: 8.95, h: 6.8, dx: 0, dy: 0 },
    { x: 11.75, y: 1.6, w: 7.1, h: 6.8, dx: 1.75, dy: 6.95 },
    { x: 1.2, y: 1.6, w: 1.1, h: 4, dx: 0.5, dy: 6.95 },
  ],
};

const LITTLE = {
  w: 8.95, h: 9.7,
  pieces: [
    { x: 2.3, y: 1.6, w: 8.95, h: 6.8, dx: 0, dy: 0 },
    { x: 11.75, y: 6, w: 7.1, h: 2.4, dx: 0.92, dy: 7.3 },
    { x: 15.4, y: 4.56, w: 2.2, h: 0.52, dx: 3.4, dy: 6.8 },
  ],
};
const FORMS = [WHOLE, APART, LITTLE];

const TOUCHED = 24.2 / 0.68; // pixels of an inch, so that a finger hits a switch
const ENOUGH = 60; // and of one that nobody needs larger
const seen = (/** @type {Shown} */ form) => (form === WHOLE ? { w: 20.2, h: 10 } : form); // with what is around it

/** How high the panel has to be in that form, where so much is wide. */
export const least = (/** @type {Shown} */ form, /** @type {number} */ w) => seen(form).h * Math.min(TOUCHED, w / seen(form).w);

/** How the panel is shown in a frame: so that a finger hits its switches, as large as may be, with little to scroll. */
export function formed(/** @type {{ w: number; h: number }} */ { w, h }) {
  const worth = (/** @type {Shown} */ form) => {
    const high = Math.max(h, least(form, w));
    const scale = Math.min(w / seen(form).w, high / seen(form).h);
    return Math.min(scale, TOUCHED) ** 2 * Math.min(scale, ENOUGH) * Math.sqrt(h / high) * (form === LITTLE ? 0.88 : 1);
  };
  return FORMS.reduce((best, each) => (worth(each) > worth(best) ? each : best));
}

/** Let `draw` draw the panel as it is `shown`, piece by piece. */
export function inPieces(/** @type {Canvas} */ c, /** @type {Shown} */ shown, /** @type {() => void} */ draw) {
  for (const { x, y, w, h, dx, dy } of shown.pieces) {
    c.save();
    if (shown !== WHOLE) {
      c.beginPath();
      c.rect(dx, dy, w, h);
      c.clip();
      c.translate(dx - x, dy - y);
    }
    draw();
    c.restore();
  }
}

/** Where a place of the panel is in `shown`, WHOLE or APART. */
export function within(/** @type {Shown} */ { pieces }, /** @type {Area} */ { x, y, w, h }) {
  const piece = pieces.find((each) => x >= each.x && x < each.x + each.w) ?? pieces[0];
  return { x: x - piece.x + piece.dx, y: y - piece.y + piece.dy, w, h };
}

/** Filaments: how bright each lamp is, which follows the share of the time in which it was lit. */
export class Filaments {
  constructor() {
    this.lit = new Map();
    this.moves = false; // whether some filament has not followed yet
  }

  /** Follow what some samples of the lamps say; `keep`, 0 to 1, is how much of its brightness a filament keeps; `ema`, the
   *  field that the lamp EMA is of.
   */
  follow(/** @type {Lamps[]} */ samples, keep = 0, ema = 0) {
    this.moves = false;
    this.lit.set("ema", [Math.min(1, ema)]);
    for (const [field, bits] of shares(samples).items()) {
      const before = this.lit.get(field) ?? bits;
      this.lit.set(field, bits.map((now, index) => {
        const off = (before[index] - now) * keep;
        if (Math.abs(off) > 0.01) this.moves = true;
        return now + off;
      }));
    }
  }
}

export function drawPanel(/** @type {Canvas} */ c) {
  box(c, 0, 0, PANEL.w, PANEL.h, 0.22, shade(c, 0, 8.75, ["#4a443d", "#2c2823", "#1d1a17"]), 0.9);
  box(c, 0.22, 0.22, 18.56, 8.31, 0.12, shade(c, 0, 8.5, ["#161412", "#0c0b0a"]));
  box(c, 0.22, 5.72, 18.56, 2.81, 0.12, shade(c, 5.7, 8.5, ["#3a322a", "#29231d"]));
  c.fillStyle = shade(c, 0, 1, ["rgba(255,240,215,.10)", "rgba(255,240,215,.015)", "rgba(255,240,215,0)"], [2, 0, 9, 6]);
  c.fillRect(0.22, 0.22, 18.56, 5.5);
  [..."digital"].forEach((letter, index) => {
    box(c, 0.75 + index * 0.4, 0.62, 0.37, 0.52, 0.02, "#8e2f1d");
    words(c, letter, 0.935 + index * 0.4, 1.01, 0.42, { colour: "#fff6e6", align: "center", weight: 700, spread: 0 });
  });
  words(c, "programmed data processor", 3.95, 1, 0.3, { spread: 0.03 });
  words(c, "PDP-8/L", 18.2, 1.02, 0.42, { align: "right", weight: 700, colour: "#f3e9d6" });
  for (const [y, name] of Object.values(ROWS)) {
    words(c, name, 2.5, y - 0.42, 0.21, { least: LEAST });
    c.fillStyle = "rgba(217,206,185,.28)";
    for (const group of [0, 3, 6, 9, 12]) c.fillRect((group < 12 ? bit(group) : bit(11) + 0.88) - 0.45, y - 0.26, 0.018, 0.52);
  }
  words(c, "INSTR REG", 12.78, 1.88, 0.21, { least: LEAST });
  words(c, "EMA", 1.7, 1.92, 0.19, { align: "center", least: LEAST });
  words(c, "LINK", 1.7, 5.24, 0.19, { align: "center", least: LEAST });
  for (let index = 0; index < 12; index++) words(c, String(index), bit(index), 5.28, 0.2, { align: "center", colour: "#b5a992", least: LEAST });
  for (const field of SIGNS) {
    const [[, , x, y]] = lamps(field);
    words(c, NAMES[field] ?? field.toUpperCase(), x + 0.26, y + 0.075, 0.21, { least: LEAST });
  }
  for (const [, , x, y] of LIT) socket(c, x, y);
  words(c, "SWITCH REGISTER", 2.5, 6.05, 0.19, { colour: "#c6b9a2", least: LEAST });
  SWITCHES.forEach(({ x, w }, index) => {
    const name = index < 12 ? [String(index)] : KEYS[index - 12].toUpperCase().split(" ");
    name.forEach((word, line) => words(c, word, x + w / 2, 8.06 + line * 0.23, 0.19, { align: "center", spread: 0, colour: "#d8ccb5", least: LEAST }));
  });
}

function socket(/** @type {Canvas} */ c, /** @type {number} */ x, /** @type {number} */ y) {
  c.fillStyle = "#2a211a";
  c.beginPath();
  c.arc(x, y, 0.15, 0, 7);
  c.fill();
  c.strokeStyle = "#453a2f";
  c.lineWidth = 0.025;
  c.stroke();
}

/** The lamps, as bright as `lit` says, and the switches; `pressed` is the name of a key that is held down. */
export function drawLamps(/** @type {Canvas} */ c, /** @type {Lit} */ lit, /** @type {Processor} */ { sr, mem_prot: protection, sing_step: step }, /** @type {string | null} */ pressed) {
  c.save();
  c.globalCompositeOperation = "lighter";
  for (const [field, index, x, y] of LIT) {
    const level = lit.get(field)?.[index] ?? 0;
    if (level < 0.02) continue;
    c.globalAlpha = Math.min(1, level * 1.6);
    c.drawImage(glow("ember"), x - 0.62, y - 0.62, 1.24, 1.24);
    c.globalAlpha = level;
    c.drawImage(glow("hot"), x - 0.3, y - 0.3, 0.6, 0.6);
  }
  c.restore();
  /** @type {Record<string, number>} */ const down = { "mem prot": protection, "sing step": step };
  SWITCHES.forEach(({ x, y, w }, index) => {
    const name = KEYS[index - 12];
    const up = name ? pressed === name || down[name] : sr & (0o4000 >> index);
    c.drawImage(rocker(Boolean(up), name ? 2 : Math.floor(index / 3) % 2), x + (w - 0.64) / 2, y, 0.64, 1.6);
  });
}

/** The picture of a rocker that is up or down: of a group of three, of the next, or of the keys. */
const rocker = (/** @type {boolean} */ up, /** @type {number} */ kind) => kept(`${up} ${kind}`, () => sheet(0.64, 1.6, 160, (c) => drawRocker(c, 0, 0, up, kind)));

function drawRocker(/** @type {Canvas} */ c, /** @type {number} */ x, /** @type {number} */ y, /** @type {boolean} */ up, /** @type {number} */ kind) {
  const [light, face, dark] = [["#fff8e8", "#d8ccb4", "#8f836d"], ["#f2a066", "#c2602c", "#6f2f11"], ["#efe5d0", "#b9ad96", "#6f6453"]][kind];
  box(c, x, y + 0.12, 0.64, 1.4, 0.06, "#0e0c0a");
  const middle = y + (up ? 0.62 : 1);
  box(c, x + 0.06, y + 0.17, 0.52, 1.3, 0.05, dark);
  if (up) {
    box(c, x + 0.06, middle, 0.52, 0.85, 0.05, shade(c, middle, middle + 0.85, [light, light, face]));
    box(c, x + 0.06, y + 0.17, 0.52, 0.47, 0.05, shade(c, y + 0.17, middle, [dark, face]));
  } else {
    box(c, x + 0.06, y + 0.17, 0.52, 0.85, 0.05, shade(c, y + 0.17, middle, [face, light]));
    box(c, x + 0.06, middle, 0.52, 0.47, 0.05, shade(c, middle, middle + 0.47, [face, dark]));
  }
}

/** @type {Record<string, [number, string][]>} */ const LIGHT = {
  ember: [[0, "rgba(255,140,40,.95)"], [0.2, "rgba(235,95,18,.85)"], [0.25, "rgba(200,80,15,.3)"], [1, "rgba(120,40,5,0)"]],
  hot: [[0, "rgba(255,244,214,1)"], [0.35, "rgba(255,214,130,.95)"], [0.5, "rgba(255,170,70,.5)"], [1, "rgba(255,140,40,0)"]],
};

/** The picture of a filament that is barely lit, "ember", or of one that burns, "hot". */
const glow = (/** @type {string} */ kind) => kept(kind, () => sheet(1, 1, 128, (c) => {
  const light = c.createRadialGradient(0.5, 0.5, 0, 0.5, 0.5, 0.5);
  LIGHT[kind].forEach(([at, colour]) => light.addColorStop(at, colour));
  c.fillStyle = light;
  c.fillRect(0, 0, 1, 1);
}));
