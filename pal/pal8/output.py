"""What PAL8 punches: words, literals, origins, fields; and where each word is loaded."""

from pal.assembler import START, Output, Punched, Written
from pal.isa import ADDRESS, PAGE
from pal.notes import note
from pal.pal8.literals import END, Literals
from pal.pal8.log import Log
from pal.punch import BLOCK
from tapes.binary import FIELD, ORIGIN, WORD

_MASK = 0o7777


class Punch:
    """Puts words at the location of the log, and moves it.

    punching  False after NOPUNCH
    written   the words, in the order of the source
    tape      what is punched
    """

    def __init__(self, log: Log, literals: Literals, wipe: bool) -> None:
        self._log = log
        self._literals = literals
        self._wipe = wipe
        self._skips_origin = False
        self._relocation = 0  # from where a word runs to where it is loaded
        self._next_relocation = 0  # the same from the next origin on
        self._relocated_at = 0  # the place of the last RELOC
        self.written: list[Written] = []
        self.tape: Output = []

    def begin(self) -> None:
        """Begin a pass."""
        self._field = 0
        self.punching = True
        self._bank = 0  # the field that the loader is in, above the twelve bits
        self._loading = -1  # the address where it puts the next word
        self._checksum = 0
        self._literals.clear()
        self.enter_page(START)

    def end(self) -> None:
        """End a pass: put out the literals, punch the checksum."""
        self.leave_page()
        self._next_relocation = 0
        self.leave_page_zero()
        self.punching = True
        self.put(WORD, self._checksum & _MASK)

    def write(self, value: int, at: int, names: list[str], link: bool) -> None:
        """Put a word at the location: `at` is its place, `names` are the symbols in it."""
        location = self._log.location
        self._literals.pass_word(location >> 7, location & ADDRESS)
        if self._log.number == 2:
            address = self._field << 12 | location + self._relocation & _MASK
            self._put_word(Written(address, value, at, names, False, link))
        location = self._log.location = location + 1 & _MASK
        if not location & ADDRESS:
            self._literals.enter(location >> 7)

    def _put_word(self, written: Written) -> None:
        """Keep a word, and punch it: it goes where the loader is, which after NOPUNCH may be elsewhere."""
        self.written.append(written)
        if not self.punching:
            return
        self.tape.append(written)
        if self._loading < 0:
            if not self._log.faults:
                self._log.faults.append(note("PS02 RELOC", self._relocated_at))
        else:
            written.address = self._bank | self._loading
            self._loading = self._loading + 1 & _MASK
        self._checksum += (written.word >> 6) + (written.word & 0o77)

    def put(self, kind: str, value: int) -> None:
        """Punch an origin, a field, a block or the checksum, in pass 2."""
        if self._log.number == 1 or not self.punching:
            return
        self.tape.append(Punched(kind, value))
        if kind == FIELD:
            self._bank = value << 12
        elif kind == ORIGIN:
            self._loading = value
            self._checksum += 0o100 + (value >> 6) + (value & 0o77)
        elif kind == BLOCK:
            self._checksum += value & 0o77

    def put_block(self, value: int, at: int) -> None:
        """DTORG: punch a block number; its first frame is in the checksum even after NOPUNCH."""
        self._checksum += 0o300 + (value >> 6)
        self.put(BLOCK, value)
        if self._log.number == 2:
            self._log.faults.append(note("PS02 DTORG", at))

    def begin_field(self, field: int) -> None:
        """Go to 0200 of a field."""
        self._field = field
        self.put(FIELD, field)
        self._literals.clear()
        self.enter_page(START)

    def relocate(self, location: int, undefined: bool, at: int) -> None:
        """RELOC: what follows runs at `location`; an origin is punched only where literals come before it."""
        self._skips_origin = True
        self._relocated_at = at
        self._next_relocation = self._log.location + self._relocation - location & _MASK
        self._go_to(location, undefined)

    def go_to(self, location: int, undefined: bool) -> None:
        """`*`: go to a location."""
        self._skips_origin = False
        self._go_to(location, undefined)

    def _go_to(self, location: int, undefined: bool) -> None:
        if undefined:
            self._log.say("UO")
        leaves = (location ^ self._log.location) & PAGE
        if leaves:
            self.leave_page()
        self._relocation = self._next_relocation
        if leaves:
            self.enter_page(location)
        else:
            self._set_origin(location)
            self._log.forget_tag()

    def loaded_at(self) -> int:
        """Return where the next word is loaded."""
        return self._log.location + self._relocation & _MASK

    def enter_page(self, location: int) -> None:
        """Go to a location on another page, or reenter this page."""
        self._set_origin(location)
        self._literals.enter(self._log.location >> 7)
        self._log.forget_tag()

    def _set_origin(self, location: int) -> None:
        self._log.location = location & _MASK
        if self._log.number == 2:
            if not self._skips_origin:
                self.put(ORIGIN, self.loaded_at())
            self._skips_origin = False

    def leave_page(self) -> None:
        """Put out the literals of this page that were stored since the source came to it."""
        page = self._log.location >> 7
        if not page:
            return
        literals = self._literals
        bottom = literals.bottom[page]
        if bottom < literals.end:
            self._skips_origin = False
            self._set_origin(page << 7 | bottom)
            self._put_out(literals.words, bottom, literals.end)
            literals.leave(page)
        if self._wipe:
            literals.wipe(page)

    def leave_page_zero(self) -> None:
        """Put out the literals of page zero."""
        bottom = self._literals.bottom[0]
        if bottom < END:
            self._set_origin(bottom)
            self._put_out(self._literals.zero_words, bottom, END)

    def _put_out(self, words: list[tuple[int, int]], first: int, after: int) -> None:
        for place in range(first, after):
            value, at = words[place]
            if self._log.number == 2:
                self._put_word(Written(self._field << 12 | self.loaded_at(), value, at, [], True))
            self._log.location = self._log.location + 1 & _MASK
