# The types with which Cython compiles engine.py; Python itself never reads this.

cimport cython
from libc.stdint cimport int64_t

from pal.isa cimport autoindexed, jumps_to, refers_to
cimport pdp8.computer.speed.piece as piece
from pdp8.computer.hardware.processor cimport Processor
from pdp8.computer.speed.waiting cimport Waiting

cdef int64_t LONGEST, PIECE, _CYCLES
cdef int FIELD, STRIDE, BREAK
cdef int CYCLE, EXECUTE, FETCH, GROUP_2, INDIRECT, IOT, ISZ, JMP, JMS, OPR, PROTECTED, UNDECODED, JMP_X, GROUP_1, GROUP_1_ROTATE, DELAY, WRAP, LEFT
cdef unsigned short _ARG[32784]
cdef unsigned short _KEEP[256]
cdef unsigned short _FLIP[256]
cdef unsigned short _PLUS[256]


@cython.final
cdef class Engine:
    cdef Processor processor
    cdef Waiting waiting
    cdef public bint delays
    cdef bint has_breakpoints
    cdef unsigned short[::1] core
    cdef int wall, base
    cdef frozenset breakpoints
    cdef bytes conditions
    # Stores into bytes may alias everything, so that C would fetch its pointers anew after each; and arrays
    # should not lie a multiple of 4096 bytes apart, as the same indices would then be taken for one place.
    cdef unsigned short arg[32784]
    cdef unsigned short apart[480]
    cdef unsigned short keep[256]
    cdef unsigned short flip[256]
    cdef unsigned short plus[256]
    cdef int64_t registers[3]

    cpdef run(self, int64_t until, int64_t last, object breakpoints = *)
    cdef bint _called(self) except -1
    @cython.locals(address=int)
    cdef _prepare(self, object breakpoints)
    @cython.locals(room=int64_t)
    cdef int64_t _room(self, int64_t until, int64_t last) except? -1
    @cython.locals(field=int, word=int, code=int, operand=int, op=int)
    cdef _decode(self, int address)
    @cython.locals(code=int)
    cdef int _memory_reference(self, int word, int operand, int address) except -1
    @cython.locals(behind=int)
    cdef bint _may_delay(self, int counter, int address) except -1
    @cython.locals(p=Processor, waiting=Waiting, left=bint)
    cdef bint _run_pieces(self, int64_t until, int64_t last) except -1
    @cython.locals(p=Processor, registers="int64_t *", time=int64_t)
    cdef bint _run_piece(self, int64_t limit) except -1
    @cython.locals(p=Processor)
    cdef bint _at_breakpoint(self) except -1
    @cython.locals(p=Processor)
    cdef int _execute(self, int64_t limit) except -1


cdef int _wall(int mem_prot) noexcept
