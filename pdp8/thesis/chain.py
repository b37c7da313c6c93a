"""The chain of 1971 for one tape: a part program's printout, through eia.pal, to the cut path.

Each tape is made once in a run; a part is named as `pdp8 part` names it, with its constants.
"""

from functools import cache
from inspect import signature
from typing import Any

import nc
import pal
import pdp8
from pdp8 import shelf
from programs import parts
from programs.milling import Milling
from tapes import ascii, eia
from tapes.nominal import Nominal


def printout(part: str, **constants: Any) -> str:
    """Return what the part program prints."""
    given = signature(parts.find(part).program()).bind(**constants)
    given.apply_defaults()
    return _printed(part, **given.arguments)


@cache
def _printed(part: str, **constants: Any) -> str:
    return parts.find(part).program()(**constants)


def nominal(part: str) -> Nominal:
    """Return the curve that the part follows; it must have one."""
    found = parts.find(part).nominal()
    assert found, part
    return found


@cache
def translated(text: str, program: str = "eia.pal") -> bytes:
    """Return the EIA tape of a printout, translated on the PDP-8/L by a conversion program."""
    machine = pdp8.Machine()
    machine.load(pal.assemble(shelf.read_bundled(program)).words)
    machine.start(0o200)
    machine.teletype.reader.load(ascii.encode(text))
    machine.run()
    return machine.teletype.punch.tape


@cache
def path(part: str, **constants: Any) -> nc.Path:
    """Return the path of a part's tape at the Hydra-Point."""
    return nc.cut(translated(printout(part, **constants)))


def pieces(part: str) -> nc.Path:
    """Return the path of a part's tape by the piece-wise technique."""
    return path(part, milling=Milling("piece"))


def typed(*blocks: str) -> nc.Path:
    """Return the path of blocks as the thesis prints them, their digits apart."""
    lines = "".join(block.replace(" ", "") + "\n" for block in blocks)
    return nc.cut(eia.encode(lines))
