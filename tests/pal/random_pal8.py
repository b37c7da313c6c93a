"""Random sources: `written` by a grammar, mostly right, and `faulty`, in which anything stands anywhere.

SOURCES=5000 pytest -k "palbart or model" tests/pal     compares so many with palbart and with the model
"""

import os
import random
import re
import shutil
import subprocess
from pathlib import Path

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


class _Author:
    """Somebody who writes PAL8 and makes all the mistakes there are."""

    def __init__(self, seed: int) -> None:
        self.draw = random.Random(seed)
        self.depth = 0

    def one(self, ways: str) -> str:
        return self.draw.choice(ways.split("|"))

    def often(self, part: float) -> bool:
        return self.draw.random() < part

    def number(self) -> str:
        most = self.draw.choice((0o20, 0o10000, 0o400))
        return self.draw.choice(
            (f"{self.draw.randrange(most):o}", str(self.draw.randrange(100)), "7777", "200")
        )

    def name(self) -> str:
        return self.one("A|B|C|T1|T2|LOOP|LONGNAME|LONGNAMX|K|UND|X1|I|Z|CLA|TAD")

    def term(self) -> str:
        kind = self.draw.randrange(20)
        if kind < 6:
            return self.number()
        if kind < 12:
            return self.name()
        if kind < 14:
            return "." if kind < 13 else '"' + self.draw.choice('AB;/<>$ "+(Z1\ta')
        if kind < 17 and self.depth < 4:
            self.depth += 1
            inside = self.one("(|[") + self.one("|| ") + self.expression() + self.one("|)|]| )|)")
            self.depth -= 1
            return inside
        return self.reference() if kind < 18 else self.one("PAGE|TEXT||HLT|CDF 10|?|12A|189|A.B")

    def expression(self) -> str:
        text = self.one("||||-|+") + self.term()
        while self.often(0.35):
            text += self.one("+|-|!|&|^|%| | | | ") + self.one("|||| |-") + self.term()
        return text

    def reference(self) -> str:
        text = self.one("AND|TAD|ISZ|DCA|JMS|JMP|OWN")
        while self.often(0.3):
            text += self.one(" I| I| Z")
        return f"{text} {self.expression()}" if self.depth < 5 else text

    def text(self) -> str:
        mark = self.draw.choice('/"%.AX;<')
        inside = "".join(self.draw.choice('ABC 12/;<>$"@_?\t') for _ in range(self.draw.randrange(6)))
        return "TEXT" + self.one(" | | ||\t |") + mark + inside + self.draw.choice((mark, mark, mark, ""))

    def condition(self) -> str:
        self.depth += 1
        head = self.one("IFDEF |IFNDEF ") + self.one(f"{self.name()}|PAGE|5")
        if self.often(0.5):
            head = self.one("IFZERO |IFNZRO ") + self.expression()
        body = self.draw.choice((self.statement(), f"\n{self.lines(self.draw.randrange(1, 4))}", ""))
        self.depth -= 1
        return (
            head
            + self.one(" || ")
            + self.one("<|<|<|<|")
            + body
            + self.one(f">|>|>|>\n||>{self.statement()}")
        )

    def pseudo_operator(self) -> str:
        kinds = (
            "PAGE|PAGE {}|FIELD {}|FIELD 1|RELOC|RELOC {}|RELOC .+200|DECIMAL|OCTAL|NOPUNCH|ENPUNCH|FIXTAB"
        )
        kinds += "|XLIST {}|EJECT FOO;1|ZBLOCK 7|ZBLOCK 177|ZBLOCK K|ZBLOCK|DEVICE LTA12|DEVICE D1-5|DEVICE"
        kinds += (
            "|FILENAME A.B|FILENAME ABCDEFGH.IJK|FILENAME|FIXMRI OWN=4000|FIXMRI  OWN = 2400|FIXMRI G=TAD"
        )
        kinds += "|FIXMRI 5=6|FIXMRI OWN 4000|FIXMRI|DTORG {}"
        return self.one(kinds).format(self.number() if self.often(0.6) else self.expression())

    def statement(self) -> str:
        kind = self.draw.randrange(100)
        if kind < 30:
            return self.reference()
        if kind < 50:
            return self.expression()
        if kind < 58:
            return (
                self.name() + self.one(",| ,|,|=|= ") + self.one(f"{self.expression()}|{self.reference()}|")
            )
        if kind < 66:
            place = f"{self.draw.randrange(8) * 0o200 + self.draw.randrange(0o200):o}"
            return "*" + self.one(f"{place}|{self.expression()}|20|200|400|370|.+30")
        if kind < 84:
            return self.pseudo_operator()
        if kind < 87:
            return self.text()
        if kind < 91 and self.depth < 3:
            return self.condition()
        if kind < 92:
            return self.one("PAUSE|EXPUNGE|")
        soup = "AB19+-*=,;/()[]<>\". \t&^%!#@'"
        return "".join(self.draw.choice(soup) for _ in range(self.draw.randrange(8)))

    def lines(self, count: int) -> str:
        text = ""
        for _ in range(count):
            text += self.one(f"|||\t| |{self.name()},|T7,") + self.statement()
            while self.often(0.2):
                text += f";{self.statement()}"
            text += self.one('||| | |\t/COMMENT| /A <B> "C|/X>|/<Y') + "\n"
        return text

    def full_pages(self) -> str:
        text = f"*{self.draw.randrange(8) * 0o200 + self.draw.choice((0, 0o170, 0o100)):o}\n"
        for _ in range(self.draw.randrange(1, 8)):
            for _ in range(self.draw.randrange(30)):
                text += self.one("TAD (|TAD [|JMP ") + f"{self.draw.randrange(0o400, 0o500):o}\n"
            text += self.lines(self.draw.randrange(4))
            text += self.one("PAGE\n|*200\n|*210\n|*400\n|*377\n|*250\n|*20\n|*170\n|ZBLOCK 50\n|FIELD 1\n|")
        return text


def faulty(seed: int) -> str:
    """Return a source that is hardly ever right."""
    author = _Author(seed)
    text = author.one("K=5\nA=300\n||FIXMRI OWN=2400\n|*200\n")
    text += author.full_pages() if author.often(0.3) else author.lines(author.draw.randrange(2, 20))
    return text + author.one("$\n|$\n||>\n$\n|1 $\n$\n")


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
