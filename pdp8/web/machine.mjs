// A small PDP-8/L with its ASR-33, one memory cycle at a time, so that a page can show any instant of a run.
//
//     FETCH ──► DEFER ──► EXECUTE ──► FETCH     MA and MB are what the lamps show after each cycle
//        └─────────┴──────────────────► FETCH
//
// Time is in ticks of 0.05 µs: a cycle takes 32, an IOT 85. The Python processor of this project is the authority;
// a test holds the two together cycle by cycle.
//
// Not emulated: MEM PROT, SING STEP, CONT, the high-speed reader and punch, the keyboard.
// Sources: PDP-8/L Users Handbook; Small Computer Handbook (1970); DEC module drawings M706, M707.

export const CYCLE = 32;
export const IOT = 85;
const IOP1 = 29, IOP2 = 47, IOP4 = 65; // from the start of an IOT to each pulse

export const FRAME = 2_000_000; // 11 units of 1/110 s
const START_CHECKED = halfUnits(1); // into the start unit an unread character is lost
const RECEIVED = halfUnits(17); // all 8 bits are in
const NEVER = Number.MAX_SAFE_INTEGER;

export const FETCH = 0;
export const DEFER = 1;
export const EXECUTE = 2;
const INTERRUPT = 3; // an EXECUTE cycle that does JMS 0

/** Ticks of half units of the line, to the nearest. */
function halfUnits(count) {
  return Math.floor((count * (FRAME / 2) + 5) / 11);
}

/** The ASR-33 and its interface: reader and receiver (device 03), punch and transmitter (device 04). */
export class Teletype {
  /** `witness(event, tick)` is told of every frame "received" and "punched". */
  constructor(witness = () => {}) {
    this.witness = witness;
    this.tape = new Uint8Array(0); // in the reader
    this.lever = false; // the reader's: true is START
    this.taken = 0; // frames of it that the reader has started
    this.received = 0; // frames of it that have raised the flag
    this.punched = 0; // frames punched so far
    this.paper = []; // and what they are
    this.coming = 0; // the character on the line
    this.frameStart = 0;
    this.held = 0; // the receiver's buffer between characters
    this.free = 0; // when the line from the reader is free
    this.startAt = this.clearAt = this.flagAt = this.shiftAt = NEVER;
    this.readerRun = true;
    this.asked = -1; // when a pulse last set it
    this.register = 0; // what is still to be sent, the next unit lowest, an end marker highest
    this.unit = 0; // the data unit the printer takes next, 1 to 8; 0 while it waits for a start unit
    this.selected = 0; // the data units it has taken
    this.sendStart = 0; // of the start unit
    this.shifts = 0; // units sent since
    this.sendFree = 0;
    this.initialize(0);
  }

  /** The START key's INITIALIZE: flags down, transmission aborted, the reader told to run. */
  initialize(now) {
    this.startAt = this.startAt < now ? this.startAt : NEVER; // a frame that would begin now has not begun
    this.sync(now);
    this.held = this.buffer(now);
    this.sendFree = now;
    this.readerRun = true;
    this.readerFlag = false;
    this.startAt = NEVER; // the next frame's start bit
    this.clearAt = NEVER;
    this.flagAt = NEVER;
    this.punchFlag = false;
    this.register = 0;
    this.shiftAt = NEVER; // the transmitter's next shift
    if (this.sendStart > now) this.unit = 0;
    this.#endFrame(now);
    this.run(now);
  }

  /** Put a tape in, its first frame under the head and the lever at STOP. */
  mount(tape) {
    this.tape = tape;
    this.lever = false;
    this.taken = 0;
    this.received = 0;
  }

  pullLever(now) {
    this.lever = true;
    if (this.readerRun) this.run(now);
  }

  /** The time of the next thing that happens of itself. */
  next() {
    return Math.min(this.startAt, this.clearAt, this.flagAt, this.shiftAt);
  }

  /** Let everything happen that is due by `now`. */
  sync(now) {
    for (let due = this.next(); due <= now; due = this.next()) {
      if (due === this.startAt) this.#startFrame(due);
      else if (due === this.clearAt) this.#lose();
      else if (due === this.flagAt) this.#receive(due);
      else this.#shift(due);
    }
  }

  #startFrame(now) {
    this.startAt = NEVER;
    this.readerRun = false;
    this.frameStart = now;
    this.free = now + FRAME;
    this.coming = this.tape[this.taken++];
    this.clearAt = now + START_CHECKED;
    this.flagAt = now + RECEIVED;
  }

  #lose() {
    this.clearAt = NEVER;
    this.readerFlag = false;
  }

  #receive(now) {
    this.flagAt = NEVER;
    this.held = this.coming;
    this.readerFlag = true;
    this.received++;
    this.witness("received", now);
  }

  /** Send the next unit; the flag rises with the end marker, the first of two stop units. */
  #shift(now) {
    this.#select(this.register & 1, now);
    this.register >>= 1;
    this.shifts++;
    this.punchFlag = this.register === 0;
    if (this.register) {
      this.shiftAt = this.sendStart + halfUnits(2 * this.shifts + 2);
    } else {
      this.shiftAt = NEVER;
      this.sendFree = this.sendStart + halfUnits(2 * this.shifts + 4);
      this.#endFrame(now);
    }
  }

  /** The printer's selector takes one unit off the line; after the eighth there is a frame. */
  #select(mark, now) {
    if (this.unit) {
      this.selected |= mark << (this.unit - 1);
      if (++this.unit < 9) return;
      this.unit = 0;
      this.paper[this.punched++] = this.selected;
      this.witness("punched", now);
    } else if (!mark) {
      this.selected = 0;
      this.unit = 1;
    }
  }

  /** A line that falls silent ends in marks what it has begun. */
  #endFrame(now) {
    while (this.unit) this.#select(1, now);
  }

  /** Ask the reader for its next frame; one that is on its way is not disturbed. */
  run(now) {
    this.readerRun = true;
    if (this.lever && this.startAt === NEVER && this.taken < this.tape.length) this.startAt = Math.max(now, this.free);
  }

  /** The receiver's shift register, not double-buffered: it can be seen with the bits still coming in. */
  buffer(now) {
    if (this.flagAt === NEVER) return this.held;
    if (this.frameStart === this.asked && now - this.asked <= IOP4 - IOP2) return this.held; // not seen yet
    let bits = 0;
    while (bits < 8 && now >= this.frameStart + halfUnits(2 * bits + 3)) bits++;
    return ((this.coming << (8 - bits)) | (0o377 >> bits)) & 0o377;
  }

  /** Or a character and its end marker into the register; if that was empty, begin a start unit. */
  send(character, now) {
    if (this.register === 0) {
      this.sendStart = Math.max(now, this.sendFree);
      this.shifts = 0;
      this.shiftAt = this.sendStart + halfUnits(2);
      this.#select(0, now);
    }
    this.register |= 0o400 | (character & 0o377);
  }

  save() {
    return { ...this };
  }

  restore(saved) {
    Object.assign(this, saved);
  }
}

/** Registers, core and major states. Addresses and words are 12 bits; what a lamp shows is a field of that name. */
export class Machine {
  constructor(witness) {
    this.core = new Uint16Array(4096);
    this.teletype = new Teletype(witness);
    this.ac = this.link = this.pc = this.ma = this.mb = this.ir = this.sr = 0;
    this.at = 0; // where the current instruction was fetched from
    this.running = false;
    this.ion = false;
    this.ionDelayed = false; // set one instruction after ION
    this.state = FETCH; // the major state of the last cycle, as the lamps show it
    this.next = FETCH; // and of the next
    this.ticks = 0; // since the machine was switched on
    this.started = 0; // at the last START
    this.instructions = 0;
  }

  // The operator's keys; each works only while the machine stands still, STOP only while it runs.

  loadAddress() {
    this.pc = this.ma = this.at = this.sr;
    this.mb = this.core[this.ma];
  }

  examine() {
    this.ma = this.at = this.pc;
    this.mb = this.core[this.ma];
    this.pc = (this.pc + 1) & 0o7777;
  }

  deposit() {
    this.ma = this.at = this.pc;
    this.mb = this.core[this.ma] = this.sr;
    this.pc = (this.pc + 1) & 0o7777;
  }

  start() {
    this.ac = this.link = 0;
    this.ion = this.ionDelayed = false;
    this.state = this.next = FETCH;
    this.teletype.initialize(this.ticks);
    this.started = this.ticks;
    this.running = true;
  }

  stop() {
    while (this.running && this.next !== FETCH) this.cycle();
    this.running = false;
  }

  /** Run until the next cycle would end after `ticks`; standing still, just let time pass. Waiting loops are skipped. */
  runTo(ticks) {
    while (this.running && this.ticks + this.nextCycle() <= ticks) {
      if (this.next === FETCH) this.#skipWaiting(ticks);
      this.cycle();
    }
    if (!this.running) this.ticks = ticks;
    this.teletype.sync(this.ticks);
  }

  /** The ticks the next cycle takes. */
  nextCycle() {
    return this.next === FETCH && this.core[this.pc] >> 9 === 6 ? IOT : CYCLE;
  }

  /** Pass whole turns of `KSF; JMP .-1` or `TSF; JMP .-1`, short of the next thing that happens and of `limit`. */
  #skipWaiting(limit) {
    const word = this.core[this.pc];
    if ((word !== 0o6031 && word !== 0o6041) || this.ion) return;
    const page = this.pc >= 0o200 ? 0o200 : 0;
    if (this.core[this.pc + 1] !== (0o5000 | page | (this.pc & 0o177)) || (this.pc & 0o177) === 0o177) return;
    this.teletype.sync(this.ticks);
    if (word === 0o6031 ? this.teletype.readerFlag : this.teletype.punchFlag) return;
    const turn = IOT + CYCLE;
    const turns = Math.floor((Math.min(limit, this.teletype.next()) - this.ticks) / turn) - 1;
    if (turns <= 0) return;
    this.ticks += turns * turn;
    this.instructions += turns * 2;
  }

  /** One memory cycle. */
  cycle() {
    if (this.next === FETCH) this.#fetch();
    else if (this.next === DEFER) this.#defer();
    else if (this.next === EXECUTE) this.#execute();
    else this.#interrupt();
    if (this.ion && this.next === FETCH) this.#strobe();
  }

  #fetch() {
    this.state = FETCH;
    this.instructions++;
    this.ma = this.at = this.pc;
    this.mb = this.core[this.ma];
    this.ir = this.mb >> 9;
    this.pc = (this.pc + 1) & 0o7777;
    if (this.ir === 6) {
      this.#iot();
      this.ticks += IOT;
      return;
    }
    this.ticks += CYCLE;
    if (this.ir === 7) this.#operate(this.mb);
    else if (this.mb & 0o400) this.next = DEFER;
    else if (this.ir === 5) this.pc = this.#address();
    else this.next = EXECUTE;
  }

  /** The address in the instruction in MB: on page zero, or on the page it was fetched from. */
  #address() {
    return (this.mb & 0o177) | (this.mb & 0o200 ? this.ma & 0o7600 : 0);
  }

  #defer() {
    this.state = DEFER;
    this.ticks += CYCLE;
    this.ma = this.#address();
    this.mb = this.core[this.ma];
    if (this.ma >> 3 === 1) this.#write(this.mb + 1); // autoindex
    if (this.ir === 5) {
      this.pc = this.mb;
      this.next = FETCH;
    } else {
      this.next = EXECUTE;
    }
  }

  #execute() {
    this.ma = this.state === DEFER ? this.mb : this.#address();
    this.state = EXECUTE;
    this.next = FETCH;
    this.ticks += CYCLE;
    this.mb = this.core[this.ma];
    if (this.ir === 0) {
      this.ac &= this.mb;
    } else if (this.ir === 1) {
      const sum = this.ac + this.mb;
      this.ac = sum & 0o7777;
      this.link ^= sum >> 12;
    } else if (this.ir === 2) {
      this.#write(this.mb + 1);
      if (this.mb === 0) this.pc = (this.pc + 1) & 0o7777;
    } else if (this.ir === 3) {
      this.#write(this.ac);
      this.ac = 0;
    } else {
      this.#write(this.pc);
      this.pc = (this.ma + 1) & 0o7777;
    }
  }

  #write(word) {
    this.mb = this.core[this.ma] = word & 0o7777;
  }

  /** End an instruction with ION set: take an interrupt that is requested, unless the machine stops here. */
  #strobe() {
    this.teletype.sync(this.ticks);
    const request = this.teletype.readerFlag || this.teletype.punchFlag;
    if (this.ionDelayed && this.running && request) this.next = INTERRUPT;
    this.ionDelayed = true;
  }

  #interrupt() {
    this.state = EXECUTE;
    this.next = FETCH;
    this.ir = 4;
    this.ma = 0;
    this.#write(this.pc);
    this.pc = 1;
    this.ion = this.ionDelayed = false;
    this.ticks += CYCLE;
  }

  #operate(word) {
    if (!(word & 0o400)) this.#group1(word);
    else if (!(word & 1)) this.#group2(word);
  }

  #group1(word) {
    let lac = (this.link << 12) | this.ac;
    if (word & 0o200) lac &= 0o10000;
    if (word & 0o100) lac &= 0o7777;
    if (word & 0o40) lac ^= 0o7777;
    if (word & 0o20) lac ^= 0o10000;
    if (word & 1) lac = (lac + 1) & 0o17777;
    const places = word & 2 ? 2 : 1;
    const left = ((lac << places) | (lac >> (13 - places))) & 0o17777;
    const right = ((lac >> places) | (lac << (13 - places))) & 0o17777;
    if ((word & 0o14) === 0o14) lac = left & right; // both gates open: a wired AND
    else if (word & 0o4) lac = left;
    else if (word & 0o10) lac = right;
    this.link = lac >> 12;
    this.ac = lac & 0o7777;
  }

  #group2(word) {
    const any = (word & 0o100 && this.ac & 0o4000) || (word & 0o40 && this.ac === 0) || (word & 0o20 && this.link);
    if (Boolean(any) !== Boolean(word & 0o10)) this.pc = (this.pc + 1) & 0o7777;
    if (word & 0o200) this.ac = 0;
    if (word & 4) this.ac |= this.sr;
    if (word & 2) this.running = false;
  }

  #iot() {
    const device = (this.mb >> 3) & 0o77;
    if (device === 0) this.#interruptIot(this.mb);
    else if (device === 3) this.#readerIot(this.mb);
    else if (device === 4) this.#punchIot(this.mb);
  }

  #interruptIot(word) {
    if (word & 1) this.ion = true;
    if (word & 2) this.ion = this.ionDelayed = false;
  }

  #readerIot(word) {
    const { teletype } = this;
    teletype.sync(this.ticks + IOP1);
    if (word & 1 && teletype.readerFlag) this.pc = (this.pc + 1) & 0o7777;
    teletype.sync(this.ticks + IOP2);
    if (word & 2) {
      this.ac = 0;
      teletype.readerFlag = false;
      teletype.asked = this.ticks + IOP2;
      teletype.run(this.ticks + IOP2);
    }
    teletype.sync(this.ticks + IOP4);
    if (word & 4) this.ac |= teletype.buffer(this.ticks + IOP4);
  }

  #punchIot(word) {
    const { teletype } = this;
    teletype.sync(this.ticks + IOP1);
    if (word & 1 && teletype.punchFlag) this.pc = (this.pc + 1) & 0o7777;
    teletype.sync(this.ticks + IOP2);
    if (word & 2) teletype.punchFlag = false;
    teletype.sync(this.ticks + IOP4);
    if (word & 4) teletype.send(this.ac, this.ticks + IOP4);
  }

  save() {
    return { machine: { ...this, core: this.core.slice(), teletype: null }, teletype: this.teletype.save() };
  }

  restore(saved) {
    const { teletype } = this;
    Object.assign(this, saved.machine, { core: saved.machine.core.slice(), teletype });
    teletype.restore(saved.teletype);
  }
}
