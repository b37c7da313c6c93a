"""The command that installs the libraries of an extra, by the tool that installed this pdp8."""

import json
import os
import sys
from importlib.metadata import distributions
from importlib.util import find_spec
from pathlib import Path
from urllib.parse import urlsplit
from urllib.request import url2pathname

from tapes.errors import WorkError


def need(module: str, extra: str, what: str) -> None:
    """Raise WorkError if `module` is not installed, with `what` and the command that installs it."""
    if find_spec(module) is None:
        raise WorkError(f"{what}: {hint(extra)}")


def hint(extra: str) -> str:
    """Return the command that adds `extra` to this installation: of pipx, of uv, of pip, or of a checkout."""
    wanted = f"pdp8[{extra}]"
    checkout = _checkout()
    if checkout:
        wanted = f"{checkout}[{extra}]"
    place = Path(sys.prefix).parts
    if place[-3:-1] == ("pipx", "venvs"):
        return f'pipx install --force {_editable(checkout)}"{wanted}"'
    if place[-3:-1] == ("uv", "tools"):
        return f'uv tool install --force {_editable(checkout)}"{wanted}"'
    pip = "uv pip" if _recorded("INSTALLER").strip() == "uv" else "pip"
    active = os.environ.get("VIRTUAL_ENV") == sys.prefix or sys.prefix == sys.base_prefix
    program = pip if active or pip != "pip" else f"{sys.executable} -m pip"
    return f'{program} install {_editable(checkout)}"{wanted}"'


def _editable(checkout: str) -> str:
    return "-e " if checkout else ""


def _checkout() -> str:
    """Return the folder that pdp8 runs from if it is a checkout, else an empty name."""
    origin = json.loads(_recorded("direct_url.json") or "{}")
    if not origin.get("dir_info", {}).get("editable"):
        return ""
    return url2pathname(urlsplit(origin["url"]).path)


def _recorded(file: str) -> str:
    """Return what the installer recorded in `file`; a checkout has a record of its own, without it."""
    return next((text for each in distributions(name="pdp8") if (text := each.read_text(file))), "")
