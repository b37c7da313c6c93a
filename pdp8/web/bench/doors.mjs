// Three doors: where a visitor begins. On the first visit each says what is behind it.

import { find } from "../written.mjs";
import { keep, kept } from "./kept.mjs";

const SEEN = "pdp8 seen";

export class Doors {
  constructor(bench) {
    this.doors = {
      afternoon: () => bench.afternoon.watch(),
      first: () => this.#first(bench),
      rim: () => bench.switches.card.practise(),
    };
    find("doors").classList.toggle("wide", !kept(SEEN));
    find("doors").addEventListener("click", ({ target }) => {
      const door = target.closest("[data-door]");
      if (!door) return;
      find("play").focus({ preventScroll: true }); // or space opens the door again
      this.open(door.dataset.door);
    });
  }

  open(name) {
    this.close();
    this.doors[name]();
  }

  /** The visitor is in: the doors need no more words. */
  close() {
    keep(SEEN, "yes");
    find("doors").classList.remove("wide");
  }

  /** Assemble, load and start hello.pal. */
  #first(bench) {
    bench.tabs.open("program");
    bench.editor.open("hello.pal", bench.shelf.get("hello.pal").frames);
    bench.editor.run();
    find("teletype").scrollIntoView({ block: "nearest" });
  }
}
