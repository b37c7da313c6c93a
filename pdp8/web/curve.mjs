// A curve in ten minutes: the figures of the page that teaches the method, in Chapter 3's order.

import { computer, holes } from "./curve/block.mjs";
import { near } from "./curve/near.mjs";
import { curved } from "./curve/quarter.mjs";
import { roundness } from "./curve/roundness.mjs";
import { one, piecewise, stepwise } from "./curve/slopes.mjs";
import { whole } from "./curve/whole.mjs";
import { circle } from "./method.mjs";
import { unpacked } from "./packed.mjs";

const record = await unpacked(document.getElementById("record").textContent);
const made = circle(5);
const figures = { near: near(), one: one(), piecewise: piecewise(record), stepwise: stepwise(), curved: curved() };
figures.whole = whole(made, document.getElementById("cut"));
figures.holes = holes(made);
figures.computer = computer(made, record);
figures.roundness = roundness();
window.curve = { figures, made };
