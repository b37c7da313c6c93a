"""The rooms: whose sources are changed and whose tests run; and the mutants that change nothing."""

import tomllib
from pathlib import Path

HOUSE = Path(__file__).parents[2]

PHOTOGRAPHS = "tests/tapes/photograph"
COMMANDS = [f"tests/pdp8/cli/test_{name}.py" for name in ("files", "loading", "manners", "refusals", "root")]
"""The tests of what all commands do alike, which tapes/ holds."""

ROOMS = {
    "tapes": (
        "tapes",
        [
            "tests/tapes",
            f"--ignore-glob=*/{PHOTOGRAPHS}/test_[!c]*",
            *COMMANDS,
            "tests/programs/test_functions.py",
            "tests/test_notebook.py",
        ],
    ),
    "photographs": ("tapes/photograph", [PHOTOGRAPHS]),
    "pal": ("pal", ["tests/pal", "tests/test_editors.py", "tests/test_notebook.py"]),
    "programs": ("programs", ["tests/programs"]),
    "nc": ("nc", ["tests/nc", "tests/tapes/test_hydrapoint.py", "tests/test_notebook.py"]),
    "lessons": ("pdp8/lessons", ["tests/pdp8/lessons", "tests/test_lesson_kit.py"]),
    "monitor": ("pdp8/monitor", ["tests/pdp8/monitor", "tests/pdp8/cli/test_files.py"]),
    "computer": ("pdp8/computer", ["tests/pdp8/computer"]),
}
"""The folder and the tests of each room. A folder of its own here is left out of the room around it."""


def sources(room: str) -> list[Path]:
    """Return the sources of a room, relative to the house."""
    folder = ROOMS[room][0]
    within = [other for other, _ in ROOMS.values() if other.startswith(f"{folder}/")]
    found = (path.relative_to(HOUSE) for path in (HOUSE / folder).rglob("*.py"))
    return sorted(path for path in found if not any(path.is_relative_to(other) for other in within))


def equal() -> dict[tuple[str, str, str], str]:
    """Return why a mutant changes nothing, by its file, its scope and the change as the table shows it."""
    found = tomllib.loads((Path(__file__).parent / "equal.toml").read_text())
    return {
        (entry["file"], entry["scope"], change): entry["why"]
        for entry in found.get("mutant", [])
        for change in entry["changes"]
    }
