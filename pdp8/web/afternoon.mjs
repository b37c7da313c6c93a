// The afternoon: what the operator did and when, and every instant in between made again.
//
//     terminal ──► RIM toggled ──► BIN loaded ──► program loaded ──► translation ──► Hydra-Point
//
// The record holds only the tapes, the operator's actions and the blocks as they were cut. Everything else follows:
// the computer is run once from cold, a checkpoint kept every ten seconds, and an instant is the checkpoint before it
// run forward. `now` is in ticks of 0.05 µs since the afternoon began.

import { CYCLE, FRAME, IO_TICKS, TICKS_PER_SECOND as SECOND } from "../computer/hardware/signals.mjs";
import { Machine } from "../computer/machine.mjs";
import { FETCH, IOT } from "../../pal/isa.mjs";
import { CR } from "../../tapes/ascii.mjs";
import { EOB } from "../../tapes/eia.mjs";
import { ROWS } from "../../tapes/hydrapoint.mjs";

const LONGEST = 3 * CYCLE + IO_TICKS; // no instruction takes more
const CHECKPOINT_EVERY = 10 * SECOND;

export class Afternoon {
  constructor(record) {
    this.record = record;
    this.acts = record.acts;
    this.actions = record.actions;
    this.tapes = record.tapes;
    this.end = this.acts.at(-1).to;
    this.#fromCold();
    this.#rehearse();
    this.to(0);
  }

  get processor() {
    return this.machine.processor;
  }

  #fromCold() {
    this.machine = new Machine();
    this.now = 0;
    this.done = 0; // actions done
    this.mounted = null;
  }

  /** Run the whole afternoon once: checkpoints, and the instants a step can go to. */
  #rehearse() {
    const starts = this.acts.map((act) => act.from).concat(this.end);
    const actions = this.actions.map((action) => action.at);
    this.characters = starts.concat(actions);
    this.blocks = starts.slice();
    this.checkpoints = [];
    const computing = this.actions.length ? this.actions.at(-1).at : 0;
    for (let tick = 0; tick < computing + CHECKPOINT_EVERY; tick += CHECKPOINT_EVERY) {
      this.#rehearseTo(tick);
      this.checkpoints.push(this.#save());
    }
    this.#rehearseTapes();
    this.characters = ordered(this.characters);
    this.blocks = ordered(this.blocks);
    this.moments = ordered(starts.concat(actions));
  }

  /** The instants of the terminal's punch and of the Hydra-Point's reader, which no computer decides. */
  #rehearseTapes() {
    for (const act of this.acts) {
      if (act.kind === "terminal") {
        const tape = this.tapes.ascii.frames;
        for (let frame = 0; frame < tape.length; frame++) {
          const tick = act.from + (frame + 1) * FRAME;
          this.characters.push(tick);
          if (endsLine(tape[frame], "ascii")) this.blocks.push(tick);
        }
      } else if (act.kind === "mill") {
        for (const block of this.record.mill.blocks) {
          this.blocks.push(block.at);
          for (let row = 0; row < ROWS; row++) this.characters.push(block.at + Math.round(((row + 1) * block.reading) / ROWS));
        }
      }
    }
  }

  /** Go on from event to event, and note each character as it is received: the flag rises with it. */
  #rehearseTo(tick) {
    const { bus, processor, teletype: { receiver } } = this.machine;
    while (this.now < tick) {
      const action = this.actions[this.done]?.at ?? Infinity;
      const next = Math.min(tick, action, bus.next_event(processor.clock), this.now + FRAME / 4);
      const down = !receiver.flag;
      this.#advance(Math.max(next, this.now + 1));
      if (down && receiver.flag) this.#received(receiver.buffer, this.now);
    }
  }

  #received(frame, tick) {
    this.characters.push(tick);
    if (this.act(tick).kind === "translate" && endsLine(frame, "ascii")) this.blocks.push(tick);
  }

  #save() {
    const { now, done, mounted } = this;
    return { now, done, mounted, machine: this.machine.values() };
  }

  #restore({ machine, ...rest }) {
    Object.assign(this, rest);
    this.machine.put(machine);
  }

  /** Go to an instant. */
  to(tick) {
    tick = Math.max(0, Math.min(Math.round(tick), this.end));
    const nearest = this.checkpoints[Math.min(Math.floor(tick / CHECKPOINT_EVERY), this.checkpoints.length - 1)];
    if (tick < this.now || nearest.now > this.now) this.#restore(nearest);
    this.#advance(tick);
  }

  #advance(tick) {
    while (this.done < this.actions.length && this.actions[this.done].at <= tick) {
      const action = this.actions[this.done];
      goOn(this.machine, action.at);
      this.done++;
      this.now = action.at;
      this.#do(action);
    }
    goOn(this.machine, tick);
    this.now = tick;
  }

  #do({ key, value }) {
    const { panel, processor, teletype } = this.machine;
    if (key === "sr") processor.sr = value;
    else if (key === "load add") panel.load_add();
    else if (key === "dep") panel.dep();
    else if (key === "exam") panel.exam();
    else if (key === "stop") panel.stop();
    else if (key === "mount") this.#mount(value);
    else if (key === "lever") teletype.reader.lever(true);
    else if (key === "start") panel.start();
    else throw new Error(`no such action: ${key}`);
  }

  #mount(name) {
    this.mounted = name;
    const { reader } = this.machine.teletype;
    reader.lever(false);
    reader.load(this.tapes[name].frames);
  }

  act(tick = this.now) {
    return this.acts.findLast((act) => act.from <= tick);
  }

  /** The last action done, or null. */
  get action() {
    return this.done ? this.actions[this.done - 1] : null;
  }

  /** The next instant by "block", "character", "instruction" or "cycle". */
  next(unit) {
    if (unit === "block") return this.to(after(this.blocks, this.now, this.end));
    if (unit === "character" || !this.processor.run) return this.to(after(this.characters, this.now, this.end));
    const done = this.done;
    do this.#nextCycle();
    while (unit === "instruction" && this.processor.run && this.processor.next !== FETCH && this.done === done);
  }

  #nextCycle() {
    const end = this.processor.clock + cycleOf(this.processor);
    const action = this.done < this.actions.length ? this.actions[this.done].at : Infinity;
    this.to(Math.min(end, action));
  }

  /** The instant before by the same units. */
  previous(unit) {
    if (unit === "block") return this.to(before(this.blocks, this.now));
    const fresh = this.processor.clock <= this.#lastActionAt(); // no cycle since the last action
    if (unit === "character" || !this.processor.run || fresh) return this.to(before(this.characters, this.now));
    do this.#previousCycle();
    while (unit === "instruction" && this.processor.next !== FETCH);
  }

  #lastActionAt() {
    return this.action ? this.action.at : 0;
  }

  #previousCycle() {
    this.to(this.processor.clock - 1);
    this.now = Math.max(this.processor.clock, this.#lastActionAt());
  }
}

/** The ticks of the next cycle. */
function cycleOf({ core, next, pc }) {
  return next === FETCH && core[pc] >> 9 === IOT ? CYCLE + IO_TICKS : CYCLE;
}

/** Go on to the last cycle that ends at or before tick `until`; standing still or waiting, just let time pass. */
function goOn(machine, until) {
  const p = machine.processor;
  const room = until - p.clock - LONGEST;
  if (p.run && room > 0 && machine.run(room / SECOND).reason !== "limit" && p.run) turn(p, until - LONGEST);
  while (p.run && p.clock + cycleOf(p) <= until) p.cycle();
  if (!p.run && p.clock < until) p.clock = until;
  machine.bus.advance(p.clock);
}

/** Let a processor that waits for ever turn in its loop, by whole turns, as far as tick `until`. */
function turn(p, until) {
  const { pc, lac, clock, instructions } = p;
  do p.instruction();
  while ((p.pc !== pc || p.lac !== lac) && p.clock < until);
  const [ticks, count] = [p.clock - clock, p.instructions - instructions];
  const turns = Math.max(0, Math.floor((until - p.clock) / ticks));
  p.clock += turns * ticks;
  p.instructions += turns * count;
}

/** The record as it is used: tapes as frames, acts numbered, and where each tape's lines end. */
export function prepared(record) {
  for (const tape of Object.values(record.tapes)) {
    tape.frames = tape.frames.encode("latin-1");
    tape.lines = [];
    tape.frames.forEach((frame, index) => endsLine(frame, tape.code) && tape.lines.push(index));
    tape.first = tape.frames.findIndex((frame) => frame !== 0);
  }
  record.acts.forEach((act, index) => (act.index = index));
  record.translation = record.acts.findIndex((act) => act.kind === "translate");
  return record;
}

/** Whether the frame ends a line of an ASCII tape, or a block of an EIA tape. */
export function endsLine(frame, code) {
  return code === "eia" ? frame === EOB : (frame & 0o177) === CR;
}

function ordered(instants) {
  return Float64Array.from(new Set(instants)).sort();
}

/** The first of `instants` after `now`. */
function after(instants, now, otherwise) {
  const index = upper(instants, now);
  return index < instants.length ? instants[index] : otherwise;
}

/** The last of `instants` before `now`. */
function before(instants, now) {
  const index = upper(instants, now - 1);
  return index > 0 ? instants[index - 1] : 0;
}

/** How many of the ordered `instants` are at or before `now`. */
export function upper(instants, now) {
  let low = 0;
  let high = instants.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (instants[middle] <= now) low = middle + 1;
    else high = middle;
  }
  return low;
}
