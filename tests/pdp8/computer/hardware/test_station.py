"""The levers and switches of the Teletype itself: reader, keyboard, punch; and START."""

from pdp8.computer.machine import Machine
from tests.pdp8.computer.bench import octal

COPY = "6031 5200 6036 6046 6041 5204 5200"
"""KSF, JMP .-1, KRB, TLS, TSF, JMP .-1, JMP 200."""


def copying(tape: bytes = b"", keys: bytes = b"") -> Machine:
    m = Machine()
    m.load(dict(enumerate(octal(COPY), 0o200)))
    m.teletype.reader.load(tape)
    m.start(0o200)
    m.teletype.keyboard.press(keys)
    return m


def test_a_reader_at_stop_reads_nothing() -> None:
    m = copying(b"ab")
    m.teletype.reader.lever(False)
    m.run(seconds=1)
    assert m.teletype.reader.position == 0
    m.teletype.reader.lever(True)
    m.run(seconds=1)
    assert m.teletype.punch.tape == b"ab"


def test_a_tape_that_is_still_being_made_is_read_to_its_end() -> None:
    m, parts = copying(b"a"), [b"bc", b"d", b""]
    m.teletype.reader.more = lambda: parts.pop(0)
    assert (m.run().reason, m.teletype.punch.tape) == ("tape out", b"abcd")


def test_a_key_comes_before_the_reader() -> None:
    m = copying(b"ab", b"K")
    m.run(seconds=2)
    assert m.teletype.punch.tape == b"Kab"


def test_a_punch_that_is_off_punches_nothing_and_the_printer_prints() -> None:
    m = copying(b"abc")
    m.teletype.punch.on = False
    m.run(seconds=2)
    assert bytes(m.teletype.printer.frames) == b"abc"
    assert m.teletype.punch.tape == b""
