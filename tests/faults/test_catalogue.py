"""The catalogue fits the sources: every fault's place is there once, and its tests exist."""

from tests.conftest import case
from tests.faults.catalogue import applied, catalogue
from tests.faults.workshop import HOUSE

FAULTS = catalogue()


def test_the_catalogue_has_a_fault_in_every_room() -> None:
    assert len(FAULTS) >= 150
    rooms = ("processor", "engine", "waiting", "teletype", "highspeed", "panel", "state", "watch")
    assert {fault.room for fault in FAULTS} >= {*rooms, "pal", "tapes", "programs", "nc", "web"}


def test_the_fault_fits() -> None:
    for fault in FAULTS:
        with case(fault):
            text = (HOUSE / fault.file).read_text()
            assert applied(fault, text) != text
            for test in fault.tests:
                assert (HOUSE / test.split("::")[0]).exists(), test
