"""The packages: whose sources are changed and whose tests run; and the mutants that change nothing."""

import tomllib
from pathlib import Path

ROOT = Path(__file__).parents[2]

TABLES = "tests/transcripts/test_transcripts.py"
"""What commands do, each of which calls several packages."""

PACKAGES = {
    "tapes": (
        "tapes",
        [
            "tests/tapes/test_*.py",
            "tests/tapes/photograph/test_c*.py",
            # what all commands do alike, which tapes/ holds
            *(f"tests/pdp8/cli/test_{name}.py" for name in ("files", "loading", "refusals", "root")),
            "tests/programs/test_functions.py",
            "tests/test_notebook.py",
            TABLES,
        ],
    ),
    "photographs": ("tapes/photograph", ["tests/tapes/photograph/test_*.py"]),
    "pal": ("pal", ["tests/pal/test_*.py", "tests/test_editors.py", "tests/test_notebook.py"]),
    "programs": ("programs", ["tests/programs/test_*.py", TABLES]),
    "nc": ("nc", ["tests/nc/test_*.py", "tests/tapes/test_hydrapoint.py", "tests/test_notebook.py", TABLES]),
    "lessons": ("pdp8/lessons", ["tests/pdp8/lessons/test_*.py", "tests/test_lesson_kit.py", TABLES]),
    "monitor": ("pdp8/monitor", ["tests/pdp8/monitor/test_*.py", "tests/pdp8/cli/test_files.py", TABLES]),
    "computer": ("pdp8/computer", ["tests/pdp8/computer/**/test_*.py"]),
    "dap": ("pdp8/dap", ["tests/pdp8/dap/test_*.py"]),
    "cli": (
        "pdp8/cli",
        [
            *("tests/pdp8/cli/test_*.py", "tests/options/test_*.py", "tests/*/test_cli.py"),
            *("tests/pdp8/*/test_command.py", "tests/programs/test_part_command.py"),
            *(f"tests/pdp8/lessons/test_{name}.py" for name in ("where", "classes")),
            TABLES,
        ],
    ),
    "web": (
        "pdp8/web",  # by the tests that are quick: those of the page make all of it, from the cache
        [
            f"tests/pdp8/web/test_{name}.py"
            for name in ("bundle", "findings", "kept", "parts", "passing", "python")
        ],
    ),
    "translator": (
        "pdp8/web/translator",
        [
            "tests/pdp8/web/translator/test_*.py",
            *(f"tests/pdp8/web/test_{name}.py" for name in ("translated", "by_hand", "parts")),
        ],
    ),
}
"""The folder and the tests of each package. A folder of its own here is left out of the package around it."""


def sources(package: str) -> list[str]:
    """Return the sources of a package, relative to the repository."""
    folder = PACKAGES[package][0]
    within = tuple(f"{other}/" for other, _ in PACKAGES.values() if other.startswith(f"{folder}/"))
    found = (path.relative_to(ROOT).as_posix() for path in (ROOT / folder).rglob("*.py"))
    return sorted(path for path in found if not within or not path.startswith(within))


def tests(package: str) -> list[str]:
    """Return the files of a package's tests, relative to the repository."""
    found = {path for pattern in PACKAGES[package][1] for path in ROOT.glob(pattern)}
    return sorted(path.relative_to(ROOT).as_posix() for path in found)


def equal() -> dict[tuple[str, str, str], str]:
    """Return why a mutant changes nothing, by its file, its scope and the change as the table shows it."""
    found = tomllib.loads((Path(__file__).parent / "equal.toml").read_text())
    return {
        (file, scope, change): entry["why"]
        for file, scopes in found.items()
        for scope, entries in scopes.items()
        for entry in entries
        for change in entry["changes"]
    }
