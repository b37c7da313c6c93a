"""What holds of any source whatever."""

from hypothesis import given
from hypothesis import strategies as st

import pal
from pal.crossreference import cross_reference, text
from pal.report import as_json
from tapes import binary

CHARACTERS = "AB19 \t+-,=*;$./!a\n\r"
statements = st.text(CHARACTERS, max_size=80)
pieces = st.lists(
    st.sampled_from(
        [
            *"+-.; \t\n($IZAB*5",
            *("TAD", "CLA", "A,", "B=", "FIELD", "FIXMRI", "EXPUNGE", "FIXTAB", "DECIMAL", "OCTAL", "PAUSE"),
            *("189", "7777", "400", "1A", "/X\n"),
        ]
    ),
    max_size=60,
).map(" ".join)


def look_at_everything(assembly: pal.Assembly) -> None:
    for number in (1, 2, 3):
        assert assembly.printed(number).isascii()
    assert len(assembly.teletype) == 3
    assert [str(diagnostic) for diagnostic in assembly.diagnostics if diagnostic.error] or assembly.ok
    text(cross_reference(assembly))
    as_json(assembly)
    assert set(assembly.symbols) >= set()


@given(st.binary(max_size=200))
def test_any_bytes_assemble(source: bytes) -> None:
    look_at_everything(pal.assemble(source))


@given(st.text(max_size=100))
def test_any_text_assembles(source: str) -> None:
    look_at_everything(pal.assemble(source, modern=True))


@given(statements | pieces)
def test_any_statements_assemble_to_a_good_tape(source: str) -> None:
    assembly = pal.assemble(source)
    look_at_everything(assembly)
    if assembly.stopped:
        assert (assembly.tape, assembly.words) == (b"", {})
        return
    assert binary.decode(assembly.tape).words == assembly.words


@given(pieces)
def test_messages_of_the_three_passes_are_the_diagnostics(source: str) -> None:
    assembly = pal.assemble(source)
    printed = (assembly.printed(1) + assembly.printed(2)).splitlines()
    found = sorted(diagnostic.message for diagnostic in assembly.diagnostics if diagnostic.code)
    assert found == sorted(line for line in printed if line[2:4] == "  " and "  AT  " in line)


@given(pieces, pieces)
def test_two_tapes_are_one_after_the_other(first: str, second: str) -> None:
    assert pal.assemble(first + "\n", second).tape == pal.assemble(first + "\n" + second).tape


@given(pieces)
def test_the_same_source_gives_the_same_frames(source: str) -> None:
    assert pal.assemble(source).teletype == pal.assemble(source).teletype
