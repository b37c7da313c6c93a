# The types with which Cython compiles table.py; Python itself never reads this.

cimport cython

from pal.pal8.lexer cimport Lexer
from pal.pal8.log cimport Log

cdef int SIGNIFICANT


cdef class Symbol:
    cdef public str name
    cdef public int kind, value, passed
    cdef public bint permanent
    cdef public tuple where


cdef class SymbolTable:
    cdef Lexer _lexer
    cdef Log _log
    cdef bint _exact
    cdef set _early
    cdef dict _left
    cdef public dict known
    cdef public Symbol found
    cdef public int found_at, last, undefined
    cdef public bint is_undefined, expunged

    @cython.locals(name=str, found=Symbol)
    cpdef look_up(self)
    cpdef bint use_undefined(self) except -1
    @cython.locals(symbol=Symbol, log=Log)
    cpdef define_tag(self, str name, int start, int end)
    cdef _take(self, Symbol symbol)
