// The machine in JavaScript, as sides.py has it in Python: node side.mjs MODULES. A line of input is a new machine, or
// an act; then the line of output has why a run ended, and what has become different of what is seen.

import { join } from "node:path";
import { createInterface } from "node:readline";

const [, , house] = process.argv;
const modules = async (name) => import(join(house, `${name}.mjs`));
const { Machine } = await modules("pdp8/computer/machine");
const { restore, save } = await modules("pdp8/computer/past/state");
const { History } = await modules("pdp8/computer/past/history");
const { instructions: go_back } = await modules("pdp8/computer/past/rewind");
const { TICKS_PER_SECOND } = await modules("pdp8/computer/hardware/signals");
const { Breaker, Nearer } = await modules("tests/pdp8/computer/lockstep/breaker");
const { bytes, set } = await modules("pdp8/web/translator/runtime");

const at = (owner, names) => names.reduce((of, name) => (name < 0 ? of.at(name) : of[name]), owner);
const plain = (value) => (typeof value === "object" ? Buffer.from(value).toString("hex") : Number(value));
const breakers = (memory) => (memory ? [new Breaker(), new Nearer()] : []);

class Side {
  constructor({ fast, words, paths, memory }) {
    this.machine = new Machine(null, memory || 4096);
    this.memory = memory;
    if (fast) this.machine.fit(this.machine.highspeed);
    for (const device of breakers(memory)) this.machine.fit(device);
    this.machine.load(words);
    this.paths = paths.map((path) => [path, path.split(".")]);
    this.marks = [];
    this.watch([], false);
    this.count_delays = true;
  }

  call(path, ...values) {
    const names = path.split(".");
    const name = names.pop();
    const owner = at(this.machine, names);
    if (name in owner) owner[name](...values.map((value) => (Array.isArray(value) ? bytes(value) : value)));
  }

  set(path, value) {
    const names = path.split(".");
    const name = names.pop();
    at(this.machine, names)[name] = value;
  }

  run(ticks, instructions) {
    const { machine } = this;
    machine.watch.breakpoints = set(this.marks);
    machine.watch.writes = set(this.writes);
    machine.watch.observer = this.observer;
    machine.engine.delays = this.count_delays;
    return String(machine.run(ticks === null ? null : ticks / TICKS_PER_SECOND, instructions).reason);
  }

  breakpoints(addresses) { this.marks = addresses; }

  watch(writes, observed) {
    this.writes = writes;
    this.counted = 0;
    this.observer = observed
      ? { cycle: ({ state }) => { this.counted += state === 0; }, waited: (_, instructions) => { this.counted += instructions; } }
      : null;
  }

  deposit_at_pc(beyond, word) {
    const { pc, core } = this.machine;
    core.__setitem__((pc & 0o70000) | ((pc + beyond) & 0o7777), word);
  }

  wait(ticks) { this.machine.wait(ticks / TICKS_PER_SECOND); }
  delays(on) { this.count_delays = on; }
  look() { save(this.machine); }

  single_cycle() {
    this.machine.panel.sing_step = true;
    this.machine.run();
    this.machine.panel.sing_step = false;
  }

  run_cycles(count) { this.machine.run(null, null, count); }
  save_and_restore() {
    this.machine = restore(save(this.machine), breakers(this.memory));
    this.machine.watch.observer = this.observer;
  }

  record() { this.history = new History(this.machine); }

  back(instructions) { go_back(this.history, instructions); }

  seen() {
    return Object.fromEntries([["counted", this.counted], ...this.paths.map(([path, names]) => [path, plain(at(this.machine, names))])]);
  }
}

const different = (now, before) => Object.fromEntries(Object.entries(now).filter(([name, value]) => value !== before[name]));

let side, core, seen;

function answer(given) {
  if (!Array.isArray(given)) {
    [side, core, seen] = [new Side(given), new Uint16Array(given.memory || 4096), {}];
    return null;
  }
  const [name, values] = given;
  const reason = side[name](...values);
  const now = side.seen();
  const words = [];
  const { core: held } = side.machine.processor;
  held.forEach((word, address) => { if (word !== core[address]) words.push([address, (core[address] = word)]); });
  const told = [reason ?? null, different(now, seen), words];
  seen = now;
  return told;
}

for await (const line of createInterface({ input: process.stdin })) console.log(JSON.stringify(answer(JSON.parse(line))));
