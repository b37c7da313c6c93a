// What an instruction is called and what it does, in words: those of the table of permanent symbols.

import { DEFER, EXECUTE, INDIRECT, IOT, OPERATIONS, refers_to } from "../../pal/isa.mjs";
import { microinstruction } from "../../pal/disassembler.mjs";
import { PERMANENT } from "../../pal/symbols.mjs";
import { octal } from "./written.mjs";

const MEANINGS = new Map(PERMANENT.map(({ mnemonic, meaning }) => [mnemonic, meaning]));

/** The address of the instruction a processor is in, or of the one that comes. */
export function instructionAt({ next, pc }) {
  return next === DEFER || next === EXECUTE ? (pc - 1) & 0o7777 : pc;
}

/** What `word`, fetched from address `at`, does. */
export function inWords(word, at) {
  const code = word >> 9;
  if (code < IOT) {
    const address = octal(refers_to(word, at));
    return `${MEANINGS.get(OPERATIONS[code])}: ${word & INDIRECT ? `address in ${address}` : address}`;
  }
  const names = microinstruction(word)?.split(" ") ?? [];
  return names.map((name) => MEANINGS.get(name)).join(", ") || "no operation";
}
