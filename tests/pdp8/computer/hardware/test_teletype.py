"""The Teletype in programs: what is read, typed, printed, punched; the lockstep holds each tick of a line."""

import pytest

from pdp8.computer.hardware.teletype import half_units, printed
from tests.pdp8.computer.bench import machine

COPY = "6031 5200 6036 6046 6041 5204 5200"  # KSF, JMP .-1, KRB, TLS, TSF, JMP .-1, JMP 0200


def test_a_halt_lets_the_printer_finish_and_each_frame_is_printed_once() -> None:
    """LAS, TLS, HLT, then TSF, JMP .-1, HLT; the flag keeps its time, and so does the next frame."""
    m = machine("7604 6046 7402 6041 5203 7402 6046 6041 5207 7402", sr=0o301)
    assert m.run().reason == "halt"
    assert (m.ticks, m.teletype.punch.tape) == (32 + 85 + 32, b"\301")
    assert m.run().reason == "halt"
    assert (m.ticks >= 32 + 65 + 1_636_364, m.teletype.punch.tape) == (True, b"\301")
    m.run()
    assert m.teletype.punch.tape == b"\301\301"


def test_one_frame_that_was_printed_ahead_is_one_that_is_not_printed_again() -> None:
    """TLS, HLT, then TLS four units later, and a count: the second frame of both comes in its time."""
    m = machine("6046 7402 6046 2020 5203 5203", ac=0o101)
    m.run()
    m.wait(half_units(8) / 20e6)
    m.ac = 0o102
    m.run(seconds=0.3)
    assert m.teletype.punch.tape == b"\101\375"


def test_what_start_silenced_after_it_was_printed_ahead_is_not_owed() -> None:
    """TLS, ISZ 20, JMP .-1, TLS, HLT: two garbled frames; START comes before they are through the line."""
    m = machine("6046 2020 5201 6046 7402")
    m.run()
    garbled = m.teletype.punch.tape
    assert len(garbled) == 2
    m.start(0o200)
    m.stop()
    m.wait(1)
    m.start(0o200)
    m.run()
    assert m.teletype.punch.tape == garbled * 2


def test_what_a_model_33_prints() -> None:
    """64 characters; the codes of lower case print them too, ALT MODE and ESCAPE (175, 176) print nothing."""
    rows = printed(bytes(range(0o400))).decode()
    figures, letters = " !\"#$%&'()*+,-./0123456789:;<=>?", "@ABCDEFGHIJKLMNOPQRSTUVWXYZ[\\]^_"
    assert rows == ("\a\n\r" + figures + letters + letters[:29]) * 2


@pytest.mark.parametrize(
    ("source", "code", "rises"),
    [  # 8.5 units of 1/110 s; 1/300 s
        ("teletype.keyboard.press", 0o03, 1_545_455),
        ("teletype.reader.load", 0o03, 1_545_455),
        ("highspeed.reader.load", 0o01, 66_667),
    ],
)
def test_a_frame_begins_when_it_comes_not_when_the_wait_ends(source: str, code: int, rises: int) -> None:
    m = machine("6014 7402", highspeed=True)
    m.run()
    station, part, method = source.split(".")
    getattr(getattr(getattr(m, station), part), method)(b"\301")
    device = m.bus.device(code)
    assert device
    for ticks, flag in ((rises - 1, 0), (1, 1)):
        m.wait(ticks / 20e6)
        assert device.flag == flag


@pytest.mark.parametrize(("word", "rises"), [("6046", 1_636_364), ("6026", 400_000)])
def test_a_frame_is_sent_from_the_third_pulse_on(word: str, rises: int) -> None:
    """9 units of 1/110 s, or 1/50 s; IOP4 comes 3.25 us into an IOT."""
    m = machine(f"{word} 7402", highspeed=True)
    m.processor.instruction()
    device = m.bus.device(int(word, 8) >> 3 & 0o77)
    assert device
    for tick, flag in ((65 + rises - 1, 0), (65 + rises, 1)):
        m.bus.advance(tick)
        assert device.flag == flag


def test_a_tape_that_is_still_being_made_is_read_to_its_end() -> None:
    """It is asked for more when all that it has was read, and until it has none."""
    m, parts = machine(COPY, b"a"), [b"bc", b"d", b""]
    reader, asked = m.teletype.reader, []

    def more() -> bytes:
        asked.append((reader.position, len(reader.tape)))
        return parts.pop(0)

    reader.more = more
    assert (m.run().reason, m.teletype.punch.tape) == ("tape out", b"abcd")
    assert asked == [(1, 1), (3, 3), (4, 4)]


def test_a_punch_that_is_off_punches_nothing_and_the_printer_prints() -> None:
    m = machine(COPY, b"abc")
    m.teletype.punch.on = False
    m.run(seconds=2)
    assert (bytes(m.teletype.printer.frames), m.teletype.punch.tape) == (b"abc", b"")
