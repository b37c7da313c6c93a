// The operate instructions (OPR) as pure functions of the 13 bits {L, AC}: pdp8/computer/hardware/operate.py in JavaScript.

import { ISA } from "../facts.mjs";

const { CLA, CLL, CMA, CML, RAR, RAL, TWICE, IAC, SMA, SZA, SNL, REVERSED, OSR } = ISA;

/** {L, AC} after group 1 `word`: clear, complement, increment, rotate, in this order. */
export function group1(word, lac) {
  if (word & CLA) lac &= 0o10000;
  if (word & CLL) lac &= 0o7777;
  if (word & CMA) lac ^= 0o7777;
  if (word & CML) lac ^= 0o10000;
  if (word & IAC) lac = (lac + 1) & 0o17777;
  if (word & (RAR | RAL)) {
    const places = word & TWICE ? 2 : 1;
    let both = 0o17777;
    if (word & RAL) both &= (lac << places) | (lac >> (13 - places));
    if (word & RAR) both &= (lac >> places) | (lac << (13 - places));
    lac = both;
  }
  return lac;
}

/** Whether group 2 `word` skips: SMA, SZA, SNL or-ed together; the bit of SKP (SPA, SNA, SZL, SKP) inverts. */
export function skips(word, lac) {
  const condition =
    ((word & SMA) !== 0 && (lac & 0o4000) !== 0) ||
    ((word & SZA) !== 0 && (lac & 0o7777) === 0) ||
    ((word & SNL) !== 0 && (lac & 0o10000) !== 0);
  return condition !== ((word & REVERSED) !== 0);
}

/** {L, AC} after the skip of group 2 `word`: CLA, then OSR ors the switches in. */
export function group2(word, lac, sr) {
  if (word & CLA) lac &= 0o10000;
  if (word & OSR) lac |= sr;
  return lac;
}
