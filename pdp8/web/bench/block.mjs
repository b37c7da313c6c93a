// The block that passes under a head, by its fields: the digits read so far, and those to come.

import { CHARACTERS, EOB } from "../../../tapes/eia.mjs";
import { CR } from "../../../tapes/ascii.mjs";
import { FIELDS } from "../../../tapes/hydrapoint.mjs";

const SHORT = { preparatory: "prep.", x: "X", y: "Y", reserved: "res.", miscellaneous: "misc." };
const CELLS = [...FIELDS.items(), ["end", 1]];
const DIGITS = FIELDS.values().reduce((sum, width) => sum + width);

export const BLOCK = `<p>${CELLS.map(cell).join("")}</p>`;

/** A field of a block: the digits that are read, those that are not, and its name. */
function cell([name]) {
  return `<span><b><i class="read" data-text></i><i data-text></i></b><small>${SHORT[name] ?? name}</small></span>`;
}

/** The texts of BLOCK for the block at the tape's head; null where there are no blocks. */
export function blockAt({ frames, head, code }) {
  const ends = (frame) => (code === "eia" ? frame === EOB : (frame & 0o177) === CR);
  let from = Math.max(0, head);
  while (from > 0 && !ends(frames[from - 1])) from--;
  let [digits, read] = ["", 0];
  for (let frame = from; frame < frames.length && digits.length <= DIGITS; frame++) {
    const digit = ends(frames[frame]) ? "↵" : digitOf(frames[frame], code);
    digits += digit;
    if (frame <= head) read += digit.length;
    if (digit === "↵") break;
  }
  if (!/^[\d↵]*$/.test(digits)) return null;
  let at = 0;
  return CELLS.flatMap(([, width]) => {
    const shown = digits.slice(at, at + width).padEnd(width, "·");
    const passed = Math.max(0, read - at);
    at += width;
    return [shown.slice(0, passed), shown.slice(passed)];
  });
}

function digitOf(frame, code) {
  if (code === "eia") return CHARACTERS.get(frame, "");
  const character = String.fromCharCode(frame & 0o177);
  return character === " " ? "0" : /\d/.test(character) ? character : "";
}
