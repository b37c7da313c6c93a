// What is asked of the modules by hand: ESLint's recommended rules, and nothing hides a global name or an outer one.

import js from "@eslint/js";

const BROWSER = "document window pack location history navigator localStorage sessionStorage performance console prompt matchMedia "
  + "getComputedStyle getSelection addEventListener setTimeout clearTimeout requestAnimationFrame cancelAnimationFrame "
  + "IntersectionObserver ResizeObserver Option Worker Blob CSS Response URL URLSearchParams TextDecoder TextEncoder atob btoa CompressionStream "
  + "DecompressionStream OffscreenCanvas Path2D AudioContext AudioBuffer AudioBufferSourceNode "
  + "BiquadFilterNode DynamicsCompressorNode GainNode OscillatorNode";
const readonly = (names) => Object.fromEntries(names.split(" ").map((name) => [name, "readonly"]));

export default [
  js.configs.recommended,
  {
    rules: {
      "eqeqeq": ["error", "always", { null: "ignore" }],
      "no-control-regex": "off", // text of 1971 has control characters
      "no-loop-func": "error",
      "no-self-compare": "error",
      "no-shadow": ["error", { builtinGlobals: true, hoist: "never" }],
      "no-unused-expressions": "error",
      "no-var": "error",
      "prefer-const": "error",
    },
  },
  { files: ["pdp8/**"], languageOptions: { globals: readonly(BROWSER) } },
  { files: ["**/runtime.mjs"], rules: { "no-shadow": "off", "eqeqeq": "off" } }, // its names are Python's, its numbers of two kinds
  { files: ["tests/**"], languageOptions: { globals: readonly("process console setTimeout Buffer") } },
];
