# The types with which Cython compiles source.py; Python itself never reads this.

cdef class Line:
    cdef public int tape, number
    cdef public str text
