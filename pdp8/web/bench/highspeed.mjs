// The PC8/L beside the Teletype: a tape from the shelf into its reader, and what its punch has punched.

import * as kinds from "../../../tapes/kinds.mjs";
import { Machine } from "../../computer/machine.mjs";
import { find, grouped } from "../written.mjs";

/** A machine as `machine` is, with a PC8/L. */
export function fitted(machine) {
  const copy = new Machine(true);
  copy.put(machine.values());
  return copy;
}

export class HighSpeed {
  constructor(bench) {
    this.bench = bench;
    find("pc8-tear").addEventListener("click", () => this.#tear());
    bench.shelf.offer(find("pc8-shelf"), (name) => this.mount(name));
  }

  /** Put a tape from the shelf into the reader, a loader's on its leader. */
  mount(name) {
    const { frames } = this.bench.shelf.get(name);
    this.bench.touch(({ highspeed }) => highspeed.reader.load(frames.slice(kinds.start(frames))));
  }

  #tear() {
    this.bench.touch(({ highspeed: { punch: { frames } } }) => {
      this.bench.shelf.put("punched", Uint8Array.from(frames));
      frames.clear();
    });
  }

  show() {
    const { machine: { highspeed: { punch: { frames }, reader } }, writer } = this.bench;
    writer.text(find("pc8-reader"), reader.loaded ? `${grouped(reader.position)} of ${grouped(reader.tape.length)}` : "no tape");
    writer.text(find("pc8-punch"), `${grouped(frames.length)} frames punched`);
    if (find("pc8-tear").disabled === frames.length > 0) find("pc8-tear").disabled = !frames.length;
  }
}
