// How things are written on the page, and where.

import { TICKS_PER_SECOND as SECOND } from "../computer/hardware/signals.mjs";
import { counted } from "../../tapes/quantities.mjs";

/** The element with that id.
 * @returns {any} */
export const find = (/** @type {string} */ id) => document.getElementById(id);

/** What is not there yet, and is there when it is asked for. @type {any} */
export const LATER = null;

/** In the address: the page opens at the desk. Behind it, as without it in the room, #t=SECONDS is an instant of the afternoon. */
export const DESK = "#workbench";

/** Let the address of the page have another end, without going there; `push` is whether one comes back by the browser's own key;
 *  `known`, whether what it holds is here already, and a reload finds what has become of it. */
export function readdress(/** @type {string} */ end, push = false, known = false) {
  history[push ? "pushState" : "replaceState"](known || null, "", location.href.replace(/#.*/, "") + end);
}

export function octal(/** @type {number} */ value, digits = 4) {
  return value.toString(8).padStart(digits, "0");
}

/** Thousandths of an inch as inches: 2.250. */
export function inches(/** @type {number} */ thousandths) {
  return (thousandths / 1000).toFixed(3);
}

/** 170888757 as 170 888 757. */
export function grouped(/** @type {number} */ number) {
  return String(number).replace(/\B(?=(\d{3})+$)/g, "\u202f");
}

/** Ticks as seconds, every tick of 0.05 µs to be seen: 473.799 997 75 s. */
export function seconds(/** @type {number} */ ticks) {
  const [whole, parts] = (ticks / SECOND).toFixed(8).split(".");
  return `${whole}.${parts.slice(0, 3)} ${parts.slice(3, 6)} ${parts.slice(6)} s`;
}

/** A number with its unit, a plural: "13 321 frames", "1 frame", "no frames". */
export const many = (/** @type {number} */ number, /** @type {string} */ unit) => counted(number, unit).replaceAll(",", "\u202f");
