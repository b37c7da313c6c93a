// Where the page is a part of something: some panes alone, in a frame of another page, by ?embed=PANE,PANE; a screen that
// nobody attends, where with ?rest=SECONDS it begins afresh when it was not touched for so long.

const LEAST = 10; // seconds: in less nobody has done anything
const MOST = 2e6; // and as many as a timer takes

const asked = new URLSearchParams(globalThis.location?.search);
const seconds = Number(asked.get("rest"));
/** The seconds after which it begins afresh; 0 where somebody attends. Nothing is kept from one visitor to the next. */
export const RESTS = seconds > 0 ? Math.min(MOST, Math.max(LEAST, seconds)) : 0;
/** The panes that it asks for, "" for all. */
export const EMBED = asked.get("embed") ?? "";

/** Show the panes that the address asks for, with the time bar; all, where it asks for none that is there. */
export function embed(/** @type {import("./tabs.mjs").Tabs} */ tabs) {
  const sections = [...document.querySelectorAll("[data-pane]")];
  const shown = sections.filter((section) => EMBED.split(",").includes(String(section.dataset.pane)));
  if (!shown.length) return;
  document.body.classList.add("embed");
  for (const section of sections) section.classList.toggle("out", !shown.includes(section));
  tabs.only(shown.map(({ id }) => id));
}

export function rest() {
  const { href } = location; // without the instant that the afternoon will write there
  let timer = 0;
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
