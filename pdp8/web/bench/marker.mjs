// Answers marked as `pdp8 check` marks them, in a Worker: no loop of a student's stops the page.
//
//     page ── the exercise's tables, the source ──► Worker, which runs the page's own script ── marks ──► page

import { Answer } from "../../lessons/answer.mjs";
import { Case, Exercise, Question, Source, Trial } from "../../lessons/exercise.mjs";
import { mark } from "../../lessons/marking.mjs";
import { body } from "../../lessons/page.mjs";
import { bytes, dict } from "../translator/runtime.mjs";

const SECONDS = 10; // the most that an answer may take
const TAPES = ["reader", "keys", "tape"];
const TABLES = ["deposit", "core", "hints", "slips"];

function valued(name, value) {
  if (value === undefined) return value;
  return TAPES.includes(name) ? bytes(value) : TABLES.includes(name) ? dict(value) : value;
}

/** A table of a file as the record that it is; what is not given is as it is by itself. */
function record(kind, table) {
  return new kind(...kind.$fields.map((field) => valued(field, table[field])));
}

function question({ answer, ...rest }) {
  return record(Question, Array.isArray(answer) ? { ...rest, answer } : { ...rest, number: answer });
}

/** The exercise that the tables of a file say, as pdp8/lessons/student.py writes them. */
function exercise({ title, task, program = {}, case: cases = [], question: questions = [] }) {
  const tried = cases.map(({ hint, trial, ...rest }) =>
    record(Case, { ...rest, hints: hint, trials: trial.map((table) => record(Trial, table)) }),
  );
  return new Exercise("", title, task, record(Source, program), tried, questions.map(question));
}

/** The marks of a source: { right, points, of, marks, html }. */
export function marks({ tables, name, source }) {
  const result = mark(exercise(tables), new Answer(name, undefined, undefined, source));
  const failed = result.marks.map((each) => [
    each.name, each.points, Array.from(each.failures, ({ what, happened }) => [what, happened]), each.hint,
  ]);
  const { right, points, of, fault } = result;
  return { right, points, of, fault, marks: failed, html: [...body(result)].join("\n") };
}

/** What the page's script does in a Worker. */
export function serve() {
  globalThis.onmessage = ({ data }) => globalThis.postMessage(marks(data));
}

/** The marks of a source, by a Worker. Throws where it takes too long, or the exercise is none. */
export function marked(asked) {
  const script = document.querySelector("script[type=module]").textContent;
  const url = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
  const worker = new Worker(url, { type: "module" });
  return new Promise((resolve, reject) => {
    worker.onmessage = ({ data }) => resolve(data);
    worker.onerror = ({ message }) => reject(new Error(`no exercise: ${message}`));
    worker.postMessage(asked);
    setTimeout(() => reject(new Error(`it took more than ${SECONDS} s, and was ended`)), SECONDS * 1000);
  }).finally(() => {
    worker.terminate();
    URL.revokeObjectURL(url);
  });
}
