// The reader: frames of source tapes to the items PAL III reads: pal/source.py in JavaScript.
//
//   A,<TAB>TAD I B+1  /COMMENT<CR>
//   ["A", ","] ["", TAB] ["TAD", " "] ["I", " "] ["B", "+"] ["1", " "] ["", " "] ["", CR]

const PASSED_OVER = new Set([0o000, 0o200, 0o177, 0o377, 0o212]);
const ITEM = /([A-Z0-9\f]*)(?:\/[^\r]*)?([^A-Z0-9\f])/g;

export class Source {
  /** `tapes` are strings or Uint8Arrays. */
  constructor(tapes) {
    const texts = tapes.map((tape) => characters(typeof tape === "string" ? encoded(tape) : tape));
    const text = texts.join("");
    let length = 0;
    this.starts = texts.map((each) => (length += each.length) - each.length);
    this.text = text + (text.endsWith("\r") || !text ? "$" : "\r$");
    this.items = [];
    this.feeds = []; // the items in which, or in the comment after which, there is a form feed
    this.spans = []; // where each item begins, and where the character that ends it stands
    for (const match of this.text.matchAll(ITEM)) {
      if (match[0].includes("\f")) this.feeds.push(this.items.length);
      this.items.push([match[1].replaceAll("\f", ""), match[2]]);
      this.spans.push([match.index, match.index + match[0].length - 1]);
    }
  }

  /** Where item `at` stands: tape and line from 0 and 1, the line, the item's columns. */
  place(at) {
    let [start] = this.spans[at];
    const [, mark] = this.spans[at];
    let end = start + this.items[at][0].length;
    if (start === end) [start, end] = [mark, mark + 1];
    const tape = Math.max(this.starts.findLastIndex((begins) => begins <= start), 0);
    const line = this.text.slice(this.starts[tape] ?? 0, start).split("\r").length;
    const first = this.text.slice(0, start).lastIndexOf("\r") + 1;
    return { tape, line, source: this.text.slice(first, this.text.indexOf("\r", first)), start: start - first, end: end - first };
  }
}

function encoded(text) {
  return Uint8Array.from(text, (character) => (character.codePointAt(0) < 0o200 ? character.charCodeAt(0) : 0o77));
}

/** The characters of a source tape but for those that are passed over; each line ends with a return. */
function characters(tape) {
  let frames = tape;
  if (tape.some((frame) => frame & 0o200)) {
    try {
      frames = encoded(new TextDecoder("utf-8", { fatal: true }).decode(tape));
    } catch {
      frames = tape; // no UTF-8: a tape with channel 8
    }
  }
  let text = "";
  for (const frame of frames) if (!PASSED_OVER.has(frame)) text += String.fromCharCode(frame & 0o177);
  return text.replaceAll("\r\n", "\r").replaceAll("\n", "\r");
}
