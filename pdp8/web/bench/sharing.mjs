// Links: #s= holds a program, the machine, an exercise, a part; #exercise= the name of a bundled one. A bundled tape goes by its
// name, and of the machine only what is not as at power-up. It is JSON, compressed (deflate) and in base64.

export const LONGEST = 8000; // characters of a link that mail and chat leave whole

/** What the address holds, or null. Throws where it is damaged. */
export async function opened() {
  const [, kind, text] = /^#(s|exercise)=(.*)$/.exec(location.hash) ?? [];
  if (!text) return null;
  if (text.length > 2 * LONGEST) throw new Error(`it has ${text.length} characters; ${2 * LONGEST} are allowed`);
  try {
    if (kind === "exercise") return { exercise: decodeURIComponent(text) };
    return JSON.parse(await pack.unpacked(text.replaceAll("-", "+").replaceAll("_", "/")));
  } catch (error) {
    throw new Error("it is damaged or cut short", { cause: error });
  }
}

/** The address of a page with `shared` in it. */
export async function linked(/** @type {unknown} */ shared, /** @type {string} */ page) {
  const stream = new Blob([JSON.stringify(shared)]).stream().pipeThrough(new CompressionStream("deflate-raw"));
  const data = new Uint8Array(await new Response(stream).arrayBuffer());
  const text = btoa(Array.from(data, (byte) => String.fromCharCode(byte)).join(""));
  return `${page}#s=${text.replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "")}`;
}

const plain = (/** @type {any} */ value) => value?.constructor === Object;
const tape = (/** @type {any} */ value) => Array.isArray(value) && value.length > 1;

/** What in a state differs from `usual`; a tape that is a piece of one of `tapes` by [its name, from, to]. @returns {any} */
export function shortened(/** @type {any} */ state, /** @type {any} */ usual, /** @type {Map<string, string>} */ tapes) {
  const parts = Object.entries(state).map(([name, value]) => {
    if (JSON.stringify(value) === JSON.stringify(usual?.[name])) return [name, undefined];
    if (plain(value)) return [name, shortened(value, usual?.[name], tapes)];
    return [name, tape(value) ? piece(value.join(" "), tapes) ?? value : value];
  });
  return Object.fromEntries(parts.filter(([, value]) => value !== undefined));
}

/** The state that was shortened. Throws for a tape that is not at hand. @returns {any} */
export function whole(/** @type {any} */ state, /** @type {Map<string, string>} */ tapes) {
  const parts = Object.entries(state).map(([name, value]) => {
    if (!plain(value)) return [name, value];
    if (!value.$tape) return [name, whole(value, tapes)];
    const [called, from, to] = value.$tape, bundled = tapes.get(called);
    if (bundled === undefined) throw new Error(`no tape ${called} is bundled`);
    return [name, [bundled.slice(from, to)]];
  });
  return Object.fromEntries(parts);
}

function piece(/** @type {string} */ text, /** @type {Map<string, string>} */ tapes) {
  for (const [name, frames] of tapes) {
    const from = frames.indexOf(text);
    if (from >= 0) return { $tape: [name, from, from + text.length] };
  }
  return null;
}
