"""Random situations: words in core, tapes, and what the operator does between pieces of a run.

Three kinds of core, and what is laid over them:

    nonsense   words by chance, everywhere
    crowded    a loop of some twenty words that reads, writes and executes the same few cells in every way,
               where a page or core ends, or in MEM PROT's page; from wherever it strays a pointer leads back
    waiting    loops that wait for flags, interrupts and counters, with work between them

And one for the Teletype alone, at_the_teletype, and one for the panel, at_the_panel, where a hand comes
between any two cycles. The same seed gives the same situation.
"""

import random
from collections.abc import Iterator
from math import ceil
from typing import Any, NamedTuple

BASES = (0o0200, 0o0371, 0o1760, 0o7600, 0o7770, 0o0010, 0o0160)
INDEXES = range(0o10, 0o20)
POINTERS = range(0o20, 0o27)
BACK = 0o27
EDGES = (0o0000, 0o0177, 0o0200, 0o0377, 0o0400, 0o7577, 0o7600, 0o7776, 0o7777)

FLAG_IOTS = (0o6031, 0o6041, 0o6011, 0o6021)
DEVICE_IOTS = (0o6032, 0o6034, 0o6036, 0o6042, 0o6044, 0o6046, 0o6012, 0o6014, 0o6016, 0o6022, 0o6024, 0o6026)
ODD_IOTS = (
    *(0o6000, 0o6003, 0o6005, 0o6033, 0o6035, 0o6037, 0o6043, 0o6045, 0o6047),
    *(0o6013, 0o6027, 0o6214, 0o6171),
)
ION, IOF, SKP, JMP_I_0 = 0o6001, 0o6002, 0o7410, 0o5400


class Act(NamedTuple):
    """One thing an operator does: a method of both sides, and its arguments."""

    name: str
    values: tuple[Any, ...] = ()


def call(path: str, *values: Any) -> Act:
    """Return the act of calling what has this path in a machine."""
    return Act("call", (path, *values))


def put(path: str, value: int) -> Act:
    """Return the act of setting it."""
    return Act("set", (path, value))


def load_tape(fast: bool, frames: bytes) -> Act:
    """Return the act of putting a tape in one of the readers."""
    return call(f"{_STATIONS[fast]}.reader.load", frames)


_STATIONS = ("teletype", "highspeed")
STOP, START, CONT, LOAD_ADD = (call(f"panel.{key}") for key in ("stop", "start", "cont", "load_add"))
SINGLE_CYCLE = Act("single_cycle")
"""CONT under SING STEP."""
_LOOKED_AT = (
    *(Act("look"), call("wait", 0), call("run", 0), call("run", None, 0), call("values")),
    *(call("__repr__"), call("teletype.receiver.out_of_tape"), call("highspeed.reader_control.out_of_tape")),
)
LOOKS = {path for _, (path, *_) in _LOOKED_AT[1:]}
"""What is called to look at a machine, which changes nothing."""


class Situation(NamedTuple):
    """A machine switched on with `words` in core, with the PC8/L if `fast`, and what is done to it; with
    `memory` words of core and two devices with data breaks, unless that is 0.
    """

    fast: bool
    words: dict[int, int]
    acts: tuple[Act, ...]
    memory: int = 0


def situation(seed: int, longest: int = 100_000) -> Situation:
    """Return the situation of `seed`; no piece of its run has more than `longest` instructions."""
    draw = random.Random(seed)
    base = draw.choice((*BASES, draw.randrange(0o10000)))
    kind = draw.choice((_nonsense, _crowded, _crowded, _crowded, _waiting))
    words = kind(draw, base)
    if draw.random() < 0.6:
        words |= _service(draw)
    return Situation(draw.random() < 0.5, words, tuple(_acts(draw, base, longest)))


def in_the_rack(seed: int, longest: int = 100_000) -> Situation:
    """Return one with the memory extension, and with two devices that steal cycles."""
    draw = random.Random(seed)
    memory = draw.choice((0o20000, 0o20000, 0o100000))
    base = draw.choice((*BASES, draw.randrange(0o10000)))
    words: dict[int, int] = {}
    for field in {0, 0o10000, draw.randrange(0, memory, 0o10000)}:
        own = draw.choice((_nonsense, _crowded, _crowded, _waiting))(draw, base)
        for _ in range(draw.randrange(1, 6)):
            own[base + draw.randrange(12) & 0o7777] = _rack_iot(draw)
        own |= {cell: draw.choice((0o7776, 0o7700, draw.randrange(0o10000))) for cell in range(0o30, 0o34)}
        words |= {field | address: word for address, word in own.items()}
    if draw.random() < 0.6:
        service = _service(draw)
        words |= service
        if draw.random() < 0.7 and len(service) < 8:
            words |= {len(service) - 2: 0o6244, len(service) - 1: ION, len(service): JMP_I_0}
    acts: list[Act] = []
    for act in _acts(draw, base, longest):
        if acts and acts[-1].name == "run" and draw.random() < 0.5:
            acts += _rack_hands(draw, base, memory)
            if act.name == "run":
                near = frozenset((0o30, 0o31, base, draw.randrange(0, memory, 0o10000) | base))
                acts.append(Act("watch", (near, draw.random() < 0.5)))
        acts.append(act)
    return Situation(draw.random() < 0.3, words, tuple(acts), memory)


def _rack_iot(draw: random.Random) -> int:
    """Return an IOT of the memory extension, or of a device with data breaks."""
    if draw.random() < 0.6:
        return (
            0o6200
            | draw.choice((0, 0o10, 0o10, draw.randrange(8) << 3))
            | draw.choice((1, 2, 3, 4, draw.randrange(8)))
        )
    return 0o6700 | draw.choice((0, 0o10)) | draw.choice((1, 2, 4, 4, 6))


def _rack_hands(draw: random.Random, base: int, memory: int) -> list[Act]:
    field = draw.randrange(0, memory, 0o10000)
    near = field | base + draw.randrange(20) & 0o7777
    key = call(f"panel.{draw.choice(('load_add', 'start', 'cont', 'stop', 'exam', 'dep'))}")
    switch = put(f"panel.{draw.choice(('inst_field', 'data_field'))}", field >> 12)
    device = 0o6704 | draw.choice((0, 0o10))
    return draw.choice(
        (
            [call("core.__setitem__", near, draw.choice((any_word(draw), _rack_iot(draw))))],
            [switch],
            [STOP, switch, put("sr", base), LOAD_ADD, START],
            [STOP, switch, LOAD_ADD, key],
            [put("pc", near)],
            [call("core.__setitem__", near, device), put("ac", draw.randrange(0o10000)), put("pc", near)],
            [key],
            [Act("run_cycles", (draw.choice((1, 1, 2, 3, 5, 9)),))],
            [SINGLE_CYCLE] * draw.randrange(1, 9),
            [put("panel.sing_step", True), CONT, CONT, key, put("panel.sing_step", False)],
            [Act("breakpoints", (frozenset(field | base + draw.randrange(24) & 0o7777 for _ in range(2)),))],
            [Act("save_and_restore")],
        )
    )


def _nonsense(draw: random.Random, base: int) -> dict[int, int]:
    return {address: any_word(draw) for address in range(0o10000)}


def any_word(draw: random.Random) -> int:
    """Return a word by chance, with more IOT, OPR and JMP in the page than chance alone would give."""
    kind = draw.random()
    if kind < 0.1:
        return _iot(draw)
    if kind < 0.3:
        word = draw.randrange(0o7000, 0o10000)
        return word if draw.random() < 0.05 else _running(word)
    if kind < 0.5:
        return 0o5200 | draw.randrange(0o200)
    return _running(draw.randrange(0o10000))


def _running(word: int) -> int:
    """Return the word without its HLT bit."""
    return word & ~2 if word & 0o7403 == 0o7402 else word


def _iot(draw: random.Random) -> int:
    return draw.choice(draw.choice((FLAG_IOTS, DEVICE_IOTS, ODD_IOTS, (ION, IOF))))


def _crowded(draw: random.Random, base: int) -> dict[int, int]:
    words = dict.fromkeys(range(0o10000), 0o5400 | BACK)
    words |= {page: _running(draw.randrange(0o7000, 0o10000)) for page in range(0, 0o10000, 0o200)}
    words |= {index: _target(draw, base) - 1 & 0o7777 for index in INDEXES}
    words |= {pointer: _target(draw, base) for pointer in POINTERS}
    words |= {BACK: base}
    length = draw.randrange(6, 24)
    share = draw.choice((0, 0, 0.02, 0.2))
    for place in range(length):
        location = base + place & 0o7777
        words[location] = _iot(draw) if draw.random() < share else _busy_word(draw, location, base, length)
    if draw.random() < 0.3:
        words |= _delay(draw, base + draw.randrange(length) & 0o7777)
    return words


def _target(draw: random.Random, base: int) -> int:
    """Return an address that a crowded program points to."""
    return draw.choice(
        (
            base + draw.randrange(-4, 28) & 0o7777,
            base + draw.randrange(-2, 12) & 0o7777,
            draw.choice(EDGES),
            draw.choice(INDEXES),
            draw.choice(POINTERS),
            draw.randrange(0o10000),
        )
    )


def _busy_word(draw: random.Random, location: int, base: int, length: int) -> int:
    kind = draw.random()
    if kind < 0.3:
        return _running(draw.randrange(0o7000, 0o10000)) if draw.random() < 0.99 else draw.randrange(0o10000)
    code = draw.choice((0, 1, 1, 2, 2, 3, 3, 4, 4, 5)) << 9
    indirect = draw.choice((0, 0o400))
    if draw.random() < 0.5:
        cell = draw.choice((draw.choice(INDEXES), draw.choice(POINTERS), 0o177, draw.randrange(0o200)))
        return code | indirect | cell
    near = base + draw.randrange(length + 4) & 0o177
    return code | indirect | 0o200 | draw.choice((near, near, 0o177, 0o176, 0, location & 0o177))


def _delay(draw: random.Random, location: int) -> dict[int, int]:
    """Return ISZ and JMP .-1 at `location`, counting a cell on page zero."""
    counter = draw.choice((*POINTERS, *INDEXES))
    count = draw.choice((0o7775, 0o7700, 0o6000, 0))
    back = 0o5000 | location & 0o177 | (0o200 if location >= 0o200 else 0)
    return {location: 0o2000 | counter, location + 1 & 0o7777: back, counter: count}


def _waiting(draw: random.Random, base: int) -> dict[int, int]:
    words = dict.fromkeys(range(0o10000), 0o5400 | BACK) | {BACK: base}
    location = base
    for _ in range(draw.randrange(2, 6)):
        for word in _piece_of_waiting(draw, location):
            words[location] = word
            location = location + 1 & 0o7777
    if draw.random() < 0.3:
        words |= _delay(draw, location)
    return words


def _piece_of_waiting(draw: random.Random, location: int) -> list[int]:
    """Return words for `location` that wait, or do what there is to wait for."""
    page = 0o200 if location >= 0o200 else 0

    def jump(to: int) -> int:
        return 0o5000 | page | location + to & 0o177

    flag, other = draw.choice(FLAG_IOTS), draw.choice(FLAG_IOTS)
    return draw.choice(
        (
            [flag, jump(0)],
            [flag, jump(0), draw.choice(DEVICE_IOTS)],
            [flag, SKP, jump(4), jump(0)],
            [flag, 0o7000, other, jump(0)],
            [flag, SKP, jump(5), other, jump(0)],
            [0o7000] * draw.randrange(4) + [flag] + [0o7000] * draw.randrange(4) + [jump(0)],
            [draw.choice((0o6036, 0o6016, 0o6032, 0o6014)), draw.choice((0o6046, 0o6026, 0o6042))],
            [ION, jump(1)],
            [ION, 0o7000, jump(1)],
            [0o6000] * draw.randrange(20) + [ION],
            [0o7200, 0o1000 | draw.randrange(0o10, 0o27), 0o6046],
            [0o2020, jump(0)],
            [0o2020, flag, jump(0)],
        )
    )


def _service(draw: random.Random) -> dict[int, int]:
    """Return a service routine that returns: from 0001 on, some words, ION, JMP I 0."""
    body = [draw.choice((*DEVICE_IOTS, *FLAG_IOTS, 0o7000, 0o2026, 0o1026)) for _ in range(draw.randrange(5))]
    if draw.random() < 0.7:
        body += [0o6032, 0o6042, 0o6012, 0o6022]
    if draw.random() < 0.3:
        body = [0o6031, SKP, 0o6036, 0o6041, SKP, 0o6046, *body[:1]]
    end = [ION, JMP_I_0] if draw.random() < 0.9 else [JMP_I_0]
    if len(body) + len(end) > 7:
        return {0: 0, 1: 0o5030} | dict(enumerate(body + end, 0o30))
    return {0: 0} | dict(enumerate(body + end, 1))


def _acts(draw: random.Random, base: int, longest: int) -> Iterator[Act]:
    for fast in (False, True):
        if draw.random() < 0.7:
            yield load_tape(fast, draw.randbytes(draw.choice((1, 5, 40))))
    if draw.random() < 0.3:
        yield Act("record")
    yield from (put("sr", base), put("panel.mem_prot", draw.random() < 0.3), LOAD_ADD, START)
    if draw.random() < 0.5:
        yield put("ion", 1)
    for _ in range(draw.randrange(5, 40)):
        if draw.random() < 0.4:
            yield from _hands(draw, base)
        yield _run(draw, longest)


def _run(draw: random.Random, longest: int) -> Act:
    """Return a piece of the run, limited in ticks or in instructions, or in both."""
    instructions = min(longest, draw.choice((1, 2, 3, 10, 100, 2000, 20_000, 100_000)))
    ticks = draw.choice((None, draw.randrange(1, 2000), draw.randrange(50_000), draw.randrange(4_000_000)))
    return Act("run", (ticks, instructions))


def _hands(draw: random.Random, base: int) -> list[Act]:
    """Return what is done between two pieces of a run; a key that is dead while RUN is on may be among it."""
    fast = draw.random() < 0.5
    station, word = _STATIONS[fast], any_word(draw)
    near = (base + draw.randrange(20) & 0o7777, draw.randrange(0o30))
    return draw.choice(
        (
            [call("core.__setitem__", draw.choice(near), word)],
            [Act("deposit_at_pc", (draw.randrange(3), word))],
            [put("sr", draw.randrange(0o10000))],
            [put("panel.mem_prot", draw.random() < 0.5)],
            [call("teletype.keyboard.press", draw.randbytes(draw.randrange(1, 4)))],
            [load_tape(fast, draw.randbytes(draw.randrange(30)))],
            [call(f"{station}.reader.lever", draw.random() < 0.6)],
            [put(f"{station}.punch.on", draw.random() < 0.6)],
            [STOP],
            [STOP, Act("wait", (draw.randrange(3_000_000),))],
            [STOP, START],
            [STOP, *_key_sequence(draw, base)],
            [call(f"panel.{draw.choice(('start', 'load_add', 'exam', 'dep'))}")],
            [put("pc", base)],
            [put("ion", draw.randrange(2))],
            [put("ac", draw.randrange(0o10000)), put("link", draw.randrange(2))],
            [Act("save_and_restore")],
            [Act("record")],
            [Act("back", (draw.randrange(1, 5),))],
            [Act("back", (draw.randrange(1, 5),)), _run(draw, 5), Act("back", (1,))],
            [draw.choice(_LOOKED_AT)],
            [Act("delays", (draw.random() < 0.5,))],
            [SINGLE_CYCLE] * draw.randrange(1, 6),
            [Act("breakpoints", (frozenset(draw.sample(range(0o10000), draw.choice((0, 20, 300)))),))],
            [Act("breakpoints", (frozenset(base + draw.randrange(24) & 0o7777 for _ in range(2)),))],
            [Act("breakpoints", (frozenset(),)), Act("watch", (frozenset(), False))],
            [Act("watch", (frozenset(draw.choices((*INDEXES, *POINTERS, 0, base), k=2)), False))],
            [Act("watch", (frozenset(), draw.random() < 0.5))],
        )
    )


def _key_sequence(draw: random.Random, base: int) -> list[Act]:
    """Return LOAD ADD, some DEP or EXAM, and back to the base."""
    place = draw.choice((base + draw.randrange(20) & 0o7777, draw.choice(EDGES)))
    acts = [put("sr", place), LOAD_ADD]
    for _ in range(draw.randrange(3)):
        acts += [put("sr", any_word(draw)), call(f"panel.{draw.choice(('dep', 'exam'))}")]
    return [*acts, put("sr", base), LOAD_ADD]


HANDS = 250
"""Of one situation at the panel."""


def at_the_panel(seed: int) -> Situation:
    """Return one in which keys are pressed and switches thrown between any two cycles, running or not."""
    draw = random.Random(seed)
    base = draw.choice(BASES)
    kind = draw.choice((_nonsense, _crowded, _crowded, _waiting))
    words = kind(draw, base) | (_service(draw) if draw.random() < 0.8 else {})
    tapes = [load_tape(fast, draw.randbytes(40)) for fast in (False, True)]
    begin = (put("sr", base), LOAD_ADD, START)
    hands = [act for _ in range(HANDS) for act in (_some_cycles(draw), *_hand(draw, base))]
    return Situation(draw.random() < 0.5, words, (*tapes, *begin, *hands))


def _some_cycles(draw: random.Random) -> Act:
    return Act("run_cycles", (draw.choice((0, 1, 1, 1, 2, 3, 4, 20)),))


def _hand(draw: random.Random, base: int) -> list[Act]:
    """Return what a hand does at the panel, most often one thing; or what makes its next keys matter."""
    near = draw.choice((base, base + draw.randrange(20) & 0o7777, draw.choice(EDGES), any_word(draw)))
    key = call(f"panel.{draw.choice(('load_add', 'start', 'cont', 'cont', 'cont', 'stop', 'exam', 'dep'))}")
    return draw.choice(
        (
            *([key],) * 12,
            *([put("panel.sing_step", up)] for up in (True, True, False)),
            [put("panel.mem_prot", draw.random() < 0.5)],
            [put("sr", near)],
            [put("sr", base), LOAD_ADD],
            [STOP, put("sr", base), LOAD_ADD, START],
            [put("ion", 1)],
            [call("teletype.keyboard.press", draw.randbytes(1))],
            [Act("wait", (draw.choice((1, 70_000, 2_100_000)),))],
            [Act("run", (None, draw.randrange(1, 4)))],
            [call("core.__setitem__", near, any_word(draw))],
            [draw.choice((Act("save_and_restore"), Act("look"), Act("record"), Act("back", (1,))))],
        )
    )


KEYBOARD, PRINTER = range(0o6030, 0o6040), range(0o6040, 0o6050)
EIGHTH = 2_000_000 / 11 / 8
"""Ticks of an eighth of a unit of the Teletype's line; its clocks beat at eighths and at halves."""


class _Line:
    """About when something happens on a line: every eighth of a unit from when it was last idle."""

    def __init__(self) -> None:
        self.began = [0.0, 0.0]
        self.free = 0.0

    def begin(self, at: int, characters: int) -> None:
        if at > self.free:
            self.began = [self.began[1], at]
        self.free = max(self.free, at) + characters * 11 * 8 * EIGHTH

    def instant(self, draw: random.Random, now: int) -> int:
        """Return a tick soon after `now` in which something may happen."""
        began = draw.choice(self.began)
        eighths = (now - began) // EIGHTH + draw.randrange(draw.choice((2, 4, 20, 80)))
        return ceil(began + eighths * EIGHTH)


def at_the_teletype(seed: int) -> Situation:
    """Return one whose IOTs, keys, tapes, lever and START come near the instants that matter there."""
    draw = random.Random(seed)
    iots = {word: word for word in (*KEYBOARD, *PRINTER)}
    return Situation(False, iots, (put("sr", KEYBOARD.start), LOAD_ADD, START, *_at_its_instants(draw)))


def _at_its_instants(draw: random.Random) -> Iterator[Act]:
    now, received, sent = 0, _Line(), _Line()
    for _ in range(800):
        line, iots = draw.choice(((received, KEYBOARD), (sent, PRINTER)))
        at = line.instant(draw, now) + draw.choice((-1, -1, -30, -48, -65, -66, 30, 1000))
        waits = [max(at - now, 0), draw.choice((1, 1, 2))]
        yield from (Act("wait", (ticks,)) for ticks in waits if ticks)
        now += sum(waits)
        kind = draw.random()
        if kind < 0.6:
            word = draw.choice(iots)
            yield from (put("ac", draw.randrange(0o10000)), put("pc", word), Act("run", (None, 1)))
            if word & (4 if line is sent else 2):
                line.begin(now + (65 if line is sent else 47), 1)
            now += 85
        elif kind < 0.75:
            keys = draw.randbytes(draw.choice((1, 1, 3)))
            yield call("teletype.keyboard.press", keys)
            received.begin(now, len(keys))
        elif kind < 0.8:
            yield load_tape(False, draw.randbytes(draw.choice((1, 5, 30))))
            received.begin(now, 1)
        elif kind < 0.83:
            yield call("teletype.reader.lever", draw.random() < 0.8)
        elif kind < 0.9:
            yield from (STOP, START)
