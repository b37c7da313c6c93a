# The types with which Cython compiles processor.py; Python itself never reads this.

cimport cython

from pdp8.bus cimport Bus

cdef int FETCH, DEFER, EXECUTE, INTERRUPT, PROTECTED
cdef int AND, TAD, ISZ, DCA, JMS, JMP, IOT, OPR, CYCLE, IO_TICKS
cdef int GROUP_2, GROUP_3, HLT


cdef class Processor:
    cdef public Bus bus
    cdef public object core
    cdef unsigned short[::1] _core
    cdef public int lac, pc, ma, mb, ir, state, next, run
    cdef public int ion, ion_delayed, sr, mem_prot, sing_step, protect, written
    cdef public long long clock, started, instructions

    cpdef initialize(self)
    cpdef cycle(self)
    cpdef instruction(self)
    @cython.locals(address=int, word=int, code=int)
    cdef _fetch(self)
    cdef int _address(self)
    cdef _defer(self)
    cdef _execute(self)
    cdef _interrupt(self)
    cdef _write(self, int word)
    cdef _operate(self, int word)
    @cython.locals(answer=int)
    cdef _input_output(self, int word)
    cdef _interrupt_enable(self, int word)
    cdef _strobe(self)
