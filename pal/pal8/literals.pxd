# The types with which Cython compiles literals.py; Python itself never reads this.

cimport cython

from pal.pal8.log cimport Log


cdef class Literals:
    cdef Log _log
    cdef public list bottom, top, words, zero_words
    cdef dict _here, _zero
    cdef list _left
    cdef public int end

    cpdef enter(self, int page)
    cpdef pass_word(self, int page, int below)
    @cython.locals(known=dict, bottom=int, place=int, least=int, words=list)
    cpdef int find(self, int value, int page, int start) except -1
