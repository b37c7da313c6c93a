"""The products of `pdp8 tape`; what it refuses stands in tests/pdp8/cli/test_refusals.py."""

from pathlib import Path

import pytest

from tapes import ascii, eia
from tests.conftest import Call, assert_same_tape
from tests.tapes.strips import FORMAT_BIN

DRILLING = """\
001 0 00000 00000 0 35 88
002 9 03000 03500 0 01 89
003 5 01000 01000 0 01 89
004 5 01000 02000 0 01 89
005 5 04000 02000 0 01 89
006 5 04000 01000 0 01 89
"""
"""The four holes of the thesis's chapter 3, spaces "used for clarity only"."""
DIGITS = DRILLING.replace(" ", "")
SECOND = DRILLING[26:].replace("\n", "\n\n", 1)
PRINTED = "  1019   0    0   2\n  76 2250 4133  185\n"
EIA = "punch --code eia"


def product(call: Call, line: str, given: bytes) -> bytes:
    """Return what `pdp8 tape` makes of standard input, without a word."""
    status, shown, said = call(f"pdp8 tape {line}", given)
    assert (status, said) == (0, "")
    return shown.encode(errors="surrogateescape")


@pytest.mark.parametrize(
    ("line", "text", "tape"),
    [
        ("punch", DRILLING, ascii.encode(DIGITS)),
        ("punch --drop-spaces", "A B\n", ascii.encode("AB\n")),
        (
            "punch --parity even --fill 2",
            "*200\r\n\tHLT\r\n$\r\n",
            ascii.encode("*200\n\tHLT\n$\n", "even", 2),
        ),
        (f"{EIA} --drop-spaces --leader 20", DRILLING, bytes(20) + eia.encode(DIGITS) + bytes(20)),
        (f"{EIA} --keep-spaces", DRILLING, eia.encode(DRILLING)),
        *((EIA, text, eia.encode(DIGITS)) for text in (DRILLING, f"\n{DRILLING}", f"{DRILLING}   \n")),
        (EIA, DIGITS + "\n", eia.encode(DIGITS)),
        (EIA, SECOND, eia.encode(DIGITS[20:])),
        *((EIA, text, eia.encode(text)) for text in ("G1 X2\n", "1" * 17, PRINTED, " 010000000000003588\n")),
    ],
)
def test_what_is_punched_of_what_is_typed(line: str, text: str, tape: bytes, call: Call) -> None:
    assert_same_tape(product(call, line, text.encode()), tape)


def test_a_label_is_drawn_below_the_rows(call: Call) -> None:
    seven = bytes([0o001, 0o161, 0o011, 0o005, 0o003])
    for tape, span in (
        (FORMAT_BIN + seven, "--from 186"),
        (seven + bytes(3) + FORMAT_BIN, "--from 1 --to 9"),
    ):
        rows = product(call, f"show {span}", tape).decode().splitlines()
        assert rows[1].endswith("|  label")
        assert rows[-8:] == [
            f"   label    {row}".rstrip() for row in ("oooo", "   o", "  o", " o", "o", "o", "o", "")
        ]


def test_convert_tells_the_code_and_clean_leaves_digits(call: Call) -> None:
    labelled = FORMAT_BIN + b"\x41"
    spelled = product(call, "convert --to octal", labelled)
    assert_same_tape(product(call, "convert --code octal --to frames", spelled), labelled)
    for target in ("text", "octal"):
        assert call(f"pdp8 tape convert circle.eia --to {target}", terminal=True)[0] == 0
    assert product(call, "convert --to text", eia.encode("12\n")) == b"12\n"
    assert product(call, "clean", b"\x4f" + eia.encode("12\n")) == eia.encode("12\n")
    assert product(call, "clean", eia.encode("12") + b"\0" + eia.encode("34\n")) == eia.encode("1234\n")


def test_a_file_that_hides_a_bundled_one_is_named(call: Call, tmp_path: Path) -> None:
    (tmp_path / "circle.asc").write_bytes(b"A\r\n")
    said = call("pdp8 tape info circle.asc")[2]
    assert "circle.asc is the file in this folder, not the bundled one of that name" in said
