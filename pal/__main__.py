"""`python -m pal`: the command `pal`, with the bundled programs on the shelf."""

from pdp8.cli import pal

pal()
