"""Faults that the tests have to find: `make faults` puts each into a copy of the sources and runs its tests.

What `make mutants` makes by rule, a statement dropped or a number changed, is not told here once more.

catalogue  reads the faults: a file of them a package, *.toml
workshop   a copy of the sources, a fault in it, its tests run
__main__   the table
"""
