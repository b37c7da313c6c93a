"""A piece of a run: decoded instructions are executed until a limit, or until one that is not executed here.

    core      7300  1205  5201 ...        words
    ops          6     1     4  ...       what to do, 0 where the word is not decoded
    arg        300   205   201  ...       its operand: an effective address, or OPR bits

Every store clears the decoded form of its word. One number `time` counts, from the lowest, 13 bits of
instructions, 13 of those that write, and cycles: what an instruction takes is one addition. The operations
that programs use most stand first, as Python looks for them in this order.

engine.py says what the numbers of the operations are, and decodes. Where there is a C compiler, setup.py
translates the function below to C, statement by statement (release/threaded.py); so it holds to what C has
too: integers and arrays.

Sources: those of processor.py, which tests hold this in lockstep with.
"""

from collections.abc import MutableSequence


def execute(
    core: MutableSequence[int],
    ops: MutableSequence[int],
    arg: MutableSequence[int],
    keep: MutableSequence[int],
    flip: MutableSequence[int],
    plus: MutableSequence[int],
    conditions: bytes,
    registers: list[int],
    wall: int,
    limit: int,
) -> int:
    """Execute from the `registers` PC, {L, AC} and time until time reaches `limit`; set them, and return the
    operation that ended the piece: 0 if it is one to be decoded.

    A word from address `wall` on is not written: the piece ends before the instruction. The PC may end up to
    two words past 7777.
    """
    pc = registers[0]
    lac = registers[1]
    time = registers[2]
    op = ops[pc]
    while time < limit:
        op = ops[pc]
        x = arg[pc]
        if op == 1:  # TAD
            lac = lac + core[x] & 0o17777
            time += 2 << 26 | 1
            pc += 1
        elif op == 2:  # DCA
            core[x] = lac & 0o7777
            ops[x] = 0
            lac &= 0o10000
            time += 2 << 26 | 1 << 13 | 1
            pc += 1
        elif op == 3:  # ISZ
            word = core[x] + 1 & 0o7777
            core[x] = word
            ops[x] = 0
            time += 2 << 26 | 1 << 13 | 1
            pc += 1
            if word == 0:
                pc += 1
        elif op == 4:  # JMP
            pc = x
            time += 1 << 26 | 1
        elif op == 5:  # SMA SZA SNL
            time += 1 << 26 | 1
            pc += 1
            if x & conditions[lac]:
                pc += 1
        elif op == 6:  # group 1 without a rotate
            lac = (lac & keep[x] ^ flip[x]) + plus[x] & 0o17777
            time += 1 << 26 | 1
            pc += 1
        elif op == 7:  # RAL
            lac = lac << 1 & 0o17777 | lac >> 12
            time += 1 << 26 | 1
            pc += 1
        elif op == 8:  # RAR
            lac = lac >> 1 | (lac & 1) << 12
            time += 1 << 26 | 1
            pc += 1
        elif op == 9:  # SPA SNA SZL
            time += 1 << 26 | 1
            pc += 1
            if x & conditions[lac] == 0:
                pc += 1
        elif op == 10:  # TAD I
            lac = lac + core[core[x]] & 0o17777
            time += 3 << 26 | 1
            pc += 1
        elif op == 11:  # DCA I
            address = core[x]
            if address >= wall:
                break
            core[address] = lac & 0o7777
            ops[address] = 0
            lac &= 0o10000
            time += 3 << 26 | 1 << 13 | 1
            pc += 1
        elif op == 12:  # JMP I
            pc = core[x]
            time += 2 << 26 | 1
        elif op == 13:  # TAD I, autoindexed
            address = core[x] + 1 & 0o7777
            core[x] = address
            ops[x] = 0
            lac = lac + core[address] & 0o17777
            time += 3 << 26 | 1 << 13 | 1
            pc += 1
        elif op == 14:  # DCA I, autoindexed
            address = core[x] + 1 & 0o7777
            if address >= wall:
                break
            core[x] = address
            ops[x] = 0
            core[address] = lac & 0o7777
            ops[address] = 0
            lac &= 0o10000
            time += 3 << 26 | 1 << 13 | 1
            pc += 1
        elif op == 15:  # JMS
            core[x] = pc + 1 & 0o7777
            ops[x] = 0
            pc = x + 1
            time += 2 << 26 | 1 << 13 | 1
        elif op == 16:  # group 1 with a rotate
            lac = (lac & keep[x] ^ flip[x]) + plus[x] & 0o17777
            x &= 0o16
            if x == 0o4:
                lac = lac << 1 & 0o17777 | lac >> 12
            elif x == 0o10:
                lac = lac >> 1 | (lac & 1) << 12
            elif x == 0o6:
                lac = lac << 2 & 0o17777 | lac >> 11
            else:
                lac = lac >> 2 | (lac & 3) << 11
            time += 1 << 26 | 1
            pc += 1
        elif op == 17:  # AND
            lac &= core[x] | 0o10000
            time += 2 << 26 | 1
            pc += 1
        elif op == 18:  # SMA SZA SNL, CLA
            time += 1 << 26 | 1
            pc += 1
            if x & conditions[lac]:
                pc += 1
            lac &= 0o10000
        elif op == 19:  # SPA SNA SZL, CLA
            time += 1 << 26 | 1
            pc += 1
            if x & conditions[lac] == 0:
                pc += 1
            lac &= 0o10000
        elif op == 20:  # ISZ I
            address = core[x]
            if address >= wall:
                break
            word = core[address] + 1 & 0o7777
            core[address] = word
            ops[address] = 0
            time += 3 << 26 | 1 << 13 | 1
            pc += 1
            if word == 0:
                pc += 1
        elif op == 21:  # JMS I
            address = core[x]
            if address >= wall:
                break
            core[address] = pc + 1 & 0o7777
            ops[address] = 0
            pc = address + 1
            time += 3 << 26 | 1 << 13 | 1
        elif op == 22:  # AND I
            lac &= core[core[x]] | 0o10000
            time += 3 << 26 | 1
            pc += 1
        elif op == 23:  # ISZ X of a delay loop: all turns of 3 cycles that fit but the last
            if ops[pc + 1] == 4 and arg[pc + 1] == pc:
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
        elif op == 24:  # past the end of core
            pc -= 0o10000
        else:  # 0, not decoded; or left to the processor
            break
    registers[0] = pc
    registers[1] = lac
    registers[2] = time
    return op
