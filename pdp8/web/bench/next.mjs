// What can be pressed next: a sentence, and the controls that do it.

import { hands, waits_for } from "../../computer/use/ending.mjs";
import { find, octal } from "../written.mjs";

const [START, CONT, STOP] = ["start", "cont", "stop"].map((name) => [name.toUpperCase(), `[data-key=${name}]`]);
const AGAIN = ["Assemble and run", "#run-it"];
const RIM = ["Toggle in the RIM loader", "#drill"];
/** @type {Record<string, string[]>} */ const HANDS = {
  keyboard: ["Type a character", "#paper"], tape: ["Choose a tape", "#shelf"], lever: ["Lever to START", "#lever"],
  "high-speed tape": ["Choose a high-speed tape", "#pc8-shelf"],
};

/** Why the machine is stopped or waits, and what can be pressed: [sentences, controls as [label, selector]].
 *  @returns {[string, string[][]]} */
export function next(/** @type {Pick<Bench, "machine" | "why" | "stop">} */ { machine, why, stop }) {
  const { processor, waiting } = machine;
  if (!processor.run) return standing(machine, sentence(why || "The machine is stopped"));
  if (!waiting.endless) return ["The program runs.", [STOP]];
  const waits = stop.reason === "tape out" ? waits_for(machine) : stop.why;
  return [sentence(why || "The program waits"), [...(out("teletype") ? [] : hands(machine, waits).map((hand) => HANDS[hand])), STOP]];
}

/** Words with a full stop. */
function sentence(/** @type {string} */ words) {
  return /[.?!]$/.test(words) ? words : `${words}.`;
}

/** @returns {[string, string[][]]} */
function standing(/** @type {Machine} */ { pc, processor: { core, sing_step: step } }, /** @type {string} */ stands) {
  if (!core.some((word) => word)) return [`${stands} Its core memory is empty.`, out("program") && !out("card") ? [RIM, AGAIN] : [AGAIN]];
  const goes = step ? "CONT does one cycle" : "CONT goes on";
  return [`${stands} START begins at ${octal(pc)}, ${goes}.`, [START, CONT, AGAIN]];
}

/** Whether a pane is not in the page, which shows but some. */
export function out(/** @type {string} */ pane) {
  return find(pane).classList.contains("out");
}
