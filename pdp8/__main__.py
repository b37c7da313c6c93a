"""`python -m pdp8` is the `pdp8` command."""

from pdp8.cli import main

main()
