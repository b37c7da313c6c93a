"""What we make of each number of the thesis: read from what runs here, or computed from its tapes and paths.

A measure has a name, which numbers.txt uses. It is a number, or of octal words, lists and blocks a string.
"""

import re
from collections.abc import Callable, Mapping
from functools import cache
from inspect import signature
from math import atan2, degrees, log2, radians, tan
from typing import Any, Final

import nc
import pal
from nc import talysurf
from nc.curves import nominal
from nc.inspection import Reading, inspect
from nc.machine import READ_SECONDS
from pdp8.replay.implied import LINE_SECONDS
from pdp8.thesis import chain, facsimile, slopes, tables, work
from programs import die, fluidic
from programs.milling import Milling
from programs.parts import PARTS
from tapes import ascii, eia, frames, hydrapoint, picture
from tapes.hydrapoint import FIELDS, SPINDLE, XY_FEED, Z_FEED, Preparatory

Measure = float | str

_MEMORY: Final = 1 << 12
_PAGE: Final = 0o200


def measure(name: str) -> Measure:
    """Return a measure by its name."""
    for table in (_machine(), _tape(), _computer(), _words(), _parts(), _elements()):
        if name in table:
            return table[name]()
    raise KeyError(name)


_Table = Mapping[str, Callable[[], Measure]]


def _machine() -> _Table:
    """Chapters 2 and 3: the Hydra-Point, its feeds, the drilling program."""
    feeds, z_feeds = sorted(XY_FEED.values()), sorted(Z_FEED.values())
    ratios = sorted(
        {one / two for one in feeds for two in feeds}, key=lambda r: abs(r - 1 / tan(radians(30)))
    )
    return {
        "axes": lambda: len(nc.path.Position._fields),
        "tools": lambda: len(hydrapoint.CAROUSEL),
        "travel x": lambda: hydrapoint.X_TRAVEL / 1000,
        "travel y": lambda: hydrapoint.Y_TRAVEL / 1000,
        "travel z": lambda: hydrapoint.Z_TRAVEL / 1000,
        "precision": lambda: work.PRECISION / 1000,
        "accuracy": lambda: "±.001, page 9",
        "resolution": lambda: hydrapoint.RESOLUTION,
        "positioning speed": lambda: hydrapoint.POSITIONING_SPEED,
        "feed least": lambda: feeds[0],
        "feed most": lambda: feeds[-1],
        "z feed least": lambda: z_feeds[0],
        "z feed most": lambda: z_feeds[-1],
        "feed tolerance": lambda: 100 * hydrapoint.FEED_TOLERANCE,
        "feeds": lambda: len(XY_FEED),
        "mill code": lambda: int(Preparatory.MILL),
        "read seconds": lambda: READ_SECONDS,
        "ratio of 30 degrees": lambda: 1 / tan(radians(30)),
        "closest ratio": lambda: ratios[0],
        "first ratio": lambda: XY_FEED[2] / XY_FEED[1],
        "second ratio": lambda: XY_FEED[4] / XY_FEED[3],
        "second ratio feeds": lambda: f"{XY_FEED[4]}/{XY_FEED[3]}",
        "slope": lambda: degrees(atan2(*reversed(slopes.RUN))),
        "diagonal": lambda: min(abs(r.angle) for r in _readings("45°") if r.angle),
        "deviation at 45 degrees": lambda: 100 * (degrees(atan2(1.2, 0.8)) / 45 - 1),
        "slope length": lambda: sum(side**2 for side in slopes.RUN) ** 0.5 / 1000,
        "slope blocks": lambda: len(chain.path("slope", milling=Milling("piece", feed_error=0.1))),
        "holes": lambda: len(chain.path("drill").holes),
        "hole places": lambda: "; ".join(
            f"{x / 1000:.3f}, {y / 1000:.3f}" for x, y, _ in chain.path("drill").holes
        ),
        "blocks before the holes": lambda: len(_drill()) - len(chain.path("drill").holes),
        "drill rows": lambda: re.sub(r", (\d+)$", r" and \1", ", ".join(row[:3] for row in _drill()[2:])),
        "drill speed": lambda: SPINDLE[chain.path("drill").steps[0].block.tool],
        "drill feed point": lambda: (chain.path("drill").steps[1].modes.feed_point or 0) / 1000,
        "drill depth": lambda: chain.path("drill").steps[1].modes.final_depth / 1000,
    } | {f"drill block {number}": lambda row=row: row for number, row in enumerate(_drill(), 1)}


@cache
def _drill() -> list[str]:
    return [" ".join(row) for row in tables.drilling().rows]


def _tape() -> _Table:
    """Chapters 2, 5 and 6: the tape, its tracks and the rows of a block."""
    ends = [sum(list(FIELDS.values())[: place + 1]) for place in range(len(FIELDS))]
    last = dict(zip(FIELDS, ends, strict=True))
    first = {name: end - FIELDS[name] + 1 for name, end in last.items()}
    formats = [int(width) for width in re.findall(r"I(\d)", _listing_line("C", "335"))]
    return {
        "tape width": lambda: picture.WIDTH / 1000,
        "tracks": lambda: len(frames.channels(0o377)) + 1,
        "code hole": lambda: picture.CODE_HOLE / 1000,
        "guide hole": lambda: picture.SPROCKET_HOLE / 1000,
        "row pitch": lambda: picture.PITCH / 1000,
        "track of guide holes": lambda: (
            1 + sum(picture.track(channel) < picture.SPROCKET_TRACK for channel in range(1, 9))
        ),
        "track of 8": lambda: frames.channels(eia.CODES["8"])[0] + 1,
        "track of end of block": lambda: frames.channels(eia.EOB)[0] + 1,
        "channel of end of block": lambda: frames.channels(eia.EOB)[0],
        "bits of a digit": lambda: max(eia.CODES[digit] & 0o17 for digit in "0123456789").bit_length(),
        "digit least": lambda: min(map(int, filter(str.isdigit, eia.CODES))),
        "digit most": lambda: max(map(int, filter(str.isdigit, eia.CODES))),
        "digit of tracks 1 and 3": lambda: int(eia.decode(bytes([eia.CODES["5"]]))),
        "digit of track 5": lambda: int(eia.decode(bytes([0o010]))),
        "rows": lambda: hydrapoint.ROWS,
        "digits": lambda: sum(FIELDS.values()),
        "sequence digits": lambda: FIELDS["sequence"],
        "x digits": lambda: FIELDS["x"],
        "y digits": lambda: FIELDS["y"],
        "places": lambda: -round(log2(hydrapoint.RESOLUTION) / log2(10)),
        "preparatory digit": lambda: first["preparatory"],
        "reserved digit": lambda: first["reserved"],
        "tool digit": lambda: first["tool"],
        "tool digit, last": lambda: last["tool"],
        "miscellaneous digit": lambda: first["miscellaneous"],
        "miscellaneous digit, last": lambda: last["miscellaneous"],
        "format sequence": lambda: formats[0],
        "format preparatory": lambda: formats[1],
        "format x": lambda: formats[2],
        "format y": lambda: formats[3],
        "format tool": lambda: formats[4],
        "format miscellaneous": lambda: formats[5],
    }


def _listing_line(appendix: str, number: str) -> str:
    text = facsimile.facsimile(appendix).replace("Ø", "0")
    return next(line for line in text.splitlines() if line.startswith(number))


def _computer() -> _Table:
    """Chapter 4: the computer's words and instructions, as the assembler has them."""
    assembled = _assembled("TAD 0")[0]
    dca = _assembled("DCA 277")[0]
    mnemonics = ("CLA", "CMA", "RAR", "IAC", "SZA", "HLT", "KSF", "KRB", "TSF", "TLS")
    references = ("AND", "TAD", "ISZ", "DCA", "JMS", "JMP")
    return {
        "words": lambda: _MEMORY,
        "bits": (_MEMORY - 1).bit_length,
        "last address": lambda: f"{_MEMORY - 1:o}",
        "last address, binary": lambda: re.sub("(...)(?!$)", r"\1 ", f"{_MEMORY - 1:b}"),
        "octal digits": lambda: len(f"{_MEMORY - 1:o}"),
        "operations": lambda: len({word >> 9 for word in range(_MEMORY)}),
        "operand digits": lambda: len(f"{assembled ^ 0o777:04o}") - 1,
        "operand of 3277": lambda: f"{dca & 0o777:o}",
        "DCA 77 of the page": lambda: f"{dca:o}",
        "line of 3277": lambda: f"{dca & 0o177:o}",
        "page": lambda: f"{_PAGE:o}",
        "OPR": lambda: f"{_assembled('CLA')[0] >> 9:o}",
        "IOT": lambda: f"{_assembled('KRB')[0] >> 9:o}",
        **{name: (lambda name=name: f"{_assembled(name)[0]:o}") for name in mnemonics},  # type: ignore[misc]
        **{name: (lambda name=name: f"{_assembled(f'{name} 0')[0] >> 9:o}") for name in references},  # type: ignore[misc]
    }


@cache
def _assembled(statement: str) -> tuple[int, ...]:
    return tuple(pal.assemble(f"*200\n\t{statement}\n$\n").words.values())


@cache
def _conversion() -> Mapping[str, int]:
    """Return the constants of Appendix B by their tags: those after the definitions' origin."""
    listing = facsimile.facsimile("B").replace("Ø", "0").partition("/DEFINITIONS:")[2]
    found = re.findall(r"^\d{4}  (\d{4})  (\w+),", listing, re.MULTILINE)
    return {tag: int(word, 8) for word, tag in found}


def _signed(word: int) -> str:
    return f"{word:o}" if word < _MEMORY // 2 else f"-{_MEMORY - word:o}"


def _words() -> _Table:
    """Chapter 5: characters as they come, masked, and reduced by Appendix B's constants."""
    constants = _conversion()

    def came(character: str) -> int:
        return ascii.encode(character)[0]

    def masked(character: str) -> int:
        return came(character) & constants["MASK"]

    def reduced(character: str) -> int:
        return (masked(character) + constants["M60"]) % _MEMORY

    digits = [_signed(reduced(digit)) for digit in "0123456789"]
    negatives = [_signed(constants[f"M{digit}"]) for digit in range(1, 10)]
    return {
        "MASK": lambda: f"{constants['MASK']:o}",
        "M60": lambda: _signed(constants["M60"]),
        "MCR": lambda: f"{constants['MCR']:o}",
        "MSP": lambda: f"{constants['MSP']:o}",
        "M3": lambda: _signed(constants["M3"]),
        "P3": lambda: f"{constants['P3']:o}",
        "M1 to M9": lambda: ", ".join([*negatives[:2], "...", *negatives[6:]]),
        "ascii 0 1 2": lambda: ", ".join(f"{came(d):o} ({d})" for d in "012"),
        "ascii 8 9": lambda: ", ".join(f"{came(d):o} ({d})" for d in "89"),
        "ascii 3": lambda: f"{came('3'):o}",
        "ascii CR": lambda: f"{came(chr(10)):o}",
        "ascii space": lambda: f"{came(' '):o}",
        "masked 0": lambda: f"{masked('0'):o} (0)",
        "masked 9": lambda: f"{masked('9'):o} (9)",
        "masked CR": lambda: f"{masked(chr(10)):o}",
        "masked space": lambda: f"{masked(' '):o}",
        "reduced digits": lambda: ", ".join([*digits[:3], "...", *digits[7:]]),
        "reduced 3": lambda: _signed(reduced("3")),
        "reduced CR": lambda: _signed(reduced("\n")),
        "reduced space": lambda: _signed(reduced(" ")),
        "example digit": lambda: int(eia.decode(bytes([constants["P3"]]))),
    }


def _parts() -> _Table:
    """Chapters 7 and 10: circle, ellipse, die and polynomial."""
    polynomial, passes = PARTS["polynomial"], tables.PASSES["die"]
    crossings = [0.0, _default("polynomial", "b"), _default("polynomial", "c")]
    axes = die.AXES["opening"]
    return {
        "tolerance": lambda: _default("circle", "tolerance") / 1000,
        "circle diameter": lambda: (2 * _default("circle", "radius") + 1000 * PARTS["circle"].cutter) / 1000,
        "circle centre diameter": lambda: 2 * _default("circle", "radius") / 1000,
        "cutter": lambda: PARTS["circle"].cutter,
        "circle depth": lambda: _depth(chain.path("circle")),
        "circle blocks": lambda: len(chain.path("circle")),
        "circle punch": lambda: _tape_minutes("circle"),
        "circle translate": lambda: _tape_minutes("circle"),
        "circle minutes": lambda: _minutes(chain.path("circle")),
        "circle worst": lambda: _worst("whole"),
        "circle diagonals": lambda: _worst("45°"),
        "circle pieces": lambda: len(_pieces("circle")),
        "circle pieces minutes": lambda: _minutes(_pieces("circle")),
        "division": lambda: hydrapoint.RESOLUTION,
        "magnification": lambda: int(re.findall(r"magnification (\d+)", work.polar_graphs()[0])[0]),
        "ellipse major": lambda: _default("ellipse", "major") / 1000,
        "ellipse minor": lambda: _default("ellipse", "minor") / 1000,
        "ellipse length": lambda: 2 * _default("ellipse", "major") / 1000,
        "ellipse height": lambda: 2 * _default("ellipse", "minor") / 1000,
        "ellipse blocks": lambda: len(chain.path("ellipse")),
        "ellipse translate": lambda: _tape_minutes("ellipse"),
        "ellipse minutes": lambda: _minutes(chain.path("ellipse")),
        "ellipse reading": lambda: chain.path("ellipse").contour.reading / 60,
        "ellipse pieces": lambda: len(_pieces("ellipse")),
        "ellipse pieces minutes": lambda: _minutes(_pieces("ellipse")),
        "chapter 10 cutting": lambda: 50 - 1000 * READ_SECONDS / 60,
        "chapter 10 efficiency": lambda: 100 * (50 - 1000 * READ_SECONDS / 60) / 50,
        "die block x": lambda: die.BLOCK[0] / 1000,
        "die block y": lambda: die.BLOCK[1] / 1000,
        "die block z": lambda: die.BLOCK[2] / 1000,
        "die length": lambda: 2 * axes[0] / 1000,
        "die height": lambda: 2 * axes[1] / 1000,
        "die programs": lambda: len(die.AXES),
        "die blocks": lambda: len(chain.path("die")),
        "die minutes": lambda: _minutes(chain.path("die")),
        "die total": lambda: passes * _minutes(chain.path("die")),
        "die pieces": lambda: len(_pieces("die")),
        "die pieces minutes": lambda: _minutes(_pieces("die")),
        "die pieces total": lambda: passes * _minutes(_pieces("die")),
        "polynomial a": lambda: _default("polynomial", "a"),
        "polynomial b": lambda: _default("polynomial", "b"),
        "polynomial c": lambda: _default("polynomial", "c"),
        "polynomial tolerance": lambda: polynomial.tolerance,
        "polynomial band": lambda: _band_height() / polynomial.tolerance / 1000,
        **{f"polynomial crossing {n}": (lambda x=x: x) for n, x in enumerate(crossings, 1)},  # type: ignore[misc]
        "polynomial blocks": lambda: len(chain.path("polynomial")),
        "polynomial frames": lambda: _tape_minutes("polynomial"),
        "polynomial minutes": lambda: _minutes(chain.path("polynomial")),
    }


def _elements() -> _Table:
    """Chapter 8: the fluidic element."""
    outline, channel = fluidic.outline(), fluidic.channel(0)
    corners = [place for segment in outline if isinstance(segment, fluidic.Slope) for place in segment]
    cutter = PARTS["fluidic"].cutter
    nozzle = min(u for u, v in corners if u > 0 and v <= fluidic.EXIT)

    def slopes_of(segments: tuple[fluidic.Segment, ...]) -> int:
        """Return how many straight lines lie at an angle to both axes."""
        lines = [segment for segment in segments if isinstance(segment, fluidic.Slope)]
        return sum(start[0] != end[0] and start[1] != end[1] for start, end in lines)

    arcs = sum(isinstance(segment, fluidic.Bend) for segment in outline)
    return {
        "element width": lambda: (2 * max(u for u, _ in corners) + cutter) / fluidic.SCALE,
        "element height": lambda: (max(v for _, v in corners) + cutter) / fluidic.SCALE,
        "element nozzle": lambda: (2 * nozzle + cutter) / fluidic.SCALE,
        "element scale": lambda: fluidic.SCALE,
        "element slopes": lambda: slopes_of(outline),
        "element arcs": lambda: arcs,
        "channel slopes": lambda: 2 * slopes_of(channel),
        "element routines": lambda: slopes_of(outline) + arcs,
        "main blocks": lambda: chain.printout("fluidic", program="main").count("\n"),
        "control blocks": lambda: chain.printout("fluidic", program="control").count("\n"),
        "element blocks": lambda: len(chain.path("fluidic")),
        "element minutes": lambda: _minutes(chain.path("fluidic")),
        "element hours": lambda: _minutes(chain.path("fluidic")) / 60,
        "element cutter": lambda: cutter,
        "element tolerance": lambda: PARTS["fluidic"].tolerance,
        "downstream": lambda: work.DOWNSTREAM,
        "talysurf division": lambda: talysurf.DIVISION / 1000,
        "slope roughness": _roughness,
    }


def _default(part: str, parameter: str) -> Any:
    """Return what a part program has for one of its constants."""
    return signature(PARTS[part].program()).parameters[parameter].default


@cache
def _pieces(part: str) -> nc.Path:
    return chain.path(part, milling=Milling("piece"))


def _minutes(path: nc.Path) -> float:
    return path.contour.total / 60


def _tape_minutes(part: str) -> float:
    """Return how long the ASCII tape takes at 10 frames a second."""
    return chain.printout(part).count("\n") * LINE_SECONDS / 60


def _depth(path: nc.Path) -> float:
    modes = path.steps[-1].modes
    return (modes.final_depth - (modes.feed_point or 0)) / 1000


@cache
def _readings(place: str) -> list[Reading]:
    """Return the readings of the closed circle's walls there."""
    readings = inspect(chain.path("circle", close=True)).readings
    return [reading for reading in readings if place in reading.place]


def _worst(place: str) -> float:
    """Return the greatest trough to peak there, inches."""
    return max(reading.trough_to_peak for reading in _readings(place)) / 1000


def _band_height() -> float:
    """Return the height of the polynomial's band, thousandths."""
    part = PARTS["polynomial"]
    curve = nominal(**part.nominal)
    assert curve
    stations = curve.stations(2)
    low, high = (curve.limit(stations, side * 1000 * part.tolerance) for side in (-1, 1))
    return float(high[0, 1] - low[0, 1])


def _roughness() -> float:
    """Return the trough to peak of the stretch in Figure 8.5, inches."""
    found = re.search(r"outer wall, trough to peak ([.\d]+)", work.sloped_surface())
    assert found
    return float(found[1])
