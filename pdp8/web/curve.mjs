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
import { find } from "./written.mjs";

async function start() {
  const record = await pack.record;
  const figures = { near: near(), one: one(), piecewise: piecewise(record), stepwise: stepwise(), curved: curved(), costs: costs() };
  Object.assign(figures, { whole: whole(find("cut")), holes: holes(), computer: computer(record), roundness: roundness() });
  window.curve = { figures: Object.assign(figures, { own: own(record, find("save"), find("open")) }) };
}

if (globalThis.document) start();
else serve(WORK);
