# The types with which Cython compiles log.py; Python itself never reads this.

from pal.notes cimport Mention
from pal.pal8.lexer cimport Lexer, is_operator


cdef class Log:
    cdef Lexer _lexer
    cdef public int number, location, tag_at
    cdef public str tag
    cdef public bint misread
    cdef bint _has_illegal
    cdef public list places, complaints, faults, notes, mentions

    cpdef int keep(self, int start, int end) except -1
    cpdef int keep_word(self, int start) except -1
    cpdef mention(self, str name, int start, int end, bint defined)
