"""The transcribed listings, made into FORTRAN that gfortran takes, and run.

265     AP=6.         /MILLING CODE       RESTORED       the line number, the author's note and what stands
330     PRINT 30,AS,AP                                   from column 73 are taken off
335 30  FORMAT(I3,I1)                                    a label goes to columns 1 to 5, a statement to
        PRINT 30,INT(AS),INT(AP)                         column 7; an I-field is given an integer: today's
                                                         FORTRAN does not print a REAL under I
"""

import re
import subprocess
from pathlib import Path

import programs

LISTINGS = Path(programs.__file__).parent

_LINE = re.compile(r"(?P<number>\d+)(?P<comment>C)? +(?:(?P<label>\d+) +)?(?P<statement>.*)")
_NOTE = re.compile(r" +/[A-Z].*")
_PRINT = re.compile(r"PRINT (?P<format>\d+),(?P<values>.*)")


def printout(listing: str, folder: Path, *options: str) -> str:
    """Compile `listing` in `folder` with gfortran's `options`, run it, return what it prints."""
    source, program = folder / "part.f", folder / "part"
    source.write_text("".join(f"{_adapted(line)}\n" for line in listing.splitlines() if line))
    subprocess.run(["gfortran", "-std=legacy", *options, "-o", program, source], check=True)
    return subprocess.run([program], check=True, capture_output=True, text=True).stdout


def _adapted(line: str) -> str:
    """Return a line as fixed form FORTRAN, a comment as an empty one."""
    found = _LINE.fullmatch(line[:72].rstrip())
    assert found, f"no line of a listing: {line}"
    if found["comment"]:
        return ""
    statement = _NOTE.sub("", found["statement"])
    if printed := _PRINT.fullmatch(statement):
        values = ",".join(f"INT({value})" for value in printed["values"].split(","))
        statement = f"PRINT {printed['format']},{values}"
    return f"{found['label'] or '':5} {statement}"
