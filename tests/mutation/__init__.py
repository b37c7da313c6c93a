"""Faults put in by rule: `make mutants ROOM=nc` changes one thing at a time and runs the tests of that room.

mutants   what is changed: a comparison, an operator, a number, a word, a condition, a return, a statement
rooms     which sources and tests belong to a room, and the mutants that change nothing (equal.toml)
runner    a warm process that forks for each mutant
__main__  the table of scores, and the survivors

A test that fails where nothing of the room is compiled is left out.
"""
