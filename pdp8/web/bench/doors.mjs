// Three doors: where a visitor begins. On the first visit each says what is behind it.

import { find } from "../written.mjs";
import { keep, kept } from "./store.mjs";

const SEEN = "pdp8 seen";

export class Doors {
  constructor(bench) {
    this.bench = bench;
    find("doors").classList.toggle("wide", !kept(SEEN));
  }

  open({ dataset: { door } }) {
    find("play").focus({ preventScroll: true }); // or space opens the door again
    this.close();
    const { afternoon, editor, shelf, switches, tabs } = this.bench;
    if (door === "afternoon") afternoon.watch();
    else if (door === "rim") switches.card.practise();
    else {
      tabs.open("program");
      editor.open("hello.pal", shelf.get("hello.pal").frames);
      editor.run();
      find("teletype").scrollIntoView({ block: "nearest" });
    }
  }

  /** The visitor is in: the doors need no more words. */
  close() {
    keep(SEEN, "yes");
    find("doors").classList.remove("wide");
  }
}
