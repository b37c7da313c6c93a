// The tape under the Hydra-Point's head, frames to blocks: nc/blocks.py in JavaScript.
//
// The head senses channels 1 to 4 and 8; a row without holes is the digit 0. A block is 20 rows by position.

import { END_OF_BLOCK, FIELDS, HYDRA_POINT, ROWS } from "../facts.mjs";

const HEAD = 0o217;
const { PREPARATORY, MISCELLANEOUS, TOOL_CODES, TRAVEL } = HYDRA_POINT;

/** A block that the machine refuses, and why. */
export class BlockError extends Error {
  constructor(reason, { number, frame }, row) {
    super(`frame ${frame + row - 1}: block ${number}, row ${row}: ${reason}`);
    this.frame = frame + row - 1;
    this.block = number;
  }
}

/** Yield [{number, frame}, block] of each block in order; throw BlockError at the first that is bad. */
export function* read(frames) {
  const start = frames.findIndex((frame) => frame !== 0);
  if (start < 0) throw new Error("no row is punched: the tape is empty or blank");
  const end = frames.findLastIndex((frame) => frame !== 0) + 1;
  for (let number = 1, frame = start; frame < end; number++, frame += ROWS) {
    const place = { number, frame };
    const block = parsed(place, frames.slice(frame, Math.min(frame + ROWS, end)));
    check(place, block);
    yield [place, block];
  }
}

function parsed(place, rows) {
  rows.forEach((frame, index) => {
    const value = frame & HEAD;
    if (value > END_OF_BLOCK) {
      throw new BlockError(`an end of block with digit holes beside it: ${octal(frame)}`, place, index + 1);
    }
    if (value !== END_OF_BLOCK && value > 9) {
      throw new BlockError(`${octal(frame)} is ${value}, not a decimal digit`, place, index + 1);
    }
    if (value === END_OF_BLOCK && index + 1 < ROWS) {
      throw new BlockError(`the block ends in row ${index + 1}; a block has ${ROWS} rows`, place, index + 1);
    }
  });
  if (rows.length < ROWS) {
    throw new BlockError(`the tape ends after ${rows.length} rows of the block's ${ROWS}`, place, rows.length);
  }
  if ((rows[ROWS - 1] & HEAD) !== END_OF_BLOCK) {
    throw new BlockError(`no end of block in row ${ROWS}, but the digit ${rows[ROWS - 1] & HEAD}`, place, ROWS);
  }
  const block = { digits: [...rows].slice(0, -1).map((frame) => frame & HEAD).join("") };
  let at = 0;
  for (const [name, width] of Object.entries(FIELDS)) {
    block[name] = Number(block.digits.slice(at, at + width));
    at += width;
  }
  return block;
}

function check(place, block) {
  const { preparatory, reserved, miscellaneous, tool, x, y } = block;
  if (!(preparatory in PREPARATORY)) throw new BlockError(`unknown preparatory function ${preparatory}`, place, 4);
  if (reserved) throw new BlockError(`the reserved digit is ${reserved}; it must be 0`, place, 15);
  if (!(miscellaneous in MISCELLANEOUS)) throw new BlockError(`unknown miscellaneous function ${two(miscellaneous)}`, place, 18);
  const [selects, codes] = TOOL_CODES[miscellaneous];
  if (!codes.includes(tool)) throw new BlockError(`unknown ${selects} code ${two(tool)}`, place, 16);
  if (preparatory === HYDRA_POINT.READ_Z) {
    depths(place, x, y);
  } else {
    within(place, 5, "X", x, TRAVEL[0]);
    within(place, 10, "Y", y, TRAVEL[1]);
  }
}

function depths(place, feedPoint, finalDepth) {
  within(place, 5, "Z feed point", feedPoint, TRAVEL[2]);
  within(place, 10, "final depth", finalDepth, TRAVEL[2]);
  if (finalDepth < feedPoint) {
    throw new BlockError(`final depth ${inches(finalDepth)} is above the Z feed point ${inches(feedPoint)}`, place, 10);
  }
}

function within(place, row, name, length, travel) {
  if (length > travel) throw new BlockError(`${name} ${inches(length)} is beyond the travel of ${travel / 1000} in`, place, row);
}

const octal = (frame) => frame.toString(8).padStart(3, "0");
const two = (code) => String(code).padStart(2, "0");
export const inches = (length) => (length / 1000).toFixed(3);
