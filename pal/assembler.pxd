# The types with which Cython compiles assembler.py; Python itself never reads this.
# What pal.watched changes is a method of Python's, and not here.

cimport cython

from pal.table cimport SymbolTable

cdef int _MASK, _PLACES
cdef int ADDRESS, CURRENT_PAGE, INDIRECT, PAGE, SIGNIFICANT, ENTRY, PSEUDO, UNDEFINED, VALUE


cdef class Written:
    cdef public int address, word, at
    cdef public list names
    cdef public bint literal, link


cdef class Listed:
    cdef public int location, at
    cdef public object word


cdef class Assembler:
    cdef public list table, lost, again, output, _items, _feeds, _pending, _names
    cdef public tuple stopped
    cdef public SymbolTable _symbols
    cdef public dict _seen, _redefined
    cdef public str _broken
    cdef public object _reader, _blamed
    cdef public bint _reads_ahead, _made, _refers, _referring, _doubtful, _zero
    cdef public int _number, _at, _location, _field, _radix, _checksum, _line, _places, _letters
    cdef public int _pointer, _item, _word, _address, _operator

    @cython.locals(at=int, item=str, mark=str, name=str)
    cdef _read(self)
    cdef _clear(self)
    @cython.locals(found=object, pointer=int)
    cdef bint _look_up(self, str name, str mark) except -1
    cdef _apply(self)
    cdef _point(self)
    @cython.locals(kind=str, pointer=int, value=int)
    cdef _finish(self)
    @cython.locals(address=int, page=int)
    cdef _make_word(self)
    cdef _write(self)
    @cython.locals(fed=bint, feed=int)
    cdef _list(self, int at)
    cdef _punch(self, str kind, int value)
    cdef void _sum(self, int value) noexcept
    @cython.locals(pointer=int, first=int)
    cdef _tag(self)
    cdef _wait(self, str kind)
    cdef _room_for(self, int places)
