# The types with which Cython compiles processor.py; Python itself never reads this.

cimport cython
from libc.stdint cimport int64_t

from pal.isa cimport autoindexed, refers_to
from pdp8.computer.hardware.bus cimport Bus

cdef int FETCH, DEFER, EXECUTE, NO_STATE, INTERRUPT, PROTECTED
cdef int AND, TAD, ISZ, DCA, JMS, JMP, IOT, OPR, CYCLE, IO_TICKS
cdef int GROUP_2, GROUP_3, HLT, INDIRECT


@cython.final
cdef class Processor:
    cdef public Bus bus
    cdef public object core
    cdef unsigned short[::1] _core
    cdef public int lac, pc, ma, mb, ir, state, next, run
    cdef public int ion, ion_delayed, sr, mem_prot, sing_step, protect, stopping
    cdef public int64_t clock, started, instructions, writes
    cdef unsigned short forms[4098]

    cpdef initialize(self)
    cpdef preset(self)
    cpdef void deposit(self, int address, int word) noexcept
    cpdef stop(self)
    cpdef int cycle(self) except -1
    cpdef int instruction(self) except -1
    @cython.locals(word=int, code=int)
    cdef int _fetch(self) except -1
    cdef void _defer(self) noexcept
    cdef void _execute(self) noexcept
    cdef void _interrupt(self) noexcept
    cdef void _write(self, int word) noexcept
    cdef int _operate(self, int word) except -1
    @cython.locals(answer=int)
    cdef int _input_output(self, int word) except -1
    cdef void _interrupt_enable(self, int word) noexcept
    cdef int _end(self) except -1
