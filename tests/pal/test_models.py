"""What other models do otherwise, and the notes of `pal --for`. The words are the facts' own, as octal."""

import pytest

import pal
from pal.models import MODELS, RULES, differs
from tests.conftest import Shell


@pytest.mark.parametrize(
    ("word", "here", "elsewhere"),
    [
        (0o7002, "rotates nothing on 8/L", "on 8/E it swaps the halves of AC (BSW)"),
        (
            0o7354,
            "gives the AND of both rotations on 8/L",
            "on 8/E it gives the AND of AC and the word itself",
        ),
        (0o7016, "gives the AND of both rotations on 8/L", "on 8/E it puts an address into AC"),
        (0o7005, "increments, then rotates on 8/L", "on 8, 8/S it is not defined"),
        (0o7344, "complements, then rotates on 8/L", "on 8/S it is not defined"),
        (0o7601, "does nothing on 8/L", "on 8/I, 8/E it clears AC"),
        (0o7421, "does nothing on 8/L", "on 8/E it uses MQ"),
        (0o7407, "does nothing on 8/L", "it needs the EAE"),
        (0o6000, "does nothing on 8/L", "on 8/E it skips if ION, and clears it (SKON)"),
        (0o6003, "is not defined on 8/L", "on 8/E it skips on an interrupt request (SRQ)"),
        (0o6035, "skips on the keyboard's flag, and reads on 8/L", "(KIE)"),
        (0o6211, "needs the MC8/L for a second field on 8/L", "on 8/S it does nothing"),
    ],
)
def test_what_an_8l_does_and_others_do_otherwise(word: int, here: str, elsewhere: str) -> None:
    said = differs(word, "8/L")
    assert said.startswith(here)
    assert elsewhere in said


@pytest.mark.parametrize(
    "word",
    [0o7000, 0o7004, 0o7012, 0o7041, 0o7240, 0o7300, 0o7402, 0o7600, 0o7401, 0o6001, 0o6002, 0o6036, 0o6046],
)
def test_words_that_all_models_do_alike(word: int) -> None:
    assert [differs(word, model) for model in MODELS] == [""] * len(MODELS)


def test_every_rule_names_models_that_differ() -> None:
    for rule in RULES:
        assert set(rule.does) <= set(MODELS)
        assert len(set(rule.does.values())) > 1


SOURCE = "*200\n\tCLA CLL CMA RAL RAR\nBSW=7002\n\tBSW\nMASK,\t7002\n\tTAD MASK\n\t7421\n$\n"


def test_instructions_are_noted_and_constants_are_not() -> None:
    found = pal.assemble(SOURCE, model="8/L").diagnostics
    notes = [(note.line, note.column, note.message) for note in found if note.code == "PN38"]
    assert [(line, column) for line, column, _ in notes] == [(2, 2), (4, 2)]
    assert notes[0][2].startswith("7354 gives the AND of both rotations on 8/L; on 8, 8/S it is not defined")
    assert notes[1][2] == "7002 rotates nothing on 8/L; on 8/E it swaps the halves of AC (BSW)"


def test_without_a_model_nothing_is_noted() -> None:
    assert [note.code for note in pal.assemble(SOURCE).diagnostics] == ["PN01"]  # RAL RAR


def test_the_command_notes_and_punches(shell: Shell) -> None:
    done = shell(
        f"printf '{SOURCE}' > some.pal && pal some.pal --for 8/E && ls some.bin".replace("\n", "\\n")
    )
    assert done.returncode == 0
    assert b"7002 swaps the halves of AC (BSW) on 8/E; on 8, 8/S, 8/I, 8/L it rotates nothing" in done.stderr
    assert shell("pal eia.pal -o eia.bin --for 8/K").returncode == 2


def test_the_translation_runs_on_every_model_with_a_teletype(shell: Shell) -> None:
    assert shell("pal eia.pal -o eia.bin --for 8/L").stderr == b"wrote eia.bin\n"
