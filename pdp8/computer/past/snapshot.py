"""A machine's state as values in memory, taken and put back in some microseconds.

What is taken is what a saved state holds (see fields.py), under names such as `processor pc`, `03 reader
position` and `core`; and `left`, the registers to be set back for the next run to continue the last.
"""

from array import array
from collections.abc import Iterator, Mapping
from operator import attrgetter
from typing import TYPE_CHECKING, Any, cast

from pdp8.computer.hardware.fields import CORE, FRAMES, PART

if TYPE_CHECKING:
    from pdp8.computer.machine import Machine

Values = dict[str, object]
_VALUE = 100
"""About what a value that is no tape takes, in bytes."""


class Parts:
    """The parts of a machine with their values, looked up once: to take snapshots of it quickly."""

    def __init__(self, machine: "Machine") -> None:
        self._machine = machine
        self._plain: list[tuple[Any, tuple[str, ...], attrgetter[Any]]] = []
        self._copied: list[tuple[str, Any, str, int | str]] = []
        for path, part, fields in _parts(machine):
            plain = [name for name, kind in fields.items() if kind not in (FRAMES, CORE)]
            if len(plain) > 1:
                self._plain.append((part, tuple(f"{path} {name}" for name in plain), attrgetter(*plain)))
            for name, kind in fields.items():
                if kind in (FRAMES, CORE) or len(plain) == 1:
                    self._copied.append((f"{path} {name}", part, name, kind))

    def take(self) -> Values:
        """Return all values of the machine at its clock."""
        machine = self._machine
        machine.bus.advance(machine.processor.clock)
        core = array("H", machine.processor.core).tobytes()
        values: Values = {"core": core, "left": machine.left()}
        for part, keys, values_of in self._plain:
            values.update(zip(keys, values_of(part), strict=True))
        for key, part, name, kind in self._copied:
            value = getattr(part, name)
            if kind == FRAMES:
                value = bytes(value)
            elif kind == CORE and value is not None:
                value = value.tobytes()
            values[key] = value
        return values


def take(machine: "Machine") -> Values:
    """Return all values of the machine at its clock."""
    return Parts(machine).take()


def changed(before: Mapping[str, object], now: Mapping[str, object]) -> Values:
    """Return the values of `now` that were others `before`."""
    return {name: value for name, value in now.items() if before.get(name) != value}


def put(machine: "Machine", values: Mapping[str, object]) -> None:
    """Set the machine to `values`, all or some."""
    if "core" in values:
        _put_core(machine, values["core"])
    for path, part, fields in _parts(machine):
        for name, kind in fields.items():
            key = f"{path} {name}"
            if key in values:
                _put(part, name, kind, values[key])
    if "left" in values:
        machine.leave(cast("dict[str, int] | None", values["left"]))


def size(values: Mapping[str, object]) -> int:
    """Return about how many bytes the values take."""
    return sum(_VALUE + (len(value) if isinstance(value, bytes) else 0) for value in values.values())


def _parts(machine: "Machine") -> Iterator[tuple[str, Any, Mapping[str, int | str]]]:
    """Yield the path, the object and the fields of each part that has values of its own."""
    roots: list[tuple[str, Any]] = [
        ("processor", machine.processor),
        ("bus", machine.bus),
        ("waiting", machine.waiting),
        *((f"{device.code:02o}", device) for device in machine.bus),
    ]
    for path, part in roots:
        own = {name: kind for name, kind in part.fields.items() if kind != PART}
        yield path, part, own
        for name in part.fields.keys() - own.keys():
            inner = getattr(part, name)
            yield f"{path} {name}", inner, inner.fields


def _put(part: Any, name: str, kind: int | str, value: Any) -> None:
    if kind == FRAMES and isinstance(getattr(part, name), bytearray):
        getattr(part, name)[:] = value  # others hold the same bytearray
    elif kind == CORE and value is not None:
        setattr(part, name, array("H", value))
    else:
        setattr(part, name, value)


def _put_core(machine: "Machine", content: Any) -> None:
    words, core = array("H", content), machine.processor.core
    if words != core:
        for address, word in enumerate(words):
            if core[address] != word:
                machine.processor.deposit(address, word)
