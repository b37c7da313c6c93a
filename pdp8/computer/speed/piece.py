"""A piece of a run: decoded instructions are executed until a limit, or until one that is not executed here.

    core      7300  1205  5201 ...        words
    ops          6     1     4  ...       what to do, 0 where the word is not decoded
    arg        300   205   201  ...       its operand: an effective address, or OPR bits

In more than 4K core, ops and arg are those of the instruction field; data and data_ops are core and ops of
the data field, in which the operands of indirect AND, TAD, ISZ and DCA are.

Every store clears the decoded form of its word. One number `time` counts, from the lowest, 13 bits of
instructions, 13 of those that write, and cycles: what an instruction takes is one addition. The operations
that programs use most stand first, as Python looks for them in this order.

engine.py decodes. SKIP skips if one of the conditions in its operand holds (SMA SZA SNL), SKIP_UNLESS if
none does (SPA SNA SZL); GROUP_1 does not rotate. Where there is a C compiler, setup.py translates this file
to C, statement by statement (release/threaded.py); so `execute` holds to what C has too: integers and arrays.
In C it is there twice, once for programs whose data is in their instruction field.

Sources: those of processor.py, which tests hold this in lockstep with.
"""

from collections.abc import MutableSequence

# X: the word that the operand names; I: the word to which that points; AUTO: the same, incremented first.
UNDECODED = 0
TAD_X, GROUP_1, JMP_X, DCA_X, ISZ_X = 1, 2, 3, 4, 5
SKIP_UNLESS_CLA, SKIP_CLA, TAD_I, JMP_I, DCA_I, JMS_X = 6, 7, 8, 9, 10, 11
SKIP, SKIP_UNLESS, TAD_AUTO, DCA_AUTO, AND_X, RAL, RAR = 12, 13, 14, 15, 16, 17, 18
GROUP_1_ROTATE, JMS_I, ISZ_I, AND_I = 19, 20, 21, 22
DELAY = 23
"""ISZ X of a delay loop: all turns of 3 cycles that fit but the last are counted at once."""
WRAP = 24
"""A word past the end of core."""
LEFT = 25
"""An instruction that is left to the processor."""
STRIDE = 4098
"""From the decoded forms of a field to those of the next: two past its end wrap the PC."""


def reaches(inst: int, data: int) -> bool:
    """Whether `run` has pieces for these fields: C has them for all, arrays of Python only for field 0."""
    return inst == 0 and data == 0


def run(
    core: MutableSequence[int],
    ops: MutableSequence[int],
    arg: MutableSequence[int],
    inst: int,
    data: int,
    keep: MutableSequence[int],
    flip: MutableSequence[int],
    plus: MutableSequence[int],
    conditions: bytes,
    registers: list[int],
    wall: int,
    limit: int,
) -> int:
    """Do what `execute` does, in the fields that begin at `inst`, of instructions, and `data` in all core."""
    return execute(core, ops, arg, core, ops, keep, flip, plus, conditions, registers, wall, limit)


def execute(
    core: MutableSequence[int],
    ops: MutableSequence[int],
    arg: MutableSequence[int],
    data: MutableSequence[int],
    data_ops: MutableSequence[int],
    keep: MutableSequence[int],
    flip: MutableSequence[int],
    plus: MutableSequence[int],
    conditions: bytes,
    registers: list[int],
    wall: int,
    limit: int,
) -> int:
    """Execute from the `registers` PC, {L, AC} and time until `limit`, or before a write at `wall` or above;
    set them and return the last operation. The PC may end up to two words past 7777.
    """
    pc = registers[0]
    lac = registers[1] & 0o17777
    time = registers[2]
    op = ops[pc]
    while time < limit:
        op = ops[pc]
        x = arg[pc]
        if op == TAD_X:
            lac = lac + core[x] & 0o17777
            time += 2 << 26 | 1
            pc += 1
        elif op == GROUP_1:
            lac = (lac & keep[x] ^ flip[x]) + plus[x] & 0o17777
            time += 1 << 26 | 1
            pc += 1
        elif op == JMP_X:
            pc = x
            time += 1 << 26 | 1
        elif op == DCA_X:
            core[x] = lac & 0o7777
            ops[x] = 0
            lac &= 0o10000
            time += 2 << 26 | 1 << 13 | 1
            pc += 1
        elif op == ISZ_X:
            word = core[x] + 1 & 0o7777
            core[x] = word
            ops[x] = 0
            time += 2 << 26 | 1 << 13 | 1
            pc += 1
            if word == 0:
                pc += 1
        elif op == SKIP_UNLESS_CLA:
            time += 1 << 26 | 1
            pc += 1
            if x & conditions[lac] == 0:
                pc += 1
            lac &= 0o10000
        elif op == SKIP_CLA:
            time += 1 << 26 | 1
            pc += 1
            if x & conditions[lac]:
                pc += 1
            lac &= 0o10000
        elif op == TAD_I:
            lac = lac + data[core[x]] & 0o17777
            time += 3 << 26 | 1
            pc += 1
        elif op == JMP_I:
            pc = core[x]
            time += 2 << 26 | 1
        elif op == DCA_I:
            address = core[x]
            if address >= wall:
                break
            data[address] = lac & 0o7777
            data_ops[address] = 0
            lac &= 0o10000
            time += 3 << 26 | 1 << 13 | 1
            pc += 1
        elif op == JMS_X:
            core[x] = pc + 1 & 0o7777
            ops[x] = 0
            pc = x + 1
            time += 2 << 26 | 1 << 13 | 1
        elif op == SKIP:
            time += 1 << 26 | 1
            pc += 1
            if x & conditions[lac]:
                pc += 1
        elif op == SKIP_UNLESS:
            time += 1 << 26 | 1
            pc += 1
            if x & conditions[lac] == 0:
                pc += 1
        elif op == TAD_AUTO:
            address = core[x] + 1 & 0o7777
            core[x] = address
            ops[x] = 0
            lac = lac + data[address] & 0o17777
            time += 3 << 26 | 1 << 13 | 1
            pc += 1
        elif op == DCA_AUTO:
            address = core[x] + 1 & 0o7777
            if address >= wall:
                break
            core[x] = address
            ops[x] = 0
            data[address] = lac & 0o7777
            data_ops[address] = 0
            lac &= 0o10000
            time += 3 << 26 | 1 << 13 | 1
            pc += 1
        elif op == AND_X:
            lac &= core[x] | 0o10000
            time += 2 << 26 | 1
            pc += 1
        elif op == RAL:
            lac = lac << 1 & 0o17777 | lac >> 12
            time += 1 << 26 | 1
            pc += 1
        elif op == RAR:
            lac = lac >> 1 | lac << 12 & 0o10000
            time += 1 << 26 | 1
            pc += 1
        elif op == GROUP_1_ROTATE:
            lac = (lac & keep[x] ^ flip[x]) + plus[x] & 0o17777
            x &= 0o16
            if x == 0o4:
                lac = lac << 1 & 0o17777 | lac >> 12
            elif x == 0o10:
                lac = lac >> 1 | lac << 12 & 0o10000
            elif x == 0o6:
                lac = lac << 2 & 0o17777 | lac >> 11
            else:
                lac = lac >> 2 | lac << 11 & 0o14000
            time += 1 << 26 | 1
            pc += 1
        elif op == JMS_I:
            address = core[x]
            if address >= wall:
                break
            core[address] = pc + 1 & 0o7777
            ops[address] = 0
            pc = address + 1
            time += 3 << 26 | 1 << 13 | 1
        elif op == ISZ_I:
            address = core[x]
            if address >= wall:
                break
            word = data[address] + 1 & 0o7777
            data[address] = word
            data_ops[address] = 0
            time += 3 << 26 | 1 << 13 | 1
            pc += 1
            if word == 0:
                pc += 1
        elif op == AND_I:
            lac &= data[core[x]] | 0o10000
            time += 3 << 26 | 1
            pc += 1
        elif op == DELAY:
            if ops[pc + 1] == JMP_X and arg[pc + 1] == pc:
                turns = ((limit >> 26) - 1 - (time >> 26)) // 3
                turns = min(turns, 0o7777 - core[x])
                core[x] += turns
                time += turns * (3 << 26 | 1 << 13 | 2)
            word = core[x] + 1 & 0o7777
            core[x] = word
            ops[x] = 0
            time += 2 << 26 | 1 << 13 | 1
            pc += 1
            if word == 0:
                pc += 1
        elif op == WRAP:
            pc -= 0o10000
        else:
            break
    registers[0] = pc
    registers[1] = lac
    registers[2] = time
    return op
