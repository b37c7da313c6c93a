"""The bootstrap of DECtape: the words to toggle in, which read the first block of a drive into core.

Source: OS/8 Handbook.
"""

from pdp8.computer.machine import Machine

BOOT = 0o7613
"""Where it begins."""
_BOOT = (0o6774, 0o1222, 0o6766, 0o6771, 0o5216, 0o1223, 0o5215, 0o0600, 0o0220)


def bootstrap(unit: int = 0) -> dict[int, list[int]]:
    """Return the words to toggle in for a drive, each run of them by its first address."""
    return {BOOT: [*_BOOT[:7], *(word | unit << 9 for word in _BOOT[7:])], 0o7754: [0o7577, 0o7577]}


def boot(machine: Machine, unit: int = 0) -> None:
    """Put the bootstrap for a drive into core, and START it."""
    machine.stop()
    for address, words in bootstrap(unit).items():
        machine.load(enumerate(words, address))
    machine.panel.data_field = 0
    machine.start(BOOT)
