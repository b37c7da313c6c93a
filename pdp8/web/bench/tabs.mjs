// The tabs of the desk: one pane at a time, by mouse and by arrow keys.

export class Tabs {
  constructor() {
    this.list = document.querySelector("[role=tablist]");
    this.panes = new Map([...document.querySelectorAll("[data-tab]")].map((pane) => [pane.id, pane]));
    this.changed = () => {};
    const tabs = [...this.panes].map(([id, { dataset: { tab } }]) => `<button role="tab" data-opens="${id}" aria-controls="${id}">${tab}</button>`);
    this.list.innerHTML = tabs.join("");
    this.list.addEventListener("click", ({ target }) => {
      const tab = target.closest("[role=tab]");
      if (tab) this.open(tab.dataset.opens);
    });
    this.list.addEventListener("keydown", (event) => this.#key(event));
    this.open(this.panes.keys().next().value);
  }

  has(id) {
    return this.panes.has(id);
  }

  /** Show these panes alone, and of the tabs theirs. */
  only(ids) {
    const tabs = [...this.list.children];
    for (const tab of tabs) tab.hidden = !ids.includes(tab.dataset.opens);
    const shown = tabs.filter((tab) => !tab.hidden);
    this.list.hidden = shown.length < 2;
    this.list.parentElement.hidden = !shown.length;
    if (shown.length) this.open(shown[0].dataset.opens);
  }

  open(opened) {
    if (this.list.parentElement.hidden) return;
    for (const [id, pane] of this.panes) pane.hidden = id !== opened;
    for (const tab of this.list.children) {
      const chosen = tab.dataset.opens === opened;
      tab.ariaSelected = String(chosen);
      tab.tabIndex = chosen ? 0 : -1;
    }
    this.changed();
  }

  #key(event) {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    const tabs = [...this.list.children];
    const next = tabs[(tabs.indexOf(event.target) + step + tabs.length) % tabs.length];
    this.open(next.dataset.opens);
    next.focus();
  }
}
