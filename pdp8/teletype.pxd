# The types with which Cython compiles teletype.py; Python itself never reads this.

cimport cython

from pdp8.bus cimport Device

cdef long long NEVER, AT_ONCE, FRAME, START_CHECKED, RECEIVED, IOP2_TO_IOP4
cdef int SKIP, CLEAR_AC, _MARKER

cpdef long long half_units(long long count)


cdef class Reader:
    cdef public Device device
    cdef public bytes tape
    cdef public Py_ssize_t position
    cdef public bint loaded, on

    cpdef bint ready(self)
    cpdef bint empty(self)


cdef class Keyboard:
    cdef public Device device
    cdef public bytearray waiting


cdef class Receiver(Device):
    cdef public Reader reader
    cdef public Keyboard keyboard
    cdef public int reader_run, buffer, frame, stage
    cdef public long long now, start, free, step, asked

    @cython.locals(start="long long")
    cpdef plan(self)
    cpdef begin(self)
    @cython.locals(bits=int)
    cpdef int shifted(self, long long now) except -1


cdef class Printer:
    cdef public bytearray frames
    cdef public object on_frame

    cpdef take(self, int frame)


cdef class Punch:
    cdef public bytearray frames
    cdef public bint on
    cdef public object on_frame

    cpdef take(self, int frame)


cdef class Transmitter(Device):
    cdef public Printer printer
    cdef public Punch punch
    cdef public int register, shifts, unit, selected, printed
    cdef public long long start, free

    cpdef plan(self)
    cpdef end(self)
    cpdef stop(self)
    cpdef select(self, int mark)
    cpdef load(self, int character, long long now)
