// What can be pressed next: a sentence, and the controls that do it.

import { find, octal } from "../written.mjs";

const [START, CONT, STOP] = ["start", "cont", "stop"].map((name) => [name.toUpperCase(), `[data-key=${name}]`]);
const AGAIN = ["Assemble and run", "#run-it"];
const PAPER = ["Type", "#paper"];
const RIM = ["Toggle in the RIM loader", "[data-door=rim]"];
const TAPE = ["Choose a tape", "#shelf"];
const LEVER = ["Lever to START", "#lever"];

/** What the machine waits for: [sentence, controls as [label, selector]].
 *  @returns {[string, string[][]]} */
export function next({ machine, why }) {
  const { processor, waiting, teletype: { reader } } = machine;
  if (!processor.run) return standing(processor, why);
  if (!waiting.endless) return ["It runs.", [STOP]];
  if (!machine._out_of_tape()) return ["It waits, and nothing on its way will end that: for a key, perhaps.", [PAPER, STOP]];
  if (reader.loaded && !reader.on) return ["It waits for the tape; the reader's lever is at STOP.", [LEVER, STOP]];
  return ["It waits for more tape.", [TAPE, STOP]];
}

/** @returns {[string, string[][]]} */
function standing({ core, pc, sing_step: step }, why) {
  const said = why ? `${why}.` : "It stands still.";
  if (!core.some((word) => word)) return [`${said} Core is empty.`, out("program") && !out("card") ? [RIM, AGAIN] : [AGAIN]];
  const goes = step ? "CONT does one cycle" : "CONT goes on";
  return [`${said} START begins at ${octal(pc)}, ${goes}.`, [START, CONT, AGAIN]];
}

/** Whether a pane is not in the page, which shows but some. */
function out(pane) {
  return find(pane).classList.contains("out");
}
