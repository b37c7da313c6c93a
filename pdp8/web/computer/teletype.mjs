// The ASR-33 Teletype and its two interfaces, M706 (03) and M707 (04): pdp8/computer/hardware/teletype.py in JavaScript.
//
//       tape ─► reader ─┐                                        ┌─► printer ─► page
//                       ├─ line, 110 baud ─► M706     M707 ─ line ┤
//     fingers ► keyboard┘   READER RUN ◄───  (03)     (04)       └─► punch ─► tape
//
// Names, order and conventions are those of the Python module, which tells them.

import { ASCII, TIMES } from "../facts.mjs";
import { AT_ONCE, CLEAR_AC, Device, NEVER, SKIP } from "./bus.mjs";

const { FRAME, IOP2_TO_IOP4, START_CHECKED, RECEIVED } = TIMES;
const MARKER = 0o400;

/** The ticks of `count` half units of the line, to the nearest tick. */
export function halfUnits(count) {
  return Math.floor((count * (FRAME / 2) + 5) / 11);
}

/** The tape reader: a tape, where it stands under the head, and the lever. */
export class Reader {
  constructor(device) {
    this.device = device;
    this.tape = new Uint8Array(0);
    this.position = 0; // frames read so far of this tape
    this.loaded = false;
    this.on = true; // the lever: START, else STOP
  }

  load(frames) {
    this.tape = Uint8Array.from(frames);
    this.position = 0;
    this.loaded = true;
    this.device.look();
  }

  remove() {
    this.load([]);
    this.loaded = false;
  }

  lever(on) {
    this.on = on;
    this.device.look();
  }

  ready() {
    return this.on && this.position < this.tape.length;
  }

  empty() {
    return this.loaded && this.on && this.position >= this.tape.length;
  }
}

/** The keyboard: the keys pressed that are not yet on the line. */
export class Keyboard {
  constructor(device) {
    this.device = device;
    this.waiting = [];
  }

  press(frames) {
    this.waiting.push(...frames);
    this.device.look();
  }
}

/** M706, device 03: takes characters off the line that the reader and the keyboard share. */
export class Receiver extends Device {
  constructor() {
    super();
    this.reader = new Reader(this);
    this.keyboard = new Keyboard(this);
    this.now = 0;
    this.readerRun = 1;
    this.buffer = 0; // the last character; while the next comes in see `shifted`
    this.frame = 0; // the character on the line
    this.start = 0; // the tick at which its start unit began
    this.stage = 0; // what the receiver has noticed of it: 0 idle, 1 its start unit, 2 that it is no false start
    this.free = 0; // the tick from which the line is free
    this.requested = NEVER; // the tick of the last pulse that set READER RUN
    this.step = NEVER; // the tick of the next thing that happens here; `due` is the next that moves the flag
    this.onFrame = null; // called with each frame and its tick as the flag rises
  }

  look() {
    if (this.stage === 0) this.step = this.due = AT_ONCE;
  }

  plan() {
    if (this.stage === 2) {
      this.step = this.due = this.start + RECEIVED;
      return;
    }
    let start = this.start;
    if (this.stage === 1) {
      this.step = start + START_CHECKED;
    } else if (this.keyboard.waiting.length || (this.readerRun && this.reader.ready())) {
      this.step = start = this.free > this.now ? this.free : this.now;
    } else {
      this.step = this.due = NEVER;
      return;
    }
    this.due = start + (this.flag ? START_CHECKED : RECEIVED);
  }

  advance(now) {
    if (this.step === AT_ONCE) {
      this.now = now;
      this.plan();
    }
    while (this.step <= now) {
      this.now = this.step;
      if (this.stage === 0) {
        this.begin();
      } else if (this.stage === 1) {
        this.flag = 0;
        this.stage = 2;
      } else {
        this.flag = 1;
        this.buffer = this.frame;
        this.stage = 0;
        if (this.onFrame) this.onFrame(this.frame, this.now);
      }
      this.plan();
    }
    this.now = now;
  }

  begin() {
    if (this.keyboard.waiting.length) this.frame = this.keyboard.waiting.shift();
    else if (this.reader.ready()) this.frame = this.reader.tape[this.reader.position++];
    this.readerRun = 0;
    this.start = this.now;
    this.free = this.now + FRAME;
    this.stage = 1;
  }

  /** The buffer as it reads at tick `now`: 377 shifted down, the character coming in above. */
  shifted(now) {
    if (this.stage === 0 || (this.start >= this.requested && now - this.requested <= IOP2_TO_IOP4)) return this.buffer;
    let bits = 0;
    while (bits < 8 && now >= this.start + halfUnits(2 * bits + 3)) bits++;
    return ((this.frame << (8 - bits)) | (0o377 >> bits)) & 0o377;
  }

  pulse(iop, ac, now) {
    if (iop === 1) return this.flag ? SKIP : 0;
    this.advance(now);
    if (iop === 2) {
      this.flag = 0;
      this.readerRun = 1;
      this.requested = now;
      this.plan();
      return CLEAR_AC;
    }
    return this.shifted(now);
  }

  initialize(now) {
    if (this.step !== AT_ONCE) this.advance(now - 1); // a character that would begin now has not begun
    this.buffer = this.shifted(now);
    this.stage = this.flag = 0;
    this.readerRun = 1;
    this.now = now;
    this.plan();
  }

  outOfTape() {
    return this.readerRun === 1 && this.reader.empty();
  }
}

/** The character that a Model 33 prints for a frame: 64 characters, BELL, line feed and return; "" for others. */
export function printed(frame) {
  const code = frame & 0o177;
  if (code === ASCII.BELL || code === ASCII.LF || code === ASCII.CR) return String.fromCharCode(code);
  if (code < ASCII.space || code >= 0o175) return "";
  return String.fromCharCode(code >= 0o140 ? code - 0o40 : code);
}

/** The printer: `onFrame` is called with each frame as it is printed. */
export class Printer {
  constructor() {
    this.frames = [];
    this.onFrame = null;
  }

  take(frame) {
    this.frames.push(frame);
    if (this.onFrame) this.onFrame(frame);
  }
}

/** The tape punch: while it is `on` it punches all 8 channels of every frame it is sent. */
export class Punch {
  constructor() {
    this.frames = [];
    this.on = true;
    this.onFrame = null;
  }

  /** The tape punched so far. */
  get tape() {
    return Uint8Array.from(this.frames);
  }

  take(frame) {
    if (!this.on) return;
    this.frames.push(frame);
    if (this.onFrame) this.onFrame(frame);
  }
}

/** M707, device 04: puts characters on the line, where the printer's selector takes them off. */
export class Transmitter extends Device {
  constructor() {
    super();
    this.printer = new Printer();
    this.punch = new Punch();
    this.register = 0; // what is still to be sent, the next unit lowest, the end marker highest; 0 when idle
    this.start = 0; // the tick at which the start unit begins
    this.shifts = 0; // how many units have followed it
    this.free = 0; // the tick from which the line is free
    this.unit = 0; // the data unit the selector takes next, 1 to 8; 0 while it waits for a start unit
    this.selected = 0; // the data units it has taken
    this.printed = 0; // set while the register sends what the printer was let finish ahead of its time
  }

  plan() {
    if (this.register === 0) this.due = NEVER;
    else if (this.flag) this.due = this.start + halfUnits(2);
    else this.due = this.start + halfUnits(2 * (this.shifts + this.left()));
  }

  /** How many units are still to be sent, the end marker too. */
  left() {
    let units = 9;
    while (!(this.register >> (units - 1))) units--;
    return units;
  }

  advance(now) {
    while (this.register && this.start + halfUnits(2 * this.shifts + 2) <= now) {
      const mark = this.register & 1;
      this.register >>= 1;
      this.shifts++;
      this.flag = 0;
      if (!this.printed) this.select(mark);
      if (this.register === 0) this.end();
    }
    this.plan();
  }

  end() {
    this.flag = 1;
    this.free = this.start + halfUnits(2 * this.shifts + 4);
    this.printed = 0;
    this.stop();
  }

  /** Let the selector finish its frame with marks. */
  stop() {
    while (this.unit) this.select(1);
  }

  /** Let the printer finish what is on the line; the flag keeps its time. */
  finish() {
    for (let rest = this.printed ? 0 : this.register; rest; rest >>= 1) this.select(rest & 1);
    this.stop();
    this.printed = this.register ? 1 : 0;
  }

  select(mark) {
    if (this.unit) {
      this.selected |= mark << (this.unit - 1);
      this.unit++;
      if (this.unit === 9) {
        this.unit = 0;
        this.printer.take(this.selected);
        this.punch.take(this.selected);
      }
    } else if (!mark) {
      this.selected = 0;
      this.unit = 1;
    }
  }

  pulse(iop, ac, now) {
    if (iop === 1) return this.flag ? SKIP : 0;
    this.advance(now);
    if (iop === 2) this.flag = 0;
    else this.load(ac & 0o377, now);
    this.plan();
    return 0;
  }

  /** Or `character` and an end marker into the shift register; if that was empty begin a start unit. */
  load(character, now) {
    if (this.register === 0) {
      this.start = this.free > now ? this.free : now;
      this.shifts = 0;
    }
    if (this.register === 0 || this.printed) {
      this.printed = 0;
      this.select(0);
    }
    this.register |= MARKER | character;
  }

  initialize(now) {
    this.advance(now);
    this.register = this.flag = 0;
    this.free = now;
    if (this.start > now) this.unit = 0;
    this.stop();
    this.printed = 0;
    this.plan();
  }
}

/** The whole ASR-33, on line, its punch on and its reader's lever at START. */
export class Teletype {
  constructor() {
    this.receiver = new Receiver();
    this.transmitter = new Transmitter();
    this.reader = this.receiver.reader;
    this.keyboard = this.receiver.keyboard;
    this.printer = this.transmitter.printer;
    this.punch = this.transmitter.punch;
  }

  connect(bus) {
    bus.fit(0o04, this.transmitter);
    bus.fit(0o03, this.receiver);
  }
}
