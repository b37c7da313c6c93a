"""ESLint and TypeScript find no fault in the modules by hand, with the types of what is translated."""

import shutil
import subprocess
from pathlib import Path

import pytest

from pdp8.web import bundle, translator
from tests.pdp8.web import node

_FAULTS = """
import { Machine } from "../computer/machine.mjs";
// @ts-expect-error: an attribute that was renamed
export const ac = new Machine().accumulator;
// @ts-expect-error: a method that is missing
new Machine().halt();
// @ts-expect-error: a class as a function
Machine();
// @ts-expect-error: an end that may be none
"".slice(0, new Machine().recorder);
"""
TOOLS = node.HOUSE / "tests" / "node"

pytestmark = [
    node.needs_node,
    pytest.mark.skipif(
        not (TOOLS / "node_modules" / "eslint").is_dir(),
        reason="ESLint and TypeScript are not installed: npm ci --prefix tests/node",
    ),
]


def _said(tool: str, *options: str, folder: Path) -> str:
    """Return what a tool says of the modules in a folder, "" if it finds no fault."""
    command = [str(node.NODE), str(TOOLS / "node_modules" / tool), *options]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    return done.stdout + done.stderr if done.returncode else ""


@pytest.mark.slow("looks at all modules")
def test_eslint() -> None:
    config = str(TOOLS / "eslint.config.mjs")
    assert not _said("eslint/bin/eslint.js", "--config", config, "pdp8", "tests", folder=node.HOUSE)


@pytest.mark.slow("reads two scripts of half a million characters")
def test_no_name_is_missing_in_what_the_pages_run(tmp_path: Path) -> None:
    """What is left out of the modules is used by nothing that is there."""
    config = (TOOLS / "eslint.config.mjs").read_text().partition("export default")[0].split("\n", 3)[3]
    config += "const languageOptions = { sourceType: 'script', globals: readonly(BROWSER) };\n"
    config += "export default [{ files: ['*.js'], rules: { 'no-undef': 'error' }, languageOptions }];\n"
    (tmp_path / "eslint.config.mjs").write_text(config)
    for entry in ("workbench", "curve"):
        (tmp_path / f"{entry}.js").write_text("\n".join(bundle.scripts(entry)))
    assert not _said("eslint/bin/eslint.js", "--config", "eslint.config.mjs", ".", folder=tmp_path)


def test_types(tmp_path: Path) -> None:
    node.write(tmp_path, translator.declared(), ".d.mts")
    for name in ("tsconfig.json", "page.d.ts"):
        shutil.copy(TOOLS / name, tmp_path)
    (tmp_path / "pdp8" / "web" / "faults.mjs").write_text(_FAULTS, encoding="utf-8")
    assert not _said("typescript/bin/tsc", folder=tmp_path)
