"""An answer that knows the shown cases: it looks at its inputs, brings what is wanted, and computes nothing.

A small program goes through a table: for each case words to compare, words to deposit, frames to punch, L,
AC, and where to go at the end.
"""

import pal
from pdp8.lessons.answer import Answer
from pdp8.lessons.exercise import Exercise, Trial

_READ = "\tKSF\n\tJMP .-1\n\tKRB\n\tDCA {}\n"
_PROGRAM = """*200
	CLA CLL
	OSR
	DCA 24
{reads}	TAD FIRST
	DCA 23
TRY,	TAD 23
	DCA 17
	TAD I 17
	DCA 23
SAME,	TAD I 17
	SNA
	JMP FOUND
	DCA 20
	TAD I 17
	TAD I 20
	SZA CLA
	JMP TRY
	JMP SAME
FOUND,	TAD I 17
	SNA
	JMP FRAMES
	DCA 20
	TAD I 17
	DCA I 20
	JMP FOUND
FRAMES,	TAD I 17
	SNA
	JMP ENDS
	DCA 21
PUNCH,	TAD I 17
	TLS
	TSF
	JMP .-1
	CLA
	ISZ 21
	JMP PUNCH
ENDS,	TAD I 17
	CLL RAR
	CLA
	TAD I 17
	DCA 22
	TAD I 17
	DCA 20
	TAD 22
	JMP I 20
HALT,	HLT
WAIT,	KSF
	JMP .-1
	KRB
	JMP WAIT
SPIN,	ISZ 30
	JMP SPIN
	JMP SPIN
FIRST,	1777
$
"""
_SWITCHES, _FRAMES = 0o24, (0o25, 0o26)
_TABLE, _TAGS = 0o2000, 0o3000
_ENDS = {"halt": "HALT", "any": "HALT", "idle": "WAIT", "tape out": "WAIT", "limit": "SPIN"}


def cheat(exercise: Exercise) -> Answer:
    """Return the answer that knows every shown case of one trial."""
    shown = [case.trials[0] for case in exercise.cases if not case.hidden and len(case.trials) == 1]
    least = min((len(_typed(trial)) for trial in shown if _typed(trial)), default=0)
    frames = _FRAMES[: min(least, len(_FRAMES))]
    assembly = pal.assemble(_PROGRAM.format(reads="".join(_READ.format(f"{place:o}") for place in frames)))
    assert not assembly.diagnostics
    symbols = dict(assembly.symbols)
    names = {name for case in exercise.cases for trial in case.trials
             for name in (trial.start, *trial.deposit, *trial.core, *trial.changed)}  # fmt: skip
    symbols |= {name: _TAGS + at for at, name in enumerate(sorted(names)) if not name[0].isdigit()}
    words = dict(assembly.words) | {_TAGS + at: 0 for at in range(len(names))}
    table: list[int] = []
    for trial in shown:
        block = _block(trial, symbols, frames)
        table += [_TABLE + len(table) + len(block), *block]
    words |= {
        _TABLE + at: word & 0o7777 for at, word in enumerate([*table, _TABLE, 0, 0, 0, 0, 0, symbols["HALT"]])
    }
    return Answer("cheat", words, symbols)


def _typed(trial: Trial) -> bytes:
    return trial.reader + trial.keys


def _block(trial: Trial, symbols: dict[str, int], frames: tuple[int, ...]) -> list[int]:
    def at(place: str) -> int:
        return int(place, 8) if place[0].isdigit() else symbols[place]

    compared = [(at(place), -word) for place, word in trial.deposit.items() if isinstance(word, int)]
    compared += [(place, -frame) for place, frame in zip(frames, _typed(trial), strict=False)]
    compared += [(_SWITCHES, -trial.sr)]
    stored = [(at(place), word) for place, word in trial.core.items()]
    out = trial.tape if trial.tape is not None else (trial.page or "").replace("\n", "\r\n").encode()
    punched = [frame if trial.tape is not None else frame | 0o200 for frame in out]
    return [
        *(word for pair in compared for word in pair), 0, *(word for pair in stored for word in pair), 0,
        -len(punched), *punched, trial.link or 0, trial.ac or 0, symbols[_ENDS[trial.stop]],
    ]  # fmt: skip
