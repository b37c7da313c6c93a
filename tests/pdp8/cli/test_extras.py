"""How to get a library that is missing: by whatever installed pdp8, into the same place."""

import sys

import pytest

from pdp8.cli.shared import extras

ARCHIVE = '{"url": "x", "archive_info": {}}'
EDITABLE = '{"url": "file:///home/ana/pdp8", "dir_info": {"editable": true}}'


@pytest.mark.parametrize(
    ("prefix", "active", "records", "hint"),
    [
        ("/home/ana/lab", True, {}, 'pip install "pdp8[nc]"'),
        ("/home/ana/lab", False, {}, '/home/ana/lab/bin/python -m pip install "pdp8[nc]"'),
        (sys.base_prefix, False, {}, 'pip install "pdp8[nc]"'),
        ("/home/ana/lab", False, {"INSTALLER": "uv\n"}, 'uv pip install "pdp8[nc]"'),
        ("/home/ana/.local/pipx/venvs/pdp8", False, {}, 'pipx install --force "pdp8[nc]"'),
        ("/home/ana/.local/share/uv/tools/pdp8", False, {}, 'uv tool install --force "pdp8[nc]"'),
        ("/home/ana/lab", True, {"direct_url.json": EDITABLE}, 'pip install -e "/home/ana/pdp8[nc]"'),
        ("/home/ana/lab", True, {"direct_url.json": ARCHIVE}, 'pip install "pdp8[nc]"'),
    ],
)
@pytest.mark.skipif(sys.platform == "win32", reason="these are paths of POSIX")
def test_the_hint_fits_how_it_was_installed(
    prefix: str, active: bool, records: dict[str, str], hint: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert extras._recorded("METADATA").startswith("Metadata-Version")
    monkeypatch.setattr(sys, "prefix", prefix)
    monkeypatch.setattr(sys, "executable", f"{prefix}/bin/python")
    monkeypatch.setenv("VIRTUAL_ENV", prefix if active else "")
    monkeypatch.setattr(extras, "_recorded", lambda file: records.get(file, ""))
    assert extras.hint("nc") == hint
