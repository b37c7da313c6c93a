"""`python -m pal`: the assembler's command, which is no part of this package."""

from importlib import import_module

if __name__ == "__main__":
    import_module("pdp8.cli.assemble").main()
