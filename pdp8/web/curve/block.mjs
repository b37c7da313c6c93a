// One block as holes, in ASCII as it was punched first, and in EIA; and how the PDP-8/L makes the second of the first.

import * as ascii from "../../../tapes/ascii.mjs";
import * as eia from "../../../tapes/eia.mjs";
import { block as blockOf, FIELDS } from "../../../tapes/hydrapoint.mjs";
import { Figure } from "./drawing.mjs";
import { answered, made } from "./made.mjs";
import { rect, text } from "../svg.mjs";
import { html } from "../html.mjs";
import { find, inches, octal } from "../written.mjs";

/** @type {Record<string, string>} */ const NAMES = { sequence: "number", preparatory: "mill", x: "X", y: "Y", reserved: "0", tool: "feed", miscellaneous: "axis" };
const TRACKS = [1, 2, 4, 0, 8, 16, 32, 64, 128]; // from the edge; the guide holes are the fourth
const ROWS = 27;

/** A tape lying: row by row to the right, track 1 at the top.
 * @returns {[string, number]} */
function tape(/** @type {ArrayLike<number>} */ frames, /** @type {Place} */ box, /** @type {number} */ pitch, now = -1) {
  const up = pitch * 1.02;
  const height = up * 9.6;
  const paper = rect({ x: box.x, y: box.y, width: pitch * (frames.length + 0.4), height }, 'class="paper"');
  const marked = now < 0 ? "" : rect({ x: box.x + pitch * (now + 0.2), y: box.y, width: pitch, height }, 'class="under"');
  const holes = Array.from(frames, (frame, row) => TRACKS.map((bit, track) => {
    const [x, y] = [box.x + pitch * (row + 0.7), box.y + up * (track + 0.8)];
    if (bit && !(frame & bit)) return "";
    return `<circle cx="${x.toFixed(1)}" cy="${y.toFixed(1)}" r="${(pitch * (bit ? 0.36 : 0.2)).toFixed(1)}" class="hole"/>`;
  }).join(""));
  return [paper + marked + holes.join(""), height];
}

const lines = () => made("circle", 5, false).text.trimEnd().split("\n");

export function holes() {
  return new Figure("holes", ({ block }, width) => {
    const line = lines()[block - 1];
    const [first, second] = [ascii.encode(`${line}\n`), eia.encode(`${line.replaceAll(" ", "0")}\n`)];
    const pitch = Math.min(22, (width - 2) / (ROWS + 0.5));
    const size = Math.max(9, Math.min(16, pitch * 0.85));
    const [upper, tall] = tape(first, { x: 0, y: 42 }, pitch);
    const below = 42 + tall + 74;
    const [lower] = tape(second, { x: 0, y: below }, pitch);
    const typed = [...line, "CR", "LF"].map((character, row) => text(pitch * (row + 0.7), 36, character === " " ? "␣" : character, `class="type" style="font-size:${character.length > 1 ? size * 0.72 : size}px" text-anchor="middle"`)).join("");
    const digits = [...line.replaceAll(" ", "0"), "EOB"].map((digit, row) => text(pitch * (row + 0.7), below - 6, digit, `class="type" style="font-size:${digit.length > 1 ? size * 0.6 : size}px" text-anchor="middle"`)).join("");
    const content = text(0, 12, "ASCII, from the time-sharing terminal: 27 rows", 'class="small"') + typed + upper + text(0, below - 46, "EIA, for the Hydra-Point: 20 rows", 'class="small"') + fields(pitch, below - 22, width) + digits + lower;
    const whole = { x: 0, y: 0, width, height: below + tall };
    return [content, below + tall + 6, meaning(line.replaceAll(" ", "0")), { block: { box: whole, to: (/** @type {Drag} */ { dx, start }) => start - dx / 24 } }];
  }, { block: (/** @type {number} */ number) => `${number} of ${lines().length}` });
}

function fields(/** @type {number} */ pitch, /** @type {number} */ y, /** @type {number} */ width) {
  let row = 0;
  return [...FIELDS.items()].map(([name, wide]) => {
    const x = pitch * (row + 0.2);
    row += wide;
    const word = width < 500 ? /** @type {Record<string, string>} */ ({ number: "no.", mill: "", "0": "", feed: "f", axis: "ax" })[NAMES[name]] ?? NAMES[name] : NAMES[name];
    return `<path d="M${x + 1.5} ${y}v-4h${pitch * wide - 3}v4" class="bracket"/>` + text(x + (pitch * wide) / 2, y - 8, word, 'class="small" text-anchor="middle"');
  }).join("");
}

function meaning(/** @type {string} */ digits) {
  const { sequence, preparatory, x, y, tool, miscellaneous: axis } = blockOf(digits);
  const number = String(sequence).padStart(3, "0");
  if (preparatory === 6) return html`Block ${number}: <b>mill</b> to X ${inches(x)}, Y ${inches(y)} in, with the ${axis === 84 ? "X" : "Y"} feed at code ${String(tool).padStart(2, "0")}. A row with one hole alone, at the right, ends the block.`;
  if (preparatory === 9) return html`Block ${number}: <b>depths</b>: feed from Z ${x / 1000} in down to ${y / 1000} in.`;
  return html`Block ${number}: <b>position</b>, one of the six that open the tape: park, tool, coolant, spindle, start of the contour, depth.`;
}

export function computer(/** @type {any} */ record) {
  const listing = new Map(record.listing.map((/** @type {[string, string, string]} */ [address, word, source]) => [`${address} ${word}`, source]));
  const run = (/** @type {number} */ place) => made("characters", record.words, `${lines()[Math.floor(place / ROWS)]}\n`);
  const named = (/** @type {number} */ place) => `${(place % ROWS) + 1} of ${ROWS} of block ${Math.floor(place / ROWS) + 1}: ${shown(run(place)[place % ROWS].character)}`;
  const figure = new Figure("translating", ({ character: place }, width) => {
    const [done, at] = [run(place), place % ROWS];
    const pitch = Math.min(20, (width - 2) / (ROWS + 0.5));
    const punched = done.slice(0, at + 1).filter((each) => each.punched !== null).map((each) => Number(each.punched));
    const [reader, tall] = tape(done.map(({ character }) => character), { x: 0, y: 20 }, pitch, at);
    const [punch] = tape(punched, { x: 0, y: tall + 50 }, pitch, done[at].punched === null ? -1 : punched.length - 1);
    const content = text(0, 12, "under the reader", 'class="small"') + reader + text(0, tall + 42, "out of the punch", 'class="small"') + punch;
    const held = { box: { x: 0, y: 20, width, height: tall }, to: (/** @type {Drag} */ { dx, start }) => start + dx / pitch };
    return [content, 2 * tall + 58, told(done[at], listing), { character: held }];
  }, { character: named });
  const [button, said] = [find("translate"), find("translated")];
  button.addEventListener("click", async () => {
    button.disabled = true;
    try {
      await answered("circle", 5, false);
      const { frames, minutes } = await answered("translated", record.words, `${lines().join("\n")}\n`);
      said.textContent = `${lines().length} blocks: ${minutes.toFixed(1)} minutes at the computer; ${frames.length - 1} frames and a blank one came out.`;
    } catch (/** @type {any} */ { message }) {
      said.textContent = message;
    }
    button.disabled = false;
  });
  return figure;
}

function shown(/** @type {number} */ character) {
  const name = ascii.name(character);
  return name === "space" ? "a space" : name;
}

/** What was done with one character: the steps of the method, and every instruction. */
function told(/** @type {any} */ { character, rows, punched, waited }, /** @type {Map<string, string>} */ listing) {
  const seven = character & 0o177;
  const reduced = (seven + 0o7720) & 0o7777;
  const signed = reduced > 0o3777 ? `−${(0o10000 - reduced).toString(8)}` : reduced.toString(8);
  const end = punched === null ? html`it is not one of the twelve: <b>nothing is punched</b>` : html`punch <b>${octal(punched, 3)}</b>, ${eia.name(punched)} in EIA`;
  const steps = html`<b>${shown(character)}</b> arrives as ${octal(character, 3)}; without channel 8, ${octal(seven, 3)}; less 60, ${signed}; ${end}. All numbers octal.`;
  const body = rows.map((/** @type {Record<string, number>} */ { address, word, ac }) => html`<tr><td>${octal(address)}</td><td>${octal(word)}</td><td>${source(listing, address, word)}</td><td>${octal(ac)}</td></tr>`);
  return html`${steps} <details><summary>${rows.length} instructions, and ${waited} more that only wait for the Teletype</summary><table><thead><tr><th>at</th><th>word</th><th>instruction</th><th>AC after</th></tr></thead><tbody>${body}</tbody></table></details>`;
}

function source(/** @type {Map<string, string>} */ listing, /** @type {number} */ address, /** @type {number} */ word) {
  return (listing.get(`${address} ${word}`) ?? "").split("/")[0].replaceAll("\t", " ").trim();
}
