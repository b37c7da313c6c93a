"""`python -m pdp8.web.translator`: check what the page is made of, without Node.js or a browser.

Every module of the page can be translated to JavaScript; no name of a JavaScript module is declared twice, or
imported and not there; text is split into lines in one way (`tapes.text`). Prints file, line and construct of
each fault, and exits with 1 if there is one.
"""

import re
from importlib.resources import files
from pathlib import Path

from pdp8.web import bundle
from pdp8.web.translator import faults

_PACKAGES = ("nc", "pal", "pdp8", "programs", "tapes")
_SPLITS = re.compile(r"\.splitlines\b(?!`)")


def _lines_split() -> list[str]:
    """Return where a package splits text into lines as Python does, at ten line ends, and not as PAL does."""
    found = []
    for package in _PACKAGES:
        for path in sorted(Path(str(files(package))).rglob("*.py")):
            for number, line in enumerate(path.read_text(encoding="utf-8").split("\n"), 1):
                if _SPLITS.search(line) and path != Path(__file__):
                    found.append(f"{path}:{number}: splitlines() has other line ends; write lines_of(...)")
    return found


found = faults()
if not found:
    found = bundle.faults()
if found := [*found, *_lines_split()]:
    hint = "the page runs this as JavaScript: pdp8/web/translator/library.pyi lists what it may use"
    raise SystemExit("\n".join([*found, hint]))
