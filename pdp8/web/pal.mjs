// The assembler: source tapes in, the object tape, its words and all that was typed out: pal/assembly.py.
//
//   assemble("*200\n\tCLA\n\tHLT\n$\n").words  ->  {128: 0o7200, 129: 0o7402}
//
// This runs in Node.js as it is. It is PAL III's own mechanism, held to the Python one byte for byte.

import { PAL_III } from "./facts.mjs";
import { Assembler } from "./pal/assembler.mjs";
import { diagnose } from "./pal/diagnostics.mjs";
import * as listing from "./pal/listing.mjs";
import { notes } from "./pal/notes.mjs";
import { Source } from "./pal/source.mjs";
import { typed } from "./pal/symbols.mjs";

/** Assemble the source tapes, read one after the other; each is a string, or frames in a Uint8Array.
 *
 * tape      the object tape as the high-speed punch made it; empty if pass 1 or 2 did not end
 * words     {address: word}, the field above the twelve bits of the address
 * passes    the frames of the three passes when the ASR-33 does it all; a pass that was not run has none
 * messages  what passes 1 and 2 complain of, as DEC's assembler types it
 * ok        whether they ended, and complained of nothing
 * diagnostics  the same for a person, why a pass went no further, and notes of ours: with places, and what to do
 * listing   what pass 3 typed, without the codes that do not print; `lines`, the same by statements
 * symbols   {name: value} as pass 3 leaves them
 */
export function assemble(...sources) {
  return new Assembly(new Source(sources));
}

class Assembly {
  constructor(source) {
    const assembler = new Assembler(source, PAL_III.TELETYPE_SYMBOLS);
    const first = assembler.run(1);
    const firstTable = assembler.table;
    const second = assembler.stopped ? [] : assembler.run(2);
    this.stopped = assembler.stopped;
    this.words = this.stopped ? {} : listing.words(second);
    this.tape = this.stopped ? new Uint8Array(0) : listing.tape(second);
    const third = this.stopped ? [] : assembler.run(3);
    const { lost, table } = assembler;
    this.symbols = Object.fromEntries(table.filter(({ defined }) => defined).map(({ name, value }) => [name, value]));
    this.passes = [
      listing.first(first, second.length ? firstTable : null),
      second.length ? listing.second(second, !this.stopped) : [],
      this.stopped ? [] : listing.third(source, third, lost, assembler.stopped ? null : table),
    ].map((frames) => Uint8Array.from(frames));
    this.listing = listing.printed([...this.passes[2]]);
    this.lines = listing.lines(source, third, lost);
    const said = messages(first, second, firstTable);
    this.messages = said.map(listing.messageText);
    this.ok = this.messages.length === 0 && !this.stopped;
    const noted = notes(source, source.starts.length, PAL_III.TELETYPE_SYMBOLS);
    this.diagnostics = diagnose(source, said, [assembler.stopped, listing.overlong(source)].filter(Boolean), noted);
  }
}

function messages(first, second, table) {
  const said = [...first, ...second].filter(({ code }) => code);
  const undefinedOnes = second.length ? table.filter(({ defined }) => !defined) : [];
  const message = ({ name, value, at }) => ({ code: "UA", subject: typed(name), location: value, at });
  return [...said, ...undefinedOnes.map(message)];
}
