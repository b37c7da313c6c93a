// What a run goes on until: a breakpoint, an address, a changed word, a flag, a frame or a block that is punched.

import { TICKS_PER_SECOND as SECOND } from "../../computer/hardware/signals.mjs";
import { EOB } from "../../../tapes/eia.mjs";

/** Until a breakpoint, or whatever else ends a run. */
export class Until {
  /** Run for so many ticks at most; return how it ended. */
  run(machine, ticks) {
    return machine.run(ticks / SECOND);
  }

  /** The run is over. */
  over() {}
}

/** Until an address is met that is in `places`, breakpoints or words that are written, and `met()` holds. */
class Watched extends Until {
  constructor(places, address, met) {
    super();
    const had = places.has(address);
    places.add(address);
    this.over = () => had || places.discard(address);
    this.met = met;
  }

  run(machine, ticks) {
    const stop = super.run(machine, ticks);
    return stop.reason === "breakpoint" && !this.met() ? machine.run(0) : stop;
  }
}

/** Until a flag of the Teletype rises. */
class Flag extends Until {
  run(machine, ticks) {
    const { bus, processor, teletype: { receiver, transmitter } } = machine;
    const flags = () => [receiver.flag, transmitter.flag];
    const event = bus.next_event(processor.clock);
    const before = flags();
    const stop = super.run(machine, Math.min(ticks, Math.max(1, event - processor.clock)));
    return flags().some((flag, index) => flag > before[index]) ? reached(stop) : stop;
  }
}

/** Until the punch has punched a frame for which `wanted` holds. */
class Punched extends Until {
  constructor({ processor, teletype: { punch } }, wanted) {
    super();
    this.done = false;
    punch.on_frame = (frame) => {
      if (!wanted(frame)) return;
      this.done = true;
      processor.stop();
    };
    this.over = () => (punch.on_frame = null);
  }

  run(machine, ticks) {
    const stop = super.run(machine, ticks);
    return this.done ? reached(stop) : stop;
  }
}

function reached({ pc, elapsed }) {
  return { reason: "reached", pc, elapsed };
}

/** What was asked for: `kind` of thing, and the address where it has one. */
export function until(machine, kind, address) {
  const { core } = machine.processor;
  const word = core[address];
  if (kind === "address") return new Watched(machine.watch.breakpoints, address, () => true);
  if (kind === "word") return new Watched(machine.watch.writes, address, () => core[address] !== word);
  if (kind === "flag") return new Flag();
  return new Punched(machine, (frame) => kind === "frame" || frame === EOB);
}
