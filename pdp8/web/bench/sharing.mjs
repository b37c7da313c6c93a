// A link that holds the program and the machine: #s=... is their JSON, compressed (deflate) and in base64.

/** What the address holds, or null. Throws where the address is damaged. */
export async function opened() {
  const found = /^#s=([\w-]+)$/.exec(location.hash);
  return found ? JSON.parse(await through(new DecompressionStream("deflate-raw"), bytes(found[1]), "text")) : null;
}

/** The address of this page with `shared` in it. */
export async function address(shared) {
  const written = new TextEncoder().encode(JSON.stringify(shared));
  const packed = await through(new CompressionStream("deflate-raw"), written, "arrayBuffer");
  const text = btoa(Array.from(new Uint8Array(packed), (byte) => String.fromCharCode(byte)).join(""));
  return `${location.href.replace(/#.*/, "")}#s=${text.replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "")}`;
}

function through(stream, data, as) {
  return new Response(new Blob([data]).stream().pipeThrough(stream))[as]();
}

function bytes(text) {
  return Uint8Array.from(atob(text.replaceAll("-", "+").replaceAll("_", "/")), (character) => character.charCodeAt(0));
}
