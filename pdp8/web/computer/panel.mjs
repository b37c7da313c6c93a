// The operator's panel of the PDP-8/L, its keys and switches: pdp8/computer/hardware/panel.py in JavaScript.
//
// All keys but STOP are dead while RUN is on. SING STEP stops the machine after every memory cycle.

import { PROTECTED } from "../facts.mjs";

export class Panel {
  constructor(processor) {
    this.processor = processor;
  }

  /** LOAD ADD: the switches into PC and MA, and MB shows the word there. */
  loadAdd() {
    this.loadAddress(this.processor.sr);
  }

  /** What LOAD ADD does with `address` in the switches. */
  loadAddress(address) {
    if (this.processor.run) return;
    this.processor.pc = address & 0o7777;
    this.#read();
  }

  /** EXAM: MB shows the word at PC, and PC goes on. */
  exam() {
    const p = this.processor;
    if (p.run) return;
    this.#read();
    p.pc = (p.pc + 1) & 0o7777;
  }

  /** DEP: the switches into the word at PC, and PC goes on. Under MEM PROT PROTECT lights instead. */
  dep() {
    const p = this.processor;
    if (p.run) return;
    this.#read();
    if (p.memProt && p.ma >= PROTECTED) {
      p.protect = 1;
    } else {
      p.mb = p.sr;
      p.deposit(p.ma, p.sr);
    }
    p.pc = (p.pc + 1) & 0o7777;
  }

  #read() {
    const p = this.processor;
    p.protect = 0;
    p.ma = p.at = p.pc;
    p.mb = p.core[p.ma];
  }

  /** START: INITIALIZE, then FETCH at PC. */
  start() {
    if (this.processor.run) return;
    this.processor.initialize();
    this.#go();
  }

  /** CONT: go on with the next cycle; nothing is cleared. */
  cont() {
    if (!this.processor.run) this.#go();
  }

  /** Light RUN, or under SING STEP run one cycle. */
  #go() {
    if (this.processor.singStep) this.processor.cycle();
    else this.processor.run = 1;
  }

  /** STOP: RUN goes off at the end of the instruction, before an interrupt that is due. */
  stop() {
    this.processor.stop();
    while (this.processor.stopping) this.processor.cycle();
  }
}
