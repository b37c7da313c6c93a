"""The hardware of a PDP-8/L and its devices, each as it was.

processor    AC L PC MA MB IR, one memory cycle at a time: the one to read
operate      the OPR groups as pure functions
bus          IOP pulses, SKIP, interrupt request: what processor and devices say to each other
signals      times, pulses and answers on which the others agree
teletype     ASR-33: keyboard and reader (03), printer and punch (04)
highspeed    PC8/L: the high-speed reader (01) and punch (02)
extension    MC8/L: the fields of core above 4K
core         the words of core, examined and deposited from outside
panel        lamps, switches and keys
fields       how a part says what a saved state holds of it
"""
