// One block on its way through eia.pal: each character read, what the PDP-8/L does with it, the frame it punches.

import { Machine } from "../../computer/machine.mjs";
import { bytes } from "../translator/runtime.mjs";

const KRB = 0o6036; // the character is in AC
const TLS = 0o6046; // AC is punched
const WAITS = [0o6031, 0o6041, 0o5215, 0o5222]; // KSF, TSF, and the JMPs .-1 behind them
const MOST = 4e6; // instructions; a character takes some 17,000

/**
 * Run the program `words`, [[address, word]], on `frames`; return for each character what was done, waiting left out:
 * { character, rows: [{ address, word, ac }], punched: frame or null, waited: instructions }.
 */
export function translated(words, frames) {
  const machine = started(words, frames);
  const { processor } = machine;
  const done = [];
  let now = null;
  for (let count = 0; count < MOST; count++) {
    const address = machine.pc;
    processor.instruction();
    const word = processor.core[address];
    const row = { address, word, ac: machine.ac };
    if (word === KRB) done.push((now = { character: machine.ac, rows: [], punched: null, waited: 0 }));
    if (!now) continue;
    if (WAITS.includes(word)) now.waited += 1;
    else now.rows.push(row);
    if (word === TLS) now.punched = row.ac & 0o377;
    if (done.length === frames.length && word === 0o6031) return done; // waits for a character that does not come
  }
  return done;
}

/** The whole tape, at the speed of this machine: { tape, seconds of 1971 }. */
export function punchedTape(words, frames) {
  const machine = started(words, frames);
  const { elapsed } = machine.run();
  return { tape: machine.teletype.punch.tape, seconds: elapsed };
}

function started(words, frames) {
  const machine = new Machine(false);
  machine.load(words);
  machine.start(0o200);
  machine.teletype.reader.load(bytes(frames));
  return machine;
}
