"""A solution with one slip in it, and the same solution written otherwise: what a class might hand in.

An exercise rejects each slip that changes what the program does, and accepts every other way (proof.py).
"""

import re
from collections.abc import Iterator

from tapes.text import lines_of

_SLIPS = {
    "TAD": "AND DCA", "AND": "TAD", "DCA": "TAD", "ISZ": "TAD", "JMP": "JMS", "JMS": "JMP", "I": "",
    "SZA": "SNA", "SNA": "SZA", "SMA": "SPA", "SPA": "SMA", "SZL": "SNL", "SNL": "SZL", "SKP": "NOP",
    "CIA": "CMA", "CMA": "CIA", "IAC": "CMA", "CLA": "NOP", "CLL": "NOP", "STL": "CLL", "OSR": "NOP",
    "RAL": "RAR RTL", "RTL": "RAL RTR", "RAR": "RAL RTR", "RTR": "RAR RTL",
    "KRB": "KRS", "KSF": "TSF", "TSF": "KSF", "TLS": "TPC", "HLT": "NOP", "ION": "NOP",
}  # fmt: skip
"""What is written in place of a symbol."""
_WORD = re.compile(r"[A-Z]\w*|(?<=[-\t,;+ ])[0-7]+(?!\w)", re.ASCII)
_LINE = re.compile(r"(?P<tag>\w+,)?\s*(?P<code>[^/]*?)\s*(?P<comment>/.*)?")
ELSEWHERE = 0o400
"""A solution that uses no address from here on may also be at another place."""
_TWICE = re.compile("TAD|ISZ|JMS|R[AT][LR]|C[IM]A|IAC|KRB|TLS")
_BEHIND = re.compile(r"\.[-+]\d")


def slips(source: str) -> Iterator[tuple[str, str]]:
    """Yield (slip, program): an instruction omitted, doubled or swapped, a wrong symbol or number."""
    lines = lines_of(source)
    tags = [found["tag"].rstrip(",") for line in lines if (found := _LINE.fullmatch(line)) and found["tag"]]
    for at, line in enumerate(lines):
        found = _LINE.fullmatch(line)
        if found is None or not found["code"] or found["code"][0] in "*$":
            continue
        before, code, tag = line[: found.start("code")], found["code"], found["tag"] or ""

        def changed(*written: str, at: int = at, many: int = 1) -> str:
            return "\n".join([*lines[:at], *written, *lines[at + many :]]) + "\n"

        yield f"line {at + 1}: no {code}", changed(tag)
        if _TWICE.match(code):
            yield f"line {at + 1}: {code} twice", changed(line, f"\t{code}")
        after = _LINE.fullmatch(lines[at + 1]) if at + 1 < len(lines) else None
        if after and after["code"] and after["code"][0] not in "*$":
            other = f"{after['tag'] or ''}\t{code}"
            yield (
                f"line {at + 1}: {code} after {after['code']}",
                changed(f"{tag}\t{after['code']}", other, many=2),
            )
        for word in _WORD.finditer(code):
            for instead in _instead(word[0], tags):
                wrong = f"{code[: word.start()]}{instead}{code[word.end() :]}"
                yield f"line {at + 1}: {wrong} for {code}", changed(f"{before}{wrong}")


def _instead(word: str, tags: list[str]) -> list[str]:
    """Return possible slips for a symbol or number."""
    if word[0].isdigit():
        return [f"{int(word, 8) + step:o}" for step in (1, -1) if int(word, 8) + step >= 0]
    if word in tags:
        at = tags.index(word)
        return [tags[at - 1], tags[(at + 1) % len(tags)], f"{word}+1"] if len(tags) > 2 else [f"{word}+1"]
    return _SLIPS[word].split() or [""] if word in _SLIPS else []


def restatements(source: str, kept: set[str], longer: bool, elsewhere: bool) -> Iterator[tuple[str, str]]:
    """Yield (how, program) written otherwise; tags in `kept` stay; `longer`, `elsewhere` allow more."""
    plain = "\n".join(line.partition("/")[0].rstrip() for line in lines_of(source)) + "\n"
    yield "in lower case", source.lower()
    yield "with CR LF", source.replace("\n", "\r\n")
    yield "with blanks for tabs", source.replace("\t", "    ")
    yield "without comments", plain
    yield "with comments and blank lines", plain.replace("\n", ' / IT\'S "MINE"; $ *200\n\n/ MORE\n')
    yield "without $", source.replace("\n$", "\n")
    tags = [word for word in re.findall(r"[A-Z]\w*(?=,)", plain) if word not in kept]
    other = {tag: f"Q{at}" for at, tag in enumerate(tags)}
    yield "with other tags", re.sub(r"\b[A-Z]\w*", lambda word: other.get(word[0], word[0]), plain)
    for word in ("CIA:CMA IAC", "HLT:7402", "CLA CLL:CLL CLA", "STL:CLL CML", "SKP:7410", "TLS:TCF TPC"):
        mnemonic, _, instead = word.partition(":")
        if mnemonic in plain and not {mnemonic, *instead.split()} & kept:
            yield f"{instead} for {mnemonic}", re.sub(rf"\b{mnemonic}\b", instead, plain)
    if longer and not _BEHIND.search(re.sub(r"[KT]SF\n\tJMP \.-1", "", plain)):
        yield "with NOPs", re.sub(r"(\tDCA .*\n)", r"\1\tNOP\n", plain)
        yield "with TCF", plain.replace("TSF\n\tJMP .-1\n", "TSF\n\tJMP .-1\n\tTCF\n")
        if elsewhere:
            yield "at another place", plain.replace("*200\n", "*200\n\tJMP I .+1\n\t1000\n*1000\n", 1)
