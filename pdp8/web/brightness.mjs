// How bright each lamp is: the share of the time in which it was lit since the last look. A filament shows the mean.
//
// A lamp is sampled at instants spread over the time that is shown at once; an instant that would fall on the same
// cycle of a loop every time is avoided by spreading them at random.

import { STATES } from "../../pal/isa.mjs";

const SAMPLES = 16; // of one picture
const WORDS = { MA: 12, MB: 12, AC: 12, IR: 3 };

/** The lamps that are lit now: every bit of the words by name and number, and the single ones. */
export function lit({ processor: p }) {
  const words = { MA: p.ma, MB: p.mb, AC: p.lac & 0o7777, IR: p.ir };
  const lamps = {};
  for (const [name, bits] of Object.entries(WORDS)) {
    for (let bit = 0; bit < bits; bit++) lamps[name + bit] = (words[name] >> (bits - 1 - bit)) & 1;
  }
  lamps.LINK = p.lac >> 12;
  STATES.forEach((name, state) => (lamps[name] = p.state === state ? 1 : 0));
  return Object.assign(lamps, { ION: p.ion, PROTECT: p.protect, RUN: p.run });
}

/** Let `go(tick)` bring a machine to some instants between two ticks and to the second; return the lamps' shares. */
export function over(machine, from, to, go) {
  const samples = [];
  const instants = to - from > SAMPLES ? SAMPLES : 1;
  for (let sample = 1; sample <= instants; sample++) {
    const spread = sample < instants ? sample - Math.random() : sample;
    go(Math.floor(from + ((to - from) * spread) / instants));
    samples.push(lit(machine));
  }
  return mean(samples);
}

/** The share of samples in which each lamp is lit. */
export function mean(samples) {
  const shares = {};
  for (const lamps of samples) for (const name in lamps) shares[name] = (shares[name] ?? 0) + lamps[name] / samples.length;
  return shares;
}
