"""A few hundred hostile calls; `make fuzz` makes as many as one has time for."""

from tests.fuzz.fuzzer import failures


def test_no_hostile_input_does_more_than_be_refused() -> None:
    found = list(failures(range(1971, 2171)))
    assert not found, "\n\n".join(found)
