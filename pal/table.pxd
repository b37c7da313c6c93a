# The types with which Cython compiles table.py; Python itself never reads this.

cdef int _MASK, _PERMANENT_END, _BOUNDARY, _SPILL, _CORE, _LINE_FEED, _SAFE


cdef class SymbolTable:
    cdef public list words
    cdef public dict index
    cdef public int first, end, boundary, safe
    cdef int _room
