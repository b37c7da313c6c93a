// A machine's whole state as the JSON that `pdp8 run --save` writes and reads: pdp8/computer/past/state.py in JavaScript.
//
// What only waits is not in it: the machine that goes on from it finds that out again.

import { STATE } from "../facts.mjs";
import { NEVER } from "./bus.mjs";
import { Machine } from "./machine.mjs";

const { HEAD, KINDS, PROCESSOR, DEVICES } = STATE;
const NEVER_WRITTEN = "never", ROW = 8, FRAMES = 24;

/** The text of the machine's state. */
export function save(machine) {
  const { bus, core, processor } = machine;
  bus.advance(processor.clock);
  const devices = [...bus].map((device) => {
    const [name, fields] = DEVICES[octal(device.code, 2)];
    return [octal(device.code, 2), { device: name, ...written(device, fields) }];
  });
  const state = { ...HEAD, processor: written(processor, PROCESSOR), core: rows(core), devices: Object.fromEntries(devices) };
  return `${JSON.stringify(state, null, 1)}\n`;
}

function written(part, fields) {
  return Object.fromEntries(Object.entries(fields).map(([name, kind]) => [name, value(part[camel(name)], kind)]));
}

function value(now, kind) {
  if (typeof kind === "object") return written(now, kind);
  if (kind === KINDS.TICK) return now === NEVER ? NEVER_WRITTEN : now;
  if (kind === KINDS.FRAMES) return grouped([...now].map((frame) => octal(frame, 3)), FRAMES);
  return typeof kind === "string" ? octal(now, kind.length) : Number(now);
}

function rows(core) {
  const lines = grouped([...core].map((word) => octal(word, 4)), ROW).map((words, row) => [octal(row * ROW, 4), words]);
  return Object.fromEntries(lines.filter(([, words]) => /[1-7]/.test(words)));
}

function grouped(words, size) {
  return Array.from({ length: Math.ceil(words.length / size) }, (_, row) => words.slice(row * size, row * size + size).join(" "));
}

/** Whether `text` is a saved state. */
export function isState(text) {
  return text.startsWith("{");
}

/** The machine whose state `text` is. Throws an Error that names the place. */
export function restore(text) {
  let state;
  try {
    state = JSON.parse(text);
  } catch (error) {
    throw new Error(`the saved state is cut short or damaged: ${error.message}`);
  }
  if (Object.keys(HEAD).some((name) => state?.[name] !== HEAD[name])) {
    throw new Error(`a saved state begins with ${JSON.stringify(HEAD).slice(0, -1)}`);
  }
  const devices = Object.entries(state.devices ?? {});
  const machine = new Machine("01" in (state.devices ?? {}));
  for (const [first, words] of Object.entries(state.core ?? {})) {
    const address = number(first, "7777", "core");
    const values = words.split(" ").map((word) => number(word, "7777", `core ${first}`));
    if (address + values.length > machine.core.length) throw new Error(`core ${first}: the words go beyond 7777`);
    machine.core.set(values, address);
  }
  take(machine.processor, state.processor ?? {}, PROCESSOR, "processor");
  for (const [code, { device: name, ...fields }] of devices) {
    if (DEVICES[code]?.[0] !== name) throw new Error(`devices ${code}: this machine has no such device`);
    const device = machine.bus.device(parseInt(code, 8));
    take(device, fields, DEVICES[code][1], `devices ${code}`);
    if (!("due" in fields)) device.plan();
  }
  return machine;
}

function take(part, values, fields, place) {
  for (const [name, given] of Object.entries(values)) {
    const kind = fields[name];
    const where = `${place} ${name}`;
    if (kind === undefined) throw new Error(`${where}: the fields are ${Object.keys(fields).join(" ")}`);
    if (typeof kind === "object") take(part[camel(name)], given, kind, where);
    else part[camel(name)] = read(given, kind, part[camel(name)], where);
  }
}

function read(given, kind, old, where) {
  if (kind === KINDS.FRAMES) {
    const frames = given.flatMap((row) => row.split(" ")).map((frame) => number(frame, "377", where));
    return old instanceof Uint8Array ? Uint8Array.from(frames) : frames;
  }
  if (kind === KINDS.TICK) return given === NEVER_WRITTEN ? NEVER : given;
  if (typeof kind === "string") return number(given, kind, where);
  if (!Number.isInteger(given) || (kind >= 0 && given > kind)) {
    throw new Error(`${where}: ${JSON.stringify(given)} is out of range`);
  }
  return typeof old === "boolean" ? Boolean(given) : given;
}

function number(given, most, where) {
  if (typeof given !== "string" || !/^[0-7]+$/.test(given) || parseInt(given, 8) > parseInt(most, 8)) {
    throw new Error(`${where}: ${JSON.stringify(given)} is not an octal number from 0 to ${most}`);
  }
  return parseInt(given, 8);
}

function camel(name) {
  return name.replace(/_(.)/g, (_, letter) => letter.toUpperCase());
}

function octal(word, digits) {
  return word.toString(8).padStart(digits, "0");
}
