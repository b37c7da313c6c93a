# The types with which Cython compiles notes.py; Python itself never reads this.

cimport cython

from pal.assembler cimport Written
from pal.isa cimport changes_field, halts, in_field, refers_to, tests_flag

cdef int CLA, DCA, GROUP_2, INDIRECT, IOT, ISZ, JMP, JMS, OPR, REVERSED, _SKIPS


cdef class Mention:
    cdef public str name
    cdef public int at
    cdef public bint defined


@cython.locals(loaded=set, written=Written, address=int, last=int)
cpdef list of_overlays(object words)
@cython.locals(cells=dict, looked_at=dict, written=Written)
cpdef list of_words(object words, dict instructions)
@cython.locals(name=str)
cdef bint _is_instruction(Written written, dict instructions) except -1
@cython.locals(written=Written, cell=Written, before=Written, operation=int, target=int,
               called=set, counted=set, stored=set, aims=set, jumps=list, calls=list, after=Written,
               first=Written, reached=bint, ends=bint)
cdef list _flow(dict cells, dict instructions)
@cython.locals(cell=Written, before=int)
cdef bint _changes_field(dict cells, int address) except -1
cdef bint _goes_on(int word, Written before) except -1
@cython.locals(back=bint, is_jump=bint)
cdef bint _ends_loop(Written written, Written before) except -1
cdef bint _skips(int word) noexcept
