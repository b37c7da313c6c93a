// The page's machine plays a folder of vectors: node page_machine.mjs FOLDER. Prints {file: [played, differences]}.

import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { gunzipSync } from "node:zlib";
import { Machine } from "../../../pdp8/web/computer/machine.mjs";

const machine = new Machine(true);
const p = machine.processor;
const STATES = ["FETCH", "DEFER", "EXECUTE"];
const same = (one, other) => JSON.stringify(one) === JSON.stringify(other);

/** Play one vector; return what it came to, in the form of the vector. */
function play({ name, initial, cycles }) {
  machine.powerUp();
  p.pc = initial.pc;
  p.lac = (initial.link << 12) | initial.ac;
  p.sr = initial.sr;
  p.ion = p.ionDelayed = initial.ion;
  p.memProt = initial.mem_prot;
  p.run = 1;
  p.core.fill(0);
  for (const [address, word] of initial.ram) p.core[address] = word;
  for (const device of machine.bus) device.flag = Number((initial.flags ?? []).includes(device.code));
  const clock = p.clock;
  const done = cycles.map(() => {
    p.cycle();
    return [STATES[p.state], p.ma, p.mb];
  });
  const final = {
    ...{ pc: p.pc, ac: machine.ac, link: machine.link, sr: p.sr, ion: p.ion, mem_prot: p.memProt },
    ...{ ram: initial.ram.map(([address]) => [address, p.core[address]]), run: p.run, protect: p.protect },
  };
  return { name, initial, final, ticks: p.clock - clock, cycles: done };
}

const folder = process.argv[2];
const results = {};
for (const file of readdirSync(folder).filter((name) => name.endsWith(".json.gz")).sort()) {
  const vectors = JSON.parse(gunzipSync(readFileSync(join(folder, file)))).filter((vector) => vector.cycles);
  const wrong = vectors.map((vector) => [play(vector), vector]).filter(([got, meant]) => !same(got, meant));
  if (vectors.length) results[file] = [vectors.length, wrong.slice(0, 3)];
}
console.log(JSON.stringify(results));
