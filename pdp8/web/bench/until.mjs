// What a run goes on until: a breakpoint, an address, a changed word, a flag, a frame or a block that is punched.
//
// A goal has run(machine, ticks), which runs for so many at most and returns how it ended, and over(), when it is over.

import { TICKS_PER_SECOND as SECOND } from "../../computer/hardware/signals.mjs";
import { EOB } from "../../../tapes/eia.mjs";

/** Until a breakpoint, or whatever else ends a run. */
export const ANY = { run: (machine, ticks) => machine.run(ticks / SECOND), over: () => {} };

/** What more of may be waited for: numbers, of which one grows. */
const COUNTED = {
  flag: ({ receiver, transmitter }) => [receiver.flag, transmitter.flag],
  frame: ({ punch: { frames } }) => [frames.length],
  block: ({ punch: { frames } }) => [frames[frames.length - 1] === EOB ? frames.length : 0],
  character: ({ keyboard, printer, reader }) => [reader.position + printer.frames.length - keyboard.waiting.length],
};

/** Until an address is met that is in `places`, breakpoints or words that are written, and `met()` holds. */
function watched(places, address, met) {
  const had = places.has(address);
  places.add(address);
  const run = (machine, ticks) => {
    const stop = ANY.run(machine, ticks);
    return stop.reason === "breakpoint" && !met() ? machine.run(0) : stop;
  };
  return { run, over: () => had || places.discard(address) };
}

/** Until one of the numbers that `counted` finds at the Teletype grows: it is looked at after each event. */
function grown(counted) {
  const run = (machine, ticks) => {
    const { bus, processor, teletype } = machine;
    const before = counted(teletype);
    const stop = ANY.run(machine, Math.min(ticks, Math.max(1, bus.next_event(processor.clock) - processor.clock)));
    const reached = counted(teletype).some((number, index) => number > before[index]);
    return reached ? { reason: "reached", pc: stop.pc, elapsed: stop.elapsed } : stop;
  };
  return { run, over: ANY.over };
}

/** What was asked for: `kind` of thing, and the address where it has one. */
export function until({ processor: { core }, watch }, kind, address) {
  const word = core[address];
  if (kind === "address") return watched(watch.breakpoints, address, () => true);
  if (kind === "word") return watched(watch.writes, address, () => core[address] !== word);
  return grown(COUNTED[kind]);
}
