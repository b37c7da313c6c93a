// A paper tape under its head, in true geometry: 1.000 in wide, rows 0.1 in apart, code holes .072 in, sprocket .046.
//
//           8 7 6 5 4 · 3 2 1        channel 1 at the right, as in the octal number of a frame;
//     4340  o . o o   .   o    "6"   the sprocket track between 4 and 3; time runs downward
//
// Sources: EIA RS-227; thesis (M. S. Wong, 1971), Chapter 2.

import * as ascii from "../../tapes/ascii.mjs";
import * as eia from "../../tapes/eia.mjs";
import { write } from "./sheet.mjs";
import { octal } from "./written.mjs";

const TRACKS = [8, 7, 6, 5, 4, 0, 3, 2, 1]; // 0 is the sprocket
const WIDE = 10; // pitches
const PAPER = { ascii: "#f1dfae", eia: "#e6e1cf", bin: "#d9e0cf", rim: "#d9e0cf" };
const HOLE = "#3a3129";
const SANS = 'Helvetica, Arial, "Liberation Sans", sans-serif';
const NUMBERS = 36; // room at the left, in pixels
const MEANINGS = 24; // and at the right
const TOP = 16; // for the channels' numbers
const ROW = 13; // pitches: the paper and three signs
const ROWS = 600; // pictures of rows that are kept
const rows = new Map();

/** What of a `view` is to be seen: two views with the same key look the same. */
export function tapeKey(view) {
  return `${view.label} ${view.head} ${view.frames.length} ${view.punching}`;
}

/** Draw `view` = {frames, head, code, punching}: `head` is the frame under the head; a punch shows nothing beyond it. */
export function drawTape(context, view, width, height, look) {
  const { ratio } = look;
  const whole = (pixels) => Math.floor(pixels * ratio) / ratio; // of the screen
  const pitch = whole(Math.max(6, Math.min(15, (width - NUMBERS - MEANINGS) / WIDE)));
  const left = whole(NUMBERS + Math.max(0, (width - NUMBERS - MEANINGS - WIDE * pitch) / 2));
  const headY = whole(TOP + (height - TOP) * (view.punching ? 0.7 : 0.5));
  const place = { left, pitch, headY, height, ...look };
  drawChannels(context, place);
  context.save();
  context.beginPath();
  context.rect(0, TOP, width, height - TOP);
  context.clip();
  drawPaper(context, view, place);
  const first = Math.max(0, view.head - Math.ceil(headY / pitch));
  const last = Math.min(view.frames.length - 1, view.head + (view.punching ? 0 : Math.ceil((height - headY) / pitch)));
  for (let frame = first; frame <= last; frame++) drawFrame(context, view, frame, place);
  drawHead(context, place);
  context.restore();
}

function drawPaper(context, view, { left, pitch, headY, height }) {
  const starts = headY - (view.head + (view.punching ? 6 : 4.5)) * pitch;
  const ends = view.punching ? height : headY + (view.frames.length - view.head + 3.5) * pitch;
  const top = Math.max(TOP - 9, starts);
  const tall = Math.min(height + 9, ends) - top;
  context.fillStyle = "rgba(60,45,25,.14)";
  context.fillRect(left + 3, top, WIDE * pitch, tall);
  context.fillStyle = PAPER[view.code];
  context.fillRect(left, top, WIDE * pitch, tall);
  context.fillStyle = "rgba(255,255,255,.3)";
  context.fillRect(left, top, pitch, tall);
}

function drawFrame(context, view, frame, place) {
  const { left, pitch, headY, soft, rust } = place;
  const y = headY + (frame - view.head) * pitch;
  const current = frame === view.head;
  if (current) {
    drawRow(context, view.frames[frame], view.code, { left, y, pitch, colour: rust, weight: "bold " });
  } else {
    context.drawImage(row(view.frames[frame], view.code, place), left, y - pitch, ROW * pitch, 2 * pitch);
    if (frame % 10 || Math.abs(frame - view.head) === 1) return;
  }
  const font = `${current ? "bold " : ""}11px ${SANS}`;
  write(context, String(frame), left - 5, y, { colour: current ? rust : soft, font, align: "right" });
}

/** The picture of a row, which looks the same wherever it stands: drawn once, as drawing it costs most. */
function row(holes, code, { pitch, ratio, ink }) {
  const key = `${holes} ${code} ${pitch} ${ratio} ${ink}`;
  if (!rows.has(key)) {
    if (rows.size === ROWS) rows.clear();
    const picture = new OffscreenCanvas(Math.round(ROW * pitch * ratio), Math.round(2 * pitch * ratio));
    const context = picture.getContext("2d");
    context.scale(ratio, ratio);
    drawRow(context, holes, code, { left: 0, y: pitch, pitch, colour: ink, weight: "" });
    rows.set(key, picture);
  }
  return rows.get(key);
}

/** The holes of a frame from `left` on, and what it says beside them. */
function drawRow(context, holes, code, { left, y, pitch, colour, weight }) {
  context.fillStyle = HOLE;
  TRACKS.forEach((channel, track) => {
    if (channel && !(holes & (1 << (channel - 1)))) return;
    context.beginPath();
    context.arc(left + (track + 1) * pitch, y, pitch * (channel ? 0.36 : 0.23), 0, 2 * Math.PI);
    context.fill();
  });
  const said = sign(holes, code);
  const font = `${weight}${Math.max(weight ? 11 : 0, Math.min(16, pitch))}px "Courier New", Courier, "Liberation Mono", monospace`;
  write(context, said, left + WIDE * pitch + 6, said === SPACE ? y - 0.25 * pitch : y, { colour, font, align: "left" });
}

function drawHead(context, { left, pitch, headY, rust }) {
  context.strokeStyle = rust;
  context.lineWidth = 2;
  context.strokeRect(left - 1, headY - pitch * 0.55, WIDE * pitch + 2, pitch * 1.1);
}

function drawChannels(context, { left, pitch, soft }) {
  const look = { colour: soft, font: `11px ${SANS}`, baseline: "alphabetic" };
  TRACKS.forEach((channel, track) => {
    if (channel) write(context, String(channel), left + (track + 1) * pitch, TOP - 5, look);
  });
}

const SPACE = "␣"; // hangs below its line: drawn a little higher, it stays off the next
const SIGNS = { CR: "↵", EOB: "↵", LF: "↓", RUBOUT: "×", blank: "", leader: "", space: SPACE };

/** What one frame says in its code, as one sign; a binary frame as its octal digits. */
function sign(frame, code) {
  const name = meaning(frame, code);
  return SIGNS[name] ?? name;
}

/** The same in words, as `tape show` has them. */
export function meaning(frame, code) {
  return code === "ascii" ? ascii.name(frame) : code === "eia" ? eia.name(frame) : octal(frame, 3);
}
