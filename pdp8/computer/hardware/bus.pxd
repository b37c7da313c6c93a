# The types with which Cython compiles bus.py; Python itself never reads this.

cimport cython
from libc.stdint cimport int64_t

cdef int64_t NEVER
cdef int SKIP, CLEAR_AC, IOP1, IOP2, IOP4


cdef class Device:
    cdef public int code, flag, iot, tested, enabled
    cdef public Device behind
    cdef public int64_t due

    cpdef restored(self)
    cpdef int pulse(self, int iop, int ac, int64_t now) except? -1
    cpdef advance(self, int64_t now)
    cpdef initialize(self, int64_t now)
    cpdef look(self)
    cpdef finish(self)
    cpdef bint out_of_tape(self) except -1


cdef class BreakDevice(Device):
    cdef public int64_t asked
    cdef public int breaking, address, field, three_cycle, counts_address, into_core, increments

    cpdef accepted(self, int64_t now)
    cpdef overflow(self, int64_t now)
    cpdef int give(self, int64_t now) except? -1
    cpdef take(self, int word, int64_t now)


@cython.final
cdef class Bus:
    cdef public Device first
    cdef public bint has_breaks
    cdef public int64_t actions

    @cython.locals(device=Device)
    cpdef Device device(self, int code)
    @cython.locals(device=Device)
    cpdef int transfer(self, int word, int lac, int64_t clock) except -1
    @cython.locals(device=Device)
    cpdef void forget_tests(self) noexcept
    @cython.locals(device=Device)
    cpdef bint request(self, int64_t now) except -1
    @cython.locals(device=Device, asking=BreakDevice)
    cpdef BreakDevice accept_break(self, int64_t tp1, int64_t now)
    @cython.locals(device=Device, asking=BreakDevice)
    cpdef BreakDevice in_break(self)
    @cython.locals(device=Device, event=int64_t)
    cpdef int64_t next_event(self, int64_t now) except? -1


@cython.locals(answer=int)
cdef int _pulse(Device device, int iop, int lac, int64_t now) except -1
