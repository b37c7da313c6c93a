// The first minute at the panel: what comes next, and what a key has done, both said from the machine's own state.
//
//     STOP ──► LOAD ADD ──► five words, each set and DEP ──► LOAD ADD ──► START ──► a name, typed, printed, punched
//
// The first row of STEPS whose condition holds is what comes next; so whoever presses something else, leaves, or has some words
// in already is guided from there. DID answers a key by what happened, whatever was asked for. No sentence has more than 90
// characters.

import { of_word } from "../../../pal/meaning.mjs";
import { name } from "../../../tapes/ascii.mjs";
import { octal } from "../written.mjs";

const FIRST = 0o200;
/** The program types and punches what is typed: each word, and what it says. @type {[number, string][]} */
const WORDS = [[0o6031, "is there a letter?"], [0o5200, "no: ask again"], [0o6036, "yes: take it"], [0o6046, "print it, punch it"], [0o5200, "now the next"]];
const KEYS = globalThis.matchMedia?.("(hover: hover) and (pointer: fine)").matches; // whether there is likely a keyboard
const ringed = ({ place, word, there }) => `Flip the ringed switches${KEYS ? `, or type ${octal(there ? word[0] : place)}` : ""}.`;

/** What comes next: when, what is said, what is to be touched: a key's name, or what the switches are to say.
 *  @type {[(s: any) => any, (s: any) => string, ((s: any) => string | number)?][]} */
const STEPS = [
  [(s) => s.waits && s.made, (s) => `${s.made}: ${s.frames.length > 1 ? `${s.frames.length} rows` : "one row"} of holes, made by you. Type on, or see your tape.`],
  [(s) => s.waits, () => "Your program runs, and waits for a letter. Type your name: it is printed and punched."],
  [(s) => s.run, () => "RUN is lit: a computer that runs obeys no key but STOP. Press STOP.", () => "stop"],
  [(s) => s.step, () => "SING STEP is on: it stops after each cycle. Press SING STEP, to turn it off.", () => "sing step"],
  [(s) => !s.word && s.pc > FIRST && s.pc < FIRST + WORDS.length, () => "It stands within your program. Press CONT: it goes on.", () => "cont"],
  [(s) => !s.there && s.sr !== s.place && !s.at, (s) => `Memory has 4096 words. Yours begin at number 0200. ${ringed(s)}`, (s) => s.place],
  [(s) => !s.there && s.sr !== s.place && s.word, (s) => `Word ${s.at + 1} of 5 belongs to ${octal(s.place)}. ${ringed(s)}`, (s) => s.place],
  [(s) => !s.there && s.sr !== s.place, (s) => `All five words are in. They begin at 0200. ${ringed(s)}`, (s) => s.place],
  [(s) => !s.there, (s) => `The switches say ${octal(s.place)}. Press LOAD ADD: the lamps show the word there.`, () => "load add"],
  [(s) => s.word && s.sr !== s.word[0], (s) => `Word ${s.at + 1} of 5, ${octal(s.word[0])}, says “${s.word[1]}”. ${ringed(s)}`, (s) => s.word[0]],
  [(s) => s.word, (s) => `The switches say ${octal(s.sr)}. Press DEP: that is put into memory, at ${octal(s.place)}.`, () => "dep"],
  [() => true, () => "Five words: you have programmed a computer by hand. Press START.", () => "start"],
];

/** What a key has done, of the state before it and after it: to a machine that runs, STOP and the two switches alone. */
const DID = {
  stop: (b, a) => (b.run ? `It has stopped: RUN is dark, and MEMORY ADDRESS says ${octal(a.ma)}.` : "It had stopped already: STOP did nothing."),
  "sing step": (b, a) => (a.step ? "SING STEP is on: it stops after each cycle." : "SING STEP is off: it runs freely again."),
  "mem prot": (b, a) => `MEM PROT is ${a.protects ? "on: 7600 to 7777 cannot" : "off: all of memory can"} be written.`,
  "load add": (b, a) => `MEMORY ADDRESS says ${octal(a.ma)}, MEMORY BUFFER the word there: ${symbol(a.mb, a.ma)}.`,
  exam: (b, a) => `In ${octal(a.ma)} is ${symbol(a.mb, a.ma)}. The next EXAM shows ${octal(a.pc)}.`,
  dep: (b, a) => (a.refused ? `MEM PROT is on: ${octal(a.ma)} keeps its word.` : `${octal(a.ma)} held ${octal(b.next)}; now it holds ${symbol(a.mb, a.ma)}.`),
  start: (b, a) => `It began at ${octal(b.pc)}${a.run ? ", and runs" : "; it has stopped again"}.`,
  cont: (b, a) => `It went on at ${octal(b.pc)}${a.run ? ", and runs" : "; it has stopped again"}.`,
};
const HEARD = ["stop", "sing step", "mem prot"];

/** A word as an assembler has it. */
const symbol = (word, place) => of_word(word, place)[0].split(":")[0].replace("  ", " ").slice(0, 30);

export class Guide {
  constructor() {
    this.from = Infinity; // the first frame that is the visitor's
  }

  /** The switches are taken. */
  begin(machine) {
    this.state = this.#look(machine);
    this.did = `The switches are yours. The computer ${this.state.run ? "runs" : "is stopped"}; its tape reader is off.`;
  }

  /** What the steps ask about. `place` is where the next word belongs, or the program begins. */
  #look({ processor, teletype: { punch } }) {
    const { core, ma, mb, mem_prot: protects, pc, protect: refused, run, sing_step: step, sr } = processor;
    const at = WORDS.findIndex(([word], index) => core[FIRST + index] !== word);
    const word = WORDS[at];
    this.from = word ? punch.frames.length : Math.min(this.from, punch.frames.length);
    const frames = punch.frames.slice(this.from);
    const made = String.fromCharCode(...frames.slice(-60).map((frame) => frame & 0o177)).replace(/[^ -_]/g, "").trim().slice(-24);
    const place = FIRST + Math.max(0, at);
    const there = pc === place && (at > 0 || ma === place);
    const waits = run && !word && ma >= FIRST && ma < FIRST + WORDS.length;
    return { at, frames, ma, made, mb, next: core[pc], pc, place, protects, refused, run, sr, step, there, waits, word };
  }

  /** A key was pressed. */
  answer(key, machine) {
    const { state: before } = this;
    const after = this.state = this.#look(machine);
    this.key = key;
    this.did = before.run && !HEARD.includes(key) ? `It runs, and did not hear ${key.toUpperCase()}.` : DID[key](before, after);
  }

  /** What the machine has done since the last look is said, and what comes next: what is said, and what is to be touched. */
  next(machine) {
    const { state: before } = this;
    const { frames, ma, run, sr } = this.state = this.#look(machine);
    const flipped = before.sr ^ sr;
    if (flipped) this.did = `${flipped & (flipped - 1) ? "" : `Switch ${Math.clz32(flipped) - 20} ${sr > before.sr ? "up adds" : "down takes away"} ${octal(flipped)}. `}The switches say ${octal(sr)}.`;
    if (before.run && !run && this.key !== "stop") this.did = `It stopped by itself at ${octal(ma)}: the word there is ${symbol(machine.processor.core[ma], ma)}.`;
    if (frames.length > before.frames.length) this.did = row(frames.at(-1));
    const [, say, touch] = STEPS.find(([when]) => when(this.state));
    return { say: say(this.state), due: touch?.(this.state) };
  }
}

/** What a row of the tape says. */
function row(frame) {
  const channels = [8, 7, 6, 5, 4, 3, 2, 1].filter((channel) => frame & (1 << (channel - 1)));
  return `${name(frame)} came in as ${octal(frame, 3)}: its row has holes in channels ${channels.join(" ")}.`;
}
