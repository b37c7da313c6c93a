"""The vectors, played on the reference and on the page's machine.

emulators   the reference as runner.py wants an emulator
faults      faults of the reference that the runner in C has to find
"""
