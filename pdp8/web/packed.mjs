// JSON, compressed (deflate) and in base64: what a link holds.

/** What `text` holds. Throws where it is damaged. */
export async function unpacked(text) {
  const binary = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  const data = new Uint8Array(binary.length);
  for (let at = 0; at < data.length; at++) data[at] = binary.charCodeAt(at);
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
