// The high-speed reader (01) and punch (02), PC8/L: pdp8/computer/hardware/highspeed.py in JavaScript.
//
//   reader   RSF 1 skip if flag | RRB 2 AC or buffer, flag down | RFC 4 flag down, buffer 0, fetch a frame
//   punch    PSF 1 skip if flag | PCF 2 flag down, buffer 0     | PPC 4 buffer or AC, punch it

import { TIMES } from "../facts.mjs";
import { AT_ONCE, Device, NEVER, SKIP } from "./bus.mjs";
import { Punch, Reader } from "./teletype.mjs";

/** Device 01. */
export class ReaderControl extends Device {
  constructor() {
    super();
    this.reader = new Reader(this);
    this.buffer = 0;
    this.fetching = 0; // set by RFC until the frame is in the buffer
  }

  look() {
    if (this.fetching && this.due === NEVER) this.due = AT_ONCE;
  }

  fetch(now) {
    this.fetching = 1;
    this.due = this.reader.ready() ? now + TIMES.READ : NEVER;
  }

  advance(now) {
    if (this.due === AT_ONCE) {
      this.fetch(now);
    } else if (this.due <= now) {
      this.due = NEVER;
      if (this.reader.ready()) {
        this.buffer = this.reader.tape[this.reader.position++];
        this.flag = 1;
        this.fetching = 0;
      }
    }
  }

  pulse(iop, ac, now) {
    if (iop === 1) return this.flag ? SKIP : 0;
    this.advance(now);
    this.flag = 0;
    if (iop === 2) return this.buffer;
    this.buffer = 0;
    if (!this.fetching) this.fetch(now);
    return 0;
  }

  initialize(now) {
    this.advance(now);
    this.flag = this.buffer = this.fetching = 0;
    this.due = NEVER;
  }

  outOfTape() {
    return this.fetching === 1 && this.reader.empty();
  }
}

/** Device 02. */
export class PunchControl extends Device {
  constructor() {
    super();
    this.punch = new Punch();
    this.buffer = 0;
    this.punched = 0; // set while the punch works on what it was let finish ahead of its time
  }

  advance(now) {
    if (this.due > now) return;
    this.flag = 1;
    this.finish();
    this.punched = 0;
    this.due = NEVER;
  }

  pulse(iop, ac, now) {
    if (iop === 1) return this.flag ? SKIP : 0;
    this.advance(now);
    if (iop === 2) {
      this.flag = this.buffer = 0;
    } else {
      this.buffer |= ac & 0o377;
      if (this.due === NEVER) this.due = now + TIMES.PUNCH;
    }
    return 0;
  }

  /** Punch the frame the punch has begun. */
  finish() {
    if (this.due === NEVER || this.punched) return;
    this.punched = 1;
    this.punch.take(this.buffer);
  }

  initialize(now) {
    this.advance(now);
    this.finish();
    this.flag = this.buffer = this.punched = 0;
    this.due = NEVER;
  }
}

/** The reader and the punch of the PC8/L. */
export class HighSpeed {
  constructor() {
    this.readerControl = new ReaderControl();
    this.punchControl = new PunchControl();
    this.reader = this.readerControl.reader;
    this.punch = this.punchControl.punch;
    this.fitted = false;
  }

  connect(bus) {
    this.fitted = true;
    bus.fit(0o01, this.readerControl);
    bus.fit(0o02, this.punchControl);
  }
}
