"""OS/8 as DEC shipped it: programs assembled from DEC's sources, word for word the ones on DEC's tapes, and
device handlers, frame for frame.

    PDP8_OS8=FOLDER pytest -s tests/pal/test_shipped.py     FOLDER has the DECtapes of OS/8 V3D, *.tu56

Sources and programs stand on different tapes, al-454* to al-564*; tangentsoft/pidp8i has them. FORT and SABR
are two sources each, as their first lines say; the overlays of BRTS stand in files of their own. BUILD alone
differs, because it was saved after it ran: of 655 words 421 are zeros in the source, which are variables and
return addresses, and its tables lie over the code that it runs once.

Sources: OS/8 Software Support Manual (directory, core image); the tapes.
"""

import os
import struct
from pathlib import Path

import pytest

import pal

FOLDER = os.environ.get("PDP8_OS8", "")
SAME = (
    "BASIC BATCH BCOMP BITMAP BLOAD BOOT BRTS CAMP CCL CREF DIRECT DTCOPY DTFRMT EDIT EPIC F4 FORT FOTP FUTIL"
    " HELP LIBRA LIBSET LOAD LOADER MCPIP MSBAT PAL8 PASS2 PASS3 PIP PIP10 RALF RESORC RKLFMT RXCOPY SABR SET"
    " SRCCOM TDCOPY TDFRMT TDINIT TECO"
)
"""Programs of which every word is as shipped."""
OVERLAYS = ("TECO", "BRTS", "RALF")
"""What DEC says is to be assembled with /W."""
PATCHES = {"FORT": ["FPATCH"], "SABR": ["SPATCH"]}
"""Sources that are loaded over a program."""
BESIDE = {"BRTS": ["BASIC.AF", "BASIC.SF", "BASIC.FF", "BASIC.UF"]}
"""Core images of a program beside its own."""

Block = list[int]


def blocks(path: Path) -> list[Block]:
    """Return the blocks of 256 words of a DECtape, which has 129 words in each of its own."""
    raw = path.read_bytes()
    words = struct.unpack(f"<{len(raw) // 2}H", raw)
    halves = [list(words[at : at + 128]) for at in range(0, len(words) - 128, 129)]
    return [one + two for one, two in zip(halves[::2], halves[1::2], strict=False)]


def name(words: Block) -> str:
    codes = [code for word in words for code in (word >> 6, word & 0o77) if code]
    return "".join(chr(code + 64 if code < 32 else code) for code in codes)


def directory(tape: list[Block]) -> dict[str, list[Block]]:
    files, segment = {}, 1
    while segment:
        words = tape[segment]
        at, place, more = 5, words[1], -words[4] & 0o7777
        for _ in range(-words[0] & 0o7777):
            length_at = at + 1 if words[at] == 0 else at + 4 + more
            length = -words[length_at] & 0o7777
            if words[at]:
                files[f"{name(words[at : at + 3])}.{name(words[at + 3 : at + 4])}"] = tape[
                    place : place + length
                ]
            place, at = place + length, length_at + 1
        segment = words[2]
    return files


def frames(file: list[Block]) -> bytes:
    """Return the frames of a file: three in two words."""
    words = [word for block in file for word in block]
    pairs = zip(words[::2], words[1::2], strict=True)
    return bytes(c for one, two in pairs for c in (one & 0o377, two & 0o377, one >> 8 << 4 | two >> 8))


def text(file: list[Block]) -> bytes:
    return bytes(code & 0o177 for code in frames(file) if code & 0o177).partition(b"\x1a")[0]


def core(file: list[Block]) -> dict[int, int]:
    """Return {address: word} of a core image."""
    head, at, loaded = file[0], 1, {}
    for segment in range(-head[0] & 0o7777):
        origin, control = head[4 + 2 * segment], head[5 + 2 * segment]
        pages = control >> 6 & 0o37 or 32
        words = [word for block in file[at : at + (pages + 1) // 2] for word in block]
        at += (pages + 1) // 2
        for offset in range(pages * 128):
            loaded[(control & 0o70) << 9 | (origin + offset & 0o7777)] = words[offset]
    return loaded


@pytest.fixture(scope="module")
def files() -> dict[str, list[list[Block]]]:
    """Return {file: its copies on the tapes}."""
    if not FOLDER:
        pytest.skip("PDP8_OS8 names no folder with DEC's tapes of OS/8")
    found: dict[str, list[list[Block]]] = {}
    for path in sorted(Path(FOLDER).glob("*.tu56")):
        for file, content in directory(blocks(path)).items():
            found.setdefault(file, []).append(content)
    return found


def assembled(copies: list[list[Block]], wipe: bool = False) -> pal.Assembly:
    """Return the longest copy of a source (one of FORT is empty) as ours makes it."""
    assembly = pal.assemble(max(map(text, copies), key=len), dialect="pal8", wipe=wipe)
    assert assembly.ok
    return assembly


def test_programs_are_word_for_word_as_dec_shipped_them(files: dict[str, list[list[Block]]]) -> None:
    whole = []
    print()
    for each in sorted(file.removesuffix(".SV") for file in files if file.endswith(".SV")):
        if f"{each}.PA" in files:
            made: dict[int, int] = {}
            for source in (each, *PATCHES.get(each, ())):
                made |= assembled(files[f"{source}.PA"], each in OVERLAYS).words
            beside = [core(files[file][0]) for file in BESIDE.get(each, ())]
            same = 0
            for image in map(core, files[f"{each}.SV"]):  # FUTIL is there in two versions
                shipped = dict(pair for loaded in (*beside, image) for pair in loaded.items())
                same = max(same, sum(shipped.get(address) == word for address, word in made.items()))
            whole += [each] * (same == len(made))
            print(f"{each:8}{len(made):6} words, {same:6} as shipped")
    assert " ".join(whole) == SAME


def test_object_tapes_are_frame_for_frame_as_dec_punched_them(files: dict[str, list[list[Block]]]) -> None:
    """From the first origin to the checksum."""
    names = [file.removesuffix(".BN") for file in files if file.endswith(".BN")]
    both = sorted(each for each in names if f"{each}.PA" in files)
    for each in both:
        tape = assembled(files[f"{each}.PA"]).tape.strip(b"\0\x80")
        assert tape == frames(files[f"{each}.BN"][0]).rstrip(b"\0\x9a").strip(b"\0\x80"), each
    assert len(both) == 34
