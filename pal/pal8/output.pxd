# The types with which Cython compiles output.py; Python itself never reads this.

cimport cython

from pal.assembler cimport Written
from pal.pal8.literals cimport Literals
from pal.pal8.log cimport Log

cdef int START, ADDRESS, PAGE, END, _MASK


cdef class Punch:
    cdef Log _log
    cdef Literals _literals
    cdef bint _wipe, _skips_origin
    cdef int _field, _relocation, _next_relocation, _relocated_at, _bank, _loading, _checksum
    cdef public bint punching
    cdef public list written, tape

    @cython.locals(location=int, address=int)
    cpdef write(self, int value, int at, list names, bint link)
    cdef _put_word(self, Written written)
    cpdef put(self, str kind, int value)
    cpdef int loaded_at(self)
    cdef _set_origin(self, int location)
