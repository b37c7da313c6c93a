"""The circle with another tolerance, by the whole chain.

tolerance ──► programs.circle ──► ASCII tape ──► eia.pal ──► EIA tape
"""

from pal.assembling import assemble
from pdp8.computer.machine import Machine
from programs import circle
from tapes import ascii


def loosened(tolerance: int, source: str) -> bytes:
    """Return the circle's EIA tape for half a band of so many thousandths; `source` is that of eia.pal."""
    machine = Machine()
    machine.load(assemble(source, names=["eia.pal"]).words)
    machine.teletype.reader.load(ascii.encode(circle.part(tolerance=tolerance)))
    machine.start(0o200)
    machine.run()
    return machine.teletype.punch.tape
