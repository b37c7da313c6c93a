"""What launch.json says, and the machine that it makes ready.

"program": "eia.pal"      a PAL source, BIN or RIM tape, or a bundled name; or the source tapes of one, a list
"start": "0200"           an octal address, or a symbol
"sr": "0000"              the switch register
"reader": ["in.asc"]      tapes for the Teletype's reader, one after the other
"punch": "out.eia"        where what was punched goes, each time that the machine stops
"highspeed": true         fits the PC8/L
"device": ["clock.py:Clock"]      fits devices of your own
"memory": "8k"            fits the MC8/L
"dectape": ["0=ps8.tu56"]       fits a DECtape, and mounts reels
"boot": true              loads the program from cold: RIM, BIN, tape
"stopOnEntry": true       stops before the first instruction
"commands": ["set hands 0"]     lines for the monitor, before START
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Any, Self

from pdp8 import fitting, reels, shelf
from pdp8.computer.hardware.extension import MEMORY
from pdp8.computer.machine import Machine
from pdp8.computer.use.program import Program
from pdp8.monitor import rack, tapes
from pdp8.monitor.commands import do
from pdp8.monitor.debugging import set_
from pdp8.monitor.prompt import Monitor
from tapes.errors import WorkError


@dataclass(frozen=True)
class Launch:
    """A configuration of launch.json."""

    program: Sequence[str] = ()
    start: str = "0200"
    sr: str = "0000"
    reader: Sequence[str] = ()
    punch: str = ""
    highspeed: bool = False
    device: Sequence[str] = ()
    memory: str = "4k"
    dectape: Sequence[str] = ()
    boot: bool = False
    stopOnEntry: bool = False
    noDebug: bool = False
    commands: Sequence[str] = ()

    @classmethod
    def of(cls, arguments: Mapping[str, Any]) -> Self:
        """Return what the editor sent. Raises WorkError; what other debuggers know is passed over."""
        given = {
            field.name: _checked(field.name, arguments[field.name], field.default)
            for field in fields(cls)
            if arguments.get(field.name) is not None
        }
        made = cls(**given)
        made._check_files()
        return made

    def _check_files(self) -> None:
        if not self.program:
            raise WorkError("program: the name of a PAL source or of a tape expected")
        if "-" in (*self.program, self.punch, *self.reader):
            raise WorkError("-: standard input and output are the debugger's own; name a file")
        if self.punch:
            shelf.check_writable(self.punch)
            shelf.check_kind(self.punch, "tape")
            for name in (*self.program, *self.reader):
                if shelf.identity(self.punch) == shelf.identity(shelf.find(name)):
                    raise WorkError(f"punch: {self.punch} is read too; name another file")

    def ready(self, say: Callable[[str], object]) -> tuple[Monitor, Program]:
        """Return a machine loaded and started, and its program; `say` takes messages. Raises WorkError."""
        memory = MEMORY.get(self.memory.lower())
        if memory is None:
            raise WorkError(f"memory: {self.memory}; {', '.join(MEMORY)} are allowed")
        found = shelf.programs(self.program, memory)
        machine = Machine(memory=memory)
        fitting.fit(machine, fitting.devices(["highspeed", *self.device] if self.highspeed else self.device))
        monitor = Monitor(say, machine, found.listing)
        for device, name in map(reels.assignment, self.dectape):
            rack.attach(monitor, device, name)
        if self.boot and len(self.program) > 1:
            raise WorkError("boot: the program is one tape; assemble its sources first")
        if self.boot:
            tapes.boot(monitor, *self.program)
            monitor.listing = found.listing
        else:
            monitor.machine.load(found.words)
        if self.reader:
            tapes.reader(monitor, *self.reader)
        set_(monitor, "sr", self.sr)
        for line in self.commands:
            do(monitor, line)
        if not (self.boot and monitor.machine.panel.lamps.run):  # a tape may start itself
            monitor.machine.panel.stop()
            monitor.machine.pc = monitor.address(self.start)
            monitor.operator.press("start")
        return monitor, found


def _checked(name: str, value: Any, default: object) -> Any:
    """Return a value of the type that its field has by default. Raises WorkError."""
    expected, good = "a text in quotes", isinstance(value, str)
    if isinstance(default, bool):
        expected, good = "true or false", isinstance(value, bool)
    elif not isinstance(default, str):
        value = [value] if good else value
        expected = "a text or a list of texts"
        good = isinstance(value, list) and all(isinstance(each, str) for each in value)
    if not good:
        raise WorkError(f"{name}: {expected} expected, not {value!r}")
    return value
