// Answers marked as `pdp8 check` marks them, by its own code; and where they go wrong.

import { save } from "../../computer/past/state.mjs";
import { Answer, assembled } from "../../lessons/answer.mjs";
import { Case, Exercise, Question, Source, Trial } from "../../lessons/exercise.mjs";
import { first_failed, mark } from "../../lessons/marking.mjs";
import { body } from "../../lessons/page.mjs";
import { find, standing } from "../../lessons/where.mjs";
import { bytes, dict } from "../translator/runtime.mjs";

const TAPES = ["reader", "keys", "tape"];
const TABLES = ["deposit", "core", "hints", "slips", "executed", "callers"];

/** What a file gives for a field. Throws where points are no number, or a table has no names. */
function valued(/** @type {string} */ name, /** @type {any} */ value) {
  if (value === undefined) return value;
  if (name === "again") return value.map((/** @type {any} */ table) => record(Trial, table));
  if (name === "points" && !Number.isFinite(value)) throw new Error(`points: ${JSON.stringify(value)} is no number`);
  if (TABLES.includes(name) && !value.every((/** @type {any[]} */ [key]) => typeof key === "string")) throw new TypeError(name);
  return TAPES.includes(name) ? bytes(value) : TABLES.includes(name) ? dict(value) : value;
}

/** A table of a file as the record that it is; what is not given has its default. */
function record(/** @type {any} */ kind, /** @type {any} */ table) {
  return new kind(...kind.$fields.map((/** @type {string} */ field) => valued(field, table[field])));
}

function question(/** @type {any} */ { answer, ...rest }) {
  return record(Question, Array.isArray(answer) ? { ...rest, answer } : { ...rest, number: answer });
}

/** The exercise that the tables of a file say, as pdp8/lessons/student.py writes them. Throws where they say none. */
export function exercise(/** @type {any} */ { title, task, program = {}, case: cases = [], question: questions = [], others }) {
  for (const text of [title, task]) if (typeof text !== "string") throw new Error("it has no title or no task");
  for (const { name } of [...cases, ...questions]) if (typeof name !== "string") throw new Error("a case or a question has no name");
  const tried = cases.map((/** @type {any} */ { hint, trial, ...rest }) =>
    record(Case, { ...rest, hints: hint, trials: trial.map((/** @type {any} */ table) => record(Trial, table)) }),
  );
  return new Exercise("", title, task, record(Source, program), tried, questions.map(question), others);
}

/** The marks of a source: { right, points, of, said, wrong }: what is said in HTML, and the cases that failed, "" for a hidden one. */
export function marks(/** @type {any} */ tables, /** @type {string} */ name, /** @type {string} */ source) {
  const given = exercise(tables);
  const result = mark(given, new Answer(name, undefined, undefined, source));
  const { right, points, of } = result;
  const wrong = result.marks.filter(({ failures }) => failures.length).map(({ hidden, name: called }) => (hidden ? "" : called));
  return { right, points, of, said: [...body(given, result)].join("\n"), wrong };
}

/** Where a source goes wrong in a case: { says, state, until }, the machine at START and the instructions from there. */
export function located(/** @type {any} */ tables, /** @type {string} */ name, /** @type {string} */ source, /** @type {string} */ called) {
  const answer = assembled(new Answer(name, undefined, undefined, source));
  for (const whole of exercise(tables).cases.find((each) => each.name === called)?.trials ?? []) {
    const failed = first_failed(answer, whole);
    if (!failed) continue;
    const { says, instructions } = find(answer, whole, failed);
    return { says, state: save(standing(answer, whole, failed.outcome.number)), until: instructions };
  }
  return null;
}
