// What the 4,096 words of a PDP-8 mean: the functions of pal/isa.py in JavaScript. Its numbers are among the facts.

import { ISA } from "../facts.mjs";

export const { AND, TAD, ISZ, DCA, JMS, JMP, IOT, OPR, FETCH, DEFER, EXECUTE } = ISA;
const { ADDRESS, PAGE, CURRENT_PAGE } = ISA;

/** The address in the memory-reference instruction `word` fetched from `location`. */
export function refersTo(word, location) {
  return (word & ADDRESS) | (word & CURRENT_PAGE ? location & PAGE : 0);
}

/** Whether an indirect reference increments the word at `pointer` first. */
export function autoindexed(pointer) {
  return (pointer & 0o7770) === 0o10;
}

/** Whether `word` at `location` is a direct JMP to `target`. */
export function jumpsTo(target, word, location) {
  return word >> 8 === JMP << 1 && refersTo(word, location) === target;
}

/** Whether `word` is an IOT that sends IOP1 alone, such as KSF. */
export function testsFlag(word) {
  return (word & 0o7007) === 0o6001;
}

/** Whether `word` has the HLT bit of group 2. */
export function halts(word) {
  return (word & 0o7403) === 0o7402;
}
