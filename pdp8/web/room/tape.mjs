// A paper tape in true geometry: 1.000 in wide, rows 0.1 in apart, code holes .072 in, sprocket .046.
//
//           8 7 6 5 4 · 3 2 1        channel 1 at the right, as in the octal number of a frame;
//           o . o o   .   o          the sprocket track between 4 and 3
//
// Sources: EIA RS-227; thesis (M. S. Wong, 1971), Chapter 2.

import { kept, sharpness, sheet } from "./ink.mjs";

export const TRACKS = [8, 7, 6, 5, 4, 0, 3, 2, 1]; // 0 is the sprocket
export const PITCH = 0.1;
const HOLE = "#1c1713";
const END = 0.45; // paper beyond the last row

/** Draw a tape that lies between y = `from` and `until`, its left edge at `x`; the frame `at`, which may have parts, is
 *  at y = `head`, those before it below, or above if `way` is -1. Frames are there up to `last`; the paper lies `lift` inches above what is under it.
 */
export function drawTape(/** @type {Canvas} */ c, /** @type {Strip} */ { x, head, from, until, way = 1, lift = 0.1 }, /** @type {{ frames: ArrayLike<number>; code: Code; at: number; last?: number }} */ { frames, code, at, last = frames.length }) {
  const place = (/** @type {number} */ frame) => head + way * (at - frame) * PITCH;
  const ends = [place(0) + way * END, place(last - 1) - way * END];
  const [top, bottom] = [Math.max(from, Math.min(...ends)), Math.min(until, Math.max(...ends))];
  if (bottom <= top) return;
  c.fillStyle = "rgba(0,0,0,.3)";
  c.fillRect(x + lift, top + lift, 1, bottom - top);
  c.fillStyle = code.paper;
  c.fillRect(x, top, 1, bottom - top);
  c.fillStyle = "rgba(255,255,255,.16)";
  c.fillRect(x, top, 0.12, bottom - top);
  c.fillStyle = "rgba(60,40,10,.12)";
  c.fillRect(x + 0.9, top, 0.1, bottom - top);
  const [one, other] = [top, bottom].map((y) => at - (way * (y - head)) / PITCH);
  const [first, end] = [Math.max(0, Math.ceil(Math.min(one, other))), Math.min(last - 1, Math.floor(Math.max(one, other)))];
  const sharp = sharpness(c);
  for (let frame = first; frame <= end; frame++) {
    const holes = frames[frame];
    const picture = kept(`holes ${holes} ${sharp}`, () => sheet(1, PITCH, sharp, (paper) => drawHoles(paper, holes)));
    c.drawImage(picture, x, place(frame) - PITCH / 2, 1, PITCH);
  }
}

function drawHoles(/** @type {Canvas} */ c, /** @type {number} */ holes) {
  c.fillStyle = HOLE;
  TRACKS.forEach((channel, track) => {
    if (channel && !(holes & (1 << (channel - 1)))) return;
    c.beginPath();
    c.arc((track + 1) * PITCH, PITCH / 2, channel ? 0.036 : 0.023, 0, 7);
    c.fill();
  });
}

/** @type {Record<string, string>} */ const SIGNS = { CR: "↵", EOB: "↵", LF: "↓", RUBOUT: "×", blank: "", leader: "", space: "␣" };

/** What a frame says in its code, as one sign; a binary frame as its octal digits. */
export function sign(/** @type {number} */ frame, /** @type {Code} */ code) {
  const name = code.caption(frame);
  return SIGNS[name] ?? name;
}
