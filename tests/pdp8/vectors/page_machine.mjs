// The page's machine plays a folder of vectors: node page_machine.mjs MODULES FOLDER. Prints {file: [played, differences]}.
// Instructions are played cycle by cycle; devices IOT by IOT, looked at whenever one has moved.

import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { gunzipSync } from "node:zlib";

const [, , house, folder] = process.argv;
const { Machine } = await import(join(house, "pdp8/computer/machine.mjs"));
const { tick_of } = await import(join(house, "pdp8/computer/hardware/teletype.mjs"));
const { bytes } = await import(join(house, "pdp8/web/translator/runtime.mjs"));

const kept = new Machine(true);
const STATES = ["FETCH", "DEFER", "EXECUTE"];
const same = (one, other) => JSON.stringify(one) === JSON.stringify(other);

/** Play the vector of an instruction; return its result, in the form of the vector. */
function step({ name, models, instructions, initial, final, cycles }) {
  const machine = kept, p = kept.processor;
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

/** Play the vector of a device. */
function play({ name, models, instructions, initial, ticks, events }) {
  const machine = new Machine(true);
  const { processor: p, teletype, highspeed } = machine;
  teletype.reader.load(bytes(initial.tape));
  highspeed.reader.load(bytes(initial.tape));
  const done = [];
  const see = () => ({
    read: [[1, highspeed.reader.position], [3, teletype.reader.position]],
    flag: [...machine.bus].map((device) => [device.code, device.flag]).sort(([one], [other]) => one - other),
    print: teletype.printer.frames.length,
    punch: highspeed.punch.frames.length,
  });
  let seen = see();
  const look = (tick) => {
    const before = seen;
    seen = see();
    seen.read.forEach(([device, count], i) => {
      if (count !== before.read[i][1]) done.push({ tick, read: initial.tape[count - 1], device });
    });
    seen.flag.forEach(([device, flag], i) => {
      if (flag !== before.flag[i][1]) done.push({ tick, flag: device, is: flag });
    });
    if (seen.print !== before.print) done.push({ tick, print: teletype.printer.frames.at(-1) });
    if (seen.punch !== before.punch) done.push({ tick, punch: highspeed.punch.frames.at(-1) });
  };
  const next = () => {
    const { receiver, transmitter } = teletype;
    const line = Math.min(tick_of(transmitter.next_step()), receiver.due, receiver.step);
    return Math.min(line, highspeed.reader_control.due, highspeed.punch_control.due);
  };
  const to = (tick) => {
    for (let due = next(); due <= tick; due = next()) {
      machine.bus.advance(Math.max(due, p.clock));
      look(Math.max(due, p.clock));
    }
    machine.bus.advance(tick);
    p.clock = tick;
  };
  const iot = (tick, word, ac) => {
    p.pc = 0o200;
    p.lac = ac;
    p.core[0o200] = word;
    p.cycle();
    machine.bus.advance(p.clock);
    done.push({ tick, iot: word, ac, final: { ac: machine.ac, skip: p.pc - 0o201 } });
    look(p.clock);
  };
  to(0);
  for (const event of events) {
    if (!("iot" in event || "key" in event || "start" in event)) continue;
    to(event.tick);
    if ("iot" in event) {
      iot(event.tick, event.iot, event.ac);
    } else {
      done.push({ ...event });
      if ("key" in event) teletype.keyboard.press(bytes([event.key]));
      else machine.bus.initialize(event.tick);
      if ("start" in event) look(event.tick);
    }
    to(p.clock);
  }
  to(ticks);
  const final = { flags: seen.flag.filter(([, flag]) => flag).map(([code]) => code) };
  return { name, models, instructions, initial, final, ticks, events: done };
}

const results = {};
for (const file of readdirSync(folder).filter((name) => name.endsWith(".json.gz")).sort()) {
  const vectors = JSON.parse(gunzipSync(readFileSync(join(folder, file))));
  const wrong = vectors.map((vector) => [vector.cycles ? step(vector) : play(vector), vector]).filter(([got, expected]) => !same(got, expected));
  results[file] = [vectors.length, wrong.slice(0, 3)];
}
console.log(JSON.stringify(results));
