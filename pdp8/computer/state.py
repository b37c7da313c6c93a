"""A machine's whole state as a text that a person can read, and back.

A run saved in the middle goes on as if nothing had happened.

    pdp8 state 1
    processor.lac 00017          words are octal
    processor.clock 1234567      flags, counts and ticks of 0.05 us are decimal; "never" is no time
    core 0200 7200 1205 ...      eight words a line; words not named are 0000
    teletype.reader.tape 215 ... frames are octal
    end                          what comes before is whole

Breakpoints and observers are not part of the machine, and not saved.
"""

from collections.abc import Iterator
from typing import NamedTuple

from pdp8.computer.bus import AT_ONCE, NEVER
from pdp8.computer.machine import Machine
from tapes.errors import WorkError

_TITLE = "pdp8 state 1"
_END = "end"


class Part(NamedTuple):
    """A part of the machine: where it is, its words (octal), numbers (decimal), tapes (octal frames)."""

    path: str
    words: str = ""
    numbers: str = ""
    tapes: str = ""


_CONSOLE = (
    Part(
        "processor",
        "lac pc ma mb ir sr",
        "state next run ion ion_delayed mem_prot sing_step protect clock started instructions",
    ),
    Part("teletype.receiver", "buffer frame", "flag now reader_run start stage free"),
    Part("teletype.reader", "", "position loaded on", "tape"),
    Part("teletype.keyboard", tapes="waiting"),
    Part("teletype.transmitter", "register selected", "flag start shifts free unit printed"),
    Part("teletype.printer", tapes="frames"),
    Part("teletype.punch", "", "on", "frames"),
)
_HIGH_SPEED = (
    Part("highspeed.reader_control", "buffer", "flag due fetching"),
    Part("highspeed.reader", "", "position loaded on", "tape"),
    Part("highspeed.punch_control", "buffer", "flag due punched"),
    Part("highspeed.punch", "", "on", "frames"),
)
_MOST = {"lac": 0o17777, "register": 0o777, "ir": 7, "buffer": 0o377, "frame": 0o377, "selected": 0o377}
_MOST |= {"state": 2, "next": 3, "stage": 2, "unit": 8, "shifts": 1 << 30}
_MOST |= dict.fromkeys(("run", "ion", "ion_delayed", "mem_prot", "sing_step", "protect", "on", "loaded"), 1)
_MOST |= dict.fromkeys(("flag", "reader_run", "printed", "fetching", "punched"), 1)
_LATEST = 1 << 60
_ROW = 8
_FRAMES = 24


class StateError(WorkError):
    """A text that is no saved state; the message names the line."""


def save(machine: Machine) -> str:
    """Return the state of `machine` as text."""
    machine.bus.advance(machine.processor.clock)
    return "\n".join([_TITLE, *_registers(machine), *_core(machine), _END, ""])


def _registers(machine: Machine) -> Iterator[str]:
    parts = _CONSOLE + (_HIGH_SPEED if machine.highspeed.fitted else ())
    for part in parts:
        for name in part.words.split():
            yield f"{part.path}.{name} {_get(machine, part.path, name):04o}"
        for name in part.numbers.split():
            number = int(_get(machine, part.path, name))
            yield f"{part.path}.{name} {'never' if number == NEVER else number}"
        for name in part.tapes.split():
            frames: bytes = _get(machine, part.path, name)
            for at in range(0, len(frames), _FRAMES):
                row = frames[at : at + _FRAMES]
                yield f"{part.path}.{name} {' '.join(f'{frame:03o}' for frame in row)}"


def _core(machine: Machine) -> Iterator[str]:
    core = list(machine.core)
    for address in range(0, len(core), _ROW):
        row = core[address : address + _ROW]
        if any(row):
            yield f"core {address:04o} {' '.join(f'{word:04o}' for word in row)}"


def restore(text: str) -> Machine:
    """Return the machine whose state `text` is. Raises StateError."""
    title, *lines = text.rstrip().splitlines() or [""]
    if title.strip() != _TITLE:
        raise StateError(f"line 1: a saved state begins with {_TITLE!r}")
    if not lines or lines.pop().strip() != _END:
        raise StateError(f"the saved state is cut short: its last line is not {_END!r}")
    machine = Machine(highspeed=any(line.startswith("highspeed.") for line in lines))
    known = _known(machine)
    tapes: dict[str, bytearray] = {}
    for number, line in enumerate(lines, 2):
        if not line.strip() or line.startswith("#"):
            continue
        try:
            _take(machine, line.split(), known, tapes)
        except (ValueError, IndexError, KeyError) as error:
            raise StateError(f"line {number}: {_reason(error)}: {line.strip()[:60]}") from error
    for path, frames in tapes.items():
        part, name = path.rsplit(".", 1)
        old = _get(machine, part, name)
        _set(machine, part, name, bytes(frames) if isinstance(old, bytes) else frames)
    _check_readers(machine)
    machine.teletype.receiver.plan()
    machine.teletype.transmitter.plan()
    return machine


def _take(machine: Machine, fields: list[str], known: dict[str, str], tapes: dict[str, bytearray]) -> None:
    """Set what one line says."""
    name, *values = fields
    if name == "core":
        address = int(values[0], 8)
        for offset, word in enumerate(values[1:]):
            machine.core[address + offset] = _limited(int(word, 8), 0o7777)
        return
    part, attribute = name.rsplit(".", 1) if "." in name else ("", name)
    kind = known[name]
    if kind == "tape":
        tapes.setdefault(name, bytearray()).extend(_limited(int(frame, 8), 0o377) for frame in values)
        return
    (value,) = values
    if kind == "word":
        _set(machine, part, attribute, _limited(int(value, 8), _MOST.get(attribute, 0o7777)))
    else:
        number = _time(value) if attribute == "due" else _limited(int(value), _MOST.get(attribute, _LATEST))
        old = _get(machine, part, attribute)
        _set(machine, part, attribute, bool(number) if isinstance(old, bool) else number)


def _time(value: str) -> int:
    """Return the tick of an event: AT_ONCE, a number or never."""
    return NEVER if value == "never" else _limited(int(value) - AT_ONCE, _LATEST) + AT_ONCE


def _limited(value: int, most: int) -> int:
    if not 0 <= value <= most:
        raise ValueError(f"{value:o} is out of range")
    return value


def _reason(error: Exception) -> str:
    return "no part of a PDP-8/L" if isinstance(error, KeyError) else "not understood"


def _known(machine: Machine) -> dict[str, str]:
    """Return what each name of a line is: a word, a number or a tape."""
    kinds: dict[str, str] = {}
    for part in _CONSOLE + (_HIGH_SPEED if machine.highspeed.fitted else ()):
        for kind, names in (("word", part.words), ("number", part.numbers), ("tape", part.tapes)):
            kinds |= {f"{part.path}.{name}": kind for name in names.split()}
    return kinds


def _check_readers(machine: Machine) -> None:
    for reader in (machine.teletype.reader, machine.highspeed.reader):
        if not 0 <= reader.position <= len(reader.tape):
            raise StateError(f"the reader stands at frame {reader.position} of a tape of {len(reader.tape)}")


def _get(machine: Machine, path: str, name: str):  # type: ignore[no-untyped-def]
    part: object = machine
    for step in path.split("."):
        part = getattr(part, step)
    return getattr(part, name)


def _set(machine: Machine, path: str, name: str, value: object) -> None:
    part: object = machine
    for step in path.split("."):
        part = getattr(part, step)
    setattr(part, name, value)
