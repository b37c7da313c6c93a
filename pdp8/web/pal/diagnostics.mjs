// What is wrong with a source, said to a person: pal/diagnostics.py and pal/dialects.py in JavaScript.
//
//   eia.pal:12:5: UA  LOOP    AT  0203
//       JMP LOOP
//           ^^^^
//     undefined: LOOP is taken as 0377, the last address of its page; define it with LOOP, or LOOP=
//
// The errors are DEC's. Besides, there are notes of ours, of things at which PAL III is silent.

import { DIALECTS, SYMBOLS } from "../facts.mjs";
import { octal } from "../written.mjs";
import { messageText } from "./listing.mjs";

export const ERROR = "error";
export const NOTE = "note";

const PAGE = 0o7600, ADDRESS = 0o177, WIDTH = 100; // characters of a line that are shown
const REFERENCES = new Set(Object.keys(SYMBOLS).filter((name) => SYMBOLS[name][2]));

/** The messages, why PAL III went no further, and our notes, in source order: each with its severity, ERROR or NOTE, its place
 * and what to do. */
export function diagnose(source, messages, stops, notes) {
  if (source.text.length === 1) {
    const place = { tape: 0, line: 1, source: "", start: 0, end: 1 };
    return [{ severity: NOTE, message: "note: the source is empty", advice: "write at least a $", hint: "", ...place }];
  }
  const full = messages.some(({ code }) => code === "ST");
  const said = messages.map((message) => {
    const at = message.code === "IR" ? reference(source, message.at) : message.at;
    const subject = message.subject.trim();
    const advice = ADVICE[message.code](subject, message.location);
    return { severity: ERROR, at, message: messageText(message), advice, hint: hint(message.code, subject) };
  });
  const error = ([reason, at]) => ({ severity: ERROR, at, message: `error: ${reason}`, advice: "", hint: "" });
  const ended = full ? [] : stops.map(error);
  const noted = notes.map(({ at, message, advice }) => ({ severity: NOTE, at, message: `note: ${message}`, advice, hint: "" }));
  const found = [...said, ...ended, ...noted].sort((one, other) => one.at - other.at);
  return found.map((each) => ({ ...each, message: visible(each.message), ...source.place(each.at) }));
}

/** A diagnostic as `pal` prints it, of the source tape that is called `file`. */
export function printed({ message, advice, hint: sentence, line, source, start, end }, file) {
  const [from, to] = excerpt(source, start);
  const margin = source.slice(from, start).replace(/[^\t]/g, " ");
  const shown = visible(source.slice(from, to));
  const carets = "^".repeat(Math.max(1, Math.min(end - start, to - start)));
  const excerpted = shown.trim() ? [`    ${shown}`, `    ${margin}${carets}`] : [];
  const advised = [advice, sentence].filter(Boolean).map((words) => `  ${words}`);
  return [`${file}:${line}:${start + 1}: ${message}`, ...excerpted, ...advised].join("\n");
}

/** A page is shown no control codes of a source. */
function visible(text) {
  return text.replace(/[\0-\x08\n-\x1f\x7f]/g, "·");
}

/** Which part of a line is shown: all of it, or of a long one a screen's width about the place. */
function excerpt(source, place) {
  if (source.length <= WIDTH) return [0, source.length];
  const start = Math.max(0, Math.min(place - WIDTH / 2, source.length - WIDTH));
  return [start, start + WIDTH];
}

/** The memory-reference symbol of the statement that ends there, or its end. */
function reference({ items }, end) {
  for (let at = end; at >= 0; at--) {
    if (at < end && (items[at][1] === "\r" || items[at][1] === ";")) break;
    if (REFERENCES.has(items[at][0])) return at;
  }
  return end;
}

const ADVICE = {
  IC: illegal,
  RD: (name) => `redefinition: ${name} has a value already and takes the new one; use another name`,
  DT: (name) => `duplicate tag: ${name || "it"} keeps the value it has; use another name`,
  ST: (name) => `symbol table full: no room for ${name}, and no tape; use fewer symbols`,
  UA: undefinedAddress,
  IR: beyond,
};

function undefinedAddress(name, location) {
  return `undefined: ${name} is taken as ${octal(location | ADDRESS)}, the last address of its page; define it with ${name}, or ${name}=`;
}

function illegal(code) {
  const value = parseInt(code, 8);
  if (value < 0o200) return `illegal character: the letter ${String.fromCharCode(value + 0o100)} in a number; a symbol begins with a letter`;
  return `illegal character ${spelled(value & 0o177)}: it is passed over; remove it`;
}

function spelled(character) {
  return character > 0o40 && character < 0o177 ? String.fromCharCode(character) : `(code ${octal(character | 0o200)})`;
}

function beyond(address, location) {
  const page = location & PAGE;
  const low = parseInt(address, 8) & ADDRESS;
  return `illegal reference: ${address} is neither on page zero nor on the page of ${octal(location)}; ${octal(page | low)} is used; go through a pointer on this page, with I`;
}

/** What PAL III has instead of what another assembler's dialect says here, or "". */
function hint(code, subject) {
  if (code === "UA") return hintOfSymbol(subject);
  return code === "IC" ? hintOfCharacter(parseInt(subject, 8)) : "";
}

function hintOfSymbol(name) {
  const { GROUPS, LATER, UNKNOWN } = DIALECTS;
  if (name in UNKNOWN) return `${name} is another assembler's: ${UNKNOWN[name]}`;
  if (LATER.includes(name)) return `${name} is not in PAL III's table, being an option's or a later PDP-8's: define it with =`;
  return name in GROUPS ? `${name} is not in PAL III's table: write ${GROUPS[name]}, or ${name}=${GROUPS[name]}` : "";
}

function hintOfCharacter(code) {
  if (code < 0o200) return "";
  const character = String.fromCharCode(code & 0o177);
  if (/[a-z]/.test(character)) return "PAL III knows capital letters only; --modern folds lower case";
  return DIALECTS.CHARACTERS[character] ?? "";
}
