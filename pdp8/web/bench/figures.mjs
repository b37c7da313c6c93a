// The thesis's figures beside the replay's, and the graph of the instrument.

import { escaped, find } from "../written.mjs";

export class Figures {
  constructor({ figures: { columns, rows }, graph }) {
    const head = columns.map((column) => `<th scope="col">${escaped(column)}</th>`).join("");
    const body = rows.map(([figure, ...said]) => `<tr><th scope="row">${escaped(figure)}</th>${said.map(cell).join("")}</tr>`);
    find("figures").querySelector("table").innerHTML = `<thead><tr>${head}</tr></thead><tbody>${body.join("")}</tbody>`;
    find("graph").innerHTML = graph;
  }
}

function cell(text) {
  return `<td>${escaped(text)}</td>`;
}
