# The types with which Cython compiles listing.py; Python itself never reads this.

from pal.assembler cimport Listed

cdef str _statement(Listed listed, str text)
