"""What other models do otherwise. Words as the facts have them: bits, octal."""

import re
from pathlib import Path

import pytest

from pal.models import MODELS, differs, rules
from tests.conftest import Call

TABLE = """
1110....001. 8SIL: rotates nothing|E: swaps the halves of AC (BSW)
1110....110. 8S: is not defined|IL: gives the AND of both rotations|E: gives the AND of AC and the word itself
1110....111. 8S: is not defined|IL: gives the AND of both rotations|E: puts an address into AC
1110....10.1 8S: is not defined|ILE: increments, then rotates
1110....01.1 8S: is not defined|ILE: increments, then rotates
1110..1.10.. S: is not defined|8ILE: complements, then rotates
1110..1.01.. S: is not defined|8ILE: complements, then rotates
11111......1 L: does nothing|IE: clears AC
1111...1...1 8I: needs the EAE|SL: does nothing|E: uses MQ
1111.1.....1 8I: needs the EAE|SL: does nothing|E: uses MQ
1111..1....1 8IE: needs the EAE|SL: does nothing
1111.00.(?!000)...1 8IE: needs the EAE|SL: does nothing
110000000000 8SIL: does nothing|E: skips if ION, and clears it (SKON)
110000000011 8SIL: is not defined|E: skips on an interrupt request (SRQ)
110000000100 8SIL: is not defined|E: gets the flags (GTF)
110000000101 8SIL: is not defined|E: restores the flags (RTF)
110000000110 8SIL: is not defined|E: skips on the greater-than flag (SGT)
110000000111 8SIL: is not defined|E: clears all flags (CAF)
110000001000 8SIL: does nothing|E: enables interrupts of reader and punch (RPE)
110000010000 8SIL: does nothing|E: disables interrupts of reader and punch (PCE)
110000011000 8SIL: does nothing|E: clears the keyboard's flag (KCF)
110000011011 8SIL: skips on the keyboard's flag, then clears it|E: is not defined
110000011101 8SIL: skips on the keyboard's flag, and reads|E: sets the interrupt enable from AC 11 (KIE)
110000011111 8SIL: skips on the keyboard's flag, clears it, and reads|E: is not defined
110000100000 8SIL: does nothing|E: sets the printer's flag (TFL)
110000100101 8SIL: skips on the printer's flag, and prints|E: skips on a request of the Teletype (TSK)
110010...... 8IE: needs the memory extension|S: does nothing|L: needs the MC8/L for a second field
"""
"""Patterns of words, and what they do on the 8, 8/S, 8/I, 8/L and 8/E, by the last letter."""


def test_every_word_is_in_the_rules_of_the_table() -> None:
    table = []
    for pattern, row in (line.split(" ", 1) for line in TABLE.strip().splitlines()):
        does = {
            letter: what
            for models, _, what in (each.partition(": ") for each in row.split("|"))
            for letter in models
        }
        table.append((pattern, {model: does[model[-1]] for model in MODELS if model[-1] in does}))
    for word in range(0o10000):
        said = [does for pattern, does in table if re.fullmatch(pattern, f"{word:012b}")]
        assert [rule.does for rule in rules(word)] == said, f"{word:04o}"


DIFFERS = {
    (0o7005, "8"): "is not defined on 8; on 8/I, 8/L, 8/E it increments, then rotates",
    (0o7621, "8/L"): "does nothing on 8/L; on 8/I, 8/E it clears AC; "
    "does nothing on 8/L; on 8, 8/I it needs the EAE, on 8/E it uses MQ",
    (0o7521, "8/L"): "does nothing on 8/L; on 8, 8/I it needs the EAE, on 8/E it uses MQ",
    (0o7601, "8"): "",
    (0o7402, "8/E"): "",
}


def test_what_a_model_does_is_said_with_what_others_do() -> None:
    assert {(word, model): differs(word, model) for word, model in DIFFERS} == DIFFERS


def test_another_model_is_refused() -> None:
    assert MODELS == ("8", "8/S", "8/I", "8/L", "8/E")
    with pytest.raises(ValueError, match="'8/K' is not one of 8, 8/S, 8/I, 8/L, 8/E"):
        differs(0, "8/K")


def test_an_address_is_no_instruction_of_another_model(call: Call, tmp_path: Path) -> None:
    """6000 is SKON on an 8/E."""
    for word, noted in (("X", True), ("T", False), ("6000", False)):
        (tmp_path / "own.pal").write_text(f"X=6000\n*200\n\t{word}\n\tHLT\n*6000\nT,\t0\n$\n")
        assert ("PN38" in call("pal own.pal --for 8/E -o own.bin")[2]) == noted, word
