"""The arrows of the house: imports between the packages point one way.

    tapes <- pal <- pdp8      tapes <- programs      tapes <- nc

Only `pdp8/cli`, `pdp8/replay`, `pdp8/thesis` and `pdp8/web` import across; nobody imports those but each
other. `pdp8/computer` imports no front end, and its own rooms import one way too:

    hardware <- speed <- machine, watch, stop, count <- past <- use

`pdp8` itself names what a script uses, from wherever it is.
"""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

from tests.conftest import case

HOUSE = Path(__file__).parent.parent
PACKAGES = ("tapes", "pal", "pdp8", "programs", "nc")
ALLOWED = {
    "tapes": {"tapes"},
    "pal": {"tapes", "pal"},
    "pdp8": {"tapes", "pal", "pdp8"},
    "programs": {"tapes", "programs"},
    "nc": {"tapes", "nc"},
}
ACROSS = ("pal.__main__", "pdp8.__main__", "pdp8.cli", "pdp8.replay", "pdp8.thesis", "pdp8.web")


def sources() -> list[Path]:
    return [path for package in PACKAGES for path in sorted((HOUSE / package).rglob("*.py"))]


def imports(path: Path) -> Iterator[str]:
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path}: imports by full name, please"
            yield str(node.module)
            yield from (f"{node.module}.{alias.name}" for alias in node.names)


def module(path: Path) -> str:
    return ".".join(path.relative_to(HOUSE).with_suffix("").parts)


def is_across(name: str) -> bool:
    return any(name == place or name.startswith(f"{place}.") for place in ACROSS)


def test_imports_point_one_way() -> None:
    for path in sources():
        with case(path):
            here = module(path)
            for name in imports(path):
                package = name.split(".", maxsplit=1)[0]
                if package not in PACKAGES or is_across(here) or here == "pdp8.__init__":
                    continue
                assert package in ALLOWED[here.split(".", maxsplit=1)[0]], f"{here} imports {name}"
                assert not is_across(name), f"{here} imports {name}, which nobody does"


def test_the_computer_imports_no_front_end() -> None:
    for path in [path for path in sources() if module(path).startswith("pdp8.computer.")]:
        with case(path):
            for name in imports(path):
                assert not name.startswith("pdp8.") or name.startswith("pdp8.computer"), f"{path}: {name}"


ROOMS = ("hardware", "speed", "machine", "past", "use")
"""Of the computer: each imports only from itself and from those before it."""
BESIDE_THE_MACHINE = {"watch": "machine", "stop": "machine", "count": "machine"}


def room(name: str) -> str:
    """Return the room of module `name`, or "" for one that is not of the computer."""
    _, _, below = name.partition("pdp8.computer.")
    first = below.split(".", maxsplit=1)[0]
    return BESIDE_THE_MACHINE.get(first, first)


def test_the_rooms_of_the_computer_import_one_way() -> None:
    for path in [path for path in sources() if module(path).startswith("pdp8.computer.")]:
        with case(path):
            here = room(module(path))
            if here == "__init__":
                return
            for name in imports(path):
                if room(name):
                    assert ROOMS.index(room(name)) <= ROOMS.index(here), f"{module(path)} imports {name}"


def reached(path: Path) -> Iterator[str]:
    """Yield the packages that a file's strings name as folders: not docstrings, nor the release's name."""
    tree = ast.parse(path.read_text())
    others = {
        id(node.value)
        for node in ast.walk(tree)
        if isinstance(node, ast.Expr)
        or (isinstance(node, ast.keyword) and node.arg in ("name", "package_name"))
    }
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in others:
            first = re.split(r"[/.]", node.value)[0]
            if first in PACKAGES and not node.value.endswith((" ", ":")):
                yield first


def test_no_path_string_leads_where_no_import_may() -> None:
    for path in [path for path in sources() if module(path).split(".")[0] in ("tapes", "pal", "nc")]:
        with case(path):
            here = module(path).split(".", maxsplit=1)[0]
            for package in reached(path):
                assert package in ALLOWED[here], f"{module(path)} names the folder {package}"


def test_every_package_lists_its_files() -> None:
    for package in {path.parent for path in sources() if (path.parent / "__init__.py").exists()}:
        listing = ast.get_docstring(ast.parse((package / "__init__.py").read_text())) or ""
        for path in sorted(package.glob("*.py")):
            if not path.stem.startswith("__"):
                assert path.stem in listing, f"{package}/__init__.py does not list {path.stem}"


def test_what_a_file_leaves_out_stands_in_the_table_of_docs_too() -> None:
    table = (HOUSE / "docs" / "emulated.md").read_text()
    for path in sources():
        said = ast.get_docstring(ast.parse(path.read_text())) or ""
        if "Not emulated" in said or "**not emulated**" in said:
            assert f"`{path.relative_to(HOUSE)}`" in table
