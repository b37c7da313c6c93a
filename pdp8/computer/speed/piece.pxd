# The types of piece.py in C, which setup.py translates it to; Python itself never reads this.

from libc.stdint cimport int64_t, uint16_t

cdef extern from "piece.h":
    int within "execute"(
        uint16_t *core, uint16_t *ops, uint16_t *arg, uint16_t *keep, uint16_t *flip, uint16_t *plus,
        const unsigned char *conditions, int64_t *registers, int64_t wall, int64_t limit,
    ) noexcept
    int across "execute_across"(
        uint16_t *core, uint16_t *ops, uint16_t *arg, uint16_t *data, uint16_t *data_ops,
        uint16_t *keep, uint16_t *flip, uint16_t *plus,
        const unsigned char *conditions, int64_t *registers, int64_t wall, int64_t limit,
    ) noexcept


cdef inline bint reaches(int inst, int data) noexcept:
    return True


cdef inline int run(
    uint16_t[::1] words, uint16_t *ops, uint16_t *arg, int inst, int data,
    uint16_t *keep, uint16_t *flip, uint16_t *plus,
    const unsigned char *conditions, int64_t *registers, int64_t wall, int64_t limit,
) noexcept:
    cdef uint16_t *core = &words[inst]
    cdef uint16_t *own = ops + 4098 * (inst >> 12)
    arg += 4098 * (inst >> 12)
    if inst == data:
        return within(core, own, arg, keep, flip, plus, conditions, registers, wall, limit)
    return across(
        core, own, arg, &words[data], ops + 4098 * (data >> 12), keep, flip, plus, conditions, registers, wall, limit
    )
