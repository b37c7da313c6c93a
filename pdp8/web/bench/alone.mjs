// Some panes alone: for a frame in another page, by ?embed=PANE,PANE; one for a projector, by the button in its corner.
// And a screen that nobody attends: with ?rest=SECONDS the page begins afresh when it was not touched for so long.

/** The seconds after which it begins afresh; 0 where somebody attends. Nothing is kept from one visitor to the next. */
export const RESTS = Math.max(0, Number(new URLSearchParams(globalThis.location?.search).get("rest"))) || 0;

const CORNER = `<svg viewBox="0 0 20 20" aria-hidden="true"><path d="M3 3h6v2H5v4H3zM11 15h4v-4h2v6h-6z"/></svg>`;

/** Show the panes that the address asks for, with the time bar; all, where it asks for none that is there. */
export function embed(tabs) {
  const asked = (new URLSearchParams(location.search).get("embed") ?? "").split(",");
  const sections = [...document.querySelectorAll("[data-pane]")];
  const shown = sections.filter((section) => asked.includes(section.dataset.pane));
  if (!shown.length) return;
  document.body.classList.add("embed");
  for (const section of sections) section.classList.toggle("out", !shown.includes(section));
  tabs.only(shown.map(({ id }) => id));
}

/** Give the large panes a button that shows one alone, as large as the page, and all again. */
export function enlargeable() {
  for (const pane of document.querySelectorAll("#computer, #desk, #teletype")) {
    const button = `<button class="enlarge" data-click="enlarge" aria-label="${pane.ariaLabel}: alone" aria-pressed="false" title="This alone, or all">${CORNER}</button>`;
    pane.insertAdjacentHTML("beforeend", button);
  }
}

export function rest() {
  const { href } = location; // without the instant that the afternoon will write there
  let timer;
  const touched = () => {
    clearTimeout(timer);
    timer = setTimeout(() => {
      history.replaceState(null, "", href);
      location.reload();
    }, 1000 * RESTS);
  };
  for (const kind of ["pointerdown", "pointermove", "wheel", "keydown"]) addEventListener(kind, touched, true);
  touched();
}
