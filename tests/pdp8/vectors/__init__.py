"""The vectors, played on the reference.

emulators  the reference as runner.py wants an emulator
faults     faults of the reference that the runner in C has to find
"""
