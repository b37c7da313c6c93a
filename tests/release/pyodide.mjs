// Runs the main job in Pyodide: the archives given are unpacked as Python packages.
// usage: node pyodide.mjs FOLDER_OF_PYODIDE ARCHIVE...; the punched tape in octal on standard output
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const [folder, ...archives] = process.argv.slice(2);
const { loadPyodide } = await import(pathToFileURL(`${folder}/pyodide.mjs`));
const python = await loadPyodide({ indexURL: `${folder}/` });
for (const archive of archives) python.unpackArchive(new Uint8Array(readFileSync(archive)).buffer, "zip");
console.log(python.runPython(`
import programs  # its files are on the shelf
from click.testing import CliRunner
from pdp8.cli.root import pdp8

runner = CliRunner()
tape = runner.invoke(pdp8, ["part", "circle"], catch_exceptions=False).stdout_bytes
cut = runner.invoke(pdp8, ["run", "eia.pal"], input=tape, catch_exceptions=False)
assert cut.exit_code == 0, cut.output
cut.stdout_bytes.hex()
`));
