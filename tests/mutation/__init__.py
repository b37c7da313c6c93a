"""Faults put in by rule: `make mutants ROOM=nc` changes one thing at a time and runs the tests that run it.

mutants   what is changed: a comparison, an operator, a number, a word, a condition, a return, a statement
rooms     which sources and tests belong to a room, and the mutants that change nothing (equal.toml)
runner    a warm pytest that forks for each mutant
__main__  the table of scores, and the survivors

A test may run commands: they start in forks of the process that has the mutant. One that starts a command by
`commands.start` or at a terminal is left out, and so is one that fails where nothing of the room is compiled.
"""
