# The types with which Cython compiles bus.py; Python itself never reads this.

cimport cython

cdef long long NEVER, AT_ONCE
cdef int SKIP, CLEAR_AC, IOP1, IOP2, IOP4


cdef class Device:
    cdef public int flag
    cdef public long long due

    cpdef int pulse(self, int iop, int ac, long long now) except -1
    cpdef advance(self, long long now)
    cpdef initialize(self, long long now)
    cpdef look(self)
    cpdef finish(self)
    cpdef bint out_of_tape(self) except -1


cdef class Bus:
    cdef public list devices, by_code
    cdef public long long asked
    cdef public long long told

    @cython.locals(device=Device)
    cpdef int pulse(self, int code, int iop, int ac, long long now) except -1
    cpdef int transfer(self, int word, int lac, long long clock) except -1
    @cython.locals(answer=int)
    cdef int _send(self, int word, int iop, int lac, long long now) except -1
    @cython.locals(device=Device)
    cpdef advance(self, long long now)
    @cython.locals(device=Device)
    cpdef bint request(self, long long now) except -1
    @cython.locals(device=Device)
    cpdef bint flag(self, int code) except -1
    @cython.locals(device=Device, event="long long")
    cpdef long long next_event(self, long long now) except? -1
