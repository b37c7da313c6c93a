
// Unpacks the page's script and starts it: compressed it is a third as large.
{
  if (location.hash.startsWith("#t=")) document.body.classList.add("afternoon"); // nothing moves when its bar comes
  const packed = atob(document.getElementById("code").textContent);
  const data = new Uint8Array(packed.length);
  for (let at = 0; at < data.length; at++) data[at] = packed.charCodeAt(at); // Uint8Array.from takes five times as long
  const plain = new Blob([data]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  new Response(plain).text().then((code) => {
    const policy = globalThis.trustedTypes?.createPolicy("start", { createScript: (text) => text });
    const script = document.createElement("script");
    script.type = "module";
    script.textContent = policy ? policy.createScript(code) : code;
    document.body.append(script);
  });
}
