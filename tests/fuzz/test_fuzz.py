"""A few hundred hostile calls; `make fuzz` makes as many as one has time for."""

from tests.fuzz.fuzzer import fuzz


def test_no_hostile_input_does_more_than_be_refused() -> None:
    failures: list[str] = []
    fuzz(200, 1971, failures.append)
    assert not failures, "\n\n".join(failures)
