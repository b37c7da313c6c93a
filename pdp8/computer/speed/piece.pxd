# The types of piece.py in C, which setup.py translates it to; Python itself never reads this.

from libc.stdint cimport int64_t, uint16_t

cdef extern from "piece.h":
    int translated "execute"(
        uint16_t *core, uint16_t *ops, uint16_t *arg, uint16_t *keep, uint16_t *flip, uint16_t *plus,
        const unsigned char *conditions, int64_t *registers, int64_t wall, int64_t limit,
    ) noexcept


cdef inline int execute(
    uint16_t[::1] core, uint16_t *ops, uint16_t *arg, uint16_t *keep, uint16_t *flip, uint16_t *plus,
    const unsigned char *conditions, int64_t *registers, int64_t wall, int64_t limit,
) noexcept:
    return translated(&core[0], ops, arg, keep, flip, plus, conditions, registers, wall, limit)
