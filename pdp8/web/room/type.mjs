// The Teletype's type: capitals drawn as strokes on a grid of 4 by 6, so they are sharp at every size and on every machine.
//
//     "36300444"      a line through (3,6) (3,0) (0,4) (4,4)          "~..." the same points, rounded

const STROKES = {
  0: "~204046060020", 1: "112026", 2: "~0100404306 0646", 3: "~0100404323 ~2343460605", 4: "36300444", 5: "400003 ~0343460605",
  6: "~41400006464304", 7: "004016", 8: "~204043030020 ~234346060323", 9: "~05064640000342",
  A: "062046 1434", B: "060020 ~00404303 ~03434606", C: "~414000064645", D: "0006 ~00404606", E: "40000646 0333", F: "400006 0333",
  G: "~414000064644 4424", H: "0006 4046 0343", I: "2026 1030 1636", J: "~40460604", K: "0006 400346", L: "000646", M: "0600234046",
  N: "06004640", O: "~204046060020", P: "0006 ~00404303", Q: "~204046060020 2446", R: "0006 ~00404303 2346", S: "~4140000343460605",
  T: "0040 2026", U: "~00064640", V: "002640", W: "0016233640", X: "0046 4006", Y: "002340 2326", Z: "00400646",
  ".": "2526", ",": "2517", "-": "0343", "+": "0343 2125", "*": "2125 0244 0442", "/": "4006", "=": "0242 0444", "(": "~30101636", ")": "~10303616",
  "'": "2022", '"': "1012 3032", ":": "2122 2526", ";": "2122 2517", "!": "2024 2526", "?": "~0100404324 2526", "<": "400346", ">": "004306",
  "#": "1016 3036 0242 0444", $: "~4140000343460605 2026", "%": "4006 0001 4546", "@": "~444000064645 2444", "[": "30101636", "]": "10303616", "\\": "0046", "^": "032043", _: "0646", "←": "430323 2103 0325",
};

/** The strokes of each character, in tenths of an inch: .7 wide, 1 high, from its upper left. */
export const TYPE = new Map(Object.entries(STROKES).map(([character, strokes]) => [character, path(strokes)]));

function path(/** @type {string} */ strokes) {
  const found = new Path2D();
  for (const stroke of strokes.split(" ")) {
    const round = stroke[0] === "~";
    /** @type {[number, number][]} */
    const at = [...stroke.slice(Number(round)).matchAll(/(\d)(\d)/g)].map(([, x, y]) => [Number(x) * 0.017, Number(y) * 0.0175]);
    found.moveTo(...at[0]);
    if (!round) at.slice(1).forEach((point) => found.lineTo(...point));
    else for (let i = 1; i < at.length - 1; i++) {
      const [[x, y], [u, v]] = [at[i], at[i + 1]];
      const last = i === at.length - 2;
      found.quadraticCurveTo(x, y, last ? u : (x + u) / 2, last ? v : (y + v) / 2);
    }
  }
  return found;
}
