"""Why the Hydra-Point refuses a tape: it is turned, titled, spliced, for another control.

frame 821: block 42: 6 blank frames, where zeros are punched: a splice; `pdp8 tape cut --without 821-826`
"""

from nc.blocks import BlockError
from tapes import codes, controls, doubts, redundancy
from tapes.ascii import ends_blocks
from tapes.code import Code
from tapes.eia import CHARACTERS, DELETE, EOB
from tapes.frames import BLANK, skip
from tapes.hydrapoint import DIGITS, ROWS
from tapes.quantities import counted

_SHOWN = 5


def notes(frames: bytes, strict: bool) -> tuple[str, ...]:
    """Return what is doubtful on an EIA tape and passes the reader unnoticed, as it does not check parity; of
    one that is read as later controls did, a block that they pass over.
    """
    if strict:
        rows = frames[: frames.find(EOB)].translate(None, bytes([BLANK, DELETE]))
        passed = len(rows) == DIGITS and all(CHARACTERS.get(row, "").isdecimal() for row in rows)
        return (
            "the block before the first end of block is not read: later controls begin after that",
        ) * passed
    found = doubts.find(frames, codes.EIA) if codes.recognise(frames) is codes.EIA else []
    uneven = dict(codes.EIA.uneven(frames))
    found = [doubt for doubt in found if doubt.seen and doubt.frame not in uneven]
    shown = [f"{doubt}; the head does not check parity" for doubt in found[:_SHOWN]]
    return (*shown, *[f"and {len(found) - _SHOWN} more"] * (len(found) > _SHOWN))


def explain(frames: bytes, error: BlockError) -> str:
    """What is wrong with a tape whose block was refused, and the command that mends it, else `error`."""
    code = codes.recognise(frames)
    control = controls.other_control(frames, code)
    if control:
        text = "`pdp8 tape convert --to text` gives its G-code to a program that reads it"
        return f"a {control} tape in {code.name.upper()}, for another control than the Hydra-Point; {text}"
    way = redundancy.turned(frames)
    if way:
        return f"the tape is {redundancy.TURNED[way]}: `pdp8 tape cut {way}` turns it"
    if code is not codes.EIA:
        return _in_another_code(frames, code, error)
    labels = code.labels(frames)
    if labels and (error.frame or 0) < labels[-1].stop + ROWS:
        return codes.EIA.titled(frames, "program")
    return _in_block(frames, error)


def _in_another_code(frames: bytes, code: Code, error: BlockError) -> str:
    if error.block != 1 or code not in codes.CODES:
        return str(error)
    cure = ""
    if code is codes.ASCII:
        cure = "; `pdp8 tape punch --code eia` punches typed blocks"
        if ends_blocks(frames):
            cure = "; `pdp8 run eia.pal` translates it"
    return f"{error}; the tape seems to be {code.name.upper()}, and the machine reads EIA{cure}"


def _in_block(frames: bytes, error: BlockError) -> str:
    """Return what is wrong inside the refused block: blank tape, rubouts, or an extra end of block."""
    start = (error.frame or 0) - error.row + 1
    block = range(start, start + ROWS)
    for gap in codes.EIA.gaps(frames):
        if gap.start in block:
            said = f"{counted(len(gap), 'blank frames')}, where zeros are punched: a splice"
            return _left_out(gap, error.block, said)
    at = error.frame or 0
    if (stop := skip(frames, at, DELETE)) > at:
        return _left_out(range(at, stop), error.block, "rubouts (DEL), which the Hydra-Point reads as 15")
    if frames[start] == EOB:
        return _left_out(range(start, start + 1), error.block, "an end of block without a block")
    return str(error)


def _left_out(run: range, block: int, said: str) -> str:
    place, what = (f"{run.start}-{run.stop - 1}", "them") if len(run) > 1 else (f"{run.start}", "it")
    return f"frame {run.start}: block {block}: {said}; `pdp8 tape cut --without {place}` leaves {what} out"
