// The desk: its panes, and what the page's Workers do. It is a script of its own, for the room moves before there is a desk.

import { loosened } from "../loosened.mjs";
import { checked } from "../findings.mjs";
import { ours, put } from "../html.mjs";
import { find } from "../written.mjs";
import { embed } from "./alone.mjs";
import { Apart, serve } from "./apart.mjs";
import { booted } from "./boot.mjs";
import { Core } from "./core.mjs";
import { Drives } from "./drives.mjs";
import { Editor } from "./editor.mjs";
import { Exercises } from "./exercises.mjs";
import { located, marks } from "./marker.mjs";
import { Mill } from "./mill.mjs";
import { Parts, printout, translated } from "./parts.mjs";
import { Registers } from "./registers.mjs";
import { Session } from "./session.mjs";
import { Store } from "./store.mjs";
import { Switches } from "./switches.mjs";
import { Tabs } from "./tabs.mjs";
import { Teletype } from "./teletype.mjs";
import { Time } from "./time.mjs";
import { rove } from "./wiring.mjs";

const PANES = { switches: Switches, teletype: Teletype, drives: Drives, registers: Registers, core: Core, mill: Mill, editor: Editor, exercises: Exercises, parts: Parts, time: Time };

/** Lay the desk, piece by piece. */
export function* lay(/** @type {Bench} */ bench) {
  bench.apart = new Apart();
  bench.programs = new Store("program", (name) => bench.editor.elsewhere(name));
  bench.tabs = new Tabs(bench);
  bench.shelf.offer();
  for (const [name, Pane] of Object.entries(PANES)) {
    yield;
    /** @type {any} */ (bench)[name] = new Pane(bench);
  }
  yield;
  put(find("figures").querySelector("table"), ours(bench.record.figures));
  put(find("graph"), ours(bench.record.graph));
  embed(bench.tabs);
  for (const row of document.querySelectorAll("[role=toolbar], [role=tablist]")) rove(/** @type {HTMLElement} */ (row));
  const { exercises, parts, shelf, switches: { card }, tabs, time } = bench;
  bench.session = new Session(bench, { shelf, machine: bench, card, exercises, parts, tabs, time });
  bench.panes = [bench.afternoon, ...Object.keys(PANES).map((name) => /** @type {any} */ (bench)[name]), bench.room];
}

if (!globalThis.document) serve({ booted, checked, located, loosened, marks, printout, translated });
