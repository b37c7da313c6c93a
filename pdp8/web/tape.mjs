// A paper tape on the desk: drawn as in the room (room/tape.mjs), with the number and the sign of each frame beside it, its head
// and its channels.
//
//           8 7 6 5 4 · 3 2 1        channel 1 at the right, as in the octal number of a frame;
//     4340  o . o o   .   o    "6"   the sprocket track between 4 and 3; time runs downward

import { drawTape as drawStrip, sign, TRACKS } from "./room/tape.mjs";
import { kept, sheet } from "./room/ink.mjs";
import { write } from "./sheet.mjs";

const WIDE = 10; // pitches
const SANS = 'Helvetica, Arial, "Liberation Sans", sans-serif';
const TYPE = '"Courier New", Courier, "Liberation Mono", monospace';
const NUMBERS = 36; // room at the left, in pixels
const MEANINGS = 24; // and at the right
const TOP = 16; // for the numbers of the channels
const SPACE = "␣"; // hangs below its line: drawn a little higher, it stays off the next

/** What of a `view` is to be seen: two views with the same key look the same. */
export function tapeKey(/** @type {TapeView} */ view) {
  return `${view.label} ${view.head} ${view.frames.length} ${view.punching}`;
}

/** Draw `view` = {frames, head, code, punching}: `head` is the frame under the head; a punch shows nothing beyond it. */
export function drawTape(/** @type {Canvas} */ context, /** @type {TapeView} */ view, /** @type {number} */ width, /** @type {number} */ height, /** @type {Colours} */ look) {
  const { ratio, rust, soft } = look;
  const whole = (/** @type {number} */ pixels) => Math.floor(pixels * ratio) / ratio; // of the screen
  const pitch = whole(Math.max(6, Math.min(15, (width - NUMBERS - MEANINGS) / WIDE)));
  const left = whole(NUMBERS + Math.max(0, (width - NUMBERS - MEANINGS - WIDE * pitch) / 2));
  const y = whole(TOP + (height - TOP) * (view.punching ? 0.7 : 0.5)); // of the head
  TRACKS.forEach((channel, track) => {
    if (channel) write(context, String(channel), left + (track + 1) * pitch, TOP - 5, { colour: soft, font: `11px ${SANS}`, baseline: "alphabetic" });
  });
  context.save();
  context.beginPath();
  context.rect(0, TOP, width, height - TOP);
  context.clip();
  context.save();
  context.translate(left, y);
  context.scale(WIDE * pitch, WIDE * pitch);
  const [from, until] = [TOP - y, height - y].map((far) => far / pitch / WIDE);
  drawStrip(context, { x: 0, head: 0, from, until, way: -1, lift: 0.03 }, { ...view, at: view.head, last: view.punching ? view.head + 1 : view.frames.length });
  context.restore();
  const first = Math.max(0, view.head - Math.ceil((y - TOP) / pitch));
  const last = Math.min(view.frames.length - 1, view.head + (view.punching ? 0 : Math.ceil((height - y) / pitch)));
  for (let frame = first; frame <= last; frame++) drawBeside(context, view, frame, { left, pitch, y: y + (frame - view.head) * pitch, ...look });
  context.strokeStyle = rust;
  context.lineWidth = 2;
  context.strokeRect(left - 1, y - pitch * 0.55, WIDE * pitch + 2, pitch * 1.1);
  context.restore();
}

/** What a frame says, at its right, and the number of each tenth, at its left. Signs are pictures: drawing them costs most. */
function drawBeside(/** @type {Canvas} */ context, /** @type {TapeView} */ { code, frames, head }, /** @type {number} */ frame, /** @type {Colours & { left: number; pitch: number; y: number }} */ { left, pitch, y, ratio, ink, soft, rust }) {
  const current = frame === head;
  const [colour, weight] = current ? [rust, "bold "] : [ink, ""];
  const said = sign(frames[frame], code);
  const right = left + WIDE * pitch;
  const picture = kept(`sign ${said} ${pitch} ${ratio} ${colour}`, () => sheet(3 * pitch, 2 * pitch, ratio, (c) => {
    const font = `${weight}${Math.max(current ? 11 : 0, Math.min(16, pitch))}px ${TYPE}`;
    write(c, said, 6, said === SPACE ? 0.75 * pitch : pitch, { colour, font, align: "left" });
  }));
  context.drawImage(picture, right, y - pitch, 3 * pitch, 2 * pitch);
  if (!current && (frame % 10 || Math.abs(frame - head) === 1)) return;
  write(context, String(frame), left - 5, y, { colour: current ? rust : soft, font: `${weight}11px ${SANS}`, align: "right" });
}
