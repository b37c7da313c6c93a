"""The facts that the pages share with the rest: times, codes, names, a block's fields, a cutter.

    tables of tapes/, nc/, pdp8/computer ──► facts() ──► facts.mjs ──► the pages' scripts

The scripts hold no such number of their own. facts.mjs is made by `python -m pdp8.web.facts`, so that the
scripts also run under Node.js as they are; a test holds that it is what this module makes, and a page gets it
fresh.
"""

import json
from importlib.resources import files
from typing import Any, Final

from nc import blocks, machine
from pal import assembler, assembly, dialects, isa, table
from pal.symbols import PERMANENT, PSEUDO_OPERATORS
from pdp8.computer.hardware import fields, highspeed, signals
from pdp8.computer.hardware.teletype import half_units
from pdp8.computer.machine import Machine
from pdp8.computer.past import state
from pdp8.computer.use import keys, operator
from tapes import ascii, eia, frames, hydrapoint

FILE: Final = "facts.mjs"

_KEYBOARD: Final = [chr(code) for code in range(0o200) if len(keys.sent(chr(code))) == 1]

_ASCII_CODES: Final = ("BELL", "LF", "CR", "space", "RUBOUT")


def facts() -> dict[str, Any]:
    """Return every fact, ready for JSON. Times are ticks of 0.05 µs, lengths thousandths of an inch."""
    return {
        "TIMES": _times(),
        "ISA": {
            name: value
            for name, value in sorted(vars(isa).items())  # compiled, they stand in another order
            if name.isupper() and isinstance(value, int)
        },
        "OPERATIONS": isa.OPERATIONS,
        "STATES": isa.STATES,
        "SYMBOLS": {
            symbol.mnemonic: (symbol.octal, symbol.meaning, symbol.memory_reference) for symbol in PERMANENT
        },
        "PSEUDO_OPERATORS": PSEUDO_OPERATORS,
        "PAL_III": _pal(),
        "DIALECTS": _dialects(),
        "INTERRUPT": signals.INTERRUPT,
        "PROTECTED": signals.PROTECTED,
        "LOADERS": _loaders(),
        "ASCII": {name: _ascii_code(name) for name in _ASCII_CODES},
        "KEYS": {character: keys.sent(character)[0] for character in _KEYBOARD},
        "LEADER": frames.LEADER,
        "LEAST_LEADER": len(frames.LEAST_LEADER),
        "LABEL_GAP": len(frames.LABEL_GAP),
        "EIA": {frame: character for character, frame in eia.CODES.items()},
        "END_OF_BLOCK": eia.EOB,
        "FIELDS": hydrapoint.FIELDS,
        "ROWS": hydrapoint.ROWS,
        "HYDRA_POINT": _hydra_point(),
        "STATE": _state(),
    }


def _pal() -> dict[str, Any]:
    """Return the numbers of PAL III's mechanism; `pal` names them."""
    return {
        "START": assembler.START,
        "TELETYPE_SYMBOLS": assembler.TELETYPE_SYMBOLS,
        "HIGH_SPEED_SYMBOLS": assembler.HIGH_SPEED_SYMBOLS,
        "PLACES": assembler._PLACES,
        "PUSHED": assembler._PUSHED,
        "SAFE": assembler._SAFE,
        "CORE": table._CORE,
        "SPILL": table._SPILL,
        "LEFT_THERE": table._LEFT_THERE,
        "LEADER_LENGTH": frames.LEADER_LENGTH,
        "MOST": assembly.MOST,
    }


def _dialects() -> dict[str, Any]:
    """Return what other assemblers know and PAL III does not."""
    return {
        "UNKNOWN": dialects._UNKNOWN,
        "LATER": dialects._LATER.split(),
        "GROUPS": dialects._GROUPS,
        "CHARACTERS": dialects._CHARACTERS,
    }


def _hydra_point() -> dict[str, Any]:
    settings = machine.Settings()
    return {
        "PREPARATORY": hydrapoint.PREPARATORY,
        "MISCELLANEOUS": hydrapoint.MISCELLANEOUS,
        "PREPARATORY_CODES": {code.name: code.value for code in hydrapoint.Preparatory},
        "MISCELLANEOUS_CODES": {code.name: code.value for code in hydrapoint.Miscellaneous},
        "READ_Z": hydrapoint.Preparatory.READ_Z,
        "TOOL_CODES": {
            int(code): (name, sorted(codes)) for code, (name, codes) in blocks._TOOL_CODES.items()
        },
        "TRAVEL": (hydrapoint.X_TRAVEL, hydrapoint.Y_TRAVEL, hydrapoint.Z_TRAVEL),
        "XY_FEED": hydrapoint.XY_FEED,
        "Z_FEED": hydrapoint.Z_FEED,
        "POSITIONING_SPEED": hydrapoint.POSITIONING_SPEED,
        "READ_SECONDS": machine.READ_SECONDS,
        "PECK": settings.peck,
    }


def _state() -> dict[str, Any]:
    """Return what begins a state file, the kinds of fields, and the fields of each part."""
    computer = Machine(highspeed=True)
    devices = {
        f"{device.code:02o}": (type(device).__name__, _saved_fields(device)) for device in computer.bus
    }
    return {
        "HEAD": state.HEAD,
        "KINDS": {"TICK": fields.TICK, "FRAMES": fields.FRAMES},
        "PROCESSOR": _saved_fields(computer.processor),
        "DEVICES": devices,
    }


def _saved_fields(part: Any) -> dict[str, Any]:
    """Return the fields of a part; those of a part within it in their place."""
    return {
        name: _saved_fields(getattr(part, name)) if kind == fields.PART else kind
        for name, kind in part.fields.items()
    }


def _times() -> dict[str, int]:
    return {
        "SECOND": signals.TICKS_PER_SECOND,
        "CYCLE": signals.CYCLE,
        "IO_TICKS": signals.IO_TICKS,
        "IOP1": signals.IOP1,
        "IOP2": signals.IOP2,
        "IOP4": signals.IOP4,
        "IOP2_TO_IOP4": signals.IOP4 - signals.IOP2,
        "FRAME": signals.FRAME,
        "START_CHECKED": half_units(1),
        "RECEIVED": half_units(17),
        "READ": highspeed.READ_TICKS,
        "PUNCH": highspeed.PUNCH_TICKS,
    }


def _loaders() -> dict[str, Any]:
    return {
        "RIM": operator.RIM,
        "RIM_START": operator.RIM_START,
        "BIN_START": operator.BIN_START,
        "BIN_HALT": operator.BIN_HALT,
        "TELETYPE_READER": operator.TELETYPE_READER,
    }


def _ascii_code(name: str) -> int:
    return next(code for code in range(0o200) if ascii.name(code) == name)


def module() -> str:
    """Return the facts as a JavaScript module."""
    lines = [
        f"export const {name} = {json.dumps(fact, separators=(', ', ': '))};"
        for name, fact in facts().items()
    ]
    return "\n".join(
        ["// Made by `python -m pdp8.web.facts` from the Python tables. Change those.", "", *lines, ""]
    )


def main() -> None:
    """Write facts.mjs beside the scripts."""
    path = files("pdp8.web").joinpath(FILE)
    with open(str(path), "w", encoding="utf-8") as file:
        file.write(module())


if __name__ == "__main__":
    main()
