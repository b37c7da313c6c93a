"""The register against the texts: every claim has an entry, and every entry a claim and tests that exist."""

import pytest

from tests.claims import register
from tests.claims.register import ROOT, Register, claims, load, missing

REGISTER = load()


def test_every_sentence_that_claims_something_has_an_entry() -> None:
    lines = missing(REGISTER)
    assert not lines, "judge these sentences, and add to tests/claims/claims.txt:\n" + "\n".join(lines)


@pytest.mark.parametrize("file", REGISTER.files)
def test_no_entry_has_outlived_its_sentence(file: str) -> None:
    assert set(REGISTER.files[file]) <= set(claims(file)), "remove these lines"


def test_the_tests_of_entries_are_there_and_have_bounds() -> None:
    used = {name for entries in REGISTER.files.values() for names in entries.values() for name in names}
    assert used <= set(REGISTER.tests)
    for held in REGISTER.tests.values():
        assert all((ROOT / file).exists() for file in held.run)
        assert bool(held.wider) == bool(held.prints)


def test_a_sentence_that_is_new_or_changed_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    text = [
        "It is so, here.",
        "Only this one is proved, for 5 of 6. It is `only` here.",
        "| a row | cannot. It is one |",
    ]
    monkeypatch.setattr(register, "_paragraphs", lambda path: text)
    found = missing(Register({}, {"docs/new.md": {}}))
    assert [line.split(" | ", 2)[2] for line in found[1:]] == [
        "Only this one is proved, for 5 of 6.",
        "| a row | cannot. It is one |",
    ]
