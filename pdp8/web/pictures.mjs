// A row of pictures: each some time after the one before, and none while the page is hidden.
//
// The browser is asked for its next frame only when a picture is due: asked for every frame, it works for each. Asked a
// little early, it gives the one before.

const LATE = 1; // ms, so that the frame is there
const LONGEST = 250; // ms that a picture may stand for: a page that was asleep does not jump

const CALM = 1000 / 10; // ms from picture to picture as it was, where ten characters pass in a second
const QUICK = 1000 / 20; // and where more passes
export const READABLE = 250; // ms between two writings of what runs faster than it can be read

export class Pictures {
  /** `show(milliseconds)` shows what has changed in that time; the row goes on while it returns true. */
  constructor(/** @type {(milliseconds: number) => boolean} */ show, speed = Infinity) {
    this.speed = speed; // how many times as fast as it was
    this.show = show;
    this.running = false;
  }

  start() {
    if (this.running) return;
    this.running = true;
    /** @type {number} */ this.before = performance.now();
    this.#wait();
  }

  stop() {
    this.running = false;
    clearTimeout(this.due);
    cancelAnimationFrame(/** @type {number} */ (this.coming));
  }

  #wait() {
    const each = this.speed > 1 ? QUICK : CALM;
    const due = this.before + each + LATE - performance.now();
    this.due = setTimeout(() => (this.coming = requestAnimationFrame((now) => this.#picture(now))), due);
  }

  #picture(/** @type {number} */ now) {
    const passed = Math.min(Math.max(now - this.before, 0), LONGEST); // a frame may have begun before the row did
    this.before = Math.max(now, this.before);
    this.running = this.show(passed) && this.running;
    if (this.running) this.#wait();
  }
}
