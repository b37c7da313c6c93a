# The types with which Cython compiles assembler.py; Python itself never reads this.

cimport cython

from pal.pal8.expressions cimport Expression
from pal.pal8.lexer cimport Lexer, is_letter
from pal.pal8.log cimport Log
from pal.pal8.operators cimport Operators
from pal.pal8.output cimport Punch
from pal.pal8.table cimport Symbol, SymbolTable

cdef int PSEUDO, SIGNIFICANT


cdef class Assembler:
    cdef public Log log
    cdef public SymbolTable table
    cdef public Punch punch
    cdef public Operators operators
    cdef public int ended
    cdef public bint fatal
    cdef Lexer _lexer
    cdef Expression _expression
    cdef bint _exact

    @cython.locals(lexer=Lexer, begins=bint)
    cdef bint _line(self) except -1
    @cython.locals(lexer=Lexer)
    cdef bint _ends_statement(self) except -1
    @cython.locals(lexer=Lexer, start=int, end=int, name=str, found=Symbol, follows=Py_UCS4, level=int)
    cdef bint _statement(self) except -1
    @cython.locals(expression=Expression)
    cdef _word(self, int start, bint looked_up)
