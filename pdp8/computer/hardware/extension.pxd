# The types with which Cython compiles extension.py; Python itself never reads this.

cimport cython


@cython.final
cdef class Extension:
    cdef public int size, field, inst_field, data_field, inst_buffer, saved_inst, saved_data, inhibit
    cdef public int inst_switch, data_switch, remembered, left

    cpdef int registers(self) noexcept
    @cython.locals(restores=int, field=int, which=int)
    cpdef int input_output(self, int word, int lac) noexcept
    cdef void _load_buffer(self, int field) noexcept
    cpdef bint changes_field(self) noexcept
    cpdef void load_inst_field(self) noexcept
    cpdef void interrupt(self) noexcept
