// JSON, compressed (deflate) and in base64: a page's record, and what a link holds.

/** What `text` holds. Throws where it is damaged. */
export async function unpacked(text) {
  const binary = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  const data = Uint8Array.from(binary, (character) => character.charCodeAt(0));
  return JSON.parse(await through(new DecompressionStream("deflate-raw"), data, "text"));
}

export async function packed(value) {
  const written = new TextEncoder().encode(JSON.stringify(value));
  const data = await through(new CompressionStream("deflate-raw"), written, "arrayBuffer");
  return btoa(Array.from(new Uint8Array(data), (byte) => String.fromCharCode(byte)).join(""));
}

function through(stream, data, as) {
  return new Response(new Blob([data]).stream().pipeThrough(stream))[as]();
}
