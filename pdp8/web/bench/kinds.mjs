// What a tape is, by its frames alone, and where an operator sets it: what a reader needs of tapes/kinds.py.

import { ASCII, EIA, LABEL_GAP, LEADER, LEAST_LEADER } from "../facts.mjs";

const LOOK = 1000; // frames
const RUBOUT = 0o200 | ASCII.RUBOUT;

/** The code in which a tape is shown, by its first frames: "ascii", "eia" or "bin". */
export function codeOf(tape) {
  const frames = tape.slice(0, LOOK);
  if (frames[0] === LEADER || (frames.length > 2 && frames[1] === LEADER) || isLeader(frames, start(frames))) return "bin";
  const some = [...frames.slice(0, 200)].filter((frame) => !isSilent(frame));
  const share = (test) => some.filter(test).length / (some.length || 1);
  if (share((frame) => frame in EIA) > 0.9 && share((frame) => frame & 0o200) < 0.5) return "eia";
  const writes = (code) => code >= ASCII.space || code === ASCII.CR || code === ASCII.LF;
  return share((frame) => writes(frame & 0o177)) > 0.9 ? "ascii" : "bin";
}

/** The frame on which an operator sets a tape: its leader of 200, past blank tape, and past a label or rubouts of
 *  a loader tape; any other tape's first.
 */
export function start(frames) {
  const first = frames.findIndex((frame) => frame !== 0);
  if (first < 0 || frames[first] === LEADER) return Math.max(first, 0);
  const leader = frames.findIndex((_, at) => at > first && isLeader(frames, at));
  if (leader < 0 || hasLines(frames, leader)) return 0;
  const gap = leader >= LABEL_GAP && frames.slice(leader - LABEL_GAP, leader).every((frame) => frame === 0);
  const rubbedOut = frames.slice(0, leader).every((frame) => frame === 0 || frame === RUBOUT);
  return (gap || rubbedOut) && isOrigin(frames.slice(leader).find((frame) => !isSilent(frame))) ? leader : 0;
}

function isSilent(frame) {
  return frame === 0 || frame === LEADER;
}

function isLeader(frames, at) {
  for (let count = 0; count < LEAST_LEADER; count++) if (frames[at + count] !== LEADER) return false;
  return true;
}

/** Whether text with CR LF stands before frame `end`: no label. */
function hasLines(frames, end) {
  const code = (at) => frames[at] & 0o177;
  return frames.slice(1, end).some((_, at) => code(at) === ASCII.CR && code(at + 1) === ASCII.LF);
}

/** Whether a section of BIN or RIM may begin with this frame: an origin, an address or a field. */
function isOrigin(frame) {
  return frame >> 6 === 1 || frame >> 6 === 3;
}
