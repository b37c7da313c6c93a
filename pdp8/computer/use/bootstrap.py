"""The bootstraps of DECtape and DF32: the words to toggle in, which read the first block into core.

Source: OS/8 Handbook.
"""

from pdp8.computer.machine import Machine

BOOT = 0o7613
"""Where it begins."""
DF32 = {0o7750: [0o7600, 0o6603, 0o6622, 0o5352, 0o5752]}
_BOOT = (0o6774, 0o1222, 0o6766, 0o6771, 0o5216, 0o1223, 0o5215, 0o0600, 0o0220)


def bootstrap(unit: int = 0) -> dict[int, list[int]]:
    """Return the words to toggle in for a drive, each run of them by its first address."""
    return {BOOT: [*_BOOT[:7], *(word | unit << 9 for word in _BOOT[7:])], 0o7754: [0o7577, 0o7577]}


def boot(machine: Machine, toggled: dict[int, list[int]] | None = None) -> None:
    """Put a bootstrap into core, that of drive 0 if none is given, and START it at its first address."""
    toggled = toggled or bootstrap()
    machine.stop()
    for address, words in toggled.items():
        machine.load(enumerate(words, address))
    machine.panel.data_field = 0
    machine.start(min(toggled))
