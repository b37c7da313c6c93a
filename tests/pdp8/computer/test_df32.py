"""The DF32 beside a second one: random IOTs, transfers, locked and missing discs, times of breaks."""

import random
from array import array

from pdp8.computer.hardware.teletype import Teletype
from pdp8.computer.machine import Machine
from pdp8.computer.rack.df32 import DF32, DISC
from tests.reference.df32 import PLACE, PLACES, Model

IOTS = (
    0o6601,
    0o6611,
    0o6612,
    0o6614,
    0o6615,
    0o6616,
    0o6621,
    0o6622,
    0o6623,
    0o6626,
    0o6627,
    0o6617,
    0o6613,
)
TRANSFERS = (0o6602, 0o6603, 0o6604, 0o6605, 0o6607)
EXTENSION, ADDRESS, OTHER, CLA = 0o20, 0o21, 0o22, 0o7200
NAMES = {at: place for place, at in PLACES.items()}
"""Words 0020 to 0022; CLA."""
WORDS = random.Random(32).choices(range(4096), k=4 * DISC)


def pair(draw: random.Random) -> tuple[Machine, DF32, Model]:
    """Return both, with the same random program, core and words."""
    control = DF32()
    discs = draw.choice((1, 1, 2, 4))
    control.words = array("H", WORDS[: discs * DISC])
    control.locks = draw.choice((0, 0, 0o1, 0o6, 0o377))
    m = Machine([Teletype(), control], 0o20000)
    m.wait(draw.random())
    m.stop()
    place = (m.processor.clock // PLACE + draw.randrange(4, 40)) % 2048
    track = draw.choice(
        (0, discs * DISC - 2048, draw.randrange(16 * discs) * 2048, draw.randrange(64) * 2048)
    )
    at = track + NAMES[place]
    program = [0o1000 | EXTENSION, 0o6615, CLA, 0o1000 | ADDRESS, draw.choice(TRANSFERS[1::2])]
    for number in range(draw.randrange(30)):
        program.append(draw.choice((*IOTS, CLA, 0o1000 | OTHER, 0o1000 | EXTENSION, 0o1000 | ADDRESS)))
        if number == draw.randrange(20):
            program.append(draw.choice((*TRANSFERS, 0o6601)))
        if number % 8 == 0:
            here = 0o200 + len(program)
            program += [0o6622, 0o5200 | here & 0o177]
    program += [0o6622, 0o5200 | len(program), 0o6616, 0o6626, 0o5200]
    words = {EXTENSION: at >> 6 & 0o3700 | draw.choice((0, 0o10)), ADDRESS: at & 0o7777}
    words |= {OTHER: draw.randrange(4096), 0o7750: -draw.randrange(1, 12) & 0o7777}
    words |= {0o7751: draw.randrange(0o1000, 0o7000), **dict(enumerate(program, 0o200))}
    for address in range(0o1000, 0o20000):
        if not 0o7700 <= address < 0o10000:
            m.core[address] = WORDS[address]
    m.load(words)
    m.start(0o200)
    core = [m.core[address] for address in range(0o20000)]
    return m, control, Model(core, list(control.words), control.locks, m.processor.clock, 0o200)


def lockstep(seed: int) -> int:
    """Run both; return how many breaks there were."""
    draw = random.Random(seed)
    m, control, model = pair(draw)
    for _ in range(40):
        count = draw.choice((1, 1, 2, 5, 30))
        m.run(instructions=count)
        for _ in range(count):
            model.step()
        control.advance(m.processor.clock)
        model.disc(model.tick)
        ours = (m.ac, m.pc, m.processor.clock, control.at, control.field >> 12, control.status, control.done)
        at = model.extension << 12 | model.address
        assert ours == (model.ac, model.pc, model.tick, at, model.field, model.errors, model.done), seed
    assert [m.core[address] for address in range(0o20000)] == model.core, seed
    assert list(control.words) == model.words, seed
    return len(model.breaks)


def test_both_do_the_same_at_every_tick() -> None:
    assert sum(map(lockstep, range(30))) > 50


def test_deac_names_a_missing_disc_before_any_word_is_asked_for() -> None:
    """So MAINDEC-08-D5DB counts the discs: DEAL with 0000, 1000, 2000, 3000, and DEAC after each."""
    for discs in range(1, 5):
        machine = Machine()
        control = DF32()
        machine.fit(control)
        control.content = bytes(2 * DISC * discs)
        found = []
        for disc in range(4):
            machine.load({0o200: 0o7604, 0o201: 0o6615, 0o202: 0o7200, 0o203: 0o6616, 0o204: 0o7402})
            machine.sr = disc << 9
            machine.start(0o200)
            machine.run(1)
            found.append(machine.ac >> 1 & 1)
        assert found == [int(disc >= discs) for disc in range(4)]
