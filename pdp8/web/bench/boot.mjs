// A program loaded as an operator does, at full speed.

import { TC08 } from "../../computer/dectape/tc08.mjs";
import { one_of_each } from "../../computer/hardware/devices.mjs";
import { restore, save } from "../../computer/past/state.mjs";
import { Operator } from "../../computer/use/operator.mjs";
import { bytes } from "../translator/runtime.mjs";

/** The machine of a saved state, which may have a TC08; its reels are from `media`. */
export function restored(/** @type {string} */ state, media = /** @type {Image[]} */ ([])) {
  return restore(state, [], media, [...one_of_each(), new TC08()], "open it first");
}

/** The machine after it, and what was read. Throws where a loader ends as it should not. */
export function booted(/** @type {string} */ state, /** @type {string} */ loader, /** @type {Iterable<number>} */ tape, /** @type {string} */ name) {
  const machine = restored(state);
  const steps = [...new Operator(machine).boot(loader.encode("latin-1"), bytes(tape), name)];
  return { state: save(machine), said: String(steps.at(-1)) };
}
