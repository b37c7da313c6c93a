"""Saved states of version 1: lines of text, read into what version 2 has.

    pdp8 state 1
    processor.lac 00017          words are octal
    processor.clock 1234567      flags, counts and ticks are decimal; "never" is no time
    core 0200 7200 1205 ...      eight words a line
    teletype.reader.tape 215 ... frames are octal
    end                          what comes before is whole

They lack what a reader, a key or a loop was waiting for; that is found again as the machine runs.
"""

from typing import Any

TITLE = "pdp8 state 1"
_END = "end"
_OCTAL = ("lac", "pc", "ma", "mb", "ir", "sr", "buffer", "frame", "register", "selected")
_TAPES = ("tape", "waiting", "frames")
_PLACES = {
    "processor": ("processor",),
    "teletype.receiver": ("devices", "03"),
    "teletype.reader": ("devices", "03", "reader"),
    "teletype.keyboard": ("devices", "03", "keyboard"),
    "teletype.transmitter": ("devices", "04"),
    "teletype.printer": ("devices", "04", "printer"),
    "teletype.punch": ("devices", "04", "punch"),
    "highspeed.reader_control": ("devices", "01"),
    "highspeed.reader": ("devices", "01", "reader"),
    "highspeed.punch_control": ("devices", "02"),
    "highspeed.punch": ("devices", "02", "punch"),
}


def modern(text: str) -> dict[str, Any]:
    """Return a state of version 1 as the object of version 2. Raises ValueError naming the line."""
    lines = text.rstrip().splitlines()
    if lines[-1].strip() != _END:
        raise ValueError(f"its last line is not {_END!r}")
    state: dict[str, Any] = {"format": "pdp8 state", "version": 2, "core": {}, "devices": {}}
    for number, line in enumerate(lines[1:-1], 2):
        if line.strip() and not line.startswith("#"):
            try:
                _take(state, *line.split())
            except (TypeError, ValueError, KeyError) as error:
                raise ValueError(f"line {number}: not part of a state: {line.strip()[:60]}") from error
    return state


def _take(state: dict[str, Any], name: str, *values: str) -> None:
    """Put what one line says into `state`."""
    if name == "core":
        address, *words = values
        state["core"][address] = " ".join(words)
        return
    path, field = name.rsplit(".", 1)
    part = state
    for step in _PLACES[path]:
        part = part.setdefault(step, {})
    if field in _TAPES:
        part.setdefault(field, []).append(" ".join(values))
        return
    (value,) = values
    part[field] = value if field in _OCTAL or value == "never" else int(value)
