"""`pdp8 nc` with `pdp8 nc view`, whose page nc/ knows nothing of."""

from nc.cli import nc
from pdp8.cli.workbench import view

nc.add_command(view)

__all__ = ["nc"]
