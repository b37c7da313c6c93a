"""The catalogue fits the sources: every fault's place is there once, and its tests exist."""

from tests.conftest import case
from tests.faults.catalogue import applied, catalogue
from tests.faults.workshop import HOUSE


def test_each_fault_fits() -> None:
    for fault in catalogue():
        with case(fault):
            text = (HOUSE / fault.file).read_text()
            assert applied(fault, text) != text
            for test in fault.tests:
                assert (HOUSE / test.split("::")[0]).exists(), test
