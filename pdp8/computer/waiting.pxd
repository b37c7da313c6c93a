# The types with which Cython compiles waiting.py; Python itself never reads this.

cimport cython
from libc.stdint cimport int64_t

from pal.isa cimport jumps_to, tests_flag
from pdp8.computer.bus cimport Device
from pdp8.computer.processor cimport Processor

cdef int64_t NEVER, PERIOD, _FLAG_TICKS
cdef int CYCLE, FETCH, IO_TICKS, _TESTS, _STEPS


@cython.final
cdef class Waiting:
    cdef public Processor processor
    cdef public bint endless, hunting, watched
    cdef public int64_t strike
    cdef int pc, lac, patience, sr, mem_prot, ion
    cdef unsigned short[::1] core
    cdef object seen
    cdef int64_t told, clock, instructions, quiet_until

    cdef int _remember(self) except -1
    cpdef forget(self)
    cpdef int look(self, int64_t until, int64_t last) except -1
    @cython.locals(word=int)
    cdef bint _jumps_to(self, int target, int address) except -1
    @cython.locals(word=int, code=int, event=int64_t, device=Device)
    cdef bint _waits_for_flag(self, int64_t until, int64_t last) except -1
    @cython.locals(still=bint)
    cdef int _strike(self) except -1
    cdef bint _unwritten(self) except -1
    cdef int _compare(self, int64_t until, int64_t last) except -1
    @cython.locals(ticks=int64_t, count=int64_t, event=int64_t)
    cdef int _pass_turns(self, int64_t until, int64_t last) except -1
    @cython.locals(turns=int64_t)
    cdef void _pass(self, int64_t event, int64_t until, int64_t last, int64_t ticks, int64_t count) noexcept
    cdef int _turn_again(self, int64_t ticks, int64_t count) except -1
