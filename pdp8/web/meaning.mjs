// What an instruction is called and what it does, in words: those of the table of permanent symbols.

import { refersTo } from "./computer/isa.mjs";
import { ISA, OPERATIONS, SYMBOLS } from "./facts.mjs";
import { octal } from "./written.mjs";

const GROUP_1 = ["CLA", "CLL", "CMA", "CML", "IAC"];
const GROUP_2 = ["CLA", "OSR", "HLT"];
const SKIPS = { SMA: "SPA", SZA: "SNA", SNL: "SZL" }; // each with its reverse
const BY_OCTAL = new Map(Object.entries(SYMBOLS).map(([name, [word]]) => [word, name]).reverse());

/** The instruction as PAL III writes it: TAD I 0210, CLA CLL, KRB. */
export function mnemonic(word, location) {
  if (word >> 9 < ISA.IOT) {
    return `${OPERATIONS[word >> 9]} ${word & ISA.INDIRECT ? "I " : ""}${octal(refersTo(word, location))}`;
  }
  return BY_OCTAL.get(word) ?? (parts(word).join(" ") || octal(word));
}

/** What `word`, fetched from `location`, does. */
export function inWords(word, location) {
  const code = word >> 9;
  if (code < ISA.IOT) {
    const address = octal(refersTo(word, location));
    return `${SYMBOLS[OPERATIONS[code]][1]}: ${word & ISA.INDIRECT ? `address in ${address}` : address}`;
  }
  const names = BY_OCTAL.has(word) ? [BY_OCTAL.get(word)] : parts(word);
  return names.map((name) => SYMBOLS[name][1]).join(", ") || "no operation";
}

/** The names of the microinstructions in an OPR. */
function parts(word) {
  if (word >> 9 !== ISA.OPR || (word & ISA.GROUP_3) === ISA.GROUP_3) return [];
  if (!(word & ISA.GROUP_2)) return [...GROUP_1.filter((name) => word & ISA[name]), ...rotates(word)];
  return [...skips(word), ...GROUP_2.filter((name) => word & ISA[name])];
}

function rotates(word) {
  const twice = word & ISA.TWICE;
  return [["RAR", "RTR"], ["RAL", "RTL"]].filter(([name]) => word & ISA[name]).map((names) => names[twice ? 1 : 0]);
}

function skips(word) {
  const names = Object.keys(SKIPS).filter((name) => word & ISA[name]);
  if (!(word & ISA.REVERSED)) return names;
  return names.length ? names.map((name) => SKIPS[name]) : ["SKP"];
}
