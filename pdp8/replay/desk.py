"""The files that the afternoon leaves on the desk: every tape, listing and picture."""

from collections.abc import Iterator
from typing import Final

from nc import listing
from nc.plot import plot
from nc.talyrond import talyrond
from nc.talysurf import talysurf
from pdp8.replay.afternoon import Afternoon
from pdp8.replay.day import PROGRAMS
from pdp8.replay.figures import compare
from programs.parts import find
from tapes import picture

PICTURED: Final = 240
"""Frames of a long tape that its picture shows: its first dozen blocks."""


def names(part: str, in_fortran: bool = False) -> list[str]:
    """Return the names of the files that the afternoon of a part leaves."""
    made = find(part)
    own = [f"{part[:6]}.ft"] if in_fortran else []
    for ending in ("txt", "asc", "eia", "blocks", "asc.svg", "eia.svg", "svg"):
        own.append(f"{part}.{ending}")
    if made.nominal() is not None:
        own.append(_instrument(made.instrument))
    return [*own, "bin.rim", "eia.bin", *(name.replace(".pal", ".lst") for name in PROGRAMS), "figures.txt"]


def _instrument(name: str | None) -> str:
    return f"{(name or 'inspection').lower()}.svg"


def desk(afternoon: Afternoon) -> dict[str, bytes]:
    """Return every file by its name: tapes as they are, texts in UTF-8, pictures as SVG."""
    texts = dict(_texts(afternoon)) | dict(_pictures(afternoon))
    return afternoon.tapes | {name: text.encode() for name, text in texts.items()}


def _texts(afternoon: Afternoon) -> Iterator[tuple[str, str]]:
    part = afternoon.part
    yield f"{part}.txt", afternoon.text
    for name, assembly in afternoon.programs.items():
        yield name.replace(".pal", ".lst"), assembly.listing
    yield f"{part}.blocks", "".join(f"{line}\n" for line in listing.lines(afternoon.path, modes=True))
    yield "figures.txt", "".join("\t".join(line) + "\n" for line in compare(afternoon))


def _pictures(afternoon: Afternoon) -> Iterator[tuple[str, str]]:
    part = afternoon.part
    for code in ("asc", "eia"):
        name = f"{part}.{code}"
        tape = afternoon.tapes[name]
        yield f"{name}.svg", picture.svg(tape, {"asc": "ascii", "eia": "eia"}[code], 0, PICTURED)
    inspection, made = afternoon.inspection, afternoon.made
    if inspection:
        cutter, tolerance = inspection.cutter, inspection.tolerance
        drawing = plot(afternoon.path, inspection.curve, cutter=cutter, tolerance=tolerance)
    else:
        drawing = plot(afternoon.path)
    yield f"{part}.svg", drawing
    if inspection:
        draw = talyrond if inspection.curve.closed else talysurf
        yield _instrument(made.instrument), draw(inspection)
