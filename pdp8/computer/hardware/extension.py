"""The memory extension control MC8/L: a second field of 4K, and the field of each cycle.

    FETCH, DEFER                             IF
    EXECUTE of AND TAD ISZ DCA, indirect     DF
    EXECUTE else                             IF
    WORD COUNT, CURRENT ADDRESS              field 0
    BREAK                                    BF, from the device

    62N1 CDF  DF <- N         6214 RDF  AC 8 or DF          6234 RIB  AC 8, 11 or SF0, SF1
    62N2 CIF  IB <- N         6224 RIF  AC 8 or IF          6244 RMF  DF <- SF1, IB <- SF0

IF takes IB over as a JMP or JMS leaves its FETCH or DEFER: a pointer is read in the old field, and JMS stores
its return in the new one. CIF and RMF inhibit interrupts until then. An interrupt puts IF and DF into SF0 and
SF1 and clears IF, DF, IB.

The drawing has one flip-flop for each register, and gates for MB 3 to 7: N of 2 to 7 does nothing. Pulses
are combined as it has them: where MB 9 is 1, CDF and CIF load SF1 and SF0, as RMF does. LOAD ADD clears IF,
DF, IB and the inhibition by KEY CLEAR, which also puts IF and DF into SF, and sets them from its switches.

With 32K the registers have three bits, as no PDP-8/L had them.

Registers hold the address of the first word of a field: 0, 010000 ... They are 0 at power-up, where those of
a real machine are whatever they are.

Sources: DEC, MC8/L Memory Extension Control, pages 1 to 7 and drawing D-BS-MC8-L-2.
"""

from pdp8.computer.hardware.fields import BIT, saved

FIELD = 0o10000
"""The words of a field."""
MEMORY = {"4k": FIELD, "8k": 2 * FIELD, "32k": 8 * FIELD}
"""Words of core that a machine may have, as commands name them."""
SIZES = list(MEMORY.values())


class Extension:
    """The registers of the control; without it, in a machine of 4K, they stay 0."""

    fields = saved(
        **dict.fromkeys(("field", "inst_field", "data_field", "inst_buffer"), "70000"),
        **dict.fromkeys(("saved_inst", "saved_data", "inst_switch", "data_switch"), "70000"),
        **dict.fromkeys(("remembered", "left"), "777777777"),
        inhibit=BIT,
    )

    def __init__(self, size: int = FIELD) -> None:
        if size not in SIZES:
            raise ValueError(f"{size} words of core: {', '.join(f'{each}' for each in SIZES)} are allowed")
        self.size = size
        self.field = 0
        """The field of the last cycle."""
        self.inst_field = self.data_field = self.inst_buffer = 0
        """IF, DF, IB."""
        self.saved_inst = self.saved_data = 0
        """SF0 and SF1."""
        self.inhibit = 0
        """While it is set no interrupt is taken."""
        self.inst_switch = self.data_switch = 0
        """INST FIELD and DATA FIELD of the panel."""
        self.remembered = self.left = 0
        """The registers as Waiting remembered them, and as the last run left them."""

    def registers(self) -> int:
        """Return all registers in one number."""
        fields = self.inst_field | self.data_field << 3 | self.inst_buffer << 6
        return fields | self.saved_inst << 9 | self.saved_data << 12 | self.inhibit

    def input_output(self, word: int, lac: int) -> int:
        """Do what the pulses of IOT `word`, 6200 to 6277, do; return {L, AC} as they leave them."""
        restores = word & 4
        field = (word & 0o70) << 9
        if field < self.size:
            if word & 1:
                self.data_field = self.saved_data if restores else field
            if word & 2:
                self._load_buffer(self.saved_inst if restores else field)
        if restores:
            which = word >> 3 & 7
            if which == 1:
                lac |= self.data_field >> 9
            elif which == 2:
                lac |= self.inst_field >> 9
            elif which == 3:
                lac |= self.saved_inst >> 9 | self.saved_data >> 12
            elif which == 4:
                self.data_field = self.saved_data
                self._load_buffer(self.saved_inst)
        return lac

    def _load_buffer(self, field: int) -> None:
        self.inst_buffer = field
        self.inhibit = 1

    def changes_field(self) -> bool:
        """Whether the next JMP or JMS goes to another field or ends the inhibition of interrupts."""
        return self.inhibit != 0 or self.inst_buffer != self.inst_field

    def load_inst_field(self) -> None:
        """LOAD IF, by a JMP or JMS."""
        self.inst_field = self.inst_buffer
        self.inhibit = 0

    def interrupt(self) -> None:
        """LOAD SF: save IF and DF, and clear all but SF."""
        self.saved_inst = self.inst_field
        self.saved_data = self.data_field
        self.inst_field = self.data_field = self.inst_buffer = 0

    def load_address(self, inst_field: int, data_field: int) -> None:
        """What LOAD ADD does: KEY CLEAR, then IF and IB, and DF."""
        self.interrupt()
        self.inst_field = self.inst_buffer = inst_field
        self.data_field = data_field
        self.inhibit = 0
