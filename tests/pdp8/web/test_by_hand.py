"""ESLint and TypeScript find no fault in the modules by hand; what is translated has names, and any type."""

import shutil
import subprocess
from pathlib import Path

import pytest

from pdp8.web import bundle, translator
from tests.pdp8.web import node

TOOLS = node.HOUSE / "tests" / "node"

pytestmark = [
    node.needs_node,
    pytest.mark.slow("looks at all modules"),
    pytest.mark.skipif(
        not (TOOLS / "node_modules" / "eslint").is_dir(),
        reason="eslint is not installed: npm install --prefix tests/node",
    ),
]


def _check(*command: object, folder: Path) -> None:
    done = subprocess.run(
        [str(node.NODE), *map(str, command)], cwd=folder, capture_output=True, text=True, check=False
    )
    if done.returncode:
        pytest.fail(done.stdout + done.stderr, pytrace=False)


def test_eslint() -> None:
    eslint = TOOLS / "node_modules" / "eslint" / "bin" / "eslint.js"
    _check(eslint, "--config", TOOLS / "eslint.config.mjs", "pdp8", "tests", folder=node.HOUSE)


def test_types(tmp_path: Path) -> None:
    names = {module: bundle.exports(text) for module, text in translator.translated().items()}
    declared = {
        module: "".join(f"export const {name}: any;\n" for name in exported)
        for module, exported in names.items()
    }
    node.write(tmp_path, declared, ".d.mts")
    for name in ("tsconfig.json", "page.d.ts"):
        shutil.copy(TOOLS / name, tmp_path)
    _check(TOOLS / "node_modules" / "typescript" / "bin" / "tsc", folder=tmp_path)
