// Which instruction a processor is in: of three cycles the first has counted PC on.

import { DEFER, EXECUTE } from "../../pal/isa.mjs";

/** The address of the instruction a processor is in, or of the one that comes. */
export function instructionAt({ next, pc }) {
  return next === DEFER || next === EXECUTE ? (pc - 1) & 0o7777 : pc;
}
