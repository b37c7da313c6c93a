// The room: what a visitor sees first. The page's own machine, led through the afternoon, a picture for each frame of the browser.
//
//     Tour ──► tick ──► Script, its machine ──► Scene, through a Camera          sounds at the events' own ticks
//
// Taken over, the machine is the visitor's and lives by the page's clock; the switches in the picture are buttons. The room
// stands still when nothing in it moves.

import { clock, Kind } from "../../replay/day.mjs";
import { one_of_each } from "../../computer/hardware/devices.mjs";
import { FIELD } from "../../computer/hardware/extension.mjs";
import { FRAME, TICKS_PER_SECOND as SECOND } from "../../computer/hardware/signals.mjs";
import { Machine } from "../../computer/machine.mjs";
import { Minute } from "../../lessons/minute.mjs";
import { sent } from "../../computer/use/keys.mjs";
import { bounds } from "../bench/path.mjs";
import { ASCII, EIA } from "../../../tapes/codes.mjs";
import { counted } from "../../../tapes/quantities.mjs";
import { codeFor, codeOf } from "../bench/shelf.mjs";
import { keyed, modified } from "../bench/wiring.mjs";
import { html, put } from "../html.mjs";
import { inWords } from "../panel.mjs";
import { DESK, find, grouped, LATER, readdress } from "../written.mjs";
import { Camera } from "./camera.mjs";
import { Hands } from "./hands.mjs";
import { keepsake } from "./keepsake.mjs";
import { drawCutter, drawDusk, drawMeasured, drawSpindle, drawTable, fitted, lay, TILT } from "./mill.mjs";
import { drawLamps, Filaments, formed, least, WHOLE } from "./panel.mjs";
import { Plate } from "./plate.mjs";
import { Scene } from "./scene.mjs";
import { drawTape } from "./tape.mjs";
import { drawHeads, drawSign, Page, TAPES } from "./teletype.mjs";
import { atThePanel, atTheTape, places, Tour } from "./tour.mjs";
import { Wall } from "./wall.mjs";

const EACH = 1 / 32, HURRIED = 1 / 20; // seconds between two steps of the machine: camera and tapes glide between them
const HURRY = 20; // times as fast: no event is waited for then
const LOOKS = 4; // at the lamps in a step
const SLOW = 1 / 32; // seconds between two pictures that are too many in a hurry
const [COARSE, LEAST] = [0.6, 0.75]; // part of the pixels, across and up, that are drawn then; at least so many for one of CSS
const SAID = 0.12; // seconds in which what is read does not change
const FILAMENT = 0.045; // seconds in which a lamp follows
const CALM = 0.7; // part of an act that is shown where nothing shall move

export class Room {
  constructor(/** @type {Bench} */ bench) {
    this.bench = bench;
    this.place = find("room");
    this.scene = new Scene(this.place.querySelector("canvas"));
    this.camera = new Camera();
    this.filaments = new Filaments();
    this.guide = new Minute(matchMedia("(hover: hover) and (pointer: fine)").matches);
    this.page = new Page();
    this.still = matchMedia("(prefers-reduced-motion: reduce)").matches; // nothing shall move
    this.at = { reader: 0, punch: 0 };
    this.moved = { struck: 0, fed: 0, turns: 0 };
    this.samples = /** @type {Lamps[] | null} */ (null);
    this.work = /** @type {any} */ (null);
    this.milled = /** @type {Plate | null} */ (null);
    /** @type {Tour} */ this.tour = LATER;
    /** @type {Hands} */ this.hands = LATER;
    /** @type {HTMLButtonElement[]} */ this.chapters = LATER;
    /** @type {Shown | null} */ this.shown = null; /** @type {Shown} */ this.form = LATER; /** @type {ReturnType<Minute["next"]>} */ this.step = LATER;
    this.tall = this.cuts = false;
    this.before = this.told = this.fine = this.speed = 0;
    this.asked = this.choice = "";
    this.heard = /** @type {Record<string, number> | null} */ (null);
    this.own = null; // the machine that somebody has worked at
    this.typing = false; // whether the visitor types, and looks at punch and paper
    this.mine = ""; // what he has typed
    this.live = this.playing = false;
    this.since = 0;
    this.took = 0; // seconds between pictures, about
    this.coarse = false;
    this.said = 0; // seconds since something was written
    this.typed = 0;
    document.addEventListener("keydown", (event) => this.#key(event));
    this.place.querySelector("canvas").addEventListener("click", () => this.typing && find("mine").focus());
    new ResizeObserver(() => this.#resize()).observe(this.place);
    new ResizeObserver(() => this.#measure()).observe(this.place.querySelector(".told"));
    document.addEventListener("visibilitychange", () => (document.hidden ? bench.sound.hum(0, 0) : this.#wake()));
  }

  get open() {
    return !this.place.hidden;
  }

  /** Enter the room, and play from the beginning; or stand still at an instant of the afternoon, in ticks. */
  enter(/** @type {number | null} */ tick = null) {
    const { bench, bench: { afternoon, machine }, place } = this;
    if (!afternoon.on) this.keep(machine);
    afternoon.playing = false; // at the desk
    place.hidden = false;
    if (!this.tour) this.#furnish();
    this.#resize();
    this.go({ value: 0 });
    this.playing = !this.still && tick === null;
    if (tick !== null) {
      this.tour.at(tick);
      afternoon.lead(tick);
      this.#tell();
    }
    this.#buttons();
    bench.clock.pictures.stop();
  }

  /** Keep the machine at which somebody has worked: with anything in its core or reader, or a DECtape. */
  keep(/** @type {Machine} */ machine) {
    this.own = machine.processor.core.some((word) => word) || machine.memory > FIELD || machine.teletype.reader.loaded ? machine : null;
    this.#buttons();
  }

  /** Put into the room what an afternoon has. */
  #furnish() {
    const { afternoon: { script: { day } }, record: { afternoon: { machines, story } } } = this.bench;
    this.story = story;
    this.tour = new Tour(day, machines[0][0]);
    put(this.place.querySelector(".chapters"), story.slice(1).map((/** @type {[string]} */ [name], /** @type {number} */ index) => html`<li><button data-click="room.go" value="${index + 1}">${name}</button></li>`));
    this.chapters = [...this.place.querySelectorAll(".chapters button")];
  }

  /** Go to an act; where nothing shall move, into the midst of it. */
  go(/** @type {{ value: string | number }} */ { value }) {
    const { afternoon } = this.bench;
    this.tour.go(Number(value), this.still ? CALM : 0);
    this.#letGo();
    afternoon.lead(this.tour.tick);
    this.samples = null;
    this.#tell();
    this.#buttons();
    this.#wake();
  }

  toggle() {
    this.playing = !this.playing;
    readdress(this.playing ? "" : `#t=${this.bench.afternoon.script.now / SECOND}`);
    if (this.playing && this.tour.turn + 1 === this.tour.length && this.tour.part === 1) this.go({ value: 1 });
    this.#buttons();
    this.#wake();
  }

  /** Take the switches, where one left them if one had, or go back to the story. */
  take() {
    const { bench, own, place, tour } = this;
    if (this.live) return this.go({ value: tour.turn });
    bench.afternoon.playing = this.playing;
    bench.touch(() => {});
    bench.switches.card.end();
    this.live = true;
    if (own) {
      bench.adopt(own);
      this.typed = Infinity; // on paper of its own
    }
    const { punch, reader } = bench.machine.teletype;
    reader.lever(false); // else the visitor's program would read the story's tape
    punch.on = true;
    this.guide.begin(bench.machine);
    this.hands = new Hands(place.querySelector(".hand"));
    this.#buttons();
    this.show();
    (this.hands.buttons.find(({ ariaCurrent }) => ariaCurrent === "step") ?? this.hands.buttons[0]).focus({ preventScroll: true });
    return undefined;
  }

  /** A key was pressed: it is answered by what it did. */
  answer(/** @type {string} */ key) {
    if (this.live) this.guide.answer(key, this.bench.machine);
  }

  /** Say what was done and what comes next, and mark what is to be touched. */
  #guide() {
    const { bench, bench: { machine, writer }, guide, hands, place } = this;
    const { say, key, switches } = this.step = guide.next(machine);
    const { did, seen } = guide, { made, run, sr, waits } = /** @type {Look} */ (seen);
    writer.text(place.querySelector(".did"), did);
    writer.text(place.querySelector(".lamps"), run ? "running" : inWords(machine));
    this.#tell(say);
    hands.due(key, switches < 0 ? 0 : switches ^ sr);
    if (say !== this.asked) {
      place.querySelector(".told").scrollTop = 0;
      hands.seek();
    }
    this.asked = say;
    const begins = waits && !this.waits;
    if (begins || !waits) this.typing = waits;
    this.waits = waits;
    const shown = `${waits} ${Boolean(made)} ${this.typing}`;
    if (shown === this.choice) return;
    this.choice = shown;
    find("help").hidden = waits;
    find("mine").parentElement.hidden = find("turn").hidden = !waits;
    find("see").hidden = !made;
    find("turn").textContent = this.typing ? "To the panel" : "To the punch";
    hands.place.hidden = this.typing;
    this.#measure();
    if (!begins) return;
    find("mine").focus({ preventScroll: true });
    if (made) return;
    this.#paper(machine.teletype.printer.frames.length); // what comes is only of the visitor
    find("mine").value = this.mine = "";
    if (guide.start) bench.teletype.tear({ value: "teletype" });
  }

  /** Look from the punch at the panel, or back. */
  turn() {
    this.typing = !this.typing;
    this.#guide();
  }

  /** Do for the visitor what comes next: set the switches, and press the key. */
  help() {
    const { bench, step: { switches } } = this;
    if (switches >= 0) bench.touch(({ panel }) => (panel.sr = switches));
    bench.switches.press(this.step.key);
  }

  /** The keyboard presses what is added to the field. */
  type(/** @type {HTMLInputElement} */ { value }) {
    const { bench, mine } = this;
    this.mine = value;
    if (value.startsWith(mine)) bench.touch(({ teletype: { keyboard } }) => keyboard.press(sent(value.slice(mine.length).toUpperCase())));
  }

  /** Show the visitor's tape, as a picture to keep. */
  async see() {
    const { frames, made } = /** @type {Look} */ (this.guide.seen);
    if (!made) return;
    const picture = await keepsake(frames, made).convertToBlob();
    const box = find("tape"), link = box.querySelector("a"), image = box.querySelector("img");
    if (link.href) URL.revokeObjectURL(link.href);
    image.src = link.href = URL.createObjectURL(picture);
    image.alt = `A paper tape with ${counted(frames.length, "rows")} of holes: ${made}`;
    link.download = `${made.replace(/\W+/g, "-") || "tape"}.png`;
    box.showModal();
  }

  about() {
    find("truth").showModal();
  }

  /** Show the lamps in words, or leave them to who listens. */
  speak(/** @type {HTMLButtonElement} */ button) {
    button.ariaPressed = String(!this.place.classList.toggle("wordless"));
    this.#measure();
  }

  /** There are no switches to be pressed any more. */
  #letGo() {
    if (this.live) [this.own, this.typed] = [this.bench.machine, Infinity];
    this.live = this.typing = this.waits = false;
    this.choice = "";
    this.hands?.place.replaceChildren();
    for (const name of [".did", ".lamps"]) this.bench.writer.text(this.place.querySelector(name), "");
    this.shown = null;
  }

  /** Go to the desk, where a first program is written and runs. */
  program() {
    this.#letGo();
    this.own ??= new Machine(one_of_each()); // with a page of its own
    this.leave();
    this.bench.first();
  }

  /** Go to the desk, where the machine is as it was, if somebody had worked at it; else as it is in the room. */
  leave() {
    this.place.hidden = true;
    this.playing = false;
    if (!this.live && this.own) this.bench.afternoon.release(this.own);
    this.#letGo();
    this.own = null; // it is the page's
    this.bench.sound.hum(0, 0);
    if (/^(#t=.*)?$/.test(location.hash)) readdress(DESK, true);
    this.bench.show();
    this.bench.time.focus();
  }

  #key(/** @type {KeyboardEvent} */ event) {
    const { key } = event;
    if (!this.open || event.defaultPrevented || event.target?.matches("input") || this.place.querySelector("dialog[open]")) return;
    const act = { "[": -1, "]": 1 }[key], altGr = event.altKey && !event.metaKey;
    if ((modified(event) && !(act && altGr)) || (key === " " && event.target?.matches("button"))) return;
    const control = keyed(this.place.querySelector(".told"), event);
    if (act) this.go({ value: Math.max(0, Math.min(this.tour.length - 1, this.tour.turn + act)) });
    else if (control?.checkVisibility()) control.click();
    else return;
    event.preventDefault();
  }

  /** The page's clock has run the machine, which is the visitor's: keep what its lamps showed. */
  show(samples = /** @type {Lamps[] | undefined} */ (undefined)) {
    if (!this.open) return;
    this.samples = samples ?? [this.bench.machine.panel.lamps];
    if (this.live) this.#guide();
    this.#wake();
  }

  #buttons() {
    this.place.querySelector(".yours").hidden = find("speak").hidden = !this.live;
    find("write").hidden = this.live;
    find("pause").hidden = this.live || this.still;
    find("pause").textContent = this.playing ? "Pause" : "Play";
    find("take").textContent = this.live ? "Back to the story" : this.own ? "Go on at the switches" : "Take the switches";
    this.#measure();
  }

  /** Tell what the act is about, or other words. */
  #tell(words = this.story[this.tour.turn][1]) {
    this.told = this.tour.turn;
    this.bench.writer.text(this.place.querySelector(".story"), words);
    this.chapters.forEach((button, index) => {
      button.style.setProperty("--done", String(Number(index < this.told - 1)));
      button.toggleAttribute("aria-current", index === this.told - 1);
    });
  }

  // --- time

  #pass(/** @type {number} */ seconds) {
    if (this.live || !this.playing) return;
    const { tour, bench: { afternoon } } = this;
    this.playing = tour.pass(seconds);
    if (!this.playing) this.#buttons();
    if (this.told !== tour.turn) {
      this.#tell();
      afternoon.lead(tour.tick);
    }
    this.since += seconds;
    const ticks = tour.tick - afternoon.script.now;
    const speed = ticks / SECOND / this.since;
    if (ticks > 0 && this.since > (speed > HURRY ? HURRIED : EACH)) this.#step(ticks, speed);
  }

  /** Let so many ticks pass, with some looks at the lamps; at a pace that can be heard, from event to event. */
  #step(/** @type {number} */ ticks, /** @type {number} */ speed) {
    const { script } = this.bench.afternoon;
    const from = script.now;
    const heard = speed <= HURRY;
    this.later = (/** @type {number} */ tick) => (tick - from) / SECOND / speed;
    this.samples = Array.from({ length: heard ? LOOKS : 2 }, (_, look, all = heard ? LOOKS : 2) => {
      const until = Math.floor(from + (ticks * (look + (look + 1 < all ? Math.random() : 1))) / all);
      while (heard && script.machine.bus.next_event(script.now) < until) {
        script.to(script.machine.bus.next_event(script.now));
        this.#hear(script.now);
      }
      script.to(until);
      this.#hear(script.now);
      return script.machine.panel.lamps;
    });
    this.speed = speed;
    this.since = 0;
  }

  /** Sound for what has happened by a tick. */
  #hear(/** @type {number} */ tick) {
    const { bench: { afternoon, sound } } = this;
    const { teletype: { punch, reader } } = afternoon.script.machine;
    const now = { punch: this.printing ? Math.floor(tick / FRAME) : punch.frames.length, read: reader.position, key: afternoon.script.done };
    for (const [kind, count] of Object.entries(now)) if (this.heard && count > this.heard[kind]) sound.strike(kind, this.later?.(tick) ?? 0);
    this.heard = now;
    this.#type(tick);
  }

  /** Whether the terminal in Toronto types. */
  get printing() {
    return !this.live && this.bench.afternoon.script.act.kind === Kind.TERMINAL;
  }

  /** Put in paper on which nothing is typed, where so many frames have been printed. */
  #paper(/** @type {number} */ count) {
    this.page.clear();
    this.typed = count;
    this.first = this.printing;
  }

  /** Type what has been printed. */
  #type(/** @type {number} */ tick) {
    const { bench: { afternoon, machine, sound }, moved, page, printing } = this;
    const { day } = afternoon.script;
    const frames = printing ? /** @type {Bytes} */ (day.tapes.get(`${day.part}.asc`)) : machine.teletype.printer.frames;
    const count = printing ? Math.floor(afternoon.script.now / FRAME) : frames.length;
    if (count < this.typed || printing !== this.first) this.#paper(printing ? 0 : Math.max(0, count - 2500));
    for (; this.typed < count; this.typed++) {
      const character = page.take(frames[this.typed]);
      const kind = character === "\x07" ? "bell" : character === "\n" ? "feed" : character > " " ? "print" : "";
      if (kind) sound.strike(kind, this.later?.(tick) ?? 0);
      if (kind === "feed") moved.fed = 1;
      if (kind === "print") moved.struck = 1;
    }
  }

  // --- a picture

  #resize() {
    if (!this.open) return;
    const { clientWidth: width } = this.place;
    const ratio = Math.min(window.devicePixelRatio || 1, width > 2600 ? 1 : width < 700 ? 1.6 : 2);
    this.scene.fine = ratio;
    this.coarse = false;
    this.fine = width * ratio > 1200 ? 1800 : 1000; // pixels of the picture of the plate
    this.camera.eye = LATER;
    this.#measure();
  }

  /** The frame in which things are seen: between the time of day and what is told, or beside that. Where the switches would be
   *  too small for a finger they are larger than the window, which scrolls then.
   */
  #measure() {
    const { live, place, scene, typing } = this;
    const { clientWidth: width, clientHeight: height } = place;
    if (!this.open || !scene.fine || !height) return; // nothing is seen of it on paper
    this.tall = width < height;
    place.classList.toggle("taken", live);
    const told = place.querySelector(".told").getBoundingClientRect();
    const beside = told.left > 0;
    const top = place.querySelector(".when").getBoundingClientRect().bottom;
    const [w, bottom] = beside ? [told.left, height] : [width, told.top];
    const form = live && !typing ? formed({ w, h: bottom - top }) : WHOLE;
    this.form = form;
    this.frame = { left: 0, top, w, h: Math.max(bottom - top, live && !typing ? least(form, w) : 0) };
    const all = Math.max(height, Math.ceil(top + this.frame.h + height - bottom));
    place.querySelector("canvas").style.height = `${all}px`;
    place.style.scrollPadding = `${top}px 0 ${height - bottom}px`;
    scene.resize(width, all, scene.fine, 1);
    this.#wake();
  }

  #wake() {
    if (this.awake || !this.open || document.hidden) return;
    this.awake = true;
    this.before = performance.now();
    requestAnimationFrame((now) => this.#picture(now));
  }

  #picture(/** @type {number} */ now) {
    this.awake = false;
    if (!this.open || !this.frame) return;
    const seconds = Math.min(0.1, Math.max(0, now - this.before) / 1000);
    this.#pass(seconds);
    this.#hurry(seconds);
    this.#type(this.bench.afternoon.script.now);
    const { form, tall } = this;
    const box = this.typing ? atTheTape(tall) : form !== WHOLE ? { x: 0, y: 0, w: form.w, h: form.h } : this.live ? atThePanel(tall) : this.tour.box(tall);
    this.camera.look(box, this.frame, this.still || this.formed !== form);
    this.formed = form;
    this.camera.glide(seconds);
    const goes = this.#draw(seconds, form) || this.playing || this.camera.moves;
    this.said += seconds;
    if (!goes || this.said > SAID) this.#say();
    if (!goes) return;
    this.awake = true;
    this.before = now;
    requestAnimationFrame((next) => this.#picture(next));
  }

  /** In a hurry pictures that come too slowly have fewer pixels, until there is none. */
  #hurry(/** @type {number} */ seconds) {
    this.took += (seconds - this.took) * 0.15;
    const coarse = this.playing && !this.live && this.speed > HURRY && (this.coarse || this.took > SLOW);
    if (coarse === this.coarse) return;
    this.coarse = coarse;
    const { fine, height, width } = this.scene;
    this.scene.resize(width, height, fine, coarse ? Math.min(1, Math.max(COARSE, LEAST / fine)) : 1);
  }

  /** Draw the room; return whether something in it still moves of itself. */
  #draw(/** @type {number} */ seconds, /** @type {any} */ shown) {
    const { bench: { afternoon, machine }, filaments, moved } = this;
    filaments.follow(this.samples ?? [machine.panel.lamps], this.still ? 0 : Math.exp(-seconds / FILAMENT), machine.panel.ema);
    moved.struck *= Math.exp(-seconds / 0.03);
    moved.fed *= Math.exp(-seconds / 0.04);
    const live = {
      panel: (/** @type {Canvas} */ c) => drawLamps(c, filaments.lit, machine.processor, this.live ? null : afternoon.pressed),
      teletype: (/** @type {Canvas} */ c) => this.#teletype(c, seconds),
      mill: (/** @type {Canvas} */ c) => this.#mill(c, seconds),
    };
    const where = shown === WHOLE ? places(this.tall) : { panel: { x: 0, y: 0 } };
    const lit = (/** @type {string} */ name) => (this.live ? name !== "mill" : this.tour.lights(name));
    this.cuts = false;
    const changes = this.scene.draw(this.camera, where, live, lit, seconds, shown);
    this.bench.sound.hum(Number(this.playing), Number(this.playing && this.cuts));
    if (this.live) this.#overlay(where.panel, shown);
    return changes || moved.struck > 0.01 || moved.fed > 0.01 || filaments.moves || this.glides;
  }

  /** Lay the buttons over the panel that is drawn. */
  #overlay(/** @type {Place} */ { x, y }, /** @type {any} */ shown) {
    const { camera: { origin, scale }, hands } = this;
    const other = this.shown !== shown;
    if (other) hands.lay(shown);
    this.shown = shown;
    Object.assign(hands.place.style, { left: `${origin.x + x * scale}px`, top: `${origin.y + y * scale}px`, width: `${shown.w * scale}px`, height: `${shown.h * scale}px` });
    hands.mark(this.bench.machine.processor);
    if (other) hands.seek();
  }

  #say() {
    const { bench: { afternoon, writer }, live, place, playing, speed, tour } = this;
    this.said = 0;
    if (!live) this.chapters[tour.turn - 1]?.style.setProperty("--done", tour.part.toFixed(3));
    const [time, pace] = place.querySelector(".when").children;
    writer.text(time, clock(live ? this.bench.machine.processor.clock : afternoon.script.now));
    const times = speed > 30 ? Math.round(speed / 10) * 10 : Math.round(speed);
    writer.text(pace, live ? "yours now" : !playing ? "stands still" : speed < 1.6 ? "at the pace of 1971" : `${grouped(times)} times as fast`);
  }

  #teletype(/** @type {Canvas} */ c, /** @type {number} */ seconds) {
    const { bench: { afternoon, machine: { teletype: { punch, reader } } }, moved, page, printing } = this;
    page.draw(c, moved.struck, moved.fed);
    const { day, now } = afternoon.script;
    const terminal = printing && day.tapes.get(`${day.part}.asc`);
    const count = terminal ? Math.floor(now / FRAME) : punch.frames.length;
    this.glides = false;
    this.#tape(c, "punch", terminal || punch.frames, count - 1, count, terminal ? ASCII : this.typing ? ASCII : this.live ? codeOf(punch.frames) : EIA, seconds);
    if (reader.loaded && !terminal) this.#tape(c, "reader", reader.tape, reader.position - 1, reader.tape.length, codeFor(reader.tape), seconds);
    drawHeads(c, reader.on && !terminal);
  }

  #tape(/** @type {Canvas} */ c, /** @type {"reader" | "punch"} */ which, /** @type {ArrayLike<number>} */ frames, /** @type {number} */ head, /** @type {number} */ last, /** @type {Code} */ code, /** @type {number} */ seconds) {
    const gone = head - this.at[which];
    this.at[which] += Math.abs(gone) > 400 || this.still ? gone : gone * (1 - Math.exp(-seconds / 0.022));
    if (Math.abs(head - this.at[which]) < 0.01) this.at[which] = head;
    if (this.at[which] !== head) this.glides = true;
    drawTape(c, TAPES[which], { frames, code, at: this.at[which], last });
    if (Math.abs(gone) < 4 && frames[head] !== undefined) drawSign(c, TAPES[which], frames[head], code);
  }

  /** What is milled, when it is seen first. */
  #work() {
    const { afternoon: { script: { day: { path } } }, record: { afternoon: { wall }, cutter: diameter } } = this.bench;
    const within = bounds(path, diameter);
    return { diameter, fit: fitted(within), path, wall: wall && new Wall(wall, path.knots, diameter, within, this.fine > 1000 ? 2.6 : 1.5), within };
  }

  #mill(/** @type {Canvas} */ c, /** @type {number} */ seconds) {
    this.work ??= this.#work();
    const { moved, tour, work: { diameter, fit, path, wall, within } } = this;
    const { day: { mill_starts: starts }, now } = this.bench.afternoon.script;
    const second = (now - starts) / SECOND;
    const place = second >= 0 ? path.at(Math.min(second, path.times.total)) : path.first;
    this.cuts = Boolean(second >= 0 && place.down && this.cutter && Math.hypot(place.x - this.cutter.x, place.y - this.cutter.y) > 0);
    this.cutter = place;
    if (this.cuts) moved.turns += seconds * 5;
    const measured = !this.live && tour.turn + 1 === tour.length;
    const close = measured && wall ? wall.closeness(tour.part) : 0;
    const { above } = tour;
    const tilt = TILT + (1 - TILT) * above;
    const middle = { x: (within.left + within.right) / 2, y: (within.bottom + within.top) / 2 };
    const aim = !measured ? place : wall ? wall.between(middle, close, fit) : middle;
    c.save();
    c.beginPath();
    c.roundRect(0, 0, 19, 12, 0.3);
    c.clip();
    c.save();
    lay(c, measured && wall ? fit * wall.larger(close, fit) : fit, aim, tilt);
    drawTable(c, within, above);
    this.#plate(second >= 0 ? place : null, above < 0.5).draw(c, aim);
    if (close > 0) wall.draw(c, close);
    const { band, part } = this.bench.record.afternoon;
    c.globalAlpha = Math.max(0, 1 - close * 4);
    if (measured && band) drawMeasured(c, band.nominal, part);
    c.restore();
    if (!measured && above > 0.5) drawCutter(c, (diameter / 2) * fit, place.down && second >= 0, moved.turns);
    if (above < 1) drawSpindle(c, (diameter / 2) * fit, place.down && second >= 0, moved.turns, above * above * 9);
    drawDusk(c);
    c.restore();
    if (close > 0) wall.label(c, close);
  }

  /** The plate, as it has been milled: seen from before, or from above. */
  #plate(/** @type {PathPlace | null} */ place, /** @type {boolean} */ before) {
    const { diameter, path: { knots }, within } = this.work;
    if (this.milled?.before !== before) this.milled = new Plate(knots, diameter, within, this.fine, before);
    if (place) this.milled.to(place);
    return this.milled;
  }
}
