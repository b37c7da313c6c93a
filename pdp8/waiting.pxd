# The types with which Cython compiles waiting.py; Python itself never reads this.

cimport cython

from pdp8.processor cimport Processor

cdef long long NEVER, PERIOD, _FLAG_TICKS
cdef int CYCLE, FETCH, IO_TICKS, JMP, _TESTS, _STEPS


cdef class Waiting:
    cdef public Processor processor
    cdef public bint endless, hunting, watched
    cdef public long long strike
    cdef int pc, lac, patience, sr, mem_prot, ion
    cdef unsigned short[::1] core
    cdef object seen
    cdef long long told, clock, instructions, quiet_until

    cdef _remember(self)
    cpdef forget(self)
    cpdef look(self, long long until, long long last)
    @cython.locals(word=int)
    cdef bint _jumps_to(self, int target, int address) except -1
    @cython.locals(event="long long")
    cdef bint _waits_for_flag(self, long long until, long long last) except -1
    @cython.locals(still=bint)
    cdef _strike(self)
    cdef bint _unwritten(self) except -1
    cdef _compare(self, long long until, long long last)
    @cython.locals(ticks="long long", count="long long", event="long long")
    cdef _pass_turns(self, long long until, long long last)
    @cython.locals(turns="long long")
    cdef _pass(self, long long event, long long until, long long last, long long ticks, long long count)
    cdef _turn_again(self, long long ticks, long long count)
