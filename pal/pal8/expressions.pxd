# The types with which Cython compiles expressions.py; Python itself never reads this.

cimport cython

from pal.pal8.lexer cimport Lexer, ends_expression, is_digit, is_letter, is_operator
from pal.pal8.literals cimport Literals
from pal.pal8.log cimport Log
from pal.pal8.table cimport Symbol, SymbolTable

cdef int ADDRESS, CURRENT_PAGE, INDIRECT, PAGE, SIGNIFICANT, _MASK, _CELLS
cdef int MARK, PSEUDO, REFERENCE, WEAK, _CELLS_OF_EXPRESSION, _CELLS_OF_REFERENCE, _CELLS_OF_LITERAL


cdef class Expression:
    cdef Lexer _lexer
    cdef Log _log
    cdef SymbolTable _table
    cdef Literals _literals
    cdef Expression _within
    cdef public int value
    cdef public bint link
    cdef public list names
    cdef int _begun, _cells, _ored, _group
    cdef bint _may_refer, _has_blank
    cdef Py_UCS4 _operator

    cpdef int word(self, int start, bint looked_up) except? -1
    cdef Expression _inside(self)
    @cython.locals(lexer=Lexer, start=int, more=bint)
    cdef int _read(self, int begun, bint looked_up, bint may_refer, int cells) except? -1
    cdef _use_cells(self, int cells)
    @cython.locals(lexer=Lexer)
    cdef bint _next_operator(self, int start) except -1
    cdef _take_operator(self, Py_UCS4 operator)
    cdef _end(self, int start)
    @cython.locals(lexer=Lexer, table=SymbolTable, first=Py_UCS4)
    cdef bint _term(self) except -1
    @cython.locals(operator=Py_UCS4, last=int)
    cdef bint _combine(self) except -1
    cdef int _operate(self, int value, Py_UCS4 operator, int last) except? -1
    @cython.locals(lexer=Lexer, found=Symbol, refers=bint)
    cdef bint _take_symbol(self) except -1
    cdef int _number(self, str token) except? -1
    @cython.locals(lexer=Lexer, log=Log, table=SymbolTable, start=int, marks=int, found=bint, number=bint,
                   address=int, elsewhere=int)
    cdef bint _refer(self, int operation) except -1
    cdef int _indirect(self, int operation, int elsewhere, int start) except -1
    @cython.locals(lexer=Lexer, start=int, value=int)
    cdef bint _take_literal(self, Py_UCS4 opening) except -1
