// A curve in ten minutes: the figures of the page that teaches the method, in Chapter 3's order.

import { serve } from "./bench/apart.mjs";
import { computer, holes } from "./curve/block.mjs";
import { WORK } from "./curve/made.mjs";
import { near } from "./curve/near.mjs";
import { own } from "./curve/own.mjs";
import { costs, curved } from "./curve/quarter.mjs";
import { roundness } from "./curve/roundness.mjs";
import { one, piecewise, stepwise } from "./curve/slopes.mjs";
import { whole } from "./curve/whole.mjs";

async function start() {
  const record = await pack.record;
  const figures = { near: near(), one: one(), piecewise: piecewise(record), stepwise: stepwise(), curved: curved(), costs: costs() };
  figures.whole = whole(document.getElementById("cut"));
  figures.holes = holes();
  figures.computer = computer(record);
  figures.roundness = roundness();
  figures.own = own(record, document.getElementById("save"), document.getElementById("open"));
  window.curve = { figures };
}

if (globalThis.document) start();
else serve(WORK);
