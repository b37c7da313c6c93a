// How the controls are worked: the method that each calls, the key that presses it, the arrows along a toolbar.
//
//     <button data-click="time.step" value="1" aria-keyshortcuts="ArrowRight">        bench.time.step(button)
//
// So do data-change, data-input and data-submit, of what is in the page now or later.

/** Let the controls of the page call the methods that they name; one that is pressed before all is there waits. */
export function wire(/** @type {Bench} */ bench) {
  for (const kind of ["click", "change", "input", "submit"]) {
    document.addEventListener(kind, (event) => {
      const control = event.target?.closest(`[data-${kind}]`);
      if (!control) return;
      if (kind === "submit") event.preventDefault();
      const names = control.dataset[kind].split(".");
      const method = names.pop();
      const call = () => names.reduce((/** @type {any} */ owner, /** @type {string} */ name) => owner[name], bench)[method](control);
      if (bench.ready) call();
      else bench.opening?.then(call);
    }, true);
  }
}

/** Let a pane that fills the page be as large as the others again, if it hides an element. */
export function uncover(/** @type {Element} */ element) {
  if (!element.checkVisibility()) document.querySelector(".alone > .enlarge")?.click();
}

/** Whether a key is pressed with another: Alt with an arrow, Ctrl with a digit are the browser's. */
export const modified = (/** @type {KeyboardEvent} */ { ctrlKey, altKey, metaKey }) => ctrlKey || altKey || metaKey;

/** The control within `place` that names the key of an event, or null. */
export function keyed(/** @type {HTMLElement} */ place, /** @type {KeyboardEvent} */ event) {
  if (modified(event)) return null;
  const { key } = event, [, latin] = /^Key(.)$/.exec(event.code) ?? [];
  const name = key === " " ? "Space" : key.length > 1 ? key : key > "~" && latin ? latin : key.toUpperCase(); // Cyrillic letters, and others, stand where Latin ones do
  return place.querySelector(`[aria-keyshortcuts~="${CSS.escape(name)}"]`);
}

/** Make a row of buttons one stop of the Tab key: arrows lead from one to the next. */
export function rove(/** @type {HTMLElement} */ row) {
  const controls = [...row.querySelectorAll("button")];
  const at = () => Math.max(0, controls.findIndex((control) => control.tabIndex === 0 && !control.disabled));
  const choose = (/** @type {number} */ chosen) => controls.forEach((control, index) => (control.tabIndex = index === chosen ? 0 : -1));
  choose(Math.max(0, controls.findIndex((control) => control.checkVisibility())));
  row.addEventListener("focusin", ({ target }) => choose(Math.max(0, controls.indexOf(target?.closest("button")))));
  row.addEventListener("keydown", (event) => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!step || modified(event)) return;
    event.preventDefault();
    for (let next = at() + step; controls[next]; next += step) {
      if (controls[next].disabled || !controls[next].checkVisibility()) continue;
      controls[next].focus();
      return;
    }
  });
}
