# The types with which Cython compiles operators.py; Python itself never reads this.

from pal.pal8.expressions cimport Expression
from pal.pal8.lexer cimport Lexer, is_digit, is_letter
from pal.pal8.log cimport Log
from pal.pal8.output cimport Punch
from pal.pal8.table cimport SymbolTable


cdef class Operators:
    cdef Lexer _lexer
    cdef Log _log
    cdef SymbolTable _table
    cdef Punch _punch
    cdef Expression _expression
    cdef bint _exact, _opens
    cdef int _start, _zeros
    cdef public list origins

    cpdef bint obey(self, str name, int start) except -1
    cpdef assign(self, str name, int kind, int start, int end)
