// A row of controls as one stop of the Tab key: arrows lead from one to the next.

/** Let the arrows lead through the controls of each toolbar. */
export function rove(toolbar) {
  const controls = [...toolbar.querySelectorAll("button")];
  const at = () => Math.max(0, controls.findIndex((control) => control.tabIndex === 0 && !control.disabled));
  const choose = (chosen) => controls.forEach((control, index) => (control.tabIndex = index === chosen ? 0 : -1));
  choose(0);
  toolbar.addEventListener("focusin", ({ target }) => choose(Math.max(0, controls.indexOf(target.closest("button")))));
  toolbar.addEventListener("keydown", (event) => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    for (let next = at() + step; controls[next]; next += step) {
      if (controls[next].disabled || controls[next].hidden) continue;
      controls[next].focus();
      return;
    }
  });
}
