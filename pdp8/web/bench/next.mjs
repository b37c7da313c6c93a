// What can be pressed next: a sentence, and the controls that do it.

import { hands, said, waits_for } from "../../computer/use/ending.mjs";
import { Listing } from "../../computer/use/trace.mjs";
import { find, octal } from "../written.mjs";

const [START, CONT, STOP] = ["start", "cont", "stop"].map((name) => [name.toUpperCase(), `[data-key=${name}]`]);
const AGAIN = ["Assemble and run", "#run-it"];
const RIM = ["Toggle in the RIM loader", "#drill"];
/** @type {Record<string, string[]>} */ const HANDS = {
  keyboard: ["Type a character", "#paper"], tape: ["Choose a tape", "#shelf"], lever: ["Lever to START", "#lever"],
  "high-speed tape": ["Choose a high-speed tape", "#pc8-shelf"],
};

/** What the machine waits for: [sentence, controls as [label, selector]].
 *  @returns {[string, string[][]]} */
export function next(/** @type {Bench} */ { machine, why }) {
  const { processor, waiting } = machine;
  if (!processor.run) return standing(processor, why);
  if (!waiting.endless) return ["The program runs.", [STOP]];
  const waits = waits_for(machine);
  const words = waits.map((each) => said(each, new Listing(), machine.core));
  return [words.join(" "), [...hands(machine, waits).map((hand) => HANDS[hand]), STOP]];
}

/** @returns {[string, string[][]]} */
function standing(/** @type {Processor} */ { core, pc, sing_step: step }, /** @type {string} */ why) {
  const stands = why ? `${why}.` : "The machine is stopped.";
  if (!core.some((word) => word)) return [`${stands} Its core memory is empty.`, out("program") && !out("card") ? [RIM, AGAIN] : [AGAIN]];
  const goes = step ? "CONT does one cycle" : "CONT goes on";
  return [`${stands} START begins at ${octal(pc)}, ${goes}.`, [START, CONT, AGAIN]];
}

/** Whether a pane is not in the page, which shows but some. */
export function out(/** @type {string} */ pane) {
  return find(pane).classList.contains("out");
}
