// Names in PAL III's code: pal/symbols.py in JavaScript; the symbols themselves are among the facts.

export const SIGNIFICANT = 6; // characters of a symbol that count

/** The three words of `name` in PAL III's table, two characters of six bits in each. */
export function codes(name) {
  const six = [...name.slice(0, SIGNIFICANT).padEnd(SIGNIFICANT, "@")].map((character) => character.charCodeAt(0) & 0o77);
  return [(six[0] << 6) | six[1], (six[2] << 6) | six[3], (six[4] << 6) | six[5]];
}

/** The name whose `codes` are these words; 40 to 77 are the characters from space to `?`. */
export function spelled(words) {
  const six = words.flatMap((word) => [word >> 6, word & 0o77]);
  return String.fromCharCode(...six.map((code) => (code < 0o40 ? code + 0o100 : code))).replace(/@+$/, "");
}

const TYPED = { "@": " ", "#": "\n", "%": "\r" };

/** What the Teletype types for a `spelled` name: six characters. */
export function typed(name) {
  return name.padEnd(SIGNIFICANT).replace(/[@#%]/g, (character) => TYPED[character]);
}
