// The one way to write HTML: what stands in ${} is text, unless html`` or ours() made it, or a list of those.
//
//     put(place, html`<li title="${name}">${name}</li>`)            an attribute's value stands in double quotes
//
// The page's policy (pdp8/web/bundle.py) has the browser refuse HTML and scripts that do not come through here.

const same = (/** @type {string} */ text) => text;
const policy = /** @type {any} */ (globalThis).trustedTypes?.createPolicy("page", { createHTML: same, createScriptURL: same }) ?? { createHTML: same, createScriptURL: same };

class HTML {
  constructor(/** @type {string} */ source) {
    this.source = source;
  }
}

const ENTITY = (/** @type {string} */ character) => `&#${character.charCodeAt(0)};`;

/** @returns {string} */
function source(/** @type {unknown} */ value) {
  if (value instanceof HTML) return value.source;
  return Array.isArray(value) ? value.map(source).join("") : String(value).replace(/[&<>"']/g, ENTITY);
}

/** HTML with values in it, each as text unless it is HTML, or a list of it. */
export function html(/** @type {TemplateStringsArray} */ parts, /** @type {any[]} */ ...values) {
  return new HTML(String.raw({ raw: parts }, ...values.map(source)));
}

/** HTML or SVG that our own code has made, and escaped where there are words in it. */
export function ours(/** @type {string} */ markup) {
  return new HTML(markup);
}

/** Let `content` be all that is in an element: HTML, or text. */
export function put(/** @type {Element} */ element, /** @type {unknown} */ content) {
  element.innerHTML = policy.createHTML(source(content));
}

/** The address of a script of the page's own, for a Worker. */
export function scriptAt(/** @type {string} */ url) {
  return policy.createScriptURL(url);
}
