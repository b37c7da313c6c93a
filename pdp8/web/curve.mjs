// A curve in ten minutes: the figures of the page that teaches the method, in Chapter 3's order.

import { computer, holes } from "./curve/block.mjs";
import { remembered } from "./curve/drawing.mjs";
import { near } from "./curve/near.mjs";
import { own } from "./curve/own.mjs";
import { costs, curved } from "./curve/quarter.mjs";
import { roundness } from "./curve/roundness.mjs";
import { one, piecewise, stepwise } from "./curve/slopes.mjs";
import { whole } from "./curve/whole.mjs";
import { circle } from "./method.mjs";
import { unpacked } from "./packed.mjs";

const record = await unpacked(document.getElementById("record").textContent);
const listed = remembered(() => circle(5));
const figures = { near: near(), one: one(), piecewise: piecewise(record), stepwise: stepwise(), curved: curved(), costs: costs() };
figures.whole = whole(listed, document.getElementById("cut"));
figures.holes = holes(listed);
figures.computer = computer(listed, record);
figures.roundness = roundness();
figures.own = own(record, document.getElementById("save"));
window.curve = { figures, listed };
