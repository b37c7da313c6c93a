// A canvas that notes where it is filled, and refuses what a browser refuses or passes over.

const checked = (...numbers) => {
  for (const number of numbers) if (typeof number === "number" && !Number.isFinite(number)) throw new Error("a number that is none");
};

/** A context on which an inch has `sharp` pixels; `filled` has what it fills, [name, left, top, right, bottom, colour or picture], in pixels. */
export class Context {
  constructor(sharp = 1) {
    Object.assign(this, { at: [sharp, 0, 0, sharp, 0, 0], alpha: 1, saved: [], filled: [], texts: [], lines: 0, path: null, clips: 0, colour: "", lineWidth: 1 });
  }
  get globalAlpha() { return this.alpha; }
  set globalAlpha(alpha) {
    if (!(alpha >= 0 && alpha <= 1)) throw new Error(`an alpha of ${alpha}`);
    this.alpha = alpha;
  }
  get fillStyle() { return this.colour; }
  set fillStyle(colour) {
    if (colour === undefined || /NaN|undefined/.test(String(colour))) throw new Error(`the colour ${colour}`);
    this.colour = colour;
  }
  save() { this.saved.push([this.at, this.alpha, this.colour, this.clips, this.lineWidth]); }
  restore() {
    if (!this.saved.length) throw new Error("restored once more than saved");
    [this.at, this.alpha, this.colour, this.clips, this.lineWidth] = this.saved.pop();
  }
  getTransform() { return { a: this.at[0] }; }
  setTransform(...at) { checked(...at); this.at = at; }
  resetTransform() { this.at = [1, 0, 0, 1, 0, 0]; }
  translate(x, y) {
    checked(x, y);
    const [a, b, c, d, e, f] = this.at;
    this.at = [a, b, c, d, e + a * x + c * y, f + b * x + d * y];
  }
  scale(x, y) {
    checked(x, y);
    const [a, b, c, d, e, f] = this.at;
    this.at = [a * x, b * x, c * y, d * y, e, f];
  }
  rotate(turn) {
    const [a, b, c, d, e, f] = this.at, [cos, sin] = [Math.cos(turn), Math.sin(turn)];
    checked(turn);
    this.at = [a * cos + c * sin, b * cos + d * sin, c * cos - a * sin, d * cos - b * sin, e, f];
  }
  place(x, y) {
    checked(x, y);
    const [a, b, c, d, e, f] = this.at;
    return [a * x + c * y + e, b * x + d * y + f];
  }
  corners(x, y, w, h) {
    if (w <= 0 || h <= 0) throw new Error(`a rectangle of ${w} by ${h}`);
    return [[x, y], [x + w, y], [x, y + h], [x + w, y + h]].map((place) => this.place(...place));
  }
  note(name, places, picture) {
    const [xs, ys] = [0, 1].map((axis) => places.map((place) => place[axis]));
    this.filled.push([name, Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys), picture ?? this.colour]);
  }
  beginPath() { this.path = []; }
  add(...places) {
    if (!this.path) throw new Error("no path was begun");
    this.path.push(...places);
  }
  moveTo(x, y) { this.add(this.place(x, y)); }
  lineTo(x, y) { this.add(this.place(x, y)); }
  rect(...given) { this.add(...this.corners(...given)); }
  roundRect(x, y, w, h) { this.rect(x, y, w, h); }
  arc(x, y, radius) { this.rect(x - radius, y - radius, 2 * radius, 2 * radius); }
  ellipse(x, y, wide, high) { this.rect(x - wide, y - high, 2 * wide, 2 * high); }
  fill() { this.add(); this.note("fill", this.path); }
  clip() { this.add(); this.clips += 1; }
  strokeRect() { this.lines += 1; }
  stroke(path) { if (!path) this.add(); checked(this.lineWidth); this.lines += 1; }
  fillRect(...given) { this.note("fillRect", this.corners(...given)); }
  clearRect(...given) { this.corners(...given); }
  fillText(text, x, y) { this.texts.push([text, ...this.place(x, y)]); }
  drawImage(picture, ...given) {
    if (!picture) throw new Error("no picture");
    const [x, y, w = 1, h = 1] = given.slice(-4);
    this.note("picture", this.corners(x, y, w, h), picture);
  }
  gradient(...given) {
    checked(...given);
    return { addColorStop(at, colour) { if (!(at >= 0 && at <= 1) || !colour) throw new Error(`the colour ${colour} at ${at}`); } };
  }
  createLinearGradient(...given) { return this.gradient(...given); }
  createRadialGradient(...given) { return this.gradient(...given); }
}

/** What `draw` does to a context, which it leaves as it was. */
export function drawing(draw, sharp = 1) {
  const context = new Context(sharp);
  const before = String(context.at);
  draw(context);
  if (context.saved.length || String(context.at) !== before || context.alpha !== 1) throw new Error("it is not as it was");
  return context;
}

/** Pairs of what is filled that cross one another's edges by more than `near`: neither is within the other, nor are they apart. */
export function crossed(filled, near) {
  const within = ([, l, t, r, b], [, left, top, right, bottom]) => l >= left - near && t >= top - near && r <= right + near && b <= bottom + near;
  const apart = ([, l, t, r, b], [, left, top, right, bottom]) => r <= left + near || l >= right - near || b <= top + near || t >= bottom - near;
  return filled.flatMap((one, at) => filled.slice(at + 1).filter((other) => !(within(one, other) || within(other, one) || apart(one, other))).map((other) => [one, other]));
}
