// The page's machine plays the instructions of a folder of vectors, cycle by cycle: node page_machine.mjs MODULES FOLDER.
// Prints {file: [played, differences]}.

import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { gunzipSync } from "node:zlib";

const [, , house, folder] = process.argv;
const { Machine } = await import(join(house, "pdp8/computer/machine.mjs"));

const machine = new Machine(true), p = machine.processor;
const STATES = ["FETCH", "DEFER", "EXECUTE"];
const same = (one, other) => JSON.stringify(one) === JSON.stringify(other);

/** Play a vector; return its result, in the form of the vector. */
function step({ name, models, instructions, initial, final, cycles }) {
  machine.power_up();
  p.pc = initial.pc;
  p.lac = (initial.link << 12) | initial.ac;
  p.sr = initial.sr;
  machine.ion = initial.ion;
  p.mem_prot = initial.mem_prot ?? 0;
  p.run = 1;
  p.core.fill(0);
  for (const [address, word] of initial.ram) p.core[address] = word;
  for (const device of machine.bus) device.flag = Number((initial.flags ?? []).includes(device.code));
  const clock = p.clock;
  const done = cycles.map(() => {
    p.cycle();
    return [STATES[p.state], p.ma, p.mb];
  });
  const now = {
    ...{ pc: p.pc, ac: machine.ac, link: machine.link, sr: p.sr, ion: p.ion, mem_prot: p.mem_prot },
    ...{ ram: initial.ram.map(([address]) => [address, p.core[address]]), run: p.run, protect: p.protect },
  };
  const got = Object.fromEntries(Object.keys(final).map((register) => [register, now[register]]));
  return { name, models, instructions, initial, final: got, ticks: p.clock - clock, cycles: done };
}

const results = {};
for (const file of readdirSync(folder).filter((name) => name.endsWith(".json.gz")).sort()) {
  const vectors = JSON.parse(gunzipSync(readFileSync(join(folder, file)))).filter(({ cycles }) => cycles);
  const wrong = vectors.map((vector) => [step(vector), vector]).filter(([got, expected]) => !same(got, expected));
  results[file] = [vectors.length, wrong.slice(0, 3)];
}
console.log(JSON.stringify(results));
