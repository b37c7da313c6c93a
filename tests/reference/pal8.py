# mypy: disable-error-code="no-untyped-def, no-untyped-call, has-type, var-annotated, assignment"
"""DEC's PAL8 as its own rules tell it: the judge of pal/pal8.

Written from the rules of PAL8 V10D and from DEC's source of the assembler, before pal/pal8 was read; it
imports nothing of ours. It follows the mechanism register by register where faults leave something behind
(the stale value, the last operator): that makes the same tape from a faulty source. It has no allowances.

    assemble(source, wipe=False) -> Result(tape, messages)

    tape       the frames of the BIN tape, without leader and trailer; None after a fatal message
    messages   (pass, code, place): place as DEC types it, "0203" or "A" or "A+0001"

Not modelled: the listing (pass 3), /B /E /F /O, room for symbols. Where a new literal
is searched for below a bound that code has pushed up, DEC's searches all memory: `Wild` is raised.

Source: PAL8.PA V13 (DEC, 1975) beside runs of V10D under OS/8 V3D.
"""

from contextlib import suppress
from typing import NamedTuple


class Wild(Exception):
    """What DEC's makes here depends on what its memory happens to hold."""


class _Done(Exception):
    pass


class _Fatal(Exception):
    pass


class _Next(Exception):
    """Give the statement up and look for its end."""


def _pairs(text):
    words = text.split()
    return list(zip(words[::2], words[1::2], strict=True))


class Result(NamedTuple):
    tape: bytes | None
    messages: list[tuple[int, str, str]]

    def words(self):
        return core(self.tape)


PERMANENT = _pairs("""
    AND 0 TAD 1000 ISZ 2000 DCA 3000 JMS 4000 JMP 5000 NOP 7000 OPR 7000 IAC 7001 BSW 7002 RAL 7004 RTL
    7006 RAR 7010 RTR 7012 CML 7020 CMA 7040 CIA 7041 CLL 7100 STL 7120 CLA 7200 GLK 7204 STA 7240 HLT
    7402 OSR 7404 SKP 7410 SNL 7420 MQL 7421 SZL 7430 SZA 7440 SNA 7450 SMA 7500 MQA 7501 SPA 7510 SWP
    7521 LAS 7604 IOT 6000 SKON 6000 ION 6001 IOF 6002 SRQ 6003 GTF 6004 RTF 6005 SGT 6006 CAF 6007 RPE
    6010 RSF 6011 RRB 6012 RFC 6014 PCE 6020 PSF 6021 PCF 6022 PPC 6024 PLS 6026 KCF 6030 KSF 6031 KCC
    6032 KRS 6034 KIE 6035 KRB 6036 TFL 6040 TSF 6041 TCF 6042 TPC 6044 TSK 6045 TLS 6046 CDF 6201 CIF
    6202 RDF 6214 RIF 6224 RIB 6234 RMF 6244 I 400 Z 0
    """)

HANDLERS = _pairs("""
    DECIMA 207 DEVICE 2530 DTORG 5400 EJECT 5505 ENPUNC 205 EXPUNG 2667 FIELD 415 FILENA 2533 FIXMRI 464
    FIXTAB 4253 IFDEF 5050 IFNDEF 5051 IFNZRO 5001 IFZERO 5000 NOPUNC 204 OCTAL 210 PAGE 437 PAUSE 361
    RELOC 5466 TEXT 2601 XLIST 5453 ZBLOCK 4130
    """)

OPERATORS = "+-&% !^"
END = "\r"  # the current character at a logical end of line, whatever ended it


class Name:
    def __init__(self, value=0, permanent=False, mri=False, handler="", iz=False):
        self.value, self.permanent, self.mri, self.handler, self.iz = value, permanent, mri, handler, iz


def core(tape: bytes | None) -> dict[int, int] | None:
    """{address: word}, the field in bits 12 to 14, of a BIN tape's frames; None of None."""
    if tape is None:
        return None
    words, field, place, at = {}, 0, None, 0
    while at < len(tape) - 2:  # the last two frames are the checksum
        frame = tape[at]
        if frame >= 0o300:
            field, at = frame >> 3 & 7, at + 1
            continue
        word = (frame & 0o77) << 6 | tape[at + 1]
        at += 2
        if frame & 0o100:
            place = word
        else:
            place = 0 if place is None else place  # no origin at all: the loader's own, arbitrary
            words[field << 12 | place] = word
            place = place + 1 & 0o7777
    return words


def assemble(source: str, wipe: bool = False) -> Result:
    it = _Pal8(source, wipe)
    try:
        for number in (1, 2):
            it.run_pass(number)
    except _Fatal:
        return Result(None, it.messages)
    total = it.total & 0o7777
    return Result(bytes([*it.tape, total >> 6, total & 0o77]), it.messages)


class _Pal8:
    def __init__(self, source, wipe):
        text = source.replace("\r\n", "\r").replace("\n", "\r").partition("\x1a")[0]
        text = "".join(c for c in (chr(ord(c) & 0o177) for c in text) if c not in "\0\177\n\v\f")
        whole, dot, rest = text.rpartition("\r")
        self.lines = [line[:80] for line in (whole + dot + rest + "$").split("\r")]
        self.wipe = wipe
        self.names = {}
        self.gone = {}  # the values of expunged names, which stay where they were
        for name, value in PERMANENT:
            refers = name in ("AND", "TAD", "ISZ", "DCA", "JMS", "JMP")
            self.names[name] = Name(int(value, 8), True, refers, "", name in "IZ")
        for name, value in HANDLERS:
            self.names[name] = Name(int(value, 8), True, False, name)
        self.messages, self.tape, self.total = [], [], 0
        self.offset = self.offset_to_be = 0
        self.skip_origin = False
        self.value2, self.tag, self.undefined_tag = 0, Name(), False

    def run_pass(self, number):
        self.number = number
        self.row, self.column, self.line = 0, 0, ""
        self.at_line_end, self.squeeze = True, False
        self.level = self.radix = 0
        self.field = 0
        self.punching, self.raw = True, False
        self.stack = 0
        self.clean()
        self.pool_top = 0o200
        self.set_origin(0o200)
        self.next()
        with suppress(_Done):
            self.statements()

    # ---- characters

    def next(self):
        """The next character into self.char: blanks squeezed, a logical end of line as END."""
        while True:
            if self.at_line_end:
                if self.row == len(self.lines):
                    self.fatal("PH")
                self.line, self.column = self.lines[self.row], 0
                self.row += 1
                self.at_line_end = self.squeeze = False
            if self.column == len(self.line):
                self.at_line_end = True
                self.char = END
                return
            c = self.line[self.column]
            self.column += 1
            if self.raw:
                self.char, self.squeeze = c, False
                return
            if c in " \t":
                if self.squeeze:
                    continue
                self.char, self.squeeze = " ", True
                return
            self.squeeze = False
            if c == ";":
                self.char = END
            elif c == "/":
                self.comment()
                self.char, self.at_line_end = END, True
            else:
                self.char = c
            return

    def comment(self):
        for c in self.line[self.column :]:
            if not self.level:
                return
            self.level += (c == "<") - (c == ">")

    def blanks(self):
        while self.char == " ":
            self.next()

    @property
    def letter(self):
        return "A" <= self.char <= "Z"

    @property
    def digit(self):
        return "0" <= self.char <= "9"

    # ---- messages

    def error(self, code, late=False):
        if late and self.number == 1:
            return
        if self.last is None:
            place = f"{self.loc:04o}"
        else:
            name, value = self.last
            place = name if value == self.loc else f"{name}+{self.loc - value & 0o7777:04o}"
        self.messages.append((self.number, code, place))

    def fatal(self, code):
        self.error(code)
        raise _Fatal

    def illegal(self):
        """IC for this character, and on to the next; at the line's end the statement is given up."""
        self.error("IC")
        if self.char == END:
            raise _Next
        self.next()

    # ---- statements

    def statements(self):
        new = True
        while True:
            try:
                if new:
                    self.statement()
                self.blanks()
                new = self.ended()
                if not new:
                    self.error("IC")
                    self.next()
            except _Next:
                new = False

    def ended(self):
        """True when a new statement may start; a `>` that closes a condition asks again."""
        while True:
            if self.char == END:
                self.next()
                return True
            if self.char != ">" or not self.level:
                return False
            self.level -= 1
            self.next()
            self.blanks()

    def statement(self):
        while True:
            self.blanks()
            if self.char == "$":
                self.dump_page()
                self.offset_to_be = 0
                if self.number == 2:
                    self.dump_zero()
                raise _Done
            if self.char == "*":
                self.next()
                self.blanks()
                self.origin(self.expression())
                return
            if not self.letter:
                if self.char in (END, ">"):
                    if self.char == END:
                        self.next()
                        continue
                    return
                self.put(self.expression())
                return
            name, known = self.look_up()
            if self.tag.handler:
                if getattr(self, "do_" + self.tag.handler.lower())() != "new":
                    return
                continue
            if self.char == ",":
                self.define_tag(name, known)
                continue
            if self.char == "=":
                self.equals(name, False)
                return
            self.put(self.expression(found=True))
            return

    def look_up(self):
        name = ""
        while self.letter or self.digit:
            name += self.char
            self.next()
        name = name[:6]
        known = name in self.names
        self.tag = self.names[name] if known else Name(self.gone.get(name, 0))
        self.tag = Name(self.tag.value, self.tag.permanent, self.tag.mri, self.tag.handler, self.tag.iz)
        self.value2 = self.tag.value
        self.undefined_tag = not known
        return name, known

    def define_tag(self, name, known):
        self.next()
        self.undefined_tag = False
        if not known:
            self.names[name] = Name(self.loc)
            self.tag, self.value2 = Name(self.loc), self.loc
        elif self.names[name].value != self.loc:
            self.error("ID")
            return
        self.last = (name, self.loc)

    def equals(self, name, mri):
        self.next()
        undefined = self.undefined_tag
        self.push(6)
        self.blanks()
        value = self.expression()
        self.stack -= 6
        self.undefined_tag = undefined
        if self.undefined:
            self.error("IE", late=True)
            self.undefined = 0
            return
        self.undefined_tag = False
        old = self.names.get(name)
        if old is None:
            old = self.names[name] = Name(value)
        elif old.value != value and old.permanent:
            self.error("RD")
        if old.handler:
            raise Wild
        old.value, old.mri = value, mri
        self.tag, self.value2 = Name(value, old.permanent, mri, "", old.iz), value

    # ---- expressions

    def push(self, cells):
        self.stack += cells
        if self.stack > 34:
            self.fatal("BE")

    def expression(self, found=False, mri_ok=True):
        """The value of the expression that begins here; self.undefined is -1 if a name in it is undefined."""
        self.mri_ok = mri_ok
        self.value, self.undefined, self.op = 0, 0, "+"
        self.push(1)
        term_due = not found
        if found:
            if self.take_name():
                self.stack -= 1
                return self.value
        elif self.char in "+-":
            self.operator()
        while True:
            if term_due:
                done = self.term()
                if done:
                    break
            term_due = True
            while self.char not in OPERATORS:
                if self.ends():
                    break
            else:
                self.operator()
                continue
            self.finish()
            break
        self.stack -= 1
        return self.value

    def operator(self):
        self.op = self.char
        self.next()
        self.mri_ok = False

    def finish(self):
        if self.undefined:
            self.undefined, self.value = -1, 0

    def ends(self):
        """True at what may end an expression; anything else is IC and dropped."""
        if self.char in "])><" + END:
            return True
        self.illegal()
        return False

    def term(self):
        """One term combined with the value; True when the expression ends with it."""
        while True:
            c = self.char
            if c == ".":
                self.next()
                self.value2 = self.loc
                return self.combine()
            if c == '"':
                if self.column == len(self.line):
                    self.error("IC")
                    self.char, self.at_line_end = END, True
                    self.finish()
                    return True
                self.value2 = ord(self.line[self.column]) | 0o200
                self.column += 1
                self.squeeze = False
                self.next()
                return self.combine()
            if c in "([":
                return self.literal(c == "[")
            if self.letter:
                self.look_up()
                return self.take_name()
            if self.digit:
                return self.take_number()
            if not self.ends():
                continue
            if self.op == " ":
                self.finish()
                return True
            self.error("IC")
            return self.take_name()

    def combine(self):
        a, b, op = self.value, self.value2, self.op
        if op == "+":
            a += b
        elif op == "-":
            a -= b
        elif op == "&":
            a &= b
        elif op in " !":
            a |= b
        elif op == "^":
            a *= b
        else:
            self.value2 = -b & 0o7777
            a = a // b if b else 0
        self.value = a & 0o7777
        return False

    def take_number(self):
        base, number = (10 if self.radix else 8), 0
        while self.digit:
            if base == 8 and self.char in "89":
                self.illegal()
            else:
                number = number * base + int(self.char) & 0o7777
                self.next()
        self.value2 = number
        return self.combine()

    def take_name(self):
        """The name that was looked up last as a term; where none was, the stale one."""
        if self.tag.handler:
            self.error("IP")
        if self.undefined_tag:
            self.undefined_tag = False
            self.undefined += 1
            if self.undefined == 0 or self.number == 2:
                self.error("US")
        if not (self.tag.mri and self.char == " "):
            return self.combine()
        self.blanks()
        if self.char == END or not self.mri_ok:
            return self.combine()
        return self.memory_reference()

    def memory_reference(self):
        self.push(2)
        operation, iz, found = self.value2, 0, False
        while self.letter:
            self.look_up()
            if not self.tag.iz:
                found = True
                break
            iz = iz + (self.value2 or 1) & 0o7777
            self.blanks()
        address = self.expression(found=found, mri_ok=False)
        self.stack -= 2
        self.value2 = operation
        if address & 0o7600:
            if (address ^ self.loc) & 0o7600:
                address = self.find(address, page=self.loc >> 7)
                self.indirect()
            self.value2 = self.value2 + 0o200 & 0o7777
            if iz & 0o77:
                self.error("IZ")
        if iz & 0o7700:
            self.indirect()
        self.value = (address & 0o177) + self.value2 & 0o7777
        return True

    def indirect(self):
        if self.value2 & 0o400:
            self.error("II")
        self.value2 |= 0o400

    def literal(self, zero):
        self.next()
        self.blanks()
        self.push(4)
        kept = self.mri_ok, self.op, self.value
        value = self.expression()
        self.value2 = self.find(value, 0 if zero else self.loc >> 7)
        self.mri_ok, self.op, self.value = kept
        self.stack -= 4
        if self.char in ")]":
            self.next()
        return self.combine()

    # ---- pools

    def clean(self):
        self.bottom = [0o200] * 32
        self.top = [0] * 32
        self.here, self.zero = {}, {}
        self.last = None

    def find(self, value, page):
        """The address of the literal in the page's pool; a new one goes below."""
        pool, high, least = (self.here, self.pool_top, 0o100) if page else (self.zero, 0o200, 0o20)
        bottom = self.bottom[page]
        if bottom > high:
            raise Wild
        for at in range(bottom, high):
            if pool[at] == value:
                return page << 7 | at
        if self.top[page] >= bottom or bottom - 1 < least:
            self.error("PE" if page else "ZE", late=True)
        else:
            self.bottom[page] -= 1
        pool[bottom - 1] = value
        return (page << 7) + bottom - 1

    def dump_page(self):
        page = self.loc >> 7
        if not page:
            return
        bottom = self.bottom[page]
        if bottom < self.pool_top:
            self.skip_origin = False
            self.set_origin(page << 7 | bottom)
            for at in range(bottom, self.pool_top):
                self.punch(self.here[at])
                self.loc = self.loc + 1 & 0o7777
            if self.wipe:
                self.bottom[page] = self.pool_top
        if self.wipe:
            self.top[page] = 0

    def dump_zero(self):
        bottom = self.bottom[0]
        if bottom < 0o200:
            self.set_origin(bottom)
            for at in range(bottom, 0o200):
                self.punch(self.zero[at])
                self.loc = self.loc + 1 & 0o7777

    def enter_page(self):
        self.pool_top = self.bottom[self.loc >> 7]

    def put(self, value):
        page, at = self.loc >> 7, self.loc & 0o177
        if at >= self.bottom[page]:
            self.bottom[page] = at + 1
            self.error("PE" if page else "ZE", late=True)
        self.top[page] = max(self.top[page], at + 1)
        self.punch(value)
        self.loc = self.loc + 1 & 0o7777
        if not self.loc & 0o177:
            self.enter_page()

    # ---- the tape

    def frame(self, *frames):
        if self.number == 2 and self.punching:
            self.tape.extend(frames)
            self.total += sum(frame for frame in frames if frame < 0o200)

    def punch(self, word):
        self.frame(word >> 6, word & 0o77)

    def set_origin(self, place):
        self.loc = place & 0o7777
        if self.number == 1:
            return
        if not self.skip_origin:
            real = self.loc + self.offset & 0o7777
            self.frame(0o100 | real >> 6, real & 0o77)
        self.skip_origin = False

    # ---- origins

    def origin(self, value, skip=False):
        self.skip_origin = skip
        if self.undefined == -1:
            self.error("UO")
        if (value ^ self.loc) & 0o7600:
            self.dump_page()
            self.offset = self.offset_to_be
            self.begin_page(value)
        else:
            self.offset = self.offset_to_be
            self.set_origin(value)
            self.last = None

    def begin_page(self, value):
        self.set_origin(value)
        self.enter_page()
        self.last = None

    def argument(self):
        self.blanks()
        return self.char not in (">", END)

    def do_page(self):
        self.dump_page()
        if self.argument():
            self.begin_page(self.expression() << 7 & 0o7600)
        else:
            self.begin_page(self.loc + 0o177 & 0o7600)

    def do_field(self):
        self.blanks()
        self.dump_page()
        self.dump_zero()
        self.field = self.expression() & 7
        self.frame(0o300 | self.field << 3)
        self.clean()
        self.begin_page(0o200)

    def do_reloc(self):
        if self.argument():
            value = self.expression()
            self.offset_to_be = self.loc + self.offset - value & 0o7777
        else:
            value = self.loc + self.offset & 0o7777
            self.offset_to_be = self.undefined = 0
        self.origin(value, skip=True)

    # ---- the other pseudo-operators

    def do_decima(self):
        self.radix = 1

    def do_octal(self):
        self.radix = 0

    def do_nopunc(self):
        self.punching = False

    def do_enpunc(self):
        self.punching = True

    def do_pause(self):
        self.row, self.at_line_end, self.char = len(self.lines), True, END
        self.lines = [*self.lines, "$"]

    def do_xlist(self):
        if self.argument():
            self.expression()

    def do_eject(self):
        while self.char != END:
            self.next()

    def do_dtorg(self):
        self.blanks()
        value = self.expression()
        self.frame(0o300 | value >> 6, value & 0o77)
        self.total += (0o300 | value >> 6) * (self.number == 2)

    def do_zblock(self):
        self.blanks()
        for _ in range(self.expression()):
            self.put(0)

    def do_fixmri(self):
        self.blanks()
        while not self.letter:
            self.illegal()  # a blank too
        name, _known = self.look_up()
        self.blanks()
        while self.char != "=":
            self.illegal()
            self.blanks()
        self.equals(name, True)

    def do_fixtab(self):
        if self.number == 1:
            for name in self.names.values():
                name.permanent = True
            self.tag, self.value2 = Name(), 0

    def do_expung(self):
        if self.number == 1:
            self.gone |= {name: it.value for name, it in self.names.items()}
            self.names = {name: it for name, it in self.names.items() if it.handler or it.iz}
            self.tag, self.value2 = Name(), 0

    def do_text(self):
        self.raw = True
        try:
            while self.char != END and not "!" <= self.char <= "_":
                self.next()
            if self.char == END:
                self.put(0)
                return
            delimiter, codes = self.char, []
            self.next()
            while self.char not in (END, delimiter):
                if " " <= self.char <= "_":
                    codes.append(ord(self.char) & 0o77)
                    if len(codes) == 2:
                        self.put(codes.pop(0) << 6 | codes.pop())
                else:
                    self.error("IC")
                self.next()
            self.raw = False
            if self.char == delimiter:
                self.next()
            self.put((codes or [0])[0] << 6)
        finally:
            self.raw = False

    def pack(self, room):
        codes = []
        while self.letter or self.digit:
            if len(codes) < room:
                codes.append(ord(self.char) & 0o77)
                if not len(codes) & 1:
                    self.put(codes[-2] << 6 | codes[-1])
            self.next()
        while len(codes) < room:
            codes.append(0)
            if not len(codes) & 1:
                self.put(codes[-2] << 6 | codes[-1])

    def do_device(self):
        self.blanks()
        self.pack(4)

    def do_filena(self):
        self.blanks()
        self.pack(6)
        if self.char == ".":
            self.next()
        self.pack(2)

    # ---- conditions

    def do_ifzero(self):
        self.blanks()
        value = self.expression()
        return self.condition(value == 0)

    def do_ifnzro(self):
        self.blanks()
        value = self.expression()
        return self.condition(value != 0)

    def do_ifdef(self):
        return self.condition(self.defined())

    def do_ifndef(self):
        return self.condition(not self.defined())

    def defined(self):
        self.blanks()
        while not self.letter:
            self.illegal()
            self.blanks()
        kept = self.undefined_tag
        _name, known = self.look_up()
        self.undefined_tag = kept
        if self.tag.handler:
            self.error("IP")
        self.blanks()
        return known

    def condition(self, true):
        while self.char != "<":
            self.illegal()
            self.blanks()
        self.next()
        outside = self.level
        self.level += 1
        if not true:
            while self.level > outside:
                self.level += (self.char == "<") - (self.char == ">")
                self.next()
        return "new"
