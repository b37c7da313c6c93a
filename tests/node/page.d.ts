// Types for tsc that the page's modules share. Which kind of element a name finds only the page knows.

type Act = import("./pdp8/replay/day.mjs").Act;
type Assembly = import("./pal/assembly.mjs").Assembly;
type Bench = import("./pdp8/web/workbench.mjs").Bench;
type Bytes = import("./pdp8/web/translator/runtime.mjs").Bytes;
type Code = import("./tapes/code.mjs").Code;
type Contour = ReturnType<typeof import("./pdp8/web/bench/path.mjs").contour>;
type Diagnostic = import("./pal/diagnostics.mjs").Diagnostic;
type Image = import("./tapes/dectape.mjs").Image;
type Lamps = import("./pdp8/computer/hardware/panel.mjs").Lamps;
type Coach = import("./pdp8/lessons/drill.mjs").Coach;
type Look = import("./pdp8/lessons/minute.mjs").Look;
type Machine = import("./pdp8/computer/machine.mjs").Machine;
type Path = import("./nc/path.mjs").Path;
type PathPlace = import("./nc/path.mjs").Place;
type Processor = import("./pdp8/computer/hardware/processor.mjs").Processor;
type Step = import("./nc/path.mjs").Step;
type View = import("./pdp8/web/svg.mjs").View;

type Made = ReturnType<typeof import("./pdp8/web/curve/made.mjs").plain>;
type Canvas = CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D;
type Place = { x: number; y: number };
type Knot = Place & { down?: boolean };
type Circle = Place & { radius: number };
type Box = Place & { width: number; height: number };
type Area = Place & { w: number; h: number };
type Bounds = { left: number; right: number; bottom: number; top: number };
type Band = { inner: Place[]; nominal: Place[]; outer: Place[] };
/** Where the camera looks, and how fast it glides. */
type Eye = Place & { zoom: number; [speed: string]: number };
/** How a hold of a figure is dragged: to where, how far, and what the value was. */
type Drag = Place & { dx: number; dy: number; start: number };
/** How the panel is shown, in pieces. */
type Shown = { w: number; h: number; pieces: (Area & { dx: number; dy: number })[] };
/** How bright each lamp of a field is. */
type Lit = Map<string, number[]>;
/** How far the cutter's edge is off at each station; NaN where nothing was cut. */
type Walls = { outer: Float64Array; inner: Float64Array };
/** How a Drawing or Sheet is drawn. */
type Draw = (...at: any[]) => any;
/** The panes of the desk, and what they share. */
type Desk = {
  Apart: import("./pdp8/web/bench/apart.mjs").Apart;
  Core: import("./pdp8/web/bench/core.mjs").Core;
  Drives: import("./pdp8/web/bench/drives.mjs").Drives;
  Editor: import("./pdp8/web/bench/editor.mjs").Editor;
  Exercises: import("./pdp8/web/bench/exercises.mjs").Exercises;
  Mill: import("./pdp8/web/bench/mill.mjs").Mill;
  Parts: import("./pdp8/web/bench/parts.mjs").Parts;
  Store: import("./pdp8/web/bench/store.mjs").Store;
  Session: import("./pdp8/web/bench/session.mjs").Session;
  Switches: import("./pdp8/web/bench/switches.mjs").Switches;
  Tabs: import("./pdp8/web/bench/tabs.mjs").Tabs;
  Teletype: import("./pdp8/web/bench/teletype.mjs").Teletype;
  Time: import("./pdp8/web/bench/time.mjs").Time;
};
/** What is found in a program, as the Worker sends it. */
type Findings = import("./pdp8/web/findings.mjs").Findings;
type Found = { [name in keyof Findings as Exclude<name, symbol>]: Findings[name] };
type Note = Found["diagnostics"][number];
/** A piece of paper tape: where, and the frame at the head. */
type Strip = { x: number; head: number; from: number; until: number; way?: number; lift?: number };
type TapeView = { label: string; frames: ArrayLike<number>; head: number; code: Code; punching?: boolean };
/** A part program and one of its options, as the record has them (pdp8/web/parts.py). */
type Option_ = { name: string; default: string; spelling: string; choices?: string[]; flag?: boolean; places?: boolean; required?: boolean; whole?: boolean; unit?: any };
type Part_ = { name: keyof typeof import("./pdp8/web/bench/parts.mjs").PROGRAMS; summary: string; form: string; options: Option_[]; arguments: [string, string, string[]][] };
/** The colours of a canvas, and its pixels for one of CSS. */
type Colours = { [colour: string]: any; ratio: number };

interface EventTarget {
  checked: any;
  closest: any;
  disabled: any;
  files: any;
  hidden: any;
  matches: any;
  max: any;
  name: any;
  selectedIndex: any;
  selectionEnd: any;
  selectionStart: any;
  setRangeText: any;
  setSelectionRange: any;
  type: any;
  value: any;
}

interface Element extends HTMLOrSVGElement {}

/** As `a[index]` has it. */
interface Array<T> {
  at(index: number): T;
}

interface ParentNode {
  querySelector(selectors: string): any;
}

/** start.js */
declare const pack: {
  early(): File[];
  unpacked(packed: string): Promise<string>;
  record: Promise<any>;
  later<T>(module: () => T): Promise<T>;
  more(): Promise<any>;
};

interface Window {
  curve: any;
  workbench: any;
}
