// The input/output bus: what the processor and a device say to each other; pdp8/computer/hardware/bus.py in JavaScript.
//
//                   IOP1 IOP2 IOP4, device code, AC
//      processor  ──────────────────────────────────►  device   (flag, due)
//                 ◄──────────────────────────────────
//                   SKIP, clear AC, data or-ed into AC; interrupt request

import { TIMES } from "../facts.mjs";

export const NEVER = Number.MAX_SAFE_INTEGER;
export const AT_ONCE = -1;

// What a device answers to a pulse: data for AC 4-11 in the low bits, and
export const SKIP = 0o10000;
export const CLEAR_AC = 0o20000;

const { IOP1, IOP2, IOP4 } = TIMES; // ticks after the memory cycle

/** One device code: a flag, and `due`, the tick at which it moves next. */
export class Device {
  constructor() {
    this.code = 0;
    this.behind = null; // the next device on the cable
    this.flag = 0;
    this.due = NEVER;
  }

  look() {}

  plan() {}

  finish() {}

  outOfTape() {
    return false;
  }
}

/** The devices that are fitted, one behind the other on the cable; unused codes answer nothing. */
export class Bus {
  constructor() {
    this.first = null;
    this.tested = new Uint8Array(0o100); // the codes whose skip was tested since somebody cleared this
    this.actions = 0; // how often a device, or the interrupt, was changed rather than tested
  }

  *[Symbol.iterator]() {
    for (let device = this.first; device; device = device.behind) yield device;
  }

  fit(code, device) {
    device.code = code;
    device.behind = this.first;
    this.first = device;
  }

  device(code) {
    let device = this.first;
    while (device !== null && device.code !== code) device = device.behind;
    return device;
  }

  /** Send the pulses of IOT `word`; {L, AC} as they are afterwards, above them 1 if the device answered SKIP. */
  transfer(word, lac, clock) {
    const device = this.device((word >> 3) & 0o77);
    if (device === null) return lac;
    if (word & 1) {
      this.tested[device.code] = 1;
      lac = pulse(device, 1, lac, clock + IOP1);
    }
    if (word & 2) {
      this.actions++;
      lac = pulse(device, 2, lac, clock + IOP2);
    }
    if (word & 4) {
      this.actions++;
      lac = pulse(device, 4, lac, clock + IOP4);
    }
    return lac;
  }

  advance(now) {
    for (let device = this.first; device !== null; device = device.behind) device.advance(now);
  }

  request(now) {
    for (let device = this.first; device !== null; device = device.behind) {
      if (device.due <= now) device.advance(now);
      if (device.flag) return true;
    }
    return false;
  }

  /** The tick after `now` at which a flag moves next, NEVER if none will. */
  nextEvent(now) {
    let event = NEVER;
    for (let device = this.first; device !== null; device = device.behind) {
      if (device.due <= now) device.advance(now);
      if (device.due < event) event = device.due;
    }
    return event;
  }

  finish() {
    for (const device of this) device.finish();
  }

  initialize(now) {
    this.actions++;
    for (const device of this) device.initialize(now);
  }
}

function pulse(device, iop, lac, now) {
  if (device.due <= now) device.advance(now);
  const answer = device.pulse(iop, lac & 0o7777, now);
  if (answer & CLEAR_AC) lac &= 0o30000;
  if (answer & SKIP) lac |= 0o20000;
  return lac | (answer & 0o7777);
}
