"""Words spelled out as text: what courses and tools write, read by its form; nothing else is."""

import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from pdp8 import shelf
from pdp8.computer.use import program
from tapes import spelled

WORDS = {0o200: 0o7300, 0o201: 0o1250, 0o202: 0o7402, 0o250: 2}
EP = "EP, entry point and hexadecimal words"
FORMS = {
    "102 000 073 000 012 050 074 002 102 050 000 002 # in a row\n": "octal frames, one a line",
    "@080\nec0 // CLA CLL\n2a8\nf02\n@0a8\n002\n": "Verilog's $readmemh",
    "\ufeff/* two\nlines */\n@0080 0EC0 0_2A8 f02\n\n@a8 2\n": "Verilog's $readmemh",
    "@0080\n1110_1100_0000\n001010101000\n111100000010\n@00A8\n000000000010\n": "lines of twelve bits",
    "@80\n0000111011000000\n0000001010101000\n0000111100000010\n@a8\n000000000010\n": "lines of twelve bits",
    "@80\n111011000000\n0010_1010_1000\n111 100 000 010\n@0a8\n000000000010\n": "lines of twelve bits",
    "0x080:0xEC0\n0x081:0x2a8\n082: F02 ; HLT\n0A8:2\nep:080\n": f"{EP}; it starts at 0200",
    "(0200)=7300\n201: 1250\n0202/ 7402 / HLT\n0250,0002\n": "octal addresses and words",
    "sim> d 200-202 7402\nsim> DEP 200 7300\nsim> ex 200\nd 201 1250\nd 250 2\nattach ptr x\n": (
        "deposits of a SIMH script"
    ),
    "0200 7300\n0201 1250\n0202 7402\n0250 0002\n": "octal addresses and words",
    "Address  Contents\n-------  --------\n0200  7300\n0201  1250\n0202  7402\n0250  0002\n": (
        "octal addresses and words"
    ),
    "0o200 0o7300\n0o201 0o1250\n0o202 0o7402\n0o250 0o0002\n": "octal addresses and words",
    "dep -m 200 7300\nd 201 1250\nd 202 7402\nd 250 2\n": "deposits of a SIMH script",
    "@80\n0b111011000000\n0b001010101000\n0b111100000010\n@a8\n0b000000000010\n": "lines of twelve bits",
    "/ A sum\n0200: 7300 1250 7402\n / data\n0250: 0002\n": "octal addresses and words",
    "0200:730012507402\n0250:0002\n0200:\n": "octal addresses and words; it starts at 0200",  # mrieker/pdp8v
    ":06010000C00EA802020F70\n:020150000200AB\n:00000001FF\n": "Intel's hexadecimal records",
    ":060100000ec002a80f0270\n:020150000002AB\n:020000040000FA\n:00000001FF\n": "Intel's hexadecimal records",
    "WIDTH=12; DEPTH=4096; -- words; 12\n% as in\na listing %\nADDRESS_RADIX=OCT; DATA_RADIX=OCT;\nCONTENT\n"
    "BEGIN\n\n[0000..0177] : 0000; 0200 : 7300 1250\n7402; -- HLT\n250:2;\nEND;\n": (
        "Altera's memory initialization file"
    ),
    "199  0200  *200 /* A\n200 00200 7300' CLA\n  00201 1250@\n202 00202 7402\n\n  00250 0002\n": "a listing",
    "PAGE 1\n*200\n0200 7300 A, CLA\n0201 1250 TAD C\n0202 7402\n*250\n0250 0002 C, 2\nA 0200\n": "a listing",
    "; a script\nset cpu 4k\nd 200 7300 1250 7402\ndep 250 2\nd pc 200\ngo\n": "deposits of a SIMH script",
}


@pytest.mark.parametrize("text", FORMS)
def test_a_form_is_known_and_a_program(text: str) -> None:
    found = program.read(text.replace("\n", "\r\n").encode(), "x")
    assert {at: word for at, word in found.words.items() if word} == WORDS
    assert found.notes == (f"read as {FORMS[text]}",)


def test_a_line_of_bits_for_each_word() -> None:
    lines = ["000000000000"] * 0o10000
    lines[0o200:0o202] = ["111011000000", "111100000010"]
    found = spelled.found("\n".join(lines).encode())
    assert found is not None
    assert (found.words[0o200], found.words[0o201], len(found.words)) == (0o7300, 0o7402, 0o10000)


@settings(max_examples=40)
@given(
    st.dictionaries(st.integers(0, 0o77777), st.integers(0, 0o7777), min_size=8),
    st.sampled_from(list(spelled.FORMATS)),
)
@example({0o10200 + at: 1 for at in range(8)}, "ep")
@example({0o7771 + at: 1 for at in range(8)}, "mif")
def test_what_is_written_is_read(words: dict[int, int], name: str) -> None:
    text = spelled.FORMATS[name].spell(words)
    if name == "octal-frames":
        *before, high, low = (int(frame, 8) for frame in text.split())
        closed = sum(frame for frame in before if frame < 0o300) & 0o7777 == high << 6 | low
        assume(not closed)  # by chance the last word is a checksum: that is a whole tape
    found = spelled.found(text.encode())
    assert found is not None
    assert found.words == dict.fromkeys(found.words, 0) | words
    depth = text.partition("DEPTH=")[2].partition(";")[0]
    assert not depth or int(depth) > max(words), "Quartus refuses a word beyond the memory"


@pytest.mark.parametrize(
    "name", [name for name in shelf.bundled() if name.endswith((".pal", ".asc", ".for", ".eia"))]
)
def test_nothing_else_is(name: str) -> None:
    assert spelled.found(shelf.read_bundled(name)) is None


def test_nor_is_a_source_or_a_table_or_a_listing_without_a_line() -> None:
    cut = "0200 7300 A\n0201 7001 B\n0202 7402 C /A * B, NEXT PAGE\n0204 5200 D"
    others = "*200\n7300\n$", "D 200", "00190290303500", "12 34", "@", "EP:", "L,\n0200 7300"
    for text in (cut, cut[:11], *others):
        assert spelled.found(text.encode()) is None, text
