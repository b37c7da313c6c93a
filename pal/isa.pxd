# The types with which Cython compiles isa.py; Python itself never reads this.

cdef int _ADDRESS, _PAGE, _FIELD, _CURRENT_PAGE, _JMP

cpdef int refers_to(int word, int location) noexcept
cpdef int in_field(int location, int address) noexcept
cpdef bint autoindexed(int pointer) noexcept
cpdef bint jumps_to(int target, int word, int location) noexcept
cpdef bint changes_field(int word) noexcept
cpdef bint tests_flag(int word) noexcept
cpdef bint halts(int word) noexcept
