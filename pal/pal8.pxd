# The types with which Cython compiles pal8.py; Python itself never reads this.

cimport cython

from pal.assembler cimport Written
from pal.notes cimport Mention
from pal.source cimport Line, tokens

cdef int START, ADDRESS, CURRENT_PAGE, INDIRECT, PAGE, SIGNIFICANT, _MASK, _LINKED


cdef class Symbol:
    cdef public str name
    cdef public int kind, value, passed


cdef class Pool:
    cdef public list values, places
    cdef public int out


cdef int _signed(int value) noexcept


cdef class Assembler:
    cdef public dict symbols
    cdef public list written, output, places, problems, notes, mentions
    cdef public int ended
    cdef list _lines, _read, _tokens, _names
    cdef dict _pools
    cdef str _mode, _token
    cdef bint _punching, _link, _failed
    cdef int _number, _location, _field, _shift, _radix, _loading, _checksum, _index, _next, _start, _end, _before

    @cython.locals(line=Line)
    cdef _take_line(self, int column)
    @cython.locals(blanks=str)
    cdef _advance(self)
    cdef str _joined(self)
    cdef int _at(self, int start, int end) except -2
    cdef bint _line(self) except -1
    @cython.locals(token=str, follows=str, symbol=Symbol)
    cdef _statement(self)
    @cython.locals(start=int, value=int)
    cdef _word(self)
    @cython.locals(address=int)
    cdef _write(self, int value, int at)
    cdef _put_word(self, Written written)
    cdef _put(self, str kind, int value)
    @cython.locals(word=int, refers=bint, start=int, addressed=bint, address=int, item=int, also=bint)
    cdef int _expressions(self) except? -1
    cdef int _refer(self, int word, int address, int start) except? -1
    @cython.locals(sign=str, value=int, operator=str, operand=int)
    cdef (int, bint) _expression(self) except *
    cdef int _operate(self, int value, str operator, int operand) except? -1
    @cython.locals(token=str, first=str, value=int)
    cdef (int, bint) _term(self) except *
    @cython.locals(joined=bint)
    cdef _end_term(self)
    @cython.locals(start=int, end=int, symbol=Symbol)
    cdef (int, bint) _symbol(self, str name) except *
    @cython.locals(pool=Pool, number=int)
    cdef int _literal(self, int page, int value) except? -1
