// The Teletype's sound, made as it is needed: a click of noise for a character, a struck bell.

export class Sound {
  constructor() {
    this.on = false;
    this.context = null;
  }

  turn({ checked }) {
    this.on = checked;
    if (this.on) this.context ??= new AudioContext();
  }

  /** Make the sound of a character that is printed; "" is none. */
  make(character) {
    if (!this.on) return;
    if (character === "\x07") this.#ring();
    else if (character > "\r") this.#click();
  }

  #click() {
    const { context } = this;
    const length = Math.round(context.sampleRate * 0.02);
    const buffer = context.createBuffer(1, length, context.sampleRate);
    const samples = buffer.getChannelData(0);
    for (let at = 0; at < length; at++) samples[at] = (Math.random() - 0.5) * Math.exp(-at / (length / 6));
    const source = new AudioBufferSourceNode(context, { buffer });
    source.connect(context.destination);
    source.start();
  }

  #ring() {
    const { context } = this;
    const tone = new OscillatorNode(context, { frequency: 2300 });
    const gain = new GainNode(context, { gain: 0.2 });
    gain.gain.exponentialRampToValueAtTime(0.001, context.currentTime + 0.6);
    tone.connect(gain).connect(context.destination);
    tone.start();
    tone.stop(context.currentTime + 0.6);
  }
}
