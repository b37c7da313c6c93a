// What the assembler says of a source while it is typed: where its words are, and what is wrong, line by line.

import { FOUND, assemble } from "../../../pal/assembling.mjs";
import { MOST } from "../../../pal/assembly.mjs";
import { counted } from "../../../tapes/measure.mjs";
import { here } from "../written.mjs";

/** Assemble a source, in the dialect that it is written in. */
export function assembled(name, text) {
  return assemble([text], [name], false, undefined, null, FOUND);
}

export function checked({ name, text }) {
  return findings(assembled(name, text));
}

/** What an assembly made, the words of each line, [[line, address, word]], the first diagnostics, and what is said of
 *  the whole.
 */
export function findings(assembly) {
  const placed = assembly.lines.filter(({ address }) => address !== null);
  return {
    ok: assembly.ok,
    tape: assembly.tape,
    words: assembly.words.items(),
    places: placed.map(({ number, address, word }) => [number, address, word]),
    diagnostics: assembly.diagnostics.slice(0, MOST).map(said),
    more: Math.max(0, assembly.diagnostics.length - MOST),
    summary: summary(assembly),
  };
}

function said(diagnostic) {
  const { line, column, end_column, severity, message, advice } = diagnostic;
  const whole = String(diagnostic).replace(/\n {2}\S.*/g, (sentence) => here(sentence));
  return { line, start: column - 1, end: end_column - 1, severity, brief: here(advice).split("; ")[0] || message, whole };
}

/** What became of a source: its words, its tape, how many errors and notes. */
function summary({ diagnostics, tape, words }) {
  const errors = diagnostics.filter(({ error }) => error).length;
  const found = [[errors, "errors"], [diagnostics.length - errors, "notes"]].filter(([number]) => number);
  const listed = found.map(([number, what]) => counted(number, what)).join(", ");
  return `${counted(words.length, "words")}, a tape of ${counted(tape.length, "frames")}${listed && `; ${listed}`}.`;
}
