// The Moog Hydra-Point: what each block makes it do, and for how long: nc/machine.py in JavaScript.
//
// The Python module is the authority: what the machine does, what is assumed and where it is from stands there.

import { HYDRA_POINT } from "../facts.mjs";
import { BlockError, read } from "./blocks.mjs";

const { XY_FEED, Z_FEED, POSITIONING_SPEED, READ_SECONDS, PECK } = HYDRA_POINT;
const P = HYDRA_POINT.PREPARATORY_CODES, M = HYDRA_POINT.MISCELLANEOUS_CODES;
const FEED_OUT = [P.TAP_FEED, P.BORE, P.TAP_PITCH];

/** Read the tape and carry out its blocks: {steps, error}; each step has its block, place, moves, and where it ends. */
export function cut(frames) {
  const machine = { at: { x: 0, y: 0, z: 0 }, modes: { partialRetract: false } };
  const steps = [];
  try {
    for (const [place, block] of read(frames)) steps.push(carryOut(machine, place, block));
  } catch (error) {
    return { steps, error };
  }
  return { steps, error: null };
}

function carryOut(machine, place, block) {
  const modes = set(machine.modes, block);
  const motion = new Motion(place, block, machine.at, modes);
  const moves = [...motion.moves()];
  machine.modes = modes;
  machine.at = motion.at;
  return { place, block, moves, at: machine.at, seconds: moves.reduce((sum, move) => sum + move.seconds, READ_SECONDS) };
}

/** The modes in force with this block. */
function set(modes, { preparatory, miscellaneous, tool, x, y }) {
  const now = { ...modes };
  if (preparatory === P.READ_Z) Object.assign(now, { feedPoint: x, finalDepth: y });
  if (miscellaneous === M.X_FEED) now.xFeed = XY_FEED[tool];
  if (miscellaneous === M.Y_FEED) now.yFeed = XY_FEED[tool];
  if (miscellaneous === M.Z_FEED) now.zFeed = Z_FEED[tool];
  if (miscellaneous === M.PARTIAL_RETRACT_ON) now.partialRetract = true;
  if (miscellaneous === M.PARTIAL_RETRACT_OFF) now.partialRetract = false;
  return now;
}

/** The moves of one block, from where the cutter is. */
class Motion {
  constructor(place, block, at, modes) {
    Object.assign(this, { place, block, at, modes });
  }

  *moves() {
    const { preparatory, miscellaneous } = this.block;
    if (preparatory === P.POSITION) {
      yield* this.quill("retract", Math.min(this.at.z, this.clear()));
      yield* this.table("position", POSITIONING_SPEED, POSITIONING_SPEED);
    } else if (preparatory === P.MILL) {
      yield* this.mill();
    } else if (preparatory !== P.READ_Z) {
      yield* this.makeHole();
    }
    if ([M.MANUAL_TOOL_CHANGE, M.INDEX, M.TOOL_CHANGE].includes(miscellaneous)) yield* this.quill("retract", 0);
  }

  /** Where the quill waits between two places. */
  clear() {
    return this.modes.partialRetract ? this.modes.feedPoint ?? 0 : 0;
  }

  *mill() {
    const { xFeed, yFeed } = this.modes;
    if (this.block.x !== this.at.x && !xFeed) this.refuse("milling along X needs an X feed (miscellaneous function 84); no block has set one");
    if (this.block.y !== this.at.y && !yFeed) this.refuse("milling along Y needs a Y feed (miscellaneous function 85); no block has set one");
    const [feedPoint, finalDepth] = this.depths();
    if (this.at.z !== finalDepth) {
      yield* this.quill("approach", Math.max(this.at.z, feedPoint));
      yield* this.quill("feed in", finalDepth);
    }
    yield* this.table("mill", xFeed ?? 0, yFeed ?? 0);
  }

  *makeHole() {
    const { preparatory } = this.block;
    const [feedPoint, finalDepth] = this.depths();
    yield* this.quill("retract", Math.min(this.at.z, this.clear()));
    yield* this.table("position", POSITIONING_SPEED, POSITIONING_SPEED);
    yield* this.quill("approach", feedPoint);
    if (preparatory === P.PECK) {
      for (let depth = feedPoint + PECK; depth < finalDepth; depth += PECK) {
        yield* this.quill("feed in", depth);
        yield* this.quill("retract", feedPoint);
        yield* this.quill("approach", depth);
      }
    }
    yield* this.quill("feed in", finalDepth);
    if (FEED_OUT.includes(preparatory)) yield* this.quill("feed out", feedPoint);
    yield* this.quill("retract", this.clear());
  }

  depths() {
    const { feedPoint, finalDepth, zFeed } = this.modes;
    if (feedPoint === undefined) this.refuse("the quill needs depths (preparatory function 9); no block has set them");
    if (!zFeed) this.refuse("the quill needs a Z feed (miscellaneous function 89); no block has set one");
    return [feedPoint, finalDepth];
  }

  /** Refuse a block for what no block has set. */
  refuse(message) {
    throw new BlockError(message, this.place, 4);
  }

  *quill(kind, depth) {
    if (depth === this.at.z) return;
    const speed = kind === "feed in" || kind === "feed out" ? this.modes.zFeed : POSITIONING_SPEED;
    yield this.move(kind, { ...this.at, z: depth }, speed);
  }

  /** Move X and Y to the block's place, each at its own speed: together, then the one left alone. */
  *table(kind, xSpeed, ySpeed) {
    const { x, y } = this.at;
    const across = this.block.x - x;
    const up = this.block.y - y;
    if (across && up) {
      const xTime = Math.abs(across) / xSpeed;
      const yTime = Math.abs(up) / ySpeed;
      const both = Math.min(xTime, yTime);
      const corner = {
        x: xTime <= yTime ? this.block.x : x + Math.sign(across) * xSpeed * both,
        y: yTime <= xTime ? this.block.y : y + Math.sign(up) * ySpeed * both,
        z: this.at.z,
      };
      yield this.move(kind, corner, Math.hypot(xSpeed, ySpeed));
    }
    if (this.at.x !== this.block.x) yield this.move(kind, { ...this.at, x: this.block.x }, xSpeed);
    if (this.at.y !== this.block.y) yield this.move(kind, { ...this.at, y: this.block.y }, ySpeed);
  }

  move(kind, end, speed) {
    const start = this.at;
    this.at = end;
    const length = Math.hypot(end.x - start.x, end.y - start.y, end.z - start.z);
    return { kind, start, end, speed, seconds: (length / 1000 / speed) * 60 };
  }
}

const CUTTING = ["mill", "feed in", "feed out"];

/** The path as a picture has it: blocks and knots by their tick, and the circle that the milling follows, if any. */
export function pictured({ steps }, second, cutter) {
  const reading = READ_SECONDS * second;
  const path = [[0, 0, 0, false]];
  const blocks = [];
  let now = 0;
  for (const { moves } of steps) {
    blocks.push({ at: Math.round(now), reading });
    now += reading;
    if (moves.length) path.push([Math.round(now), moves[0].start.x, moves[0].start.y, false]);
    for (const { kind, end, seconds } of moves) {
      now += seconds * second;
      path.push([Math.round(now), end.x, end.y, CUTTING.includes(kind)]);
    }
  }
  const circle = followed(steps);
  return { blocks, path, diameter: cutter, band: circle && band(circle), circle, end: now };
}

const TOLERANCE = 5; // thousandths, half the width of the band
const NEAR = 4 * TOLERANCE; // a path that stays this near follows the circle

/** The circle that the milled path follows, with how far inside and outside of it the cutter's centre goes. */
function followed(steps) {
  const ends = steps.flatMap(({ moves }) => moves).filter(({ kind }) => kind === "mill").map(({ end }) => end);
  if (ends.length < 8) return null;
  const circle = fitted(ends);
  const radii = ends.map(({ x, y }) => Math.hypot(x - circle.x, y - circle.y) - circle.radius);
  const [lowest, highest] = [Math.min(...radii), Math.max(...radii)];
  return lowest >= -NEAR && highest <= NEAR ? { ...circle, lowest, highest } : null;
}

/** The circle of least squares through points (Kåsa), its centre and radius to a thousandth. */
function fitted(points) {
  const mean = (value) => points.reduce((sum, point) => sum + value(point), 0) / points.length;
  const [mx, my] = [mean(({ x }) => x), mean(({ y }) => y)];
  const u = ({ x }) => x - mx, v = ({ y }) => y - my, square = (point) => u(point) ** 2 + v(point) ** 2;
  const [uu, uv, vv] = [mean((p) => u(p) ** 2), mean((p) => u(p) * v(p)), mean((p) => v(p) ** 2)];
  const [us, vs] = [mean((p) => u(p) * square(p)), mean((p) => v(p) * square(p))];
  const determinant = 2 * (uu * vv - uv * uv) || 1;
  const x = Math.round(mx + (us * vv - vs * uv) / determinant);
  const y = Math.round(my + (vs * uu - us * uv) / determinant);
  return { x, y, radius: Math.round(mean((point) => Math.hypot(point.x - x, point.y - y))) };
}

function band({ x, y, radius }) {
  const outline = (offset) => Array.from({ length: 721 }, (_, step) => {
    const angle = (step * Math.PI) / 360;
    return [x + (radius + offset) * Math.cos(angle), y + (radius + offset) * Math.sin(angle)];
  });
  return { inner: outline(-TOLERANCE), nominal: outline(0), outer: outline(TOLERANCE) };
}
