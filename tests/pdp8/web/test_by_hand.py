"""ESLint and TypeScript find no fault in the modules by hand; what is translated has names, and any type."""

import shutil
import subprocess
from pathlib import Path

import pytest

from pdp8.web import translator
from pdp8.web.names import exports
from tests.pdp8.web import node

TOOLS = node.HOUSE / "tests" / "node"

pytestmark = [
    node.needs_node,
    pytest.mark.slow("looks at all modules"),
    pytest.mark.skipif(
        not (TOOLS / "node_modules" / "eslint").is_dir(),
        reason="eslint is not installed: npm ci --prefix tests/node",
    ),
]


def _check(tool: str, *options: str, folder: Path) -> None:
    command = [str(node.NODE), str(TOOLS / "node_modules" / tool), *options]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


def test_eslint() -> None:
    config = str(TOOLS / "eslint.config.mjs")
    _check("eslint/bin/eslint.js", "--config", config, "pdp8", "tests", folder=node.HOUSE)


def test_types(tmp_path: Path) -> None:
    declared = {
        module: "".join(f"export const {name}: any;\n" for name in exports(text))
        for module, text in translator.translated().items()
    }
    node.write(tmp_path, declared, ".d.mts")
    for name in ("tsconfig.json", "page.d.ts"):
        shutil.copy(TOOLS / name, tmp_path)
    _check("typescript/bin/tsc", folder=tmp_path)
