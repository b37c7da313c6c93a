// The PDP-8/L's processor, one memory cycle at a time: pdp8/computer/hardware/processor.py in JavaScript.
//
//              ┌────────── direct JMP, OPR, IOT ──────────┐
//              ▼                                          │
//   ┌──►  FETCH ──── indirect ────►  DEFER ──── JMP I ────┤
//   │      │ direct                   │                   │
//   │      └───────►  EXECUTE  ◄──────┘                   │
//   │                    │                                │
//   └────────────────────┴── end of instruction ◄─────────┘
//                            │ request and ION
//                            ▼
//                    INTERRUPT: an EXECUTE cycle that does JMS 0
//
// The Python module is the authority, and says what is not emulated and where each fact is from. Names and order
// are the same here, so that a change there is easy to make here; a test holds both together cycle by cycle.

import { INTERRUPT, ISA, PROTECTED, TIMES } from "../facts.mjs";
import { AND, autoindexed, DCA, DEFER, EXECUTE, FETCH, IOT, ISZ, JMP, JMS, OPR, refersTo, TAD } from "./isa.mjs";
import { group1, group2, skips } from "./operate.mjs";

const { GROUP_2, GROUP_3, HLT, INDIRECT } = ISA;
const { CYCLE, IO_TICKS } = TIMES;

export class Processor {
  constructor(bus) {
    this.bus = bus;
    this.core = new Uint16Array(0o10000);
    this.lac = 0; // the link and the accumulator, one word of 13 bits
    this.pc = 0;
    this.ma = 0;
    this.mb = 0;
    this.ir = 0;
    this.state = FETCH; // the major state of the last cycle, as the lamps show it
    this.next = FETCH; // and of the next one
    this.run = 0;
    this.stopping = 0; // set by STOP until the instruction ends
    this.ion = 0;
    this.ionDelayed = 0; // interrupts are taken when this is set too, one instruction after ION
    this.sr = 0;
    this.memProt = 0;
    this.singStep = 0;
    this.protect = 0;
    this.clock = 0; // ticks since power-up
    this.started = 0; // the clock at the last INITIALIZE
    this.instructions = 0; // fetched since power-up
    this.writes = 0; // how often a word of core was written
    this.at = 0; // the address of the last FETCH: the line of a listing. The page's own
  }

  /** INITIALIZE: clear AC, L and the interrupt, and every device; core and PC stay. */
  initialize() {
    this.lac = this.ion = this.ionDelayed = this.stopping = 0;
    this.state = this.next = FETCH;
    this.started = this.clock;
    this.bus.initialize(this.clock);
  }

  /** Write `word` into core at `address`, whoever does it. */
  deposit(address, word) {
    this.core[address] = word;
    this.writes++;
  }

  /** STOP: RUN goes off as the instruction ends, before an interrupt that is due. */
  stop() {
    if (this.next === DEFER || this.next === EXECUTE) {
      this.stopping = this.run;
    } else {
      this.run = 0;
      this.next = FETCH;
    }
  }

  /** Run one memory cycle. */
  cycle() {
    this.protect = 0;
    if (this.next === FETCH) this.#fetch();
    else if (this.next === DEFER) this.#defer();
    else if (this.next === EXECUTE) this.#execute();
    else this.#interrupt();
    if (this.next === FETCH && (this.ion || this.stopping)) this.#end();
  }

  /** Run cycles to the end of the instruction, or the one of an interrupt that is due. */
  instruction() {
    this.protect = 0;
    if (this.next === INTERRUPT) {
      this.#interrupt();
      return;
    }
    if (this.next === FETCH) this.#fetch();
    if (this.next === DEFER) this.#defer();
    if (this.next === EXECUTE) this.#execute();
    if (this.ion || this.stopping) this.#end();
  }

  /** The ticks that the next cycle takes. */
  nextCycle() {
    return this.next === FETCH && this.core[this.pc] >> 9 === IOT ? CYCLE + IO_TICKS : CYCLE;
  }

  #fetch() {
    this.state = FETCH;
    this.ma = this.at = this.pc;
    const word = this.core[this.ma];
    const code = word >> 9;
    this.mb = word;
    this.ir = code;
    this.pc = (this.ma + 1) & 0o7777;
    this.clock += CYCLE;
    this.instructions++;
    if (code < JMP) this.next = word & INDIRECT ? DEFER : EXECUTE;
    else if (code === OPR) this.#operate(word);
    else if (code === IOT) this.#inputOutput(word);
    else if (word & INDIRECT) this.next = DEFER;
    else this.pc = refersTo(word, this.ma);
  }

  #defer() {
    this.state = DEFER;
    this.ma = refersTo(this.mb, this.ma);
    this.mb = this.core[this.ma];
    if (autoindexed(this.ma)) this.#write((this.mb + 1) & 0o7777);
    if (this.ir === JMP) {
      this.pc = this.mb;
      this.next = FETCH;
    } else {
      this.next = EXECUTE;
    }
    this.clock += CYCLE;
  }

  #execute() {
    this.ma = this.state === DEFER ? this.mb : refersTo(this.mb, this.ma);
    this.state = EXECUTE;
    this.next = FETCH;
    this.mb = this.core[this.ma];
    if (this.ir === TAD) {
      this.lac = (this.lac + this.mb) & 0o17777;
    } else if (this.ir === DCA) {
      this.#write(this.lac & 0o7777);
      this.lac &= 0o10000;
    } else if (this.ir === AND) {
      this.lac &= this.mb | 0o10000;
    } else if (this.ir === ISZ) {
      this.#write((this.mb + 1) & 0o7777);
      if (this.mb === 0) this.pc = (this.pc + 1) & 0o7777;
    } else {
      this.#write(this.pc);
      this.pc = (this.ma + 1) & 0o7777;
    }
    this.clock += CYCLE;
  }

  #interrupt() {
    this.state = EXECUTE;
    this.next = FETCH;
    this.ir = JMS;
    this.ma = 0;
    this.#write(this.pc);
    this.pc = 1;
    this.ion = this.ionDelayed = 0;
    this.clock += CYCLE;
  }

  /** Write `word` through MB into core at MA; where MEM PROT forbids it, stop the machine instead. */
  #write(word) {
    if (this.memProt && this.ma >= PROTECTED) {
      this.protect = 1;
      this.run = 0;
      return;
    }
    this.mb = word;
    this.deposit(this.ma, word);
  }

  #operate(word) {
    if (!(word & GROUP_2)) {
      this.lac = group1(word, this.lac) & 0o17777;
    } else if ((word & GROUP_3) !== GROUP_3) {
      if (skips(word, this.lac)) this.pc = (this.pc + 1) & 0o7777;
      this.lac = group2(word, this.lac, this.sr);
      if (word & HLT) this.run = 0;
    }
  }

  #inputOutput(word) {
    if (word & 0o770) {
      const answer = this.bus.transfer(word, this.lac, this.clock);
      this.lac = answer & 0o17777;
      this.pc = (this.pc + (answer >> 13)) & 0o7777;
    } else {
      this.#interruptEnable(word);
    }
    this.clock += IO_TICKS;
  }

  #interruptEnable(word) {
    this.bus.actions++;
    if (word & 1) this.ion = 1;
    if (word & 2) this.ion = this.ionDelayed = 0;
  }

  /** End an instruction in which STOP was pressed, or with ION set: take an interrupt that is requested. */
  #end() {
    if (this.stopping) this.run = this.stopping = 0;
    if (this.ion) {
      if (this.ionDelayed && this.run && this.bus.request(this.clock)) this.next = INTERRUPT;
      this.ionDelayed = 1;
    }
  }
}
