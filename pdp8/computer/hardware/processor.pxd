# The types with which Cython compiles processor.py; Python itself never reads this.

cimport cython
from libc.stdint cimport int64_t

from pal.isa cimport autoindexed, refers_to
from pdp8.computer.hardware.bus cimport BreakDevice, Bus
from pdp8.computer.hardware.extension cimport Extension

cdef int FETCH, DEFER, EXECUTE, NO_STATE, INTERRUPT, WORD_COUNT, CURRENT_ADDRESS, BREAK, PROTECTED, FIELD, TP1
cdef int AND, TAD, ISZ, DCA, JMS, JMP, IOT, OPR, CYCLE, IO_TICKS
cdef int GROUP_2, GROUP_3, HLT, INDIRECT
cdef unsigned short _FORMS[32784]


@cython.final
cdef class Processor:
    cdef public Bus bus
    cdef public Extension extension
    cdef public object core
    cdef unsigned short[::1] _core
    cdef public int lac, pc, ma, mb, ir, state, next, run
    cdef public int ion, ion_delayed, sr, mem_prot, sing_step, protect, stopping, stored
    cdef public int64_t clock, started, instructions, writes
    cdef unsigned short forms[32784]

    cpdef initialize(self)
    @cython.locals(device=BreakDevice)
    cpdef preset(self)
    cpdef void deposit(self, int address, int word) noexcept
    @cython.locals(address=int)
    cpdef fill(self, unsigned short[::1] words)
    cpdef stop(self)
    cpdef bint within(self) noexcept
    cpdef int cycle(self) except -1
    cpdef int instruction(self) except -1
    @cython.locals(word=int, code=int)
    cdef int _fetch(self) except -1
    cdef void _defer(self) noexcept
    @cython.locals(device=BreakDevice)
    cpdef int next_field(self) except -1
    cdef int _execute(self) except -1
    cdef void _interrupt(self) noexcept
    @cython.locals(device=BreakDevice)
    cdef int _break(self) except -1
    @cython.locals(overflows=bint)
    cdef int _word_count(self, BreakDevice device) except -1
    cdef int _current_address(self, BreakDevice device) except -1
    cdef int _transfer(self, BreakDevice device) except -1
    cdef void _write(self, int word) noexcept
    cdef int _operate(self, int word) except -1
    @cython.locals(answer=int)
    cdef int _input_output(self, int word) except -1
    cdef void _interrupt_enable(self, int word) noexcept
    cdef int _end(self) except -1
    @cython.locals(began=int64_t, device=BreakDevice)
    cdef int _accept_break(self) except -1
