# The types with which Cython compiles source.py; Python itself never reads this.

cimport cython


cdef class Line:
    cdef public int tape, number
    cdef public str text


@cython.locals(code=str, end=int)
cpdef list tokens(str text, int start=*, bint folds=*)
