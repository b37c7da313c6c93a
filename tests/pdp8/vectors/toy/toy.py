"""An emulator that knows TAD only, for what the README has a reader write; in C and Go beside it."""


class Toy:
    def __init__(self) -> None:
        self.core = [0] * 4096
        self.pc = self.ac = self.link = 0

    def step(self) -> None:
        core, word = self.core, self.core[self.pc]
        address = word & 0o177 | (self.pc & 0o7600 if word & 0o200 else 0)
        if word & 0o400:
            core[address] = core[address] + (address >> 3 == 1) & 0o7777
            address = core[address]
        total = (self.link << 12 | self.ac) + core[address]
        self.pc, self.ac, self.link = self.pc + 1 & 0o7777, total & 0o7777, total >> 12 & 1
