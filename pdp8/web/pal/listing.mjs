// What the Teletype types in each pass, frame for frame, and the object tape: pal/listing.py, pal/punch.py.

import { LEADER, PAL_III } from "../facts.mjs";
import { FIELD, ORIGIN, WORD } from "./assembler.mjs";
import { typed } from "./symbols.mjs";

const START_UP = [0];
const LEADER_FRAMES = new Array(PAL_III.LEADER_LENGTH).fill(LEADER);
const RUBOUT = "\x7f", NEW_LINE = "\r\n", EOT = "\x04", UNNUMBERED = " ".repeat(12);
const TYPED = { "\t": `\t${RUBOUT}`, "\f": `${"\0".repeat(6)}\f${"\0".repeat(6)}`, "\r": "" };
const LONGEST = 222; // characters of a line that pass 3 has room for
const SILENT = new Set([0, 0o200, 0o204, 0o215, 0o377]);

/** The object tape of pass 2, as the high-speed punch has it. */
export function tape(output) {
  return Uint8Array.from([...START_UP, ...LEADER_FRAMES, ...output.flatMap(framesOf), ...LEADER_FRAMES]);
}

function framesOf({ punched, value }) {
  if (punched === undefined) return [];
  if (punched === FIELD) return [0o300 | (value << 3)];
  return [(punched === ORIGIN ? 0o100 : 0) | ((value >> 6) & 0o77), value & 0o77];
}

/** {address: word}, field n from n0000 on; where an address comes twice, the later word. */
export function words(output) {
  const core = {};
  let bank = 0;
  for (const { punched, location, value } of output) {
    if (punched === WORD) core[bank | location] = value;
    else if (punched === FIELD) bank = value << 12;
  }
  return core;
}

/** The frames of pass 1: the messages, and after it the symbol table. */
export function first(output, table) {
  return [...START_UP, ...frames(output.map(message).join("")), ...(table ? symbolTable(table, 1) : [])];
}

/** The tape of pass 2 as the ASR-33 punches it, messages and all. */
export function second(output, finished) {
  const body = output.flatMap((piece) => (piece.punched ? framesOf(piece) : frames(message(piece))));
  return [...START_UP, ...LEADER_FRAMES, ...body, ...(finished ? LEADER_FRAMES : [])];
}

/** The frames of pass 3: the listing, and after it the symbol table. */
export function third(source, output, lost, table) {
  const texts = textsOf(source, output, lost);
  const pieces = output.map((piece) => (piece.code ? message(piece) : statement(piece, texts.next().value)));
  return [...START_UP, ...LEADER_FRAMES, ...frames(pieces.join("")), ...(table ? symbolTable(table, 3) : [])];
}

/** The listing by statements: {address, word, source, tape, number}. */
export function lines(source, output, lost) {
  const texts = textsOf(source, output, lost);
  return output.filter((piece) => piece.listed !== undefined).map(({ listed, word, at }) => {
    const { tape: number, line } = source.place(at);
    return { address: word === null ? null : listed, word, source: texts.next().value, tape: number, number: line };
  });
}

/** What is to be read of typed frames: without codes that do not print. */
export function printed(typedFrames) {
  return typedFrames.filter((frame) => !SILENT.has(frame)).map((frame) => String.fromCharCode(frame & 0o177)).join("");
}

export function messageText({ code, subject, location }) {
  return `${code}  ${subject}  AT  ${location.toString(8).padStart(4, "0")}`;
}

function symbolTable(table, number) {
  const typedLines = table.map((entry) => NEW_LINE + symbol(entry, number)).join("");
  const end = frames(RUBOUT + typedLines + NEW_LINE + EOT + NEW_LINE + RUBOUT);
  return [...frames(NEW_LINE), ...LEADER_FRAMES, ...end, ...LEADER_FRAMES];
}

function symbol({ name, value, defined }, number) {
  if (defined) return `${typed(name)}  ${value.toString(8).padStart(4, "0")}`;
  return number === 1 ? message({ code: "UA", subject: typed(name), location: value }) : "";
}

/** Why pass 3 would not list the source, and the item at the end of the line; null if it would. */
export function overlong({ items, spans }) {
  let start = 0;
  for (const [at, [, mark]] of items.entries()) {
    const end = spans[at][1];
    if (mark === "$") break;
    if (mark !== "\r") continue;
    if (end - start > LONGEST) return [`a line of ${end - start} characters: pass 3 has room for ${LONGEST}`, at];
    start = end + 1;
  }
  return null;
}

function frames(text) {
  return Array.from(text, (character) => (character === "\0" ? 0 : character.charCodeAt(0) | 0o200));
}

/** The text of each statement: that of its line where CR ends it, else none. */
function* textsOf({ text, items, spans }, output, lost) {
  for (const [from, after] of lost) {
    const start = spans[from - 1][1] + 1;
    const end = spans[after - 1][1] + 1;
    text = text.slice(0, start) + "\r".repeat(end - start) + text.slice(end);
  }
  let start = 0;
  for (const { listed, at } of output) {
    if (listed === undefined) continue;
    if (items[at][1] !== "\r") {
      yield "";
      continue;
    }
    const end = spans[at][1];
    yield text.slice(start, end).replaceAll("\r", "");
    start = end + 1;
  }
}

function statement({ listed, word }, text) {
  const octal = (value) => value.toString(8).padStart(4, "0");
  const numbers = word === null ? UNNUMBERED : `${octal(listed)}  ${octal(word)}  `;
  return NEW_LINE + numbers + text.replace(/[\t\f\r]/g, (character) => TYPED[character]);
}

function message(piece) {
  return piece.code ? RUBOUT + NEW_LINE + messageText(piece) + RUBOUT : "";
}
