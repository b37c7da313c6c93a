"""Faults put in by rule: `make mutants ROOM=nc` changes one thing at a time and runs the tests that run it.

mutants   what is changed: a comparison, an operator, a number, a word, a condition, a return, a statement
rooms     which sources and tests belong to a room, and the mutants that change nothing (equal.toml)
runner    a warm pytest that forks for each mutant
__main__  the table of scores, and the survivors

Tests that run a command as a process of its own do not see a mutant and are left out: the commands' modules
(cli.py) and what only they reach come out as not run.
"""
