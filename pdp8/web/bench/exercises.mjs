// The tutorial's six exercises on this bench: each is set up by a button, and checked by a look at the machine.

import { CODES } from "../../../tapes/eia.mjs";
import { escaped, find, octal } from "../written.mjs";

const ZERO = "0".charCodeAt(0);

const answered = (right, why) => (bench, answer) => (answer.trim() === right ? "" : why);

const EXERCISES = [
  {
    title: "Read a frame",
    text: "circle.asc is in the reader. START at 0200 and stop when frame 179 is under the head. Which digit is it?",
    prepare: (bench) => bench.translate("circle.asc"),
    check: (bench, answer) => {
      const { position } = bench.machine.teletype.reader;
      if (position < 180) return `the reader has read ${position} frames; frame 179 is the 180th`;
      return answered("8", "look at the holes in channels 1 to 4: 8 and nothing else")(bench, answer);
    },
  },
  {
    title: "Follow one digit through CHK",
    text: "Step through CHK (0227) for a 3, in instructions. A cycle is 1.6 µs. How many microseconds does CHK take, with the JMS that calls it?",
    prepare: (bench) => bench.translate("circle.asc"),
    check: answered("43.2", "count the cycles from JMS CHK to the instruction after it: TAD, DCA, JMS and JMP I take two, the others one"),
  },
  {
    title: "What KCC does",
    text: "Put NOP (7000) in place of KCC at 0201, in core, and translate circle.asc to the end. Is the tape another one?",
    prepare: (bench) => bench.translate("circle.asc"),
    check: (bench) => {
      const { processor: { core }, teletype } = bench.machine;
      if (core[0o201] !== 0o7000) return `0201 holds ${octal(core[0o201])}, not 7000`;
      const whole = bench.shelf.get("circle.eia").frames;
      const { frames } = teletype.punch;
      if (frames.length < whole.length) return `${frames.length} of ${whole.length} frames are punched`;
      return whole.every((frame, index) => frame === frames[index]) ? "" : "the tape differs";
    },
  },
  {
    title: "Why spaces are zeros",
    text: "Put 1 in place of the 20 that MSP holds, so that no character is a space any more, and translate 100 frames. What does the Hydra-Point say of the tape?",
    prepare: (bench) => bench.translate("circle.asc"),
    check: (bench) => {
      const { processor: { core }, teletype } = bench.machine;
      const msp = bench.symbols.get("MSP");
      if (core[msp] !== 1) return `MSP, at ${octal(msp)}, holds ${octal(core[msp])}, not 0001`;
      if (teletype.reader.position < 100) return `the reader has read ${teletype.reader.position} frames`;
      const zeros = teletype.reader.tape.slice(0, teletype.reader.position).filter((frame) => (frame & 0o177) === ZERO).length;
      return teletype.punch.frames.filter((frame) => frame === CODES.get("0")).length > zeros ? "a space still became a zero" : "";
    },
  },
  {
    title: "Find the block where truncation shows",
    text: "ellipse.eia was made with exact arithmetic. With a GE-635 that drops the bits it has no room for, one block's Y is 2646 instead of 2647, at X 6404. Which block is the first?",
    prepare: (bench) => bench.mill.cut("ellipse.eia"),
    check: answered("587", "look among the blocks of the ellipse for X 06404"),
  },
  {
    title: "Break a tape, and see the machine refuse it",
    text: "Lose frame 1990 of circle.eia: the tape without it is on the shelf as torn.eia. Cut it. Which block is refused?",
    prepare: (bench) => {
      const { frames } = bench.shelf.get("circle.eia");
      if (!bench.shelf.get("torn.eia")) bench.shelf.put("torn.eia", Uint8Array.from([...frames].toSpliced(1990, 1)));
      bench.tabs.open("mill");
    },
    check: (bench, answer) => {
      if (bench.mill.name !== "torn.eia") return "torn.eia has not been cut";
      return answered("100", "the Hydra-Point says it in its first line")(bench, answer);
    },
  },
];

function item({ title, text }, index) {
  return `<li><h3>${escaped(title)}</h3><p>${escaped(text)}</p>
    <div class="tools">
      <button class="text" data-prepare="${index}">Prepare</button>
      <label>Answer <input type="text" size="8" data-answer="${index}"></label>
      <button class="text" data-check="${index}">Check</button>
      <span role="status" data-verdict="${index}"></span>
    </div></li>`;
}

export class Exercises {
  constructor(bench) {
    find("exercises").innerHTML = `<ol>${EXERCISES.map(item).join("")}</ol>`;
    find("exercises").addEventListener("click", ({ target }) => {
      const { prepare, check } = target.dataset;
      if (prepare !== undefined) EXERCISES[prepare].prepare(bench);
      if (check !== undefined) this.#check(bench, check);
    });
  }

  #check(bench, index) {
    const field = (name) => document.querySelector(`[data-${name}="${index}"]`);
    const why = EXERCISES[index].check(bench, field("answer").value);
    field("verdict").textContent = why ? `Not yet: ${why}.` : "Right.";
    field("verdict").className = why ? "" : "right";
  }
}
