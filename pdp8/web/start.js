
// Unpacks the page's scripts and data: compressed they are a third as large. The first script is run at once, the
// second when it is wanted.
//
// What fails is said in a bar at the head of the page, with a way on: a script's error, at any time; what this browser has not.
globalThis.pack = (() => {
  const stumble = (words) => {
    const place = document.getElementById("stumbled") ?? document.body.appendChild(document.createElement("p"));
    const link = Object.assign(document.createElement("a"), { href: "", textContent: "Load the page again" });
    Object.assign(place, { id: "stumbled" }).replaceChildren(words, " ", link);
    place.setAttribute("role", "alert");
    const needs = document.getElementById("needs");
    if (needs) needs.hidden = true;
  };
  addEventListener("error", ({ error, message }) => error && stumble(`This page has stumbled: ${message}. What you wrote is kept.`));
  addEventListener("unhandledrejection", ({ reason }) => stumble(`This page has stumbled: ${reason?.message ?? reason}. What you wrote is kept.`));
  const has = { // what came last to browsers
    "DecompressionStream": () => new DecompressionStream("deflate-raw"), "OffscreenCanvas": () => new OffscreenCanvas(1, 1).getContext("2d").roundRect,
    "Map.groupBy": () => Map.groupBy, ":has() in its styles": () => CSS.supports("selector(:has(a))"),
  };
  const lacks = Object.keys(has).filter((name) => {
    try {
      return !has[name]();
    } catch {
      return true;
    }
  });
  const styled = getComputedStyle(document.body).getPropertyValue("--high");
  if (lacks.length) stumble(`This browser has no ${lacks.join(", no ")}: the machine needs Firefox 121, Chrome 117, Safari 17.4, or a later one.`);
  else if (!styled) stumble("The server of this page forbids its style (Content-Security-Policy): save the page, and open the file.");
  if (lacks.length || !styled) return null;
  const policy = globalThis.trustedTypes?.createPolicy("start", { createScript: (text) => text });
  let early = []; // files that are dropped before the page can take them
  const hold = (event) => {
    if (!early || !event.dataTransfer?.types.includes("Files")) return;
    event.preventDefault();
    if (event.type === "drop") early.push(...event.dataTransfer.files);
  };
  for (const kind of ["dragover", "drop"]) addEventListener(kind, hold);
  const bytes = (packed) => {
    if (Uint8Array.fromBase64) return Uint8Array.fromBase64(packed);
    const plain = atob(packed), data = new Uint8Array(plain.length);
    for (let at = 0; at < data.length; at++) data[at] = plain.charCodeAt(at); // Uint8Array.from takes five times as long
    return data;
  };
  const unpacked = (packed) => new Response(new Blob([bytes(packed)]).stream().pipeThrough(new DecompressionStream("deflate-raw"))).text();
  const content = (id) => unpacked(document.getElementById(id).textContent);
  const run = async (id) => {
    const code = await content(id);
    const script = document.createElement("script");
    script.className = "code";
    script.textContent = policy ? policy.createScript(code) : code;
    document.body.append(script);
  };
  const record = async (id) => JSON.parse(await content(id));
  run("code");
  return { unpacked, record: record("record"), later: (module) => run("later").then(module), more: () => record("more"), early: () => [early, early = null][0] };
})();
