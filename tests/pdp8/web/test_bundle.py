"""What puts the modules into one script: nothing that one imports from another is lost on the way."""

import re

import pytest

from pdp8.web import bundle
from tests.pdp8.web.node import MODULES

_NAMED = re.compile(r'^import \{([^}]*)\} from "([^"]+)";$', re.MULTILINE)


@pytest.mark.parametrize("path", sorted(MODULES.rglob("*.mjs")), ids=lambda path: path.stem)
def test_every_name_that_is_imported_is_exported(path: object) -> None:
    """As the bundle sees it: a name in a list of declarations would be undefined in the page."""
    module = MODULES / str(path)
    for names, source in _NAMED.findall(module.read_text(encoding="utf-8")):
        exported = bundle.exports((module.parent / source).read_text(encoding="utf-8"))
        for name in names.split(","):
            assert name.strip().partition(" as ")[0] in exported, f"{module.name}: {name} from {source}"
