"""A PDP-8/L with its Teletype, PAL III, paper tapes, part programs and a Hydra-Point: all a script needs.

    machine = pdp8.Machine()
    machine.load(pdp8.assemble(pdp8.tape("eia.pal")).words)
    machine.teletype.reader.load(pdp8.ascii.encode(pdp8.part("circle")))
    machine.start(0o200)
    stop = machine.run()                            # its reason, pc and elapsed seconds
    path = pdp8.cut(machine.teletype.punch.tape)    # what the Hydra-Point does with the tape

A tape is bytes, a byte a frame; a word is an int; words in core are {address: word}.

    tape(name)              a file's frames; bundled: eia.pal hello.pal echo.pal eia.bin circle.eia ...
    assemble(source, ...)   PAL III or PAL8: an Assembly with tape, words, symbols, diagnostics, listing
    disassemble(words)      PAL III source that assembles to these words
    part(name, ...)         a part program's printout; constants are the options of `pdp8 part NAME`
    ascii eia binary rim    the codes: encode(...) makes frames of text or words, decode(frames) the reverse,
                            binary.decode(frames).words; eia.EOB ends a block
    picture                 text(frames, "eia", start, stop), svg(...): a tape as holes; or "ascii", "bin"
    Machine                 load, start, run, stop, wait, count; ac link pc sr core[0o200] elapsed
                            machine.teletype: reader.load(frames), keyboard.press(frames), punch.tape,
                            printer.frames; punch.on_frame and printer.on_frame are called with each
                            machine.watch.breakpoints, a set; machine.fit(device)
    Device                  one of your own: pulse, advance, initialize; fields.saved(flag=fields.BIT,
                            due=fields.TICK) is what is saved; signals.SKIP CLEAR_AC NEVER TICKS_PER_SECOND
    Count                   what `with machine.count() as count` gives: executed, operations, waiting ...
    History                 History(machine) notes what is done; pdp8.computer.past.rewind undoes it
    state                   save(machine) makes text, restore(text) a machine
    cut, plot               a Path: steps, moves, times.total in seconds, array(); plot(path) makes SVG
    WorkError               what goes wrong with what was given; TapeError (frame) and LoadError are its kinds

Eight scripts stand in docs/python.md. Each name is imported when it is first used, so that `import pdp8`
alone is quick. The packages beside this one have plain names (`tapes`, `programs`); a script may have files
of the same names: ours are found first, and a warning names both.

The packages:

computer/   the machine itself: processor, engine, Teletype, panel, operator
monitor/    the operator's prompt, for people and scripts
dap/        a debugger for editors
console/    the front panel in a terminal
replay/     the whole 1971 afternoon in one call
thesis/     its figures and tables made again, its programs line by line
web/        pages for a browser
lessons/    exercises, and the answers of a class marked
vectors/    what every word does, for tests of any emulator
cli/        the command; `python -m pdp8` is the same

shelf       where files are found, read and written
fitting     devices of anybody's, each in a file of its own
leaving     signals that ask a program to end
reels       DECtapes on drives, discs of a DF32, and the files that they came from
companion   the nominal curve in a file beside a tape
"""

import os
import sys
import warnings
from collections.abc import Sequence
from importlib import import_module
from importlib.machinery import ModuleSpec, PathFinder

TYPE_CHECKING = False  # as of typing, which would take longer to import than all the rest

if TYPE_CHECKING:
    from types import ModuleType

    from nc import cut as cut
    from nc.plot import plot as plot
    from pal import Assembly as Assembly
    from pal import assemble as assemble
    from pal.disassembler import disassemble as disassemble
    from pdp8 import shelf
    from pdp8.computer.count import Count as Count
    from pdp8.computer.hardware import fields as fields
    from pdp8.computer.hardware import signals as signals
    from pdp8.computer.hardware.bus import Device as Device
    from pdp8.computer.machine import LoadError as LoadError
    from pdp8.computer.machine import Machine as Machine
    from pdp8.computer.past import state as state
    from pdp8.computer.past.history import History as History
    from pdp8.computer.stop import Stop as Stop
    from programs.parts import part as part
    from tapes import ascii as ascii
    from tapes import binary as binary
    from tapes import eia as eia
    from tapes import picture as picture
    from tapes import rim as rim
    from tapes.errors import TapeError as TapeError
    from tapes.errors import WorkError as WorkError

    tape = shelf.tape

    __version__: str

_PLACES = {
    "nc": "cut",
    "nc.plot": "plot",
    "pal": "Assembly assemble",
    "pal.disassembler": "disassemble",
    "pdp8.computer.count": "Count",
    "pdp8.computer.hardware": "fields signals",
    "pdp8.computer.hardware.bus": "Device",
    "pdp8.computer.machine": "LoadError Machine",
    "pdp8.computer.past": "state",
    "pdp8.computer.past.history": "History",
    "pdp8.computer.stop": "Stop",
    "pdp8.shelf": "tape",
    "programs.parts": "part",
    "tapes": "ascii binary eia picture rim",
    "tapes.errors": "TapeError WorkError",
}
"""What a script needs, by the module that has it; or it is a module of this package itself."""
_PLACE_OF = {name: place for place, names in _PLACES.items() for name in names.split()}

__all__ = list(_PLACE_OF)

_HOUSE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
_ROOMS = ("nc", "pal", "programs", "tapes")


class _Rooms:
    """Finds the packages beside this one before a file of the same name beside a script, and warns of it."""

    @staticmethod
    def find_spec(
        name: str, path: Sequence[str] | None, target: "ModuleType | None" = None
    ) -> ModuleSpec | None:
        if name not in _ROOMS:
            return None
        ours, first = PathFinder.find_spec(name, [_HOUSE]), PathFinder.find_spec(name)
        hidden = first.origin if first else None
        if ours and hidden and os.path.realpath(hidden) != os.path.realpath(f"{ours.origin}"):
            warnings.warn(
                f"{hidden} is hidden: {name!r} is {ours.origin}, of pdp8; give the file another name",
                stacklevel=2,
            )
        return ours


sys.meta_path.insert(0, _Rooms)


def __getattr__(name: str) -> object:
    """Import what is asked for. Raises ImportError where a script took the name of one of our packages."""
    if name == "__version__":
        from importlib.metadata import version

        return version("pdp8")
    if name not in _PLACE_OF:
        raise AttributeError(f"module 'pdp8' has no attribute {name!r}")
    for room in _ROOMS:
        taken = getattr(sys.modules.get(room), "__file__", None)
        if taken and os.path.dirname(os.path.dirname(taken)) != _HOUSE:
            raise ImportError(
                f"{taken} was imported as {room!r}, the name of a package of pdp8: import pdp8 before it, "
                "or give the file another name"
            )
    place = _PLACE_OF[name]
    return getattr(import_module(place), name, None) or import_module(f"{place}.{name}")


def __dir__() -> list[str]:
    """Return the names that a script needs, those that are not loaded yet too, and Python's own."""
    return sorted({*(name for name in globals() if name[:2] == "__"), *_PLACE_OF, "__version__"})
