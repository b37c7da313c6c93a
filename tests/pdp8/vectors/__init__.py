"""The vectors, played on the project's machines and on the reference.

emulators         processor, engine and reference as runner.py wants an emulator
faults            faults of the reference that the runner in C has to find
page_machine.mjs  the page's machine plays a folder in Node.js
"""
