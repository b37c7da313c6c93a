/* global document, window, workbench */
// What the desk shows and is not so, once nothing moves: [[what, as it is shown, as it is], ...] (model.py). What is drawn is
// drawn again. In the room the story has its own machine.

const shade = { addColorStop() {} }, pictures = new Map([[shade, "shade"]]);
const named = (of) => (of === null || typeof of !== "object" ? of : pictures.set(of, pictures.get(of) ?? pictures.size).get(of));
/** A canvas that notes what is done to it. */
const noting = (lines) => new Proxy({}, {
  get: (_, name) => (name === "getTransform" ? () => ({ a: 1 }) : (...given) => (lines.push([String(name), ...given.map(named)].join(" ")), shade)),
  set: (_, name, value) => lines.push(`${String(name)} ${named(value)}`) > 0,
});
for (const { prototype, prototype: { show } } of [workbench.mill.whole, workbench.mill.plate].map((each) => each.constructor)) {
  prototype.show = function noted(draw) {
    const lines = [];
    this.element.getContext = () => noting(lines);
    show.call(this, draw);
    this.lines = [...lines, this.element.innerHTML];
  };
}
const redrawn = (drawing) => {
  const { element, lines } = drawing;
  if (!lines || !element.checkVisibility({ visibilityProperty: true })) return false;
  drawing.redraw();
  return String(drawing.lines) !== String(lines);
};

window.stale = () => {
  const { afternoon, clock, editor, exercises, mill, programs, room, shelf, sound, switches: { card, panel }, tabs, teletype, until, machine, machine: { link, ac, processor, watch, highspeed: fast } } = workbench;
  if (room.open) return room.live || (afternoon.on && machine === afternoon.script.machine) ? [] : [["room", "the story's", "another machine"]];
  const { printer, punch, reader } = machine.teletype, at = (id) => document.getElementById(id);
  if (clock.pictures.running) return [];
  const all = (selector) => [...document.querySelectorAll(selector)], text = (selector) => document.querySelector(selector).textContent;
  const octal = (word) => word.toString(8).padStart(4, "0"), count = (number) => number.toLocaleString("en").replaceAll(",", "\u202f"), counted = ({ length }) => (length === 1 ? "1 frame" : `${length ? count(length) : "no"} frames`);
  const paper = new teletype.paper.constructor(400);
  for (const frame of printer.frames) paper.take(frame);
  const tape = teletype.terminal ?? punch, here = (value) => watch.breakpoints.has(Number(value));
  const pairs = {
    paper: teletype.terminal ? [] : [text("#paper pre"), paper.lines.join("\n")],
    goes: [text("#play"), afternoon.on ? "Play" : processor.run ? "Stop" : "Run"],
    lever: [text("#lever"), `Lever to ${reader.on ? "STOP" : "START"}`],
    punch: [text("#punch-on"), `Turn punch ${punch.on ? "OFF" : "ON"}`],
    reader: [text("#reader .name"), reader.loaded ? `${teletype.called()} ${count(reader.position)} of ${count(reader.tape.length)}`.trim() : "no tape"],
    punched: [text("#punch .name"), counted(tape.frames)],
    fast: [text("#pc8-punch"), `${counted(fast.punch.frames)} punched`],
    tear: [["tear", "store", "to-mill", "pc8-tear"].map((id) => at(id).disabled), [punch, punch, punch, fast.punch].map(({ frames }) => !frames.length)],
    load: [["load", "boot"].map((id) => at(id).disabled), Array(2).fill(!editor.assembly.words.length)],
    cut: at("part-cut").disabled ? [] : [punch.frames.length > 0, true],
    goal: [until._places?.has(until.address) ?? true, true], over: processor.run ? [] : [until.constructor.name, "Goal"],
    laid: [["program-name", "delete-program"].map((id) => at(id).disabled), Array(2).fill(editor.area.readOnly)],
    sound: [[at("sound").checked, at("hear").ariaPressed, at("hear").textContent], [sound.on, sound.on, `Sound ${sound.on ? "on" : "off"}`]],
    drawn: [[...(afternoon.on ? [panel.canvas] : []), ...Object.values(teletype.sheets), mill.whole, mill.close, mill.reader].map(redrawn).indexOf(true), -1],
    mill: [["run-mill", "save-cut"].map((id) => at(id).disabled), [!mill.drawing, !mill.tape]],
    switches: [all("#computer .rocker").map((each) => Number(each.ariaChecked === "true")), [...Array(12).keys()].map((bit) => (processor.sr >> (11 - bit)) & 1)],
    lamps: [panel.filaments.lit.get("ac").map(Math.round), [...Array(12).keys()].map((bit) => (ac >> (11 - bit)) & 1)],
    registers: [all("#registers input").map((each) => each.value), [link, ...[ac, processor.pc].map(octal)].map(String)],
    core: at("debugger").hidden ? [] : [all("#core td input").map((each) => each.value), [...processor.core.slice(workbench.core.first, workbench.core.first + 128)].map(octal)],
    breakpoints: [all("#gutter button").filter((each) => (each.ariaPressed === "true") !== here(each.value)).length, 0],
    lines: [["#gutter", "#blocks", "#card"].filter((id) => all(`${id} .now`).length > 1 || all(`${id} [aria-current]`).length > 1), []],
    slider: afternoon.on ? [at("slider").getAttribute("aria-valuetext"), `${text("#clock")}, ${afternoon.script.act.name}`] : [],
    card: [at("drill").ariaPressed, Boolean(card.coach)],
    counts: [at("counts").checked, watch.observer === editor.counts],
    slid: [mill.drawing && Number(at("at").value).toFixed(9), mill.drawing && Math.max(0, mill.part).toFixed(9)],
    exercise: [at("exercise").value, exercises.name],
    lists: [all("#shelf option").slice(1).map((each) => each.value), shelf.names().filter((each) => !each.endsWith(".pal"))],
    programs: [all("#sources optgroup[label=Yours] option").map((each) => each.value), programs.names()],
    panes: [all("[data-tab]").filter((each) => !each.hidden).map(({ id }) => id), tabs.kept === "exercises" && !exercises.sheet ? ["program", "exercises"] : [tabs.kept]],
    tabs: [all("[role=tab]").filter((each) => each.ariaSelected === "true").length, 1],
    units: [workbench.time.unit, document.querySelector("#units :checked").value],
    speed: [String(clock.speed), at("speed").value],
  };
  return Object.entries(pairs).filter(([, [seen, is]]) => String(seen) !== String(is)).map(([name, pair]) => [name, ...pair]);
};
