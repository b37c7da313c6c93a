// The camera: where it looks, in inches of the room, and how it glides there, as on a spring without a swing.

import { LATER } from "../written.mjs";

const STIFF = 5; // of the spring
const STEP = 0.01; // seconds of a step of the glide
const STILL = 0.5; // pixels, and pixels a second: nobody sees that it is not yet where it goes to
const EDGE = 400; // pixels from the middle, where a zoom is seen

export class Camera {
  constructor() {
    /** @type {Eye} */ this.eye = LATER;
    this.moves = false; // whether it glides
  }

  /** Look at a box { x, y, w, h } so that all of it is in a frame { left, top, w, h } of the screen; at once, or gliding there. */
  look(/** @type {Area} */ box, /** @type {{ left: number; top: number; w: number; h: number }} */ frame, /** @type {boolean} */ now) {
    /** @type {typeof frame} */ this.frame = frame;
    const scale = Math.min(frame.w / box.w, frame.h / box.h);
    /** @type {Eye} */ this.aim = { x: box.x + box.w / 2, y: box.y + box.h / 2, zoom: Math.log(scale) };
    if (now || !this.eye) this.eye = { ...this.aim, vx: 0, vy: 0, vzoom: 0 };
  }

  /** Let so many seconds pass. */
  glide(/** @type {number} */ seconds) {
    const { aim, eye, scale } = this;
    const steps = Math.ceil(seconds / STEP);
    for (let step = 0; step < steps; step++) {
      for (const at of ["x", "y", "zoom"]) {
        const speed = `v${at}`;
        eye[speed] += (STIFF * (aim[at] - eye[at]) - 2 * Math.sqrt(STIFF) * eye[speed]) * (seconds / steps);
        eye[at] += eye[speed] * (seconds / steps);
      }
    }
    const seen = (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ zoom) => Math.max(Math.abs(x * scale), Math.abs(y * scale), Math.abs(zoom * EDGE));
    this.moves = Math.max(seen(eye.vx, eye.vy, eye.vzoom), seen(eye.x - aim.x, eye.y - aim.y, eye.zoom - aim.zoom)) > STILL;
    if (!this.moves) this.eye = { ...aim, vx: 0, vy: 0, vzoom: 0 };
  }

  /** Pixels of the screen for an inch. */
  get scale() {
    return Math.exp(this.eye.zoom);
  }

  /** The same where it comes to rest. */
  get goal() {
    return Math.exp(this.aim.zoom);
  }

  /** Where on the screen the room's 0, 0 is. */
  get origin() {
    const { eye, frame, scale } = this;
    return { x: frame.left + frame.w / 2 - eye.x * scale, y: frame.top + frame.h / 2 - eye.y * scale };
  }
}
