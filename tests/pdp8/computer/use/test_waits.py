"""What a program waits for: the device whose flag it tests, or any that interrupts."""

import pytest

from pdp8.computer.stop import Reason
from pdp8.computer.use.waits import waits_for
from tests.pdp8.computer.bench import machine

KSF, RSF, PSF, TSF = ("6031 5200", "6011 5200", "6021 5200", "6041 5200")


@pytest.mark.parametrize(
    ("words", "tape", "said", "hands"),
    [
        (KSF, None, "a character from the keyboard or the reader.", ["keyboard", "tape"]),
        (KSF, b"", "the reader; the tape has run out.", ["keyboard", "tape"]),
        ("6032 6031 5201", b"", "the reader; the tape has run out.", ["keyboard", "tape"]),
        (RSF, None, "a frame from the high-speed reader, which has no tape.", ["high-speed tape"]),
        (
            "6014 6011 5201",
            b"",
            "a frame from the high-speed reader, which has no more tape.",
            ["high-speed tape"],
        ),
        (RSF, b"AB", "a frame from the high-speed reader, which no RFC asked for.", ["high-speed tape"]),
        (PSF, None, "It waits for the high-speed punch, which was sent nothing.", []),
        (TSF, None, "It waits for the printer, which was sent nothing: a TLS raises its flag.", []),
        ("6031 7410 5206 6041 5200 5206 7402", None, ", or the printer", ["keyboard", "tape"]),
        (
            "6001 5201",
            None,
            "It waits for an interrupt by a character from the keyboard",
            ["keyboard", "tape"],
        ),
        ("5200", None, "a loop that nothing can end", []),
    ],
)
def test_what_is_waited_for(words: str, tape: bytes | None, said: str, hands: list[str]) -> None:
    """And nothing else is named."""
    m = machine(words, tape, highspeed="6011" in words or "6021" in words)
    assert m.run(seconds=9).reason in (Reason.IDLE, Reason.TAPE_OUT)
    wait = waits_for(m)
    assert said in wait.said
    assert wait.hands == hands
    if hands == ["high-speed tape"] or not hands:
        assert "keyboard" not in wait.said


def test_a_lever_at_stop() -> None:
    m = machine(KSF, b"AB")
    m.teletype.reader.lever(False)
    m.run(seconds=9)
    assert waits_for(m).hands == ["keyboard", "lever"]
    assert "the reader's lever is at STOP" in waits_for(m).said
