# The types with which Cython compiles teletype.py; Python itself never reads this.

cimport cython
from libc.stdint cimport int64_t

from pdp8.computer.hardware.bus cimport Device

cdef int64_t NEVER, AT_ONCE, FRAME, START_CHECKED, RECEIVED, IOP2_TO_IOP4
cdef int SKIP, CLEAR_AC, _MARKER

cpdef int64_t half_units(int64_t count)


@cython.final
cdef class Reader:
    cdef public Device device
    cdef public bytes tape
    cdef public Py_ssize_t position
    cdef public bint loaded, on
    cdef public object more

    cpdef bint ready(self)
    cpdef bint empty(self)


@cython.final
cdef class Keyboard:
    cdef public Device device
    cdef public bytearray waiting


@cython.final
cdef class Receiver(Device):
    cdef public Reader reader
    cdef public Keyboard keyboard
    cdef public int reader_run, buffer, frame, stage
    cdef public int64_t now, start, free, step, requested

    @cython.locals(start=int64_t)
    cpdef void plan(self) noexcept
    cpdef int begin(self) except -1
    @cython.locals(bits=int)
    cpdef int shifted(self, int64_t now) except -1


@cython.final
cdef class Printer:
    cdef public bytearray frames
    cdef public object on_frame

    cpdef int take(self, int frame) except -1


@cython.final
cdef class Punch:
    cdef public bytearray frames
    cdef public bint on
    cdef public object on_frame

    cpdef int take(self, int frame) except -1


@cython.final
cdef class Transmitter(Device):
    cdef public Printer printer
    cdef public Punch punch
    cdef public int register, shifts, unit, selected, printed
    cdef public int64_t start, free

    cpdef void plan(self) noexcept
    @cython.locals(units=int)
    cdef int left(self) except -1
    cpdef int end(self) except -1
    cpdef int stop(self) except -1
    cpdef int select(self, int mark) except -1
    cpdef int load(self, int character, int64_t now) except -1
