"""The hint for a case that failed: what all trials show, and the first sentence whose condition holds."""

from collections.abc import Sequence
from dataclasses import dataclass

from pdp8.computer.stop import Reason
from pdp8.lessons import diagnosis
from pdp8.lessons.diagnosis import HINTS, ITSELF, NOT_STOPPED, NOTHING
from pdp8.lessons.exercise import Case

_WEAK = (diagnosis.FIRST, diagnosis.SHIFTED, diagnosis.PARITY, diagnosis.LONG)
"""What happened in one trial, if it says less than what all of them show."""


@dataclass(frozen=True)
class Failed:
    """A failed case, with what happened and what differs for each failure."""

    case: Case
    happened: Sequence[str]
    differs: Sequence[str]
    stop: str
    """How the trial should have ended."""
    general: str = ""
    """The case's hint for any wrong result, "" where it does not apply."""
    pattern: str = ""
    """What all trials show (evidence.py)."""
    prints: bool = False
    """Whether the program has an instruction that prints."""
    first: bool = True
    """Whether it is the first case of the exercise."""
    first_right: bool = True
    """Whether the first case, on which the others build, is right."""


def hint(failed: Failed) -> str:
    """Return the hint for a case that failed, "" for none."""
    happened, named = failed.happened[0], _named(failed)
    builds_on_wrong = not failed.first and not failed.first_right
    rules = (
        (failed.pattern != "" and not failed.first, ""),
        (named != "", named),
        (ITSELF in failed.happened, HINTS[ITSELF]),
        (failed.general != "", "" if builds_on_wrong else failed.general),
        (happened == NOT_STOPPED and failed.stop != Reason.HALT, ""),
        (happened == NOTHING and failed.prints, ""),
        (happened in _WEAK and (failed.pattern != "" or builds_on_wrong), ""),
        (True, HINTS.get(happened, "")),
    )
    own = next(sentence for applies, sentence in rules if applies)
    return " ".join([each for each in (failed.pattern, own) if each])


def _named(failed: Failed) -> str:
    """Return the case's own hint for what happened or differs; if the end is wrong, only for that."""
    ends = (*diagnosis.ENDS, ITSELF)
    for happened, differs in zip(failed.happened, failed.differs, strict=True):
        if failed.happened[0] not in diagnosis.ENDS or happened in ends:
            for key in (happened, differs):
                if failed.case.hints.get(key, "") != "":
                    return failed.case.hints[key]
    return ""
