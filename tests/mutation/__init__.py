"""Faults put in by rule: `make mutants ROOM=nc` changes one thing at a time and runs the tests that run it.

mutants   what is changed: a comparison, an operator, a number, a word, a condition, a return, a statement
rooms     which sources and tests belong to a room, and the mutants that change nothing (equal.toml)
served    our commands in forks of a process that has a mutant in it
runner    a warm pytest that forks for each mutant
__main__  the table of scores, and the survivors
"""
