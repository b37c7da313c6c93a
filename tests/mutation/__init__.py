"""Faults put in by rule: `make mutants PACKAGE=nc` changes one thing at a time and runs that package's tests.

mutants   what is changed: a comparison, an operator, a number, a word, a condition, a return, a statement
packages  which sources and tests belong to a package, and the mutants that change nothing (equal.toml)
runner    a warm process that forks for each mutant
__main__  the table of scores, and the survivors

A test that fails where nothing of the package is compiled is left out.
"""
