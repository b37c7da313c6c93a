
// Unpacks the page's scripts and data: compressed they are a third as large. The first script is run at once, the
// second when it is wanted.
globalThis.pack = (() => {
  const policy = globalThis.trustedTypes?.createPolicy("start", { createScript: (text) => text });
  const bytes = (packed) => {
    if (Uint8Array.fromBase64) return Uint8Array.fromBase64(packed);
    const plain = atob(packed), data = new Uint8Array(plain.length);
    for (let at = 0; at < data.length; at++) data[at] = plain.charCodeAt(at); // Uint8Array.from takes five times as long
    return data;
  };
  const unpacked = (id) => {
    const stream = new Blob([bytes(document.getElementById(id).textContent)]).stream();
    return new Response(stream.pipeThrough(new DecompressionStream("deflate-raw"))).text();
  };
  const run = async (id) => {
    const code = await unpacked(id);
    const script = document.createElement("script");
    script.className = "code";
    script.textContent = policy ? policy.createScript(code) : code;
    document.body.append(script);
  };
  const record = async (id) => JSON.parse(await unpacked(id));
  run("code");
  return { record: record("record"), later: (module) => run("later").then(module), more: () => record("more") };
})();
