"""What a program waits for although nothing on its way will bring it, in words, and what would end the wait.

    KSF, JMP .-1    a character from the keyboard or the reader      keyboard, reader
    RSF, JMP .-1    a frame from the high-speed reader               high-speed reader
    TSF, JMP .-1    the printer, which was sent nothing              none: a TLS has to come before
    JMP .           nothing: the loop has no end

The devices are those whose flag the loop tests; where interrupts are on, a character ends it, too.
"""

from typing import NamedTuple

from pdp8.computer.machine import Machine


class Wait(NamedTuple):
    """A sentence, and what a hand can do: "keyboard", "tape", "lever", "high-speed tape"."""

    said: str
    hands: list[str]


def waits_for(machine: Machine) -> Wait:
    """Return what a machine waits for in a loop that nothing already on its way will end."""
    ion = machine.processor.ion == 1
    tested = [device.code for device in machine.bus if device.tested]
    said: list[str] = []
    hands: list[str] = []
    if 0o03 in tested or ion:
        said.append("a character from the keyboard or the reader" + _reader(machine, hands))
    if 0o01 in tested:
        reader = machine.highspeed.reader
        why = (
            "has no tape"
            if not reader.loaded
            else "has no more tape"
            if reader.empty()
            else "no RFC asked for"
        )
        said.append(f"a frame from the high-speed reader, which {why}")
        hands.append("high-speed tape")
    if 0o02 in tested:
        said.append("the high-speed punch, which was sent nothing")
    if 0o04 in tested:
        said.append("the printer, which was sent nothing: a TLS raises its flag")
    if not said:
        return Wait("It goes round in a loop that nothing can end.", hands)
    what = f"an interrupt by {said[0]}" if ion and not tested else ", or ".join(said)
    return Wait(f"It waits for {what}.", hands)


def _reader(machine: Machine, hands: list[str]) -> str:
    """Return what is to be said of the Teletype's reader, and add what a hand can do."""
    reader = machine.teletype.reader
    hands.append("keyboard")
    if reader.loaded and not reader.on:
        hands.append("lever")
        return "; the reader's lever is at STOP"
    hands.append("tape")
    return "; the tape has run out" if reader.empty() else ""
