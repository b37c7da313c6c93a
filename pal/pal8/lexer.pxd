# The types with which Cython compiles lexer.py; Python itself never reads this.

cimport cython


cdef class Lexer:
    cdef public list lines, texts
    cdef list _codes
    cdef public int index, start, end, before, level, radix
    cdef public bint blank
    cdef public str token
    cdef public Py_UCS4 first
    cdef str _code

    cpdef bint next_line(self) except -1
    cpdef go_to(self, int column)
    @cython.locals(code=str, start=int, length=int)
    cpdef advance(self)
    @cython.locals(code=str, first=Py_UCS4)
    cdef int _token_end(self, int end, int length) except -1
    cpdef pass_blank(self)
    cpdef skip(self)
    cpdef Py_UCS4 after(self, int column) except? 0
    cpdef str text(self)
    cdef _pass_comment(self)


cpdef bint is_letter(Py_UCS4 character) noexcept
cpdef bint is_digit(Py_UCS4 character) noexcept
cpdef bint is_operator(Py_UCS4 character) noexcept
cpdef bint ends_expression(Py_UCS4 character) noexcept
