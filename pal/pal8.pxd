# The types with which Cython compiles pal8.py; Python itself never reads this.

cimport cython

from pal.assembler cimport Written
from pal.notes cimport Mention
from pal.source cimport Line

cdef int START, ADDRESS, CURRENT_PAGE, INDIRECT, PAGE, SIGNIFICANT, _MASK, _CELLS
cdef int PLAIN, REFERENCE, MARK, PSEUDO, WEAK


cdef class Symbol:
    cdef public str name
    cdef public int kind, value, passed
    cdef public bint permanent
    cdef public tuple where


cdef bint _is_letter(Py_UCS4 character) noexcept
cdef bint _is_figure(Py_UCS4 character) noexcept
cdef bint _operates(Py_UCS4 character) noexcept
cdef bint _ends(Py_UCS4 character) noexcept


cdef class Assembler:
    cdef public dict symbols
    cdef public list written, output, places, origins, complaints, notes, mentions
    cdef public int ended
    cdef public bint fatal
    cdef list _lines, _texts, _codes, _names, _bottom, _top, _here_words, _zero_words, _before_here
    cdef dict _here, _zero
    cdef set _early
    cdef str _code, _token, _tagged
    cdef Py_UCS4 _first, _operator
    cdef Symbol _tag
    cdef bint _wipe, _exact, _is_undefined, _skips_origin, _expunged, _punching, _blank, _link
    cdef bint _dropped, _slips, _may_refer, _has_blank, _opens
    cdef int _number, _location, _field, _offset, _next_offset, _level, _radix, _loading, _checksum, _stack
    cdef int _index, _start, _end, _before, _last, _tagged_at, _pool_end, _looked_up, _named, _begun
    cdef int _value, _undefined, _ored, _group

    cdef _go_to(self, int column)
    @cython.locals(code=str, start=int, length=int)
    cdef _advance(self)
    @cython.locals(code=str, first=Py_UCS4)
    cdef int _token_end(self, int end, int length) except -1
    cdef _pass_blank(self)
    cdef _pass_comment(self)
    cdef int _keep(self, int start, int end) except -1
    cdef _mention(self, str name, int start, int end, bint defined)
    cdef bint _line(self) except -1
    cdef bint _ends_statement(self) except -1
    @cython.locals(start=int, end=int, name=str, found=Symbol, follows=Py_UCS4, level=int, location=int)
    cdef bint _statement(self) except -1
    @cython.locals(value=int)
    cdef _word(self, bint found, int start)
    @cython.locals(name=str, found=Symbol)
    cdef _look_up(self)
    @cython.locals(page=int, below=int, address=int)
    cdef _write(self, int value, int at)
    cdef _put_word(self, Written written)
    cdef _put(self, str kind, int value)
    @cython.locals(symbol=Symbol)
    cdef _define_tag(self, str name, int start, int end)
    cdef _push(self, int cells)
    @cython.locals(begun=int, goes_on=bint)
    cdef int _expression(self, bint found, bint may_refer) except? -1
    cdef bint _goes_on(self, int begun) except -1
    cdef _take_operator(self, Py_UCS4 operator)
    cdef _end_expression(self, int begun)
    @cython.locals(first=Py_UCS4)
    cdef bint _term(self) except -1
    cdef int _figures(self, str token) except? -1
    cdef _look_for_division(self, int start)
    @cython.locals(operator=Py_UCS4, last=int)
    cdef bint _combine(self) except -1
    cdef int _operate(self, int value, Py_UCS4 operator, int last) except? -1
    @cython.locals(tag=Symbol, refers=bint)
    cdef bint _take_symbol(self) except -1
    @cython.locals(start=int, marks=int, found=bint, number=bint, address=int)
    cdef bint _refer(self, int operation) except -1
    cdef int _indirect(self, int operation, int elsewhere, int start) except -1
    @cython.locals(start=int, link=bint, named=int, value=int)
    cdef bint _take_literal(self, Py_UCS4 opening) except -1
    @cython.locals(pool=dict, bottom=int, place=int, least=int, words=list)
    cdef int _find(self, int value, int page, int start) except -1
    cdef _enter_page(self)
    cdef _set_origin(self, int location)


cpdef _radix(Assembler run, int radix)
cpdef _punching(Assembler run, bint punching)
cpdef _page(Assembler run)
cpdef _field(Assembler run)
cpdef _zeros(Assembler run)
cpdef _relocate(Assembler run)
cpdef _device(Assembler run)
cpdef _filename(Assembler run)
cpdef _if_defined(Assembler run, str name)
cpdef _if_zero(Assembler run, bint holds)
cpdef _expunge(Assembler run)
cpdef _fix_table(Assembler run)
cpdef _fix_reference(Assembler run)
cpdef _pause(Assembler run)
cpdef _eject(Assembler run)
cpdef _text(Assembler run)
cpdef _list_or_not(Assembler run)
cpdef _block(Assembler run)
