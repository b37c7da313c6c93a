"""What the afternoon leaves on the desk: every tape, listing and picture, by the name of its file."""

from collections.abc import Iterator
from typing import Final

from nc import listing
from nc.plot import plot
from nc.talyrond import talyrond
from nc.talysurf import talysurf
from pdp8.replay.afternoon import Afternoon
from pdp8.replay.figures import compare
from programs.parts import PARTS
from tapes import picture

PICTURED: Final = 240
"""Frames of a long tape that its picture shows: its first dozen blocks."""


def names(part: str) -> set[str]:
    """Return the names of the files that an afternoon with `part` leaves, its inspection's included."""
    listed = (f"{program}.lst" for program in ("rim", "bin", "eia"))
    of_part = (f"{part}.{kind}" for kind in ("asc", "eia", "txt", "blocks", "svg", "asc.svg", "eia.svg"))
    return {"bin.rim", "eia.bin", "figures.txt", *listed, *of_part, _inspected(part)}


def desk(afternoon: Afternoon) -> dict[str, bytes]:
    """Return {file name: content} of everything: tapes as they are, texts in UTF-8, pictures as SVG."""
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
    inspection, made = afternoon.inspection, PARTS[part]
    curve = inspection.curve if inspection else None
    yield (
        f"{part}.svg",
        plot(afternoon.path, curve, cutter=made.cutter * 1000, tolerance=made.tolerance * 1000),
    )
    if inspection:
        draw = talyrond if inspection.curve.closed else talysurf
        yield _inspected(part), draw(inspection)


def _inspected(part: str) -> str:
    """Return the name of the inspection's picture."""
    return f"{(PARTS[part].instrument or 'inspection').lower()}.svg"
