// The machine in JavaScript, as sides.py has it in Python: node side.mjs MODULES. A line of input is a situation; the
// line of output has for each act why a run ended, and what has become different of what is seen.

import { join } from "node:path";
import { createInterface } from "node:readline";

const [, , house] = process.argv;
const modules = async (name) => import(join(house, `${name}.mjs`));
const { Machine } = await modules("pdp8/computer/machine");
const { restore, save } = await modules("pdp8/computer/past/state");
const { History } = await modules("pdp8/computer/past/history");
const { instructions: go_back } = await modules("pdp8/computer/past/rewind");
const { Lamps } = await modules("pdp8/computer/hardware/panel");
const { TICKS_PER_SECOND } = await modules("pdp8/computer/hardware/signals");
const { bytes, set } = await modules("pdp8/web/translator/runtime");

const LOOKS = {
  values: (machine) => machine.values(),
  lamps: (machine) => machine.panel.lamps,
  save,
  "no time": (machine) => machine.wait(0),
  "no seconds": (machine) => machine.run(0),
  "no instructions": (machine) => machine.run(null, 0),
  "out of tape": (machine) => [...machine.bus].map((device) => device.out_of_tape()),
};
const hex = (frames) => Buffer.from(frames).toString("hex");

class Side {
  constructor({ fast, words, watched }) {
    this.machine = new Machine(fast);
    this.machine.load(words);
    this.longest = watched;
    this.marks = [];
    this.watch([], false);
    this.count_delays = true;
    this.history = null;
  }

  run(ticks, instructions) {
    const { machine, writes, observer } = this;
    machine.watch.breakpoints = set(this.marks);
    machine.watch.writes = set(writes);
    machine.watch.observer = observer;
    machine.engine.delays = this.count_delays;
    this.stood.push(machine.instructions);
    const limit = writes.length || observer ? Math.min(instructions, this.longest) : instructions;
    return String(machine.run(ticks === null ? null : ticks / TICKS_PER_SECOND, limit).reason);
  }

  breakpoints(addresses) { this.marks = addresses; }

  watch(writes, observed) {
    this.writes = writes;
    this.counted = 0;
    this.observer = observed
      ? { cycle: ({ state }) => { this.counted += state === 0; }, waited: (_, instructions) => { this.counted += instructions; } }
      : null;
  }

  deposit(address, word) { this.machine.core.__setitem__(address, word); }
  deposit_at_pc(beyond, word) { this.deposit((this.machine.pc + beyond) & 0o7777, word); }
  switches(word) { this.machine.panel.sr = word; }
  mem_prot(up) { this.machine.panel.mem_prot = up; }
  type(frames) { this.machine.teletype.keyboard.press(bytes(frames)); }
  station(fast) { return fast ? this.machine.highspeed : this.machine.teletype; }
  load_tape(fast, frames) { this.station(fast).reader.load(bytes(frames)); }
  lever(fast, start) { this.station(fast).reader.lever(start); }
  punch(fast, on) { this.station(fast).punch.on = on; }
  press(key) { this.machine.panel[key](); }
  wait(ticks) { this.machine.wait(ticks / TICKS_PER_SECOND); }
  set(name, value) { this.machine[name] = value; }
  delays(on) { this.count_delays = on; }
  look(name) { LOOKS[name]?.(this.machine); }

  single_cycles(count) {
    this.machine.panel.sing_step = true;
    for (; count; count--) {
      this.stood.push(this.machine.instructions);
      this.machine.run();
    }
    this.machine.panel.sing_step = false;
  }

  save_and_restore() {
    this.machine = restore(save(this.machine));
    if (this.history) this.record();
  }

  record() {
    this.history = new History(this.machine);
    this.stood = [];
  }

  back(runs) {
    const now = this.machine.instructions;
    this.stood = this.stood.filter((number) => number < now);
    const number = this.stood.splice(-runs)[0];
    if (this.history && number !== undefined) go_back(this.history, now - number);
    this.machine.panel.sing_step = false;
  }

  stood = [];

  seen() {
    const { processor: p, panel, teletype, highspeed } = this.machine;
    const { receiver, transmitter } = teletype;
    const { lamps } = panel;
    const seen = Object.fromEntries(Lamps.$fields.map((name) => [name, Number(lamps[name])]));
    Object.assign(seen, { pc: p.pc, sr: p.sr, next: p.next, "ion delayed": Number(p.ion_delayed) });
    Object.assign(seen, { clock: p.clock, instructions: p.instructions, counted: this.counted });
    Object.assign(seen, { "keyboard flag": receiver.flag, buffer: receiver.buffer });
    Object.assign(seen, { "reader run": receiver.reader_run, read: teletype.reader.position });
    Object.assign(seen, { keys: teletype.keyboard.waiting.length, "printer flag": transmitter.flag });
    Object.assign(seen, { register: transmitter.register, page: hex(teletype.printer.frames), punched: hex(teletype.punch.tape) });
    if (highspeed.fitted) {
      const { reader_control: reader, punch_control: punch } = highspeed;
      Object.assign(seen, { "reader flag": reader.flag, "reader buffer": reader.buffer, fetching: reader.fetching });
      Object.assign(seen, { "fast read": reader.reader.position, "punch flag": punch.flag });
      Object.assign(seen, { "punch buffer": punch.buffer, "fast punched": hex(punch.punch.tape) });
    }
    return seen;
  }
}

const different = (now, before) => Object.fromEntries(Object.entries(now).filter(([name, value]) => value !== before[name]));

function play(situation) {
  const side = new Side(situation);
  let core = new Uint16Array(4096);
  let seen = {};
  return situation.acts.map(([name, values]) => {
    const reason = side[name](...values);
    const now = side.seen();
    const words = [];
    const { core: held } = side.machine.processor;
    held.forEach((word, address) => { if (word !== core[address]) words.push([address, word]); });
    const answer = [reason ?? null, different(now, seen), words];
    [core, seen] = [Uint16Array.from(held), now];
    return answer;
  });
}

for await (const line of createInterface({ input: process.stdin })) console.log(JSON.stringify(play(JSON.parse(line))));
