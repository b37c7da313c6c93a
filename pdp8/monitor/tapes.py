"""Commands about tapes: programs, the readers and punches, the Teletype's keyboard and page, saved states."""

from collections.abc import Sequence

from pdp8 import shelf
from pdp8.computer.hardware.teletype import Punch, printed
from pdp8.computer.past import state
from pdp8.computer.use import operator, program
from pdp8.monitor.arguments import MonitorError, some
from pdp8.monitor.prompt import Monitor
from tapes import binary, codes
from tapes import rim as rim_format
from tapes.errors import naming
from tapes.frames import has_leader
from tapes.quantities import counted

_MARKS = {"\a": "<BEL>", "\x7f": "<RUBOUT>"}


def load(monitor: Monitor, name: str, *force: str) -> None:
    """Put a program straight into core; `load PROGRAM force` takes a damaged tape too."""
    found = _program(monitor, name, _forced(force))
    monitor.machine.load(found.words)
    monitor.listing = found.listing
    monitor.say(f"{name}: {counted(len(found.words), 'words')}")
    _say_notes(monitor, found)


def boot(monitor: Monitor, name: str, *force: str) -> None:
    """Load a program from cold as an operator does; or let RIM read what is in a reader."""
    device = name.lower().rstrip("0")
    if device in ("ptr", "tti"):
        from pdp8.monitor.running import go, goal_of

        goal_of(force)
        monitor.machine.panel.mem_prot = monitor.machine.panel.sing_step = False
        fast = device == "ptr" and monitor.machine.highspeed.fitted
        _toggle(monitor, operator.RIM_HIGH_SPEED if fast else operator.RIM)
        go(monitor, f"{monitor.machine.panel.inst_field << 12 | operator.RIM_START:o}", *force)
        return
    forced = _forced(force)
    found = _program(monitor, name, True)
    loader = rim_format.encode(shelf.bundled_program("bin.pal").words)
    in_reader = monitor.machine.teletype.reader
    unread = in_reader.tape if in_reader.loaded and in_reader.position == 0 else b""
    for step in monitor.operator.boot(loader, found.tape, name, forced):
        monitor.say(str(step))
    monitor.listing = found.listing
    if monitor.machine.panel.lamps.run:  # the tape is still to be read
        monitor.say("run goes on")
        return
    if unread:
        monitor.operator.mount("what was in the reader", unread)
    _say_notes(monitor, found)


def _read(monitor: Monitor, name: str) -> bytes:
    """Return the content of a file; say so where it hides a bundled one."""
    if shelf.hides(name):
        monitor.say(f"{name} {shelf.HIDES}")
    return shelf.read(name)


def _program(monitor: Monitor, name: str, force: bool) -> program.Program:
    """Return a program; say so where it hides a bundled one."""
    if shelf.hides(name):
        monitor.say(f"{name} {shelf.HIDES}")
    return shelf.program(name, force, monitor.dialect, monitor.machine.memory)


def _forced(words: Sequence[str]) -> bool:
    if words not in ((), ("force",)):
        raise MonitorError(f"{' '.join(words)}: only force may follow the name")
    return bool(words)


def _say_notes(monitor: Monitor, found: program.Program) -> None:
    for note in found.notes:
        monitor.say(f"{found.name}: {note}")


def listing(monitor: Monitor, name: str) -> None:
    """Take the listing of a program that is in core already, as after `restore`."""
    monitor.listing = _program(monitor, name, True).listing


def rim(monitor: Monitor) -> None:
    """Toggle in the RIM loader."""
    _toggle(monitor, operator.RIM)


def _toggle(monitor: Monitor, loader: Sequence[int]) -> None:
    """Toggle in a RIM loader. Raises MonitorError where the panel does not take it."""
    panel = monitor.machine.panel
    at = panel.inst_field << 12 | operator.RIM_START
    monitor.operator.press("stop")
    keys = sum(1 for _ in monitor.operator.toggle(operator.RIM_START, loader))
    if panel.lamps.protect:
        raise MonitorError(f"MEM PROT is up: {at:04o} holds {monitor.machine.core[at]:04o}; set mem_prot 0")
    monitor.say(f"RIM loader in {at:04o}-{at + len(loader) - 1:o}, {keys} keys")


def reader(monitor: Monitor, first: str, *more: str) -> None:
    """Put tapes into the Teletype's reader, each as the one before runs out; or its lever; or none."""
    names = [first, *more]
    teletype = monitor.machine.teletype
    if names in (["start"], ["stop"]):
        monitor.operator.throw_lever(names == ["start"])
        return
    if names == ["none"]:
        monitor.waiting_tapes = []
        teletype.reader.remove()
        return
    tapes = [_read(monitor, name) for name in names]
    monitor.operator.mount(first, tapes[0])
    monitor.waiting_tapes = [*more]
    for name, frames in zip(names, tapes, strict=True):
        leader = "; no leader" if frames and not has_leader(frames) else ""
        monitor.say(f"{name}: {counted(len(frames), 'frames')}{leader}")
        if doubt := codes.recognise(frames).doubt(frames):
            monitor.say(f"{name} {doubt}")


def fast_reader(monitor: Monitor, name: str) -> None:
    """Put a tape into the high-speed reader."""
    _need_highspeed(monitor)
    monitor.machine.highspeed.reader.load(_read(monitor, name))


def fast_punch(monitor: Monitor, what: str) -> None:
    """Take the tape off the high-speed punch into a file; or switch it on or off."""
    _need_highspeed(monitor)
    _take_off(monitor, monitor.machine.highspeed.punch, what)


def _need_highspeed(monitor: Monitor) -> None:
    if not monitor.machine.highspeed.fitted:
        raise MonitorError("no high-speed reader and punch are fitted: pdp8 monitor --highspeed fits them")


def punch(monitor: Monitor, what: str, *name: str) -> None:
    """Take the tape off the Teletype's punch into a file; or switch it on or off; or write words of core as a
    BIN tape: `punch 0-7577 FILE`.
    """
    if name and what not in ("on", "off"):
        core = {address: monitor.machine.core[address] for address in monitor.range(what)}
        (file,) = some(name, "the name of a file", 1, 1)
        wrote = shelf.leave(file, binary.encode(core), "tape")
        monitor.say(f"{wrote}: {counted(len(core), 'words')} in BIN format")
        return
    some(name, "a file, on or off", 0, 0)
    _take_off(monitor, monitor.machine.teletype.punch, what)


def _take_off(monitor: Monitor, device: Punch, what: str) -> None:
    if what in ("on", "off"):
        device.on = what == "on"
    else:
        take_off(monitor, device, what)


def take_off(monitor: Monitor, device: Punch, name: str) -> None:
    """Take the tape off a punch into a file."""
    wrote = shelf.leave(name, device.tape, "tape")
    monitor.say(f"{wrote}: {counted(len(device.tape), 'frames')}")
    device.frames.clear()


def page(monitor: Monitor, *more: str) -> None:
    """Say what the Teletype has printed; `page more` only what is new since the last time."""
    if more not in ((), ("more",)):
        raise MonitorError("nothing, or more, expected")
    frames = monitor.machine.teletype.printer.frames
    since = monitor.shown if more else 0
    monitor.shown = len(frames)
    text = "".join(
        _MARKS.get(chr(frame & 0o177)) or printed(bytes([frame])).decode() for frame in frames[since:]
    )
    for line in text.replace("\r", "").split("\n"):
        monitor.say(line)


def save(monitor: Monitor, name: str) -> None:
    """Write the machine's state into a file."""
    monitor.say(shelf.leave(name, state.save(monitor.machine).encode(), "JSON"))


def restore(monitor: Monitor, name: str) -> None:
    """Read the machine's state from a file; the listing stays, tapes and keys that wait do not."""
    text = shelf.read_text(name, state.LARGEST)
    with naming(name):
        monitor.turn_to(text)
    monitor.waiting_tapes, monitor.once_running = [], []
    monitor.say_where("restored")
