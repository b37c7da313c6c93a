"""Our value for each number of the thesis: a constant of what runs here, or computed from tapes and paths.

A measure has a name, which numbers.txt uses, and names its inputs (`inputs`). It is a number, or of octal
words, lists and blocks a string; "227 or more" is a proved least. Those that take long are kept in
measured.json: `make evidence` computes them again, a test compares each.
"""

import json
import re
from collections.abc import Callable, Iterable, Mapping
from functools import cache
from inspect import signature
from math import atan2, degrees, log2, radians, tan
from typing import Any, Final, NamedTuple

import nc
from nc import talysurf
from nc.curves import curve
from nc.inspection import Reading, against
from nc.machine import READ_SECONDS
from pdp8.replay.implied import LINE_SECONDS
from pdp8.thesis import chain, evidence, slopes, tables, work
from pdp8.thesis.catalogue import find
from pdp8.thesis.inputs import ITSELF
from pdp8.thesis.table import text_of
from programs import die, fluidic
from programs.parts import PARTS
from tapes import ascii, eia, frames, hydrapoint, picture
from tapes.hydrapoint import FIELDS, SPINDLE, XY_FEED, Z_FEED, Preparatory

Measure = float | str

_MEMORY: Final = 1 << 12
_PAGE: Final = 0o200
KEPT: Final = "measured.json"


_Value = Measure | Callable[[], Measure]
"""A measure, or what computes it if that takes long."""


class Made(NamedTuple):
    """Our value of a number, and the names of its inputs."""

    value: _Value
    inputs: tuple[str, ...]


_Groups = Mapping[str, Mapping[str, _Value]]
"""Measures by the inputs that they are made from, whose names are separated by commas."""


def measure(name: str) -> Measure:
    """Compute a measure by its name."""
    found = _table()[name].value
    return found() if callable(found) else found


def value(name: str) -> Measure:
    """Return a measure by name; slow ones are read from measured.json."""
    return _kept()[name] if callable(_table()[name].value) else measure(name)


def computed(names: Iterable[str]) -> dict[str, Measure]:
    """Compute the slow ones of the named measures."""
    return {name: measure(name) for name in names if name and callable(_table()[name].value)}


@cache
def _kept() -> dict[str, Measure]:
    kept: dict[str, Measure] = json.loads(text_of(KEPT))
    return kept


def inputs(name: str) -> tuple[str, ...]:
    """Return what a measure is made from: names of `inputs.INPUTS`."""
    return _table()[name].inputs


@cache
def _table() -> dict[str, Made]:
    groups = [_machine(), _tape(), _computer(), _words(), _parts(), *map(_of_part, _CONTOUR), _elements()]
    return {
        name: Made(value, tuple(made_from.split(", ")))
        for group in groups
        for made_from, values in group.items()
        for name, value in values.items()
    }


def _machine() -> _Groups:
    """Chapters 2 and 3: the Hydra-Point, its feeds, the drilling program."""
    feeds, z_feeds = sorted(XY_FEED.values()), sorted(Z_FEED.values())
    wanted = 1 / tan(radians(30))
    fast, slow = 1 + hydrapoint.FEED_TOLERANCE, 1 - hydrapoint.FEED_TOLERANCE
    return {
        ITSELF: {
            "axes": len(nc.path.Position._fields),
            "tools": len(hydrapoint.CAROUSEL),
            "travel x": hydrapoint.X_TRAVEL / 1000,
            "travel y": hydrapoint.Y_TRAVEL / 1000,
            "travel z": hydrapoint.Z_TRAVEL / 1000,
            "precision": lambda: work.PRECISION / 1000,
            "accuracy": "±.001, page 9",
            "resolution": hydrapoint.RESOLUTION,
            "positioning speed": hydrapoint.POSITIONING_SPEED,
            "feed tolerance": 100 * hydrapoint.FEED_TOLERANCE,
            "mill code": int(Preparatory.MILL),
            "read seconds": READ_SECONDS,
            "second ratio feeds": f"{XY_FEED[4]}/{XY_FEED[3]}",
            "slope": degrees(atan2(*reversed(slopes.RUN))),
            "slope length": sum(side**2 for side in slopes.RUN) ** 0.5 / 1000,
            "diagonal": lambda: min(abs(r.angle) for r in _readings("45°") if r.angle),
            "hole places": lambda: "; ".join(
                f"{x / 1000:.3f}, {y / 1000:.3f}" for x, y, _ in chain.path("drill").holes
            ),
            "drill feed point": lambda: (chain.path("drill").steps[1].modes.feed_point or 0) / 1000,
            "drill depth": lambda: chain.path("drill").steps[1].modes.final_depth / 1000,
        },
        "Table 2.4": {
            "feed least": feeds[0],
            "feed most": feeds[-1],
            "z feed least": z_feeds[0],
            "z feed most": z_feeds[-1],
            "feeds": len(XY_FEED),
            "first ratio": XY_FEED[2] / XY_FEED[1],
            "second ratio": XY_FEED[4] / XY_FEED[3],
        },
        "Chapter 3": {"ratio of 30 degrees": wanted},
        "Chapter 3, Table 2.4": {
            "closest ratio": min(
                (one / two for one in feeds for two in feeds), key=lambda r: abs(r - wanted)
            ),
            "holes": lambda: len(chain.path("drill").holes),
            "blocks before the holes": lambda: len(_drill()) - len(chain.path("drill").holes),
            "drill rows": lambda: re.sub(r", (\d+)$", r" and \1", ", ".join(row[:3] for row in _drill()[2:])),
            "drill speed": lambda: SPINDLE[chain.path("drill").steps[0].block.tool],
            **{f"drill block {number}": row for number, row in enumerate(_drill(), 1)},
        },
        "±20 %": {"deviation at 45 degrees": 100 * (degrees(atan2(fast, slow)) / 45 - 1)},
        "Chapter 3, ±.005, ±20 %, codes 01 to 05": {"slope blocks": lambda: tables.fewest("slope")},
    }


@cache
def _drill() -> list[str]:
    return [" ".join(row) for row in tables.drilling().rows]


def _tape() -> _Groups:
    """Chapters 2, 5 and 6: the tape, its tracks and the rows of a block."""
    ends = [sum(list(FIELDS.values())[: place + 1]) for place in range(len(FIELDS))]
    last = dict(zip(FIELDS, ends, strict=True))
    first = {name: end - FIELDS[name] + 1 for name, end in last.items()}
    printed = [name for name in FIELDS if name != "reserved"]
    line_335 = re.search("^335.*", _listing("circle.for"), re.MULTILINE)
    formats = [int(width) for width in re.findall(r"I(\d)", line_335[0] if line_335 else "")]
    return {
        ITSELF: {
            "tape width": picture.WIDTH / 1000,
            "code hole": picture.CODE_HOLE / 1000,
            "guide hole": picture.SPROCKET_HOLE / 1000,
            "row pitch": picture.PITCH / 1000,
            "rows": hydrapoint.ROWS,
            **{f"{name} digits": width for name, width in FIELDS.items()},
        },
        "EIA": {
            "tracks": len(frames.channels(0o377)) + 1,
            "track of guide holes": 1 + sum(picture.track(at) < picture.SPROCKET_TRACK for at in range(1, 9)),
            "track of 8": frames.channels(eia.CODES["8"])[0] + 1,
            "track of end of block": frames.channels(eia.EOB)[0] + 1,
            "channel of end of block": frames.channels(eia.EOB)[0],
            "bits of a digit": max(eia.CODES[digit] & 0o17 for digit in "0123456789").bit_length(),
            "digit least": min(map(int, filter(str.isdigit, eia.CODES))),
            "digit most": max(map(int, filter(str.isdigit, eia.CODES))),
            "digit of tracks 1 and 3": int(eia.decode(bytes([eia.CODES["5"]]))),
            "digit of track 5": int(eia.decode(bytes([0o010]))),
        },
        "Chapter 2": {
            "digits": sum(FIELDS.values()),
            "places": -round(log2(hydrapoint.RESOLUTION) / log2(10)),
            **{f"{name} digit": digit for name, digit in first.items()},
            **{f"{name} digit, last": digit for name, digit in last.items()},
        },
        "Appendix C": {f"format {name}": width for name, width in zip(printed, formats, strict=True)},
    }


def _listing(artefact: str) -> str:
    return "\n".join(row.ours for row in evidence.table(artefact))


def _computer() -> _Groups:
    """Chapter 4: the computer's words and instructions, as the assembler has them."""
    word = tables.word
    dca = word("DCA 277")
    mnemonics = ("CLA", "CMA", "RAR", "IAC", "SZA", "HLT", "KSF", "KRB", "TSF", "TLS")
    references = ("AND", "TAD", "ISZ", "DCA", "JMS", "JMP")
    return {
        ITSELF: {"words": _MEMORY, "page": f"{_PAGE:o}"},
        "4096": {
            "words, about": _MEMORY,
            "bits": (_MEMORY - 1).bit_length(),
            "last address": f"{_MEMORY - 1:o}",
            "last address, binary": re.sub("(...)(?!$)", r"\1 ", f"{_MEMORY - 1:b}"),
            "octal digits": len(f"{_MEMORY - 1:o}"),
            "operations": len({word >> 9 for word in range(_MEMORY)}),
        },
        "PAL III": {
            "operand digits": len(f"{word('TAD 0') ^ 0o777:04o}") - 1,
            "operand of 3277": f"{dca & 0o777:o}",
            "DCA 77 of the page": f"{dca:o}",
            "line of 3277": f"{dca & 0o177:o}",
            "OPR": f"{word('CLA') >> 9:o}",
            "IOT": f"{word('KRB') >> 9:o}",
            **{name: f"{word(name):o}" for name in mnemonics},
            **{name: f"{word(f'{name} 0') >> 9:o}" for name in references},
        },
    }


def _conversion() -> Mapping[str, int]:
    """Return the constants of Appendix B by their tags: those after the definitions' origin."""
    definitions = _listing("eia.pal").partition("/DEFINITIONS:")[2]
    found = re.findall(r"^\d{4} (\d{4}) (\w+),", definitions, re.MULTILINE)
    return {tag: int(word, 8) for word, tag in found}


def _signed(word: int) -> str:
    return f"{word:o}" if word < _MEMORY // 2 else f"-{_MEMORY - word:o}"


def _words() -> _Groups:
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
        "Appendix B": {
            "MASK": f"{constants['MASK']:o}",
            "M60": _signed(constants["M60"]),
            "MCR": f"{constants['MCR']:o}",
            "MSP": f"{constants['MSP']:o}",
            "M3": _signed(constants["M3"]),
            "P3": f"{constants['P3']:o}",
            "M1 to M9": ", ".join([*negatives[:2], "...", *negatives[6:]]),
            "example digit": int(eia.decode(bytes([constants["P3"]]))),
        },
        ITSELF: {
            "ascii 0 1 2": ", ".join(f"{came(d):o} ({d})" for d in "012"),
            "ascii 8 9": ", ".join(f"{came(d):o} ({d})" for d in "89"),
            "ascii 3": f"{came('3'):o}",
            "ascii CR": f"{came(chr(10)):o}",
            "ascii space": f"{came(' '):o}",
        },
        "ASCII, Appendix B": {
            "masked 0": f"{masked('0'):o} (0)",
            "masked 9": f"{masked('9'):o} (9)",
            "masked CR": f"{masked(chr(10)):o}",
            "masked space": f"{masked(' '):o}",
            "reduced digits": ", ".join([*digits[:3], "...", *digits[7:]]),
            "reduced 3": _signed(reduced("3")),
            "reduced CR": _signed(reduced("\n")),
            "reduced space": _signed(reduced(" ")),
        },
    }


_CONTOUR: Final = {
    "circle": "Appendix C",
    "ellipse": "Appendix D",
    "die": "Appendix D, die's path",
    "polynomial": "±.01, range",
    "fluidic": "Chapter 8, outline",
}
"""What the contour of a part is made from."""


def _of_part(part: str) -> _Groups:
    """A part's blocks and times in the thesis: its tape, and its machining by both techniques."""
    contour, pieces = _CONTOUR[part], f"{_CONTOUR[part]}, ±20 %, codes 01 to 05"
    return {
        contour: {f"{part} blocks": lambda: len(chain.path(part))},
        f"{contour}, 2 s, Table 2.4": {f"{part} minutes": lambda: _minutes(chain.path(part))},
        f"{contour}, 6 rubouts": {
            f"{part} tape minutes": lambda: chain.printout(part).count("\n") * LINE_SECONDS / 60
        },
        pieces: {f"{part} pieces": lambda: f"{tables.fewest(part)} or more"},
        f"{pieces}, our stops, 2 s": {f"{part} pieces minutes": lambda: _minutes(chain.pieces(part))},
    }


def _parts() -> _Groups:
    """Chapters 7 and 10: circle, ellipse, die and polynomial."""
    polynomial, passes, axes = chain.nominal("polynomial"), tables.PASSES["die"], die.AXES["opening"]
    crossings = [0.0, _default("polynomial", "b"), _default("polynomial", "c")]
    legible = re.search(r"^355 ARS=(\d+)", _listing("circle.for"), re.MULTILINE)
    centre = (int(legible[1]) if legible else 0) + _default("circle", "tolerance")
    return {
        ITSELF: {
            "tolerance": _default("circle", "tolerance") / 1000,
            "cutter": PARTS["circle"].cutter,
            "division": lambda: float(re.findall(r"division ([.\d]+) in", work.polar_graphs()[0])[0]),
            "magnification": lambda: int(re.findall(r"magnification (\d+)", work.polar_graphs()[0])[0]),
            "ellipse major": _default("ellipse", "major") / 1000,
            "ellipse minor": _default("ellipse", "minor") / 1000,
            **{f"die block {axis}": side / 1000 for axis, side in zip("xyz", die.BLOCK, strict=True)},
            "die length": 2 * axes[0] / 1000,
            "die height": 2 * axes[1] / 1000,
            "die programs": len(die.AXES),
            **{f"polynomial {name}": _default("polynomial", name) for name in "abc"},
            "polynomial tolerance": polynomial.tolerance,
            **{f"polynomial crossing {number}": x for number, x in enumerate(crossings, 1)},
        },
        "Appendix C, ±.005": {"circle centre diameter": 2 * centre / 1000},
        "Appendix C, ±.005, cutter": {
            "circle diameter": (2 * centre + 1000 * PARTS["circle"].cutter) / 1000,
            "circle worst": lambda: max(r.trough_to_peak for r in _readings("Y")) / 1000,
            "circle diagonals": lambda: max(r.trough_to_peak for r in _readings("45°")) / 1000,
        },
        "Appendix D": {
            "ellipse length": 2 * _default("ellipse", "major") / 1000,
            "ellipse height": 2 * _default("ellipse", "minor") / 1000,
        },
        "Appendix D, 2 s, Table 2.4": {
            "ellipse reading": lambda: chain.path("ellipse").contour.reading / 60,
            "ellipse cutting": lambda: chain.path("ellipse").contour.milling / 60,
            "ellipse efficiency": lambda: 100 * chain.path("ellipse").contour.efficiency,
        },
        "±.01": {"polynomial band": lambda: _band_height() / polynomial.tolerance / 1000},
        "Appendix D, die's path, 2 s, 5 passes": {"die total": lambda: passes * _minutes(chain.path("die"))},
        "Appendix D, die's path, ±20 %, codes 01 to 05, our stops, 2 s, 5 passes": {
            "die pieces total": lambda: passes * _minutes(chain.pieces("die"))
        },
    }


def _elements() -> _Groups:
    """Chapter 8: the fluidic element."""
    outline, channel = fluidic.outline(), fluidic.channel(0)
    corners = [place for segment in outline if isinstance(segment, fluidic.Slope) for place in segment]
    cutter = PARTS["fluidic"].cutter
    nozzle = min(u for u, v in corners if u > 0 and v <= fluidic.EXIT)
    oblique, arcs = len(work.oblique(outline)), sum(isinstance(segment, fluidic.Bend) for segment in outline)
    return {
        ITSELF: {
            "element scale": fluidic.SCALE,
            "element slopes": oblique,
            "element arcs": arcs,
            "channel slopes": 2 * len(work.oblique(channel)),
            "element cutter": cutter,
            "element tolerance": chain.nominal("fluidic").tolerance,
            "downstream": find("8.3").given["control"],
            "talysurf division": talysurf.DIVISION / 1000,
        },
        "Chapter 8": {"element routines": oblique + arcs},
        "Chapter 8, outline": {
            "element nozzle": (2 * nozzle + cutter) / fluidic.SCALE,
            "element width": (2 * max(u for u, _ in corners) + cutter) / fluidic.SCALE,
            "element height": (max(v for _, v in corners) + cutter) / fluidic.SCALE,
            "main blocks": lambda: chain.printout("fluidic", program="main").count("\n"),
            "control blocks": lambda: chain.printout("fluidic", program="control").count("\n"),
            "element hours": lambda: _minutes(chain.path("fluidic")) / 60,
            "slope roughness": _roughness,
        },
    }


def _default(part: str, parameter: str) -> Any:
    """Return the default of a part program's constant."""
    return signature(PARTS[part].program()).parameters[parameter].default


def _minutes(path: nc.Path) -> float:
    return path.contour.total / 60


@cache
def _readings(place: str) -> list[Reading]:
    """Return the readings of the circle's walls there, as its listing has it."""
    readings = against(chain.path("circle"), chain.nominal("circle")).readings
    return [reading for reading in readings if place in reading.place]


def _band_height() -> float:
    """Return the height of the polynomial's band, thousandths."""
    nominal = chain.nominal("polynomial")
    polynomial = curve(nominal, 0)
    stations = polynomial.stations(2)
    low, high = (polynomial.limit(stations, side * 1000 * nominal.tolerance) for side in (-1, 1))
    return float(high[0, 1] - low[0, 1])


def _roughness() -> float:
    """Return the trough to peak of the stretch in Figure 8.5, inches."""
    found = re.search(r"outer wall, trough to peak ([.\d]+)", work.sloped_surface())
    assert found
    return float(found[1])
