# The types with which Cython compiles teletype.py; Python itself never reads this.

cimport cython
from libc.stdint cimport int64_t

from pdp8.computer.hardware.bus cimport Device

cdef int64_t NEVER, AT_ONCE, FRAME, PARTS, HALF_UNIT, EIGHTH, _NINE_UNITS, _FALLS, _RISES
cdef int SKIP, CLEAR_AC, UNIT, PULSES, FIRST_SHIFT, NINTH_SHIFT, LOOKS_AGAIN, _MARKER, _MARKS, _STOP_UNITS

cpdef int64_t tick_of(int64_t time)
cpdef int64_t half_units(int64_t count)
cpdef int64_t eighths(int64_t count)


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
    cdef public int reader_run, buffer, line, active, shifts, pulses
    cdef public int64_t now, start, free, origin, edge, step, lost, lost_at

    @cython.locals(pulse=int, ninth=int64_t)
    cpdef int plan(self) except -1
    cpdef int64_t next_edge(self) except -1
    cpdef int64_t tick(self, int pulse) noexcept
    cpdef bint beaten(self, int pulse, int64_t now) noexcept
    @cython.locals(since=int64_t)
    cpdef int pulse_after(self, int64_t now) noexcept
    @cython.locals(last=int64_t, pulse=int)
    cpdef int start_seen(self) noexcept
    @cython.locals(since=int64_t)
    cpdef int units(self, int pulse) noexcept
    cpdef int begin(self) except -1
    cpdef int preset(self) noexcept
    @cython.locals(first=int)
    cpdef int sample(self, int64_t now) noexcept
    @cython.locals(count=int, first=int, units=int)
    cpdef int shift(self, int shifts) noexcept
    cpdef int stop(self, int pulse) noexcept


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
    cdef public int register, mark, sent, unit, selected, ahead
    cdef public int64_t start, free, began, lost, lost_at

    cpdef int plan(self) noexcept
    @cython.locals(units=int)
    cdef int units_to_send(self) noexcept
    cpdef int64_t next_unit(self) noexcept
    @cython.locals(unit=int64_t)
    cpdef int64_t next_step(self) noexcept
    @cython.locals(has_frame=bint)
    cpdef bint step(self, int64_t time) noexcept
    cpdef int send(self) noexcept
    cpdef int deliver(self, int frame) except -1
    cpdef int load(self, int character, int64_t now) except -1
