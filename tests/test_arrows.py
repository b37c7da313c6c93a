"""The arrows between packages: imports between the packages point one way.

    tapes <- pal <- pdp8      tapes <- programs      tapes <- nc

Only `pdp8/cli`, `pdp8/replay`, `pdp8/thesis` and `pdp8/web` import across; nobody imports those but each
other. `pdp8/computer` imports no front end, and its own folders import one way too:

    hardware <- dectape, rack <- speed <- machine, watch, stop, count <- past <- use

`pdp8` itself names what a script uses, from wherever it is. The four libraries know no command line: they
import neither click nor rich nor prompt_toolkit, open no file and print nothing.
"""

import ast
import re
import subprocess
import sys
from collections.abc import Iterator
from functools import cache
from importlib.util import find_spec
from pathlib import Path

HOUSE = Path(__file__).parent.parent
ALLOWED = {
    "tapes": {"tapes"},
    "pal": {"tapes", "pal"},
    "pdp8": {"tapes", "pal", "pdp8"},
    "programs": {"tapes", "programs"},
    "nc": {"tapes", "nc"},
}
ACROSS = re.compile(r"(pdp8\.__main__|pdp8\.cli|pdp8\.replay|pdp8\.thesis|pdp8\.web)(\.|$)")
COMPUTER = "pdp8.computer."
FOLDERS = ("hardware", "dectape", "rack", "speed", "machine", "past", "use")
"""Of the computer: each imports only from itself and from those before it."""
BESIDE_THE_MACHINE = ("watch", "stop", "count")


def sources(*packages: str) -> Iterator[tuple[Path, str, ast.Module]]:
    """Yield each source of the packages: its path, its name as a module, its tree."""
    for package in packages or ALLOWED:
        for path in sorted((HOUSE / package).rglob("*.py")):
            name = ".".join(path.relative_to(HOUSE).with_suffix("").parts)
            yield path, name, _parsed(path)


@cache
def _parsed(path: Path) -> ast.Module:
    return ast.parse(path.read_text())


def imports(tree: ast.Module) -> Iterator[str]:
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{ast.unparse(node)}: imports by full name, please"
            yield from (str(node.module), *(f"{node.module}.{alias.name}" for alias in node.names))


def test_imports_point_one_way() -> None:
    for _, here, tree in sources():
        if not ACROSS.match(here) and here != "pdp8.__init__":
            for name in imports(tree):
                package = name.partition(".")[0]
                assert package not in ALLOWED or package in ALLOWED[here.partition(".")[0]], (here, name)
                assert not ACROSS.match(name), f"{here} imports {name}, which nobody does"


def test_no_circle() -> None:
    """No module imports itself by way of others, within functions and for types included."""
    found = {name.removesuffix(".__init__"): set(imports(tree)) for _, name, tree in sources()}
    ahead = {name: _modules(names & found.keys()) for name, names in found.items()}
    while ready := [name for name, names in ahead.items() if not names & ahead.keys()]:
        for name in ready:
            del ahead[name]
    assert ahead == {}, "each of these imports another of them"


def _modules(names: set[str]) -> set[str]:
    """Return the modules that are meant: of `from pdp8 import shelf` not pdp8 itself."""
    return {each for each in names if not any(other.startswith(f"{each}.") for other in names)}


LIBRARIES = ("tapes", "pal", "programs", "nc")
OF_COMMANDS = ("click", "rich", "prompt_toolkit")
TOOLS = ("pal.server",)
"""A program of its own in a library: it talks with an editor."""


def test_the_libraries_are_imported_without_the_command_line() -> None:
    names = [name.removesuffix(".__init__") for _, name, _ in sources(*LIBRARIES) if name not in TOOLS]
    if find_spec("cv2") is None:
        names = [name for name in names if not name.startswith("tapes.photograph")]
    blocked = f"import sys, importlib\nsys.modules.update(dict.fromkeys({OF_COMMANDS!r}))\n"
    script = f"{blocked}for name in {names!r}: importlib.import_module(name)"
    done = subprocess.run(
        [sys.executable, "-c", script], cwd=HOUSE, capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stderr) == (0, "")


def test_the_libraries_open_no_file_and_print_nothing() -> None:
    for path, here, tree in sources(*LIBRARIES):
        for node in ast.walk(tree):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and here not in TOOLS:
                assert node.func.id not in ("open", "print", "input"), f"{path}:{node.lineno}"


def folder(name: str) -> int:
    """Return the place in FOLDERS of a module of the computer."""
    first = name.removeprefix(COMPUTER).partition(".")[0]
    return FOLDERS.index("machine" if first in BESIDE_THE_MACHINE else first)


def test_the_computer_imports_no_front_end_and_its_rooms_one_way() -> None:
    for _, here, tree in sources("pdp8"):
        if here.startswith(COMPUTER):
            for name in imports(tree):
                assert not name.startswith("pdp8.") or f"{name}.".startswith(COMPUTER), (here, name)
                if name.startswith(COMPUTER) and here != f"{COMPUTER}__init__":
                    assert folder(name) <= folder(here), f"{here} imports {name}"


def test_a_package_says_what_each_of_its_files_is_for() -> None:
    unsaid = []
    for path, here, tree in sources():
        if path.name == "__init__.py" and (text := ast.get_docstring(tree)):
            files = {each.stem for each in path.parent.glob("*.py")} - {"__init__", "__main__"}
            files |= {each.parent.name for each in path.parent.glob("*/__init__.py")}
            unsaid += [f"{here}: {name}" for name in sorted(files) if not re.search(rf"\b{name}\b", text)]
    assert unsaid == []


def test_what_a_module_leaves_out_is_in_emulated_md() -> None:
    left_out = (HOUSE / "docs" / "emulated.md").read_text()
    for path, here, tree in sources():
        if re.search(r"Not emulated|\*\*not emulated", ast.get_docstring(tree) or ""):
            assert f"`{path.relative_to(HOUSE)}`" in left_out, here
