"""What an editor shows over a word or a name: the handbook's times, and the indirect word of each kind."""

from pal import meaning
from tests.conftest import case

WORDS = {
    0o1410: ("1410  TAD I 0010: add the word to the AC", "and is incremented first", "3 cycles, 4.8 µs"),
    0o3634: ("3634  DCA I 0234: deposit the AC", "indirect: 0234 holds the address", "3 cycles, 4.8 µs"),
    0o2034: ("2034  ISZ 0034: ", "", "2 cycles, 3.2 µs"),
    0o5201: ("5201  JMP 0201: jump", "jump", "1 cycle, 1.6 µs"),
    0o7041: ("7041  CIA: complement", "complement and increment the AC", "1 cycle, 1.6 µs"),
    0o6046: ("6046  TLS: ", "print a character", "an IOT, 4.25 µs"),
}
NAMES = {
    "CIA": "7041  CIA: complement and increment the AC",
    "HLT": "7402  HLT: halt",
    "SKP": "7410  SKP: skip",
    "I": "I: indirect: the word there holds the address",
    "Z": "Z: on page zero",
    "NOPE": "",
}


def test_a_word_at_0200_is_told_with_its_time() -> None:
    for word, (begins, ends, time) in WORDS.items():
        with case(f"{word:04o}"):
            told, took = meaning.of_word(word, 0o200)
            assert (told.startswith(begins), told.endswith(ends), took) == (True, True, time)
            assert ("indirect" in told) == (word & 0o7400 in (0o1400, 0o3400))
    assert meaning.of_word(0o7002, 0o200) == ["7002: no symbols give it"]


def test_a_name_is_told_with_its_word() -> None:
    for name, told in NAMES.items():
        assert meaning.of_name(name) == told
    fields = [meaning.names8()[name] for name in ("CDF", "CIF", "CDI", "RDF", "RIF", "RIB", "RMF")]
    assert all(told.endswith(", with the MC8/L") for told in fields)
    assert meaning.of_name("PAUSE").startswith("PAUSE: a pseudo-operator")
