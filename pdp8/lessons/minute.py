"""The first minute at the panel: what comes next, and what a key has done, both from the machine's state.

STOP ──► LOAD ADD ──► five words, each set and DEP ──► LOAD ADD ──► START ──► a name, typed, printed, punched

Nothing is remembered of what was asked for: somebody who presses another key, leaves, or has some words in
core already is guided from there. No sentence has more than 90 characters.
"""

from typing import Final, NamedTuple

from pal.meaning import of_word
from pdp8.computer.machine import Machine
from tapes import ascii

FIRST: Final = 0o200
PROGRAM: Final = (
    (0o6031, "is there a letter?"),
    (0o5200, "no: ask again"),
    (0o6036, "yes: take it"),
    (0o6046, "print it, punch it"),
    (0o5200, "now the next"),
)
"""The words of a program that types and punches what is typed, and what each says."""

_SHOWN: Final = 60
"""The last frames, in which a name of at most 24 characters is looked for."""


class Step(NamedTuple):
    """The next step: a sentence, and a key to press or the switches to set, else -1."""

    say: str
    key: str = ""
    switches: int = -1


class Look(NamedTuple):
    """What the steps depend on: the next word's number `at` (5: none) and `place`, or the program's start;
    whether it is `there`; the punched `frames` and what they say, `made`.
    """

    at: int
    place: int
    there: bool
    waits: bool
    frames: bytes
    made: str
    pc: int
    ma: int
    mb: int
    sr: int
    run: bool
    step: bool
    protects: bool
    refused: bool
    held: int


class Minute:
    """Guides a visitor at the panel; `typed` says whether a keyboard can set the switches."""

    def __init__(self, typed: bool) -> None:
        self.typed = typed
        self.start = 0
        self.did = ""
        self.seen: Look | None = None

    def begin(self, machine: Machine) -> None:
        """Called when the visitor takes the switches."""
        self.seen = self._look(machine)
        runs = "runs" if self.seen.run else "is stopped"
        self.did = f"The switches are yours. The computer {runs}; its tape reader is off."

    def _look(self, machine: Machine) -> Look:
        p, punched = machine.processor, machine.teletype.punch.frames
        at = 0
        while at < len(PROGRAM) and p.core[FIRST + at] == PROGRAM[at][0]:
            at += 1
        whole = at == len(PROGRAM)
        self.start = min(self.start, len(punched)) if whole else len(punched)
        frames = bytes(punched[self.start :])
        codes = [frame & 0o177 for frame in frames[-_SHOWN:]]
        made = "".join([chr(code) for code in codes if 0o40 <= code < 0o140]).strip()[-24:]
        place = FIRST if whole else FIRST + at
        there = p.pc == place and (p.ma == place or 0 < at < len(PROGRAM))
        waits = bool(p.run) and whole and FIRST <= p.ma < FIRST + len(PROGRAM)
        return Look(
            at, place, there, waits, frames, made, p.pc, p.ma, p.mb, p.sr,
            bool(p.run), bool(p.sing_step), bool(p.mem_prot), bool(p.protect), p.core[p.pc],
        )  # fmt: skip

    def answer(self, key: str, machine: Machine) -> None:
        """Called when a key was pressed; say what it did."""
        before = self.seen
        self.seen = self._look(machine)
        assert before is not None
        self.did = _done(key, before, self.seen)

    def next(self, machine: Machine) -> Step:
        """Return the next step; `did` says what the machine did since the last call."""
        before = self.seen
        now = self._look(machine)
        self.seen = now
        assert before is not None
        if now.sr != before.sr:
            self.did = _flipped(before.sr, now.sr)
        if before.run and not now.run:
            word = _word(machine.processor.core[now.ma], now.ma)
            self.did = f"It stopped by itself at {now.ma:04o}: the word there is {word}."
        if len(now.frames) > len(before.frames):
            self.did = _row(now.frames[-1])
        return self._step(now)

    def _step(self, look: Look) -> Step:
        if look.waits and look.made:
            rows = f"{len(look.frames)} rows" if len(look.frames) > 1 else "one row"
            return Step(f"{look.made}: {rows} of holes, made by you. Type on, or see your tape.")
        if look.waits:
            return Step(
                "Your program runs, and waits for a letter. Type your name: it is printed and punched."
            )
        if look.run:
            return Step("RUN is lit: a computer that runs obeys no key but STOP. Press STOP.", "stop")
        if look.step:
            return Step(
                "SING STEP is on: it stops after each cycle. Press SING STEP, to turn it off.", "sing step"
            )
        if look.at == len(PROGRAM) and FIRST < look.pc < FIRST + len(PROGRAM):
            return Step("It has stopped within your program. Press CONT: it goes on.", "cont")
        return self._put(look) if look.there else self._go(look)

    def _go(self, look: Look) -> Step:
        """Return the step that loads the next word's address or the program's start."""
        place = f"{look.place:04o}"
        if look.sr == look.place:
            return Step(
                f"The switches say {place}. Press LOAD ADD: the lamps show the word there.", "load add"
            )
        says = f"Word {look.at + 1} of 5 belongs to {place}."
        if look.at == 0:
            says = f"Memory has 4096 words. Yours begin at number {place}."
        if look.at == len(PROGRAM):
            says = f"All five words are in. They begin at {place}."
        return self._flip(says, look.place, look.sr)

    def _put(self, look: Look) -> Step:
        """Return the step that deposits the next word or starts the program."""
        if look.at == len(PROGRAM):
            return Step("Five words: you have programmed a computer by hand. Press START.", "start")
        word, says = PROGRAM[look.at]
        if look.sr != word:
            return self._flip(f"Word {look.at + 1} of 5, {word:04o}, says “{says}”.", word, look.sr)
        put = f"Press DEP: that is put into memory, at {look.place:04o}."
        return Step(f"The switches say {word:04o}. {put}", "dep")

    def _flip(self, says: str, wanted: int, sr: int) -> Step:
        how = f", or type {wanted:04o}" if self.typed else ""
        different = wanted ^ sr
        ringed = "switches" if different & different - 1 else "switch"
        return Step(f"{says} Flip the ringed {ringed}{how}.", "", wanted)


def _done(key: str, before: Look, after: Look) -> str:
    """Return what a key did; a running machine obeys only STOP and two switches."""
    if key == "stop":
        stopped = f"It has stopped: RUN is dark, and MEMORY ADDRESS says {after.ma:04o}."
        return stopped if before.run else "It had stopped already: STOP did nothing."
    if key == "sing step":
        return (
            f"SING STEP is {'on: it stops after each cycle' if after.step else 'off: it runs freely again'}."
        )
    if key == "mem prot":
        how = "on: 7600 to 7777 cannot" if after.protects else "off: all of memory can"
        return f"MEM PROT is {how} be written."
    if before.run:
        return f"It runs, and did not hear {key.upper()}."
    word = _word(after.mb, after.ma)
    if key == "load add":
        return f"MEMORY ADDRESS says {after.ma:04o}, MEMORY BUFFER the word there: {word}."
    if key == "exam":
        return f"In {after.ma:04o} is {word}. The next EXAM shows {after.pc:04o}."
    if key == "dep" and after.refused:
        return f"MEM PROT is on: {after.ma:04o} keeps its word."
    if key == "dep":
        return f"{after.ma:04o} held {before.held:04o}; now it holds {word}."
    how = "began" if key == "start" else "went on"
    return f"It {how} at {before.pc:04o}{', and runs' if after.run else '; it has stopped again'}."


def _word(word: int, place: int) -> str:
    """Return a word as an assembler has it; 0000, which most of memory holds at first, as nothing else."""
    if not word:
        return "0000"
    return of_word(word, place)[0].split(":")[0].replace("  ", " ")[:30]


def _flipped(before: int, after: int) -> str:
    said = f"The switches say {after:04o}."
    for bit in range(12):
        if before ^ after == 0o4000 >> bit:
            how = "up adds" if after > before else "down takes away"
            return f"Switch {bit} {how} {0o4000 >> bit:04o}. {said}"
    return said


def _row(frame: int) -> str:
    """Describe a row of the tape."""
    channels = " ".join([str(channel) for channel in range(8, 0, -1) if frame >> channel - 1 & 1])
    return f"{ascii.name(frame)} came in as {frame:03o}: its row has holes in channels {channels}."
