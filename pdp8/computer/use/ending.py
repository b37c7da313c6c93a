"""Why a program ended where it should not, or waits for what never comes, each reason with its sentence.

    explained(stop, history, words)      the stop with its reasons, `Stop.why`
    ended(stop, machine)                 how the run ended, in a few words
    sentences(stop, listing, core)       what its reasons mean, where, and what to try
    told(stop, history, listing)         the stop with its reasons, and both of these as one text
    departure(machine, to, words, flags) how the next instruction leaves the words that were loaded

The last turn of an endless loop is run once more and looked at. Where a program left the words that were
loaded is found by going back to START and running again until it leaves them: the same run, so the same way.
Words that the program has written are its own. Afterwards the machine is as it was.

Not found out: why a program goes wrong and stays within its words.
"""

from collections.abc import Mapping
from copy import copy

from pal.isa import EXECUTE, INDIRECT, IOT, ISZ, JMP, JMS, autoindexed, in_field, refers_to
from pdp8.computer.hardware.core import Core
from pdp8.computer.hardware.fields import Values
from pdp8.computer.hardware.signals import TICKS_PER_SECOND
from pdp8.computer.machine import Machine
from pdp8.computer.past import rewind
from pdp8.computer.past.history import History
from pdp8.computer.stop import Reason, Stop, Why
from pdp8.computer.use.trace import Listing, without_comment
from tapes.quantities import counted

KEY = "key"
READER = "high-speed reader"
PUNCH = "high-speed punch"
PRINTER = "printer"
FLAG = "flag"
NO_DEVICE = "no device"
LOOP = "loop"
WITHIN = "called from within"
FIRST_WORD = "jumped to a first word"
UNCLEARED = "flag not cleared"
LEFT = "left"
JUMPED = "jumped"
INTERRUPTED = "no handler"
DEPARTURES = (LEFT, JUMPED, INTERRUPTED)
"""How a program leaves the words that were loaded."""
WRITTEN = "written over"
PROTECTED = "protected"
LOST = "lost at the printer"
UNREAD = "lost at the keyboard"

_LONGEST = 5_000
"""The most instructions of one turn of a loop."""
_AGAIN = 200_000_000
"""Instructions that are run again at most."""
_SHORT = 20_000_000
"""Instructions that are run again where nothing shows that the program has left its words."""
_LOADERS = 0o7600
"""DEC's loaders, RIM and BIN, may be from here on; a program may jump to them."""
_ION = 0o6001
_FIELDS = 0o2
"""The first digit of the codes of the memory extension, whose IOTs test nothing."""
_WAITS = {0o01: READER, 0o02: PUNCH, 0o03: KEY, 0o04: PRINTER}


class _Step:
    """An instruction of a loop: where, and which word."""

    def __init__(self, address: int, word: int) -> None:
        self.address = address
        self.word = word

    def leads_to(self, operation: int) -> int:
        """Return the address in an instruction of this operation, direct; -1 for any other."""
        direct = self.word >> 9 == operation and not self.word & INDIRECT
        return refers_to(self.word, self.address) if direct else -1


def explained(stop: Stop, history: History, words: Mapping[int, int]) -> Stop:
    """Return the stop with its causes, the first one first; `words` are the loaded ones."""
    machine = history.machine
    if not may_be_wrong(stop, machine, words):
        return stop
    found: list[Why] = []
    if stop.reason is Reason.PROTECT:
        found.append(Why(PROTECTED, machine.ma))
    turn: list[_Step] = []
    if stop.reason in (Reason.IDLE, Reason.LIMIT, Reason.TAPE_OUT):
        with rewind.looking_back(history):
            turn = _turn(machine)
    if words and _may_have_left(stop, turn, machine, words):
        found += _departure(history, words)
    if not found and turn:
        found += _interrupts(machine, turn)
    if not found and stop.reason is Reason.IDLE:
        found += _waits(machine, turn, words)
    return stop._replace(why=(*found, *_lost(history)))


def may_be_wrong(stop: Stop, machine: Machine, words: Mapping[int, int]) -> bool:
    """Whether a stop may have causes worth looking for."""
    teletype = machine.teletype
    if teletype.transmitter.lost or teletype.receiver.lost:
        return True
    if stop.reason in (Reason.HALT, Reason.TAPE_OUT):
        return bool(words) and (machine.ma if stop.reason is Reason.HALT else stop.pc) not in words
    return stop.reason in (Reason.IDLE, Reason.LIMIT, Reason.PROTECT)


def rerun(machine: Machine, began: Values) -> History:
    """Return the history of a copy that runs again from `began` with all of the reader's tape."""
    again = copy(machine)
    again.put(began)
    again.teletype.reader.tape = machine.teletype.reader.tape
    history = History(again)
    while again.processor.clock < machine.processor.clock and again.instructions < machine.instructions:
        again.run(seconds=(machine.processor.clock - again.processor.clock) / TICKS_PER_SECOND)
    again.put(machine.values())
    return history


def _may_have_left(stop: Stop, turn: list[_Step], machine: Machine, words: Mapping[int, int]) -> bool:
    """Whether a second run may show that the program left its words."""
    if stop.reason is Reason.LIMIT:
        return machine.instructions < _SHORT
    halted = stop.reason is Reason.HALT and machine.ma not in words
    strays = any(step.address not in words for step in turn)
    return (halted or strays) and machine.instructions < _AGAIN


def ended(stop: Stop, machine: Machine) -> str:
    """Return a sentence on how and where a run ended."""
    if stop.reason is Reason.HALT:
        return f"HLT at {machine.ma:04o}"
    if stop.reason is Reason.PROTECT:
        if machine.processor.state != EXECUTE or machine.ir == JMS:  # PC is not behind the instruction
            return f"MEM PROT stopped a write into {machine.ma:04o}"
        skipped = machine.ir == ISZ and machine.mb == 0
        at = in_field(stop.pc, stop.pc - 1 - skipped)
        return f"MEM PROT stopped a write at {at:04o} into {machine.ma:04o}"
    if stop.reason is Reason.TAPE_OUT:
        return f"the reader ran out of tape, and the program waits for it at {stop.pc:04o}"
    if stop.reason is not Reason.IDLE:
        return f"stopped before {stop.pc:04o}"
    waits = [why.what for why in stop.why if why.what in (*_WAITS.values(), FLAG, NO_DEVICE)]
    if KEY in waits:
        return f"the program waits for a key at {stop.pc:04o}"
    if waits:
        return f"the program waits at {stop.pc:04o} for a flag that nothing will raise"
    return f"an endless loop at {stop.pc:04o} that nothing can end"


def told(stop: Stop, history: History, listing: Listing) -> tuple[Stop, str]:
    """Return the stop with its reasons, and what there is to say of it."""
    stop, machine = explained(stop, history, listing.words), history.machine
    return stop, ". ".join((ended(stop, machine), *sentences(stop, listing, machine.core)))


def sentences(stop: Stop, listing: Listing, core: Core) -> list[str]:
    """Return a sentence for each thing that is wrong; waiting for a key is not."""
    return [said(why, listing, core) for why in stop.why if why.what != KEY]


def waits_for(machine: Machine) -> tuple[Why, ...]:
    """Return what a machine waits for in a loop that needs an operator to end it."""
    return tuple(_tested(machine, [])) or (Why(LOOP, machine.pc, machine.pc),)


def hands(machine: Machine, why: tuple[Why, ...]) -> list[str]:
    """Return what would end a wait: "keyboard", "tape", "lever", "high-speed tape"."""
    found: list[str] = []
    for each in why:
        if each.what == KEY:
            reader = machine.teletype.reader
            found += ["keyboard", "lever" if reader.loaded and not reader.on else "tape"]
        elif each.what == READER:
            found.append("high-speed tape")
    return found


def said(why: Why, listing: Listing, core: Core) -> str:
    """Return the sentence for a reason."""
    at, other = _line(listing, core, why.address), f"{why.other:04o}"
    place = f"at {at}" if why.other == why.address else f"from {other} to {why.address:04o}"
    through = f" through {why.through:04o}" if why.through >= 0 else ""
    option = "; the PC8/L, an option, has it" if why.code in (0o01, 0o02) else ""
    characters = counted(why.number, "characters")
    sentence = {
        KEY: f"It waits for a key, or a tape in the reader, at {at}.",
        READER: f"It waits for a frame from the high-speed reader at {at}: {_READER.get(why.number, '')}.",
        PUNCH: f"It waits for the high-speed punch at {at}, which was sent nothing: a PLS raises its flag.",
        PRINTER: f"It waits for the printer's flag at {at}: no character is on its way; "
        "a TLS raises the flag.",
        FLAG: f"It waits for the flag of device {why.code:02o} at {at}: the device has nothing left to do.",
        NO_DEVICE: f"It waits for device {why.code:02o} at {at}: no such device is fitted{option}.",
        LOOP: f"It goes round {place}: no flag is tested, no word changes, no HLT is reached.",
        WITHIN: f"The subroutine at {other} is called from within itself, at {at}: that puts another return "
        f"address into {other}, and it never returns to its first caller.",
        FIRST_WORD: f"It executes a return address: {at} jumps to the first word of a subroutine; "
        "JMP I returns.",
        UNCLEARED: f"No handler clears the flag of device {why.code:02o}: it interrupts again before {at}.",
        LEFT: f"It left the words that were loaded: nothing was loaded at {other}, behind {at}. "
        "Is an HLT or a jump missing?",
        JUMPED: f"It left the words that were loaded: {at} goes{through} to {other}, "
        "where nothing was loaded.",
        INTERRUPTED: f"Device {why.code:02o} interrupted it before {at}, and no handler was loaded at 0001.",
        WRITTEN: f"It wrote over itself: {at} was loaded as {other}.",
        PROTECTED: "While MEM PROT is up, nothing writes into 7600 to 7777.",
        LOST: f"The printer was sent {characters} while it was busy, the first at {at}: TSF, JMP .-1 waits "
        "until it is free.",
        UNREAD: f"{characters} came in over one that was not read, the first before {at}.",
    }
    return sentence[why.what]


_READER = {0: "no RFC asked for one", 1: "it has no tape", 2: "its tape has run out"}


def _line(listing: Listing, core: Core, address: int) -> str:
    """Return an address with what is there, without its comment."""
    line = listing.line(address, core[address])
    source = without_comment(line[len(f"{address:04o}  0000") :]).split()
    return f"{address:04o} ({' '.join(source) or f'{core[address]:04o}'})"


def _turn(machine: Machine) -> list[_Step]:
    """Run the loop once and return its instructions."""
    p = machine.processor
    first = machine.pc, p.lac
    turn: list[_Step] = []
    p.run = 1
    while len(turn) < _LONGEST:
        turn.append(_Step(machine.pc, p.core[machine.pc]))
        p.instruction()
        if (machine.pc, p.lac) == first:
            break
    return turn


def _waits(machine: Machine, turn: list[_Step], words: Mapping[int, int]) -> list[Why]:
    """Return what keeps the machine in a loop."""
    for step in turn:
        called, target = step.leads_to(JMS), step.leads_to(JMP)
        if called >= 0 and all(other.address != called for other in turn) and _returns(turn, called) < 0:
            return [Why(WITHIN, step.address, called)]
        changed = target in words and machine.core[target] != words[target]
        if changed and any(_Step(place, word).leads_to(JMS) == target for place, word in words.items()):
            return [Why(FIRST_WORD, step.address)]
        if step.word >> 9 == JMP and step.word & INDIRECT:
            pointer = refers_to(step.word, step.address)
            call = in_field(pointer, machine.core[pointer] - 1)
            inner = _Step(call, machine.core[call])
            if inner.leads_to(JMS) == pointer and all(other.address != call for other in turn):
                return [Why(WITHIN, call, pointer)]
    places = [step.address for step in turn]
    found = _tested(machine, turn)
    written = [step for step in turn if words.get(step.address, step.word) != step.word]
    if not found and written:
        found.append(Why(WRITTEN, written[0].address, words[written[0].address]))
    return found or [Why(LOOP, max(places), min(places))]


def _interrupts(machine: Machine, turn: list[_Step]) -> list[Why]:
    """Return the device that keeps interrupting, if the loop consists of interrupts only."""
    flags = requests(machine)
    entered = any(step.address == 1 for step in turn) and any(step.word == _ION for step in turn)
    if not entered or not flags or len(turn) == _LONGEST:
        return []
    interrupted = in_field(machine.processor.extension.saved_inst, machine.core[0])
    return [Why(UNCLEARED, interrupted, code=flags[0])]


def _returns(turn: list[_Step], pointer: int) -> int:
    """Return where the loop jumps through `pointer`, or -1."""
    for step in turn:
        through = step.word >> 9 == JMP and step.word & INDIRECT
        if through and refers_to(step.word, step.address) == pointer:
            return step.address
    return -1


def _tested(machine: Machine, turn: list[_Step]) -> list[Why]:
    """Return the flags that the loop tests or is interrupted by and that will never rise."""
    tested = {device.code: machine.pc for device in machine.bus if device.tested}
    for step in turn:
        code = step.word >> 3 & 0o77
        if step.word >> 9 == IOT and step.word & 1 and code and code >> 3 != _FIELDS:
            tested[code] = step.address
    if machine.ion and 0o03 not in tested:
        tested[0o03] = machine.pc
    codes = [code for code in (0o03, 0o01, 0o02, 0o04) if code in tested and machine.bus.device(code)]
    found = [Why(_WAITS[code], tested[code], code=code, number=_state(machine, code)) for code in codes]
    other = [
        Why(FLAG if machine.bus.device(code) else NO_DEVICE, at, code=code) for code, at in tested.items()
    ]
    return found or other


def _state(machine: Machine, code: int) -> int:
    """Return which of _READER holds."""
    reader = machine.highspeed.reader
    return 0 if code != 0o01 else 1 if not reader.loaded else 2 if reader.empty() else 0


def _departure(history: History, words: Mapping[int, int]) -> list[Why]:
    """Return how a program first left its words, or [] if the history does not show it."""
    machine = history.machine
    since, now = machine.processor.started, machine.processor.clock
    with rewind.looking_back(history):
        history.go_to_tick(max(since, history.snapshots()[-1].clock))
        core = machine.processor.core[:]
        own = {*words, *(address for address in range(_LOADERS, 0o10000) if core[address])}

        def left() -> bool:
            if machine.ir == JMS and machine.ma == machine.pc - 1:
                own.add(machine.ma)  # the first word of what it calls
            return machine.pc not in own and machine.core[machine.pc] == core[machine.pc]

        places = {address for address in range(len(core)) if address not in own}
        if not rewind.come_to(history, now, places, left):
            return []
        to, flags = machine.pc, requests(machine)
        history.go_to_instruction(machine.instructions - 1)
        return departure(machine, to, words, flags)


def requests(machine: Machine) -> list[int]:
    """Return the codes of the devices that request an interrupt."""
    return [device.code for device in machine.bus if device.flag and device.enabled]


def departure(machine: Machine, to: int, words: Mapping[int, int], flags: list[int]) -> list[Why]:
    """Return how the next instruction leads to address `to`, unless a device's interrupt does."""
    address = machine.pc
    word = machine.core[address]
    operation, pointer = word >> 9, refers_to(word, address) if word >> 9 <= JMP else -1
    field = machine.processor.extension.inst_buffer
    written = [Why(WRITTEN, address, words[address])] if words.get(address, word) != word else []
    if operation in (JMS, JMP):
        target = pointer
        if word & INDIRECT:
            target = machine.core[pointer] + autoindexed(pointer)
        if to == in_field(field, target + (operation == JMS)):
            return [*written, Why(JUMPED, address, to, pointer if word & INDIRECT else -1)]
    elif to in (in_field(address, address + 1), in_field(address, address + 2)):
        return [Why(LEFT, address, to)]
    return [Why(INTERRUPTED, address, to, code=flags[0] if flags else 0)]


def _lost(history: History) -> list[Why]:
    """Return the characters lost at printer and keyboard."""
    teletype = history.machine.teletype
    found: list[Why] = []
    for what, device in ((LOST, teletype.transmitter), (UNREAD, teletype.receiver)):
        if device.lost and device.lost_at >= history.snapshots()[-1].clock:
            with rewind.looking_back(history):
                history.go_to_tick(device.lost_at)
                place = history.machine.ma if what == LOST else history.machine.pc
            found.append(Why(what, place, number=device.lost))
    return found
