/* global Event, URL, dispatchEvent, history, localStorage, location, sessionStorage */
// A page on the small document, led by lines of JSON (small.py): the first says which, each other one has an answer.

import { createInterface } from "node:readline";
import { readFileSync } from "node:fs";
const asked = createInterface({ input: process.stdin })[Symbol.asyncIterator]();
const given = JSON.parse((await asked.next()).value);
globalThis.location = new URL(given.address); // what is asked for behind ? is looked at once
await import(`./pdp8/web/${given.entry === "curve" ? "curve" : "bench/desk"}.mjs?worker`); // without a document it serves
const work = globalThis.onmessage;
const dom = await import("./dom.mjs");
dom.open(readFileSync(given.file, "utf8"), given.address, { ...given, work });
process.on("unhandledRejection", (reason) => dom.complaints.push(reason));
for (const script of given.scripts) (0, eval)(script);
if (given.entry === "workbench") await import("./pdp8/web/bench/desk.mjs"); // loaded while the room plays, it would take its own time
await import(`./pdp8/web/${given.entry}.mjs`);
globalThis.dom = dom;
globalThis.walk = await import("./walk.mjs");
let owned = "";
const mine = () => {
  const now = JSON.stringify(sessionStorage);
  return now === owned ? undefined : JSON.parse(owned = now);
};
let before = { ...given.kept };
const changes = () => {
  const now = { ...localStorage }, keys = Object.keys({ ...before, ...now }).filter((key) => before[key] !== now[key]);
  before = now;
  return keys.map((key) => [key, now[key] ?? null]);
};
const plain = (of) => JSON.stringify(of, (_, each) => (each === Infinity ? "Infinity" : ArrayBuffer.isView(each) ? [...each] : each));
for await (const line of asked) {
  const { pass, code, more, another } = JSON.parse(line);
  let value, error;
  try {
    if (another) {
      for (const store of [localStorage, before]) for (const [key, text] of another) if (text === null) delete store[key]; else store[key] = text;
      for (const [key] of another) dispatchEvent(new Event("storage", { key }));
    } else if (pass !== undefined) await dom.pass(pass);
    else {
      value = (0, eval)(code);
      if (typeof value === "function") value = value(more);
      if (value?.then) {
        let done = false;
        value = value.finally(() => (done = true));
        value.catch(() => undefined);
        await dom.settle();
        for (let times = 0; !done && times < 2000; times++) await dom.pass(20);
        value = await value;
      } else await dom.settle();
    }
  } catch (thrown) { error = String(thrown?.stack ?? thrown); }
  process.stdout.write(plain({ value, error, changes: changes(), own: mine(), address: location.href, state: history.state, reloaded: location.reloaded, complaints: dom.complaints.splice(0).map((each) => String(each?.stack ?? each)) }) + "\n");
}
