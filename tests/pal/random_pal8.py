"""Random sources in PAL8 by a grammar: what palbart takes, and now and then what it does not.

SOURCES=5000 pytest -k palbart tests/pal     compares so many with palbart, here 40
"""

import os
import random
import re
import shutil
import subprocess
from pathlib import Path

import pal

PALBART = shutil.which("palbart")
SEEDS = range(int(os.environ.get("SOURCES", "40")))

PAL8 = {
    "source": "FIXMRI OWN=4000\n{names}{section*3-8}DECIMAL;OCTAL\n{rest}{end}",
    "names": "K0={1-277}\nK1={1-277}\nK2={1-277}\nLONGERNAME={1-277}\nX1={1-277}\nN1=5\n",
    "end": "$\n|$\n|$JUNK (\n|\n",
    "section": "{begin}\n{line*1-11}",
    "begin": "{origin}|{origin}|{origin}|{origin}|{page}|FIELD {0-3}|RELOC {moved}|NOPUNCH|ENPUNCH",
    "origin": "*{1-7}{half}{0-5}{0-7}",
    "half": "0|2|4|6",
    "page": "PAGE|PAGE|PAGE {0-6}|PAGE -1",
    "moved": "|400|1000|.+200",
    "line": "{label}\t{statement}{more}{comment}\n",
    "label": "||||{new},|{new}, |{new},\t",
    "more": "||||;{statement}",
    "comment": "||| |\t/A <;$> COMMENT",
    "statement": "{usual}|{usual}|{usual}|{usual}|{condition}|{text}|{assign}|{pseudo}",
    "usual": "{reference}|{reference}|{operate}|{expression}",
    "reference": "{mri} {address}|{mri} {address}|{mri} Z {address}|{mri} I {0-177}",
    "mri": "AND|TAD|ISZ|DCA|JMS|JMP|OWN",
    "operate": "CLA|CLL CMA|RAL|SZA CLA|HLT|IAC;RTL|KSF|TLS|CDF 10|NOP|SPA SNA",
    "address": "{literal}|{literal}|{named}|{named}|.{offset}|{expression}",
    "named": "{tag}{offset}|{name}{offset}",
    "name": "K0|K1|K2|LONGERNAME|X1|N1",
    "offset": "|+1|+2|-1|+K1",
    "literal": "({inside}|({inside}|({inside})|[{inside}|[{inside}]",
    "inside": "{expression}|{mri} {item}|{mri} I {0-177}|{mri} I {item}|CLA CLL|CMA|JMP I 20|SZA",
    "item": "{0-11}|{0-7777}|{0-7777}|{name}|{tag}|.|{quoted}",
    "quoted": "".join(f'|"{character}' for character in "ABCXYZ0189 .;$,+-*=()[]<&!?@#")[1:],
    "expression": "{sign}{item}{rest of it*0-3}{tail}",
    "rest of it": "{operator}{item}",
    "operator": "+|-|!|&|^",
    "sign": "|||-",
    "tail": "||||||||| {item}|%{1-7}",
    "condition": "{when} <{conditional}>{after}",
    "when": "IFDEF {known}|IFNDEF {known}|IFZERO {name}-{0-2}|IFNZRO {name}&1",
    "known": "{name}|{tag}|NONAME",
    "conditional": "|5|\n\tTAD (7\n|CLA;HLT|IFDEF K1 <6>|\n\tIFNDEF K2 <\n8>\n1\n",
    "after": "|;HLT|\n",
    "text": 'TEXT /{letters}/|TEXT "{letters}"|TEXT %AB%|ASCII /{letters}/|ZBLOCK 3|DEVICE SYS|{file}|{long}',
    "letters": "|A\t|Z.1|0 9$|ABC;,+|-*=()[]|<&!?@#",
    "file": "FILENAME PIP.SV|FILENAME LONGERNAME|FILENAME A.SAVE",
    "long": "DUBL;{0-7777777};-{0-7777777}|FLTG;{1-7777}.{0-777};-7;NOP|FLTG;0.0{1-777};5",
    "assign": "{name}={expression}",
    "pseudo": "DECIMAL;{decimal};OCTAL|XLIST|PAUSE|FIXTAB|EJECT A",
    "decimal": "89|{name}=4095-8|TAD (19|-{0-3777}+9|[1980",
}
"""The ways to write each part, between bars; {part*3-8}: as many; {1-277}: an octal number."""


def written(grammar: dict[str, str], seed: int) -> str:
    """Return a source. {new}: the next tag; {last}: that; {tag}: it, or near it; {rest}: what is left."""
    author, tags = random.Random(seed), 0

    def way(found: re.Match[str]) -> str:
        nonlocal tags
        name, least, most = found.groups()
        match name:
            case "new":
                tags += 1
                return f"T{tags}LONGER"
            case "last":
                return f"T{tags}LONGER"
            case "tag":
                return f"T{author.randrange(1, tags + 4)}LONGER"
            case "rest":
                return "".join(f"T{tag}LONGER,\t0\n" for tag in range(tags + 1, tags + 4))
            case "":
                return f"{author.randint(int(least, 8), int(most, 8)):o}"
        times = author.randint(int(least), int(most)) if least else 1
        return "".join(whole(author.choice(grammar[name].split("|"))) for _ in range(times))

    def whole(text: str) -> str:
        return re.sub(r"\{([a-z ]*)\*?(?:(\d+)-(\d+))?\}", way, text)

    return whole(grammar["source"])


def palbarts(source: str, folder: Path, *options: str) -> tuple[bytes, str]:
    """Return the tape that palbart makes, without leader and trailer, and its messages."""
    for path in folder.iterdir():
        path.unlink()
    (folder / "x.pal").write_text(source)
    command = [str(PALBART), *options, "x.pal"]
    done = subprocess.run(command, cwd=folder, capture_output=True, check=False, timeout=10)
    if done.returncode < 0:
        return b"", "crashed"
    errors = folder / "x.err"
    said = errors.read_text() if errors.exists() else ""
    return (folder / "x.bin").read_bytes().strip(b"\x80"), said if done.returncode else ""


def compare(source: str, folder: Path) -> str:
    """Return what is different between palbart and ours, "" if nothing is."""
    tape, said = palbarts(source, folder, "-$")
    assembly = pal.assemble(source, dialect="pal8")
    errors = [str(diagnostic) for diagnostic in assembly.diagnostics if diagnostic.error]
    if said:
        return "" if errors else f"palbart refuses it: {said}"
    if errors:
        return f"ours alone refuses it: {errors[0]}"
    ours = assembly.tape.strip(b"\x80")
    differ = [number for number, (our, their) in enumerate(zip(ours, tape, strict=False)) if our != their]
    return f"frame {[*differ, min(len(ours), len(tape))][0]}" if ours != tape else ""
