r"""The Teletype's keyboard: keys are pressed as the program asks for them.

    type 01.04 T "HI THERE"!        what follows `type` and one blank, then RETURN if it is asked for
    keyboard "200/"                 texts and codes as `expect` takes them, and nothing else
    keyboard now "\003"             whatever the program does

A program asks for a key when it has read the last one and waits: nothing but a key, or a tape, ends the loop
it is in. One that counts meanwhile waits when for 0.4 s it has done nothing to a device, and at each of eight
glances stood within the same eight words.
"""

from pdp8.computer.hardware.signals import NEVER
from pdp8.computer.stop import Reason
from pdp8.computer.use.keys import sent
from pdp8.monitor.arguments import FRAME, MonitorError, Quoted, some
from pdp8.monitor.prompt import Monitor
from pdp8.monitor.running import GLANCE, slices, text_of
from tapes.quantities import counted

_PATIENCE = 60.0
"""Seconds of machine time that a key waits to be asked for."""
_GLANCES = 8
_SMALL = 8
_RETURN = b"\x8d"


def type_(monitor: Monitor, text: str) -> None:
    """Press the keys of TEXT as it is, and RETURN if it is asked for, each as the program asks for it."""
    press(monitor, frames_of(text))
    if why := _refused(monitor):
        monitor.say(f"RETURN was not pressed: the program asks for no key: {why}")
    else:
        monitor.machine.teletype.keyboard.press(_RETURN)


def keyboard(monitor: Monitor, *arguments: str) -> None:
    """Press keys as `type` does, without RETURN: texts as for `expect`; or now, whatever the program does."""
    now = arguments[:1] == ("now",) and not isinstance(arguments[0], Quoted)
    words = some(arguments[1:] if now else arguments, "a text")
    frames = frames_of("".join(map(text_of, words)))
    if now:
        monitor.machine.teletype.keyboard.press(frames)
    else:
        press(monitor, frames)


def frames_of(characters: str) -> bytes:
    """Return what the keys send. Raises MonitorError where a Model 33 has no such key."""
    return b"".join(map(_frame, characters))


def _frame(character: str) -> bytes:
    code = ord(character)
    if code - FRAME in range(0o200, 0o400):
        return bytes([code - FRAME])
    frame = bytes([0o200 | code]) if code < 0o40 else sent(character)
    if not frame:
        raise MonitorError(f"{character}: a Model 33 has no such key")
    return frame


def press(monitor: Monitor, frames: bytes) -> None:
    """Press one key after another, each as it is asked for. Raises MonitorError when one is not."""
    for number, frame in enumerate(frames):
        why = _refused(monitor)
        if why:
            of = f"{counted(number, 'keys')} of {len(frames)}"
            raise MonitorError(f"the program asks for no key: {why}; {of} sent")
        monitor.machine.teletype.keyboard.press(bytes([frame]))


def _refused(monitor: Monitor) -> str:
    """Run until the program asks for a key; return why it does not, or nothing."""
    machine = monitor.machine
    if not machine.panel.lamps.run:
        return "the machine is stopped; cont continues"
    why = ""
    receiver, actions, places = machine.teletype.receiver, machine.bus.actions, list[int]()
    for stop in slices(monitor, _PATIENCE, GLANCE):
        places = [*places[1 - _GLANCES :], stop.pc] if machine.bus.actions == actions else []
        actions = machine.bus.actions
        goes_round = len(places) == _GLANCES and max(places) - min(places) < _SMALL
        waits = stop.reason in (Reason.IDLE, Reason.TAPE_OUT) and (receiver.tested or machine.ion)
        has_read_all = not receiver.flag and receiver.due == NEVER
        if has_read_all and (goes_round or waits):
            why = ""
            break
        why = f"{_PATIENCE:g} s have passed" if stop.reason is Reason.LIMIT else str(stop.reason)
    return why
