"""`python -m pal`: the command `pal`."""

from pal.cli import main

main()
