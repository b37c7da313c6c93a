// A machine as it is at one instant, to come back to: every number of every part, core, and the tapes by reference.
//
// Tapes that are punched and pages that are printed only grow; a snapshot has their lengths.

/** The parts whose numbers are the machine's state. */
function parts({ processor, teletype, highspeed, waiting }) {
  const { receiver, reader, transmitter, punch } = teletype;
  const { readerControl, punchControl } = highspeed;
  const fast = [readerControl, highspeed.reader, punchControl, highspeed.punch];
  return [processor, receiver, reader, transmitter, punch, ...fast, waiting];
}

function rolls({ teletype, highspeed }) {
  return [teletype.printer, teletype.punch, highspeed.punch];
}

const plain = (value) => typeof value === "number" || typeof value === "boolean";

export function snapshot(machine) {
  return {
    numbers: parts(machine).map((part) => Object.fromEntries(Object.entries(part).filter(([, value]) => plain(value)))),
    core: machine.core.slice(),
    keys: machine.teletype.keyboard.waiting.slice(),
    tapes: [machine.teletype.reader.tape, machine.highspeed.reader.tape],
    lengths: rolls(machine).map(({ frames }) => frames.length),
  };
}

/** Bring `machine` back to a snapshot of it. `frames` are the rolls as far as they ever grew, if they were cut since. */
export function restore(machine, { numbers, core, keys, tapes, lengths }, frames = []) {
  parts(machine).forEach((part, index) => Object.assign(part, numbers[index]));
  machine.core.set(core);
  machine.teletype.keyboard.waiting = keys.slice();
  [machine.teletype.reader.tape, machine.highspeed.reader.tape] = tapes;
  rolls(machine).forEach((roll, index) => {
    if (roll.frames.length > lengths[index]) roll.frames.length = lengths[index];
    else if (roll.frames.length < lengths[index]) roll.frames = frames[index].slice(0, lengths[index]);
  });
}

/** The rolls as they are now, for a later `restore`. */
export function grown(machine) {
  return rolls(machine).map(({ frames }) => frames.slice());
}
