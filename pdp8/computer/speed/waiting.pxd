# The types with which Cython compiles waiting.py; Python itself never reads this.

cimport cython
from libc.stdint cimport int64_t

from pal.isa cimport jumps_to, tests_flag
from pdp8.computer.hardware.bus cimport Device
from pdp8.computer.hardware.processor cimport Processor

cdef int64_t NEVER, PERIOD, _FLAG_TICKS
cdef int CYCLE, INTERRUPT, FETCH, IOT, IO_TICKS, JMP, _TESTS, _STEPS, _FORGOTTEN


@cython.final
cdef class Waiting:
    cdef public Processor processor
    cdef public bint endless, stepping, turn_first
    cdef public int pc, lac, tries, sr, mem_prot, ion
    cdef int varies
    cdef public int64_t next_look, actions, clock, instructions, quiet_until, writes
    cdef public object core, left, marks
    cdef unsigned short[::1] _words

    cdef int _remember(self) except -1
    cpdef forget(self)
    @cython.locals(word=int)
    cpdef int look(self, int64_t until, int64_t last) except -1
    @cython.locals(word=int)
    @cython.locals(word=int, code=int, behind=int, field=int, event=int64_t, device=Device)
    cdef bint _waits_for_flag(self, int64_t until, int64_t last) except -1
    @cython.locals(still=bint)
    cdef int _look_anywhere(self) except -1
    @cython.locals(p=Processor)
    cdef bint _unchanged(self) except -1
    cdef int _find(self, unsigned short[::1] old) except -1
    cdef int _compare(self, int64_t until, int64_t last) except -1
    @cython.locals(ticks=int64_t, count=int64_t, event=int64_t)
    cdef int _pass_turns(self, int64_t until, int64_t last) except -1
    @cython.locals(turns=int64_t)
    cdef void _pass(self, int64_t event, int64_t until, int64_t last, int64_t ticks, int64_t count) noexcept
    cdef int _turn_again(self, int64_t ticks, int64_t count) except -1
