// A link that holds the program and the machine: #s=...

import { packed, unpacked } from "../packed.mjs";

/** What the address holds, or null. Throws where the address is damaged. */
export async function opened() {
  const found = /^#s=([\w-]+)$/.exec(location.hash);
  return found ? unpacked(found[1]) : null;
}

/** The address of this page with `shared` in it. */
export async function address(shared) {
  const text = await packed(shared);
  return `${location.href.replace(/#.*/, "")}#s=${text.replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "")}`;
}
