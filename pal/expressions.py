"""A PAL III expression: items combined from left to right as they are read.

    value := value OP item        OP is + or - or a space, which is inclusive OR

An operator is good for one item; before an item the last one counts, so ``3++4`` is 7, and with no item after
it, it does nothing: ``3+`` is 3. The space is an operator like the others, so ``3 +4`` is 7 and ``3 + 4`` is
3 OR 4 (inferred). Where nothing stands between two items, as before a period, that is a space.

A memory-reference symbol ends what came before: that becomes the operation, and the items that follow are
its address, counted anew. ``TAD TAD`` is 1000. I sets bit 3 of the operation wherever it stands, Z does
nothing.

The address is put into the instruction so: page zero as it is; any other with the current page bit and its
low seven bits, and if its page is not that of the instruction, that is an illegal reference (IR). There are
no generated links.

Sources: DEC-08-ASAC-D, "Expressions" and "Memory reference instructions"; the output of DEC-08-ASB1.
"""

OR = " "
PLUS = "+"

INDIRECT = 0o400
CURRENT_PAGE = 0o200
PAGE = 0o7600


class Expression:
    """The expression being read: a word without an address, or an operation and its address so far."""

    __slots__ = ("_addressed", "_operation", "_operator", "_value", "empty")

    def __init__(self) -> None:
        self.clear()

    def clear(self) -> None:
        """Begin again with nothing read."""
        self.empty = True
        self._value = 0
        self._operator = OR
        self._operation = 0
        self._addressed = False

    def operate(self, operator: str) -> None:
        """Read an operator: it is for the next item."""
        self._operator = operator

    def item(self, value: int) -> None:
        """Read a number, a symbol's value, or the location."""
        operator = self._operator
        if operator == OR:
            self._value |= value
        else:
            self._value = (self._value + (value if operator == PLUS else -value)) & 0o7777
            self._operator = OR
        self.empty = False

    def instruction(self, value: int) -> None:
        """Read a memory-reference symbol."""
        self.item(value)
        self._operation |= self._value
        self._value = 0
        self._addressed = True

    def indirect(self) -> None:
        """Read I."""
        self._operation |= INDIRECT
        self.empty = False

    def page_zero(self) -> None:
        """Read Z."""
        self.empty = False

    def word(self, location: int) -> int:
        """Return the word this is at `location`."""
        value = self._value
        if self._addressed and value & PAGE:
            value = CURRENT_PAGE | value & 0o177
        return self._operation | value

    def illegal_reference(self, location: int) -> int | None:
        """Return the address that an instruction at `location` cannot reach, None if it reaches it."""
        value = self._value
        if self._addressed and value & PAGE and (value ^ location) & PAGE:
            return value
        return None
