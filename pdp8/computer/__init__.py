"""The machine itself: it prints nothing and knows no front end.

Its packages import only from those to their left; `rack` and `dectape`, only `hardware`:

    hardware  ◄──  speed  ◄──  machine, watch, stop, count  ◄──  past  ◄──  use

hardware/    processor, devices, core and panel, as they were: the ones to read
speed/       the same machine for long runs, held in lockstep with the processor by tests
machine      the one place that knows every part and wires it; run until halt, tape out or limit
watch        breakpoints, words being written, observers
count        how often words were executed and written
stop         why, where and when a run ended
past/        a machine's state in memory and as text; what it has done, and back
rack/        devices that an owner could add: clock, line printer, second Teletype, fixed-head disk
dectape/     DECtape: the TC08 and its transports
use/         what people do with it: programs, the operator's hands, keys, trace, reports of counts
"""
