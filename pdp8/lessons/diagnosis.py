"""What happened where an answer is wrong: a word for it, what is said of it, and a hint where none is given.

The keys of a case's own hints are these words too.
"""

from collections.abc import Sequence

from pal.isa import jumps_to
from pdp8.computer.past.history import History
from pdp8.computer.stop import Reason
from pdp8.computer.use import ending
from pdp8.lessons.answer import Answer
from pdp8.lessons.exercise import Trial
from pdp8.lessons.trial import Outcome, Tried, last, start, turns

NO_WORD = "no word at the start"
LEFT = "left the program"
JUMPED = "jumped out of the program"
NOT_STOPPED = "did not stop"
JUMP = "jumps to itself"
AGAIN = "reads one again and again"
INPUT = "waits for a key or a tape"
OUTPUT = "waits for the printer"
ELSEWHERE = "stopped elsewhere"
ITSELF = "wrote over itself"
NOTHING = "nothing came"
SHORT = "too short"
LONG = "too long"
FIRST = "the first is wrong"
ALL = "wrong from the first on"
SHIFTED = "one lost or doubled"
PARITY = "parity"
ONE_OFF = "one off"
NEGATIVE = "the negative"
RESULT = "wrong"

ENDS = (NO_WORD, LEFT, JUMPED, AGAIN, NOT_STOPPED, JUMP, INPUT, OUTPUT, ELSEWHERE)
"""What can be wrong with a run's end; all else is wrong with its result."""
RESULTS = (
    ITSELF, NOTHING, SHORT, LONG, FIRST, ALL, SHIFTED, PARITY, ONE_OFF, NEGATIVE, RESULT,
)  # fmt: skip
LOOKED_AT = ("the end", "the time", "instructions", "the tape", "the page", "the pointer", "AC", "L")
"""What may differ, beside the places that a trial looks at."""
HINTS = {
    NO_WORD: "Begin the program where it is started: *200, say, before its first word.",
    LEFT: "What comes after your last instruction is executed too: HLT, or a jump, ends a program.",
    JUMPED: "Which jump goes there? JMS alone leaves an address to come back to; JMP does not.",
    AGAIN: "The flag of what was read stays up: KRB clears it, KRS does not.",
    NOT_STOPPED: "What is to end this loop? Look at its count, and at what the skip skips.",
    JUMP: "A jump to itself never ends. HLT stops the machine.",
    INPUT: "All there was has been read. How does the program know that it is done?",
    OUTPUT: "The flag goes up when a character is done: print one (TLS) before you wait for it (TSF).",
    ITSELF: "Which DCA, ISZ or JMS writes there? Put data where the program never comes.",
    NOTHING: "TLS prints and punches what is in the AC.",
    SHORT: "It ends too soon, or does not wait until the last one is done.",
    LONG: "How often does the loop go round?",
    FIRST: "What is in the AC, and in L, before the first?",
    SHIFTED: "From there on everything is shifted by one: one is lost, or comes twice.",
    PARITY: "The characters are right; the channel for parity is not.",
}
_KRB = 0o6036
_INPUTS = (0o6031, 0o6011)
_OUTPUTS = (0o6041, 0o6021)
WANTED = {
    "halt": "a halt", "tape out": "waiting for a frame that does not come",
    "idle": "a loop that nothing ends", "limit": "running on", "any": "an end in the program",
}  # fmt: skip
"""What a case's stop is called."""


def end(answer: Answer, trial: Trial, outcome: Outcome, whole: Trial) -> tuple[str, str]:
    """Return what happened, and a message, where `trial` ended wrongly; `whole` has all its STARTs."""
    stop, first = outcome.stop, start(answer, trial)
    if stop.reason is Reason.BREAKPOINT:
        if outcome.instructions == 0:
            return NO_WORD, f"no word of yours is at {first:04o}"
        machine = last(answer, whole, outcome)
        before = machine.values()
        machine.run(instructions=1)
        flags = ending.requests(machine)
        machine.put(before)
        why = tuple(ending.departure(machine, stop.pc, answer.words, flags))
        how = LEFT if why[-1].what == ending.LEFT else JUMPED
        return how, " ".join(ending.sentences(stop._replace(why=why), answer.listing, machine.core))
    tried = Tried(answer, whole, outcome.number)
    tried.start(outcome.number)
    history = History(tried.machine)
    tried.run(outcome.number)
    stop = ending.explained(stop, history, answer.words)
    said = ending.sentences(stop, answer.listing, tried.machine.core)
    if stop.reason is Reason.LIMIT:
        low, high = turns(answer, whole, outcome)
        again = (
            trial.stop == Reason.TAPE_OUT and trial.tape is not None and len(outcome.tape) > len(trial.tape)
        )
        happened = AGAIN if again and _KRB not in answer.words.values() else NOT_STOPPED
        ran = f"still running after {trial.seconds:g} s, between {low:04o} and {high:04o}"
        return happened, ". ".join((ran, *said))
    told = ". ".join((ending.ended(stop, tried.machine), *said))
    word = outcome.core[stop.pc]
    if stop.reason is Reason.HALT:
        return ELSEWHERE, told
    if jumps_to(stop.pc, word, stop.pc):
        return JUMP, told
    if stop.reason is Reason.TAPE_OUT or word in _INPUTS:
        return INPUT, told
    return OUTPUT if word in _OUTPUTS else NOT_STOPPED, told


def word(expected: int, got: int) -> str:
    """Return in which way a word differs."""
    if (expected - got) & 0o7777 in (1, 0o7777):
        return ONE_OFF
    return NEGATIVE if (expected + got) & 0o7777 == 0 else RESULT


def sequence(expected: Sequence[object], got: Sequence[object]) -> str:
    """Return in which way a tape or a printed page differs."""
    if not got:
        return NOTHING
    at = first_difference(expected, got)
    if at in (len(expected), len(got)):
        return SHORT if len(got) < len(expected) else LONG
    if _parity(expected, got, 0o200) or _parity(expected, got, 0o20):
        return PARITY
    if at == 0 and list(expected[1:]) == list(got[1:]):
        return FIRST
    if at == 0:
        return ALL
    lost, doubled = expected[at + 1 :], got[at + 1 :]
    if (lost and got[at:] == lost) or (doubled and doubled == expected[at:]):
        return SHIFTED
    return RESULT


def first_difference(one: Sequence[object], other: Sequence[object]) -> int:
    """Return where two first differ: one may have ended there."""
    both = min(len(one), len(other))
    return next((at for at in range(both) if one[at] != other[at]), both)


def _parity(expected: Sequence[object], got: Sequence[object], channel: int) -> bool:
    """Tell whether frames or characters differ in this channel only."""
    if len(expected) != len(got):
        return False
    pairs = list(zip(expected, got, strict=True))
    return all(
        isinstance(one, int) and isinstance(two, int) and one ^ two in (0, channel) for one, two in pairs
    )
