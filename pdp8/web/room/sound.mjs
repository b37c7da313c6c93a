// The room's sounds, made as they are needed from noise and tones: none is heard before its switch is turned.
//
//     strike(kind, when)     print, feed, read, punch, key, bell, at the tick of its event
//     hum(motor, cutter)     what lasts
//
// They are made by ear, after descriptions: no recording was taken.

const LEAST = 0.07; // seconds between two strikes of a kind: more are not heard apart
const LEAD = 0.05; // seconds from a picture to its sound, so that each comes at its own time

/** Bursts of noise: [middle in Hz, how narrow, seconds, loudness]. */
/** @type {Record<string, [number, number, number, number][]>} */ const STRIKES = {
  print: [[190, 1.2, 0.06, 0.9], [3400, 2, 0.012, 0.3]],
  feed: [[120, 1, 0.14, 0.7]],
  read: [[2600, 3, 0.02, 0.28]],
  punch: [[880, 2, 0.035, 0.6]],
  key: [[1500, 4, 0.025, 0.8]],
};
/** @type {[number, number, number][]} */ const BELL = [[2210, 0.2, 1.1], [5480, 0.06, 0.5]]; // Hz, loudness, seconds

export class Sound {
  constructor() {
    this.on = false;
    this.last = /** @type {Record<string, number>} */ ({});
  }

  turn(/** @type {boolean} */ on) {
    this.hum(0, 0); // else it would hum on where it is turned on again
    this.on = on;
    if (on && !this.context) this.#build(new AudioContext());
    this.context?.[on ? "resume" : "suspend"]();
  }

  #build(/** @type {AudioContext} */ context) {
    /** @type {AudioContext} */ this.context = context;
    /** @type {GainNode} */ this.out = new GainNode(context, { gain: 0.7 });
    this.out.connect(new DynamicsCompressorNode(context)).connect(context.destination);
    this.noise = new AudioBuffer({ length: context.sampleRate, sampleRate: context.sampleRate });
    const samples = this.noise.getChannelData(0);
    for (let at = 0; at < samples.length; at++) samples[at] = Math.random() * 2 - 1;
    /** @type {AudioParam} */ this.motor = this.#drone([[58, 0.5], [116.5, 0.22], [232, 0.05]], 320);
    /** @type {AudioParam} */ this.cutter = this.#drone([[83, 0.3], [331, 0.16], [1240, 0.05]], 2600);
  }

  /** A sound that lasts: tones, a little noise, and a lid on them; how loud it is, is set later. */
  #drone(/** @type {number[][]} */ tones, /** @type {number} */ lid) {
    const { context } = this;
    const gain = new GainNode(context, { gain: 0 });
    const filter = new BiquadFilterNode(context, { frequency: lid });
    const hiss = new AudioBufferSourceNode(context, { buffer: this.noise, loop: true });
    hiss.connect(new GainNode(context, { gain: 0.12 })).connect(filter);
    hiss.start();
    for (const [frequency, loud] of tones) {
      const tone = new OscillatorNode(context, { type: "sawtooth", frequency });
      tone.connect(new GainNode(context, { gain: loud })).connect(filter);
      tone.start();
    }
    filter.connect(gain).connect(this.out);
    return gain.gain;
  }

  /** How loud the motor and the cutter are, 0 to 1. */
  hum(/** @type {number} */ motor, /** @type {number} */ cutter) {
    if (!this.on) return;
    this.motor.setTargetAtTime(motor * 0.05, this.context.currentTime, 0.3);
    this.cutter.setTargetAtTime(cutter * 0.09, this.context.currentTime, 0.12);
  }

  /** Strike, so many seconds after now. */
  strike(/** @type {string} */ kind, later = 0) {
    if (!this.on) return;
    const when = this.context.currentTime + LEAD + later;
    if (when - (this.last[kind] ?? 0) < LEAST) return;
    this.last[kind] = when;
    if (kind === "bell") for (const tone of BELL) this.#ring(when, ...tone);
    else for (const burst of STRIKES[kind]) this.#burst(when, ...burst);
  }

  #burst(/** @type {number} */ when, /** @type {number} */ frequency, /** @type {number} */ sharp, /** @type {number} */ long, /** @type {number} */ loud) {
    const { context } = this;
    const source = new AudioBufferSourceNode(context, { buffer: this.noise });
    const gain = new GainNode(context, { gain: 0 });
    gain.gain.setValueAtTime(loud, when);
    gain.gain.exponentialRampToValueAtTime(0.001, when + long * 2);
    source.connect(new BiquadFilterNode(context, { type: "bandpass", frequency: frequency * (0.95 + Math.random() * 0.1), Q: sharp })).connect(gain).connect(this.out);
    source.start(when, Math.random() * 0.5, long * 3);
  }

  #ring(/** @type {number} */ when, /** @type {number} */ frequency, /** @type {number} */ loud, /** @type {number} */ long) {
    const tone = new OscillatorNode(this.context, { frequency });
    const gain = new GainNode(this.context, { gain: 0 });
    gain.gain.setValueAtTime(loud, when);
    gain.gain.exponentialRampToValueAtTime(0.0005, when + long);
    tone.connect(gain).connect(this.out);
    tone.start(when);
    tone.stop(when + long);
  }
}
