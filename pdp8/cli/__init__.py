"""The command line of the project; root hangs every package's commands together as `pdp8`.

root      the `pdp8` command: its subcommands, each loaded only when it is called
check     the answers of a class           cards    to print
run       a program and its tape in, the punched tape out;   boot, trace, saved states, keyboard
monitor   the operator's prompt        replay   the afternoon of 1971        panel     the front panel
workbench the live machine in a page   nc       `pdp8 nc`, with the page of a tape
dap       a debugger for editors
vectors   what every word does, for tests of any emulator
thesis    the thesis's figures and tables, and its programs line by line
pacing    a run, Ctrl-C its STOP key       feed      the reader's tapes          outputs   the punches' tapes
keyboard  the Teletype at a terminal   line      the Teletype on a line      watching  traced, counted
parameters  what options take

tape      `pdp8 tape`                  part     `pdp8 part`                  assemble  `pal` and `pdp8 dis`
nc_options  what the commands of `pdp8 nc` share
command   how every command ends, and what it says
arguments the files that a command takes: completed, compared, never lost
progress  a bar on work that lasts      extras    how a library that is missing is got, as pdp8 was
"""

import gc
import os
import signal
from importlib import import_module

_SELDOM = 50_000


def main() -> None:
    _run("pdp8.cli.root")


def pal() -> None:
    _run("pdp8.cli.assemble")


def _run(module: str) -> None:
    """Run the command whose `main` is in `module`; Ctrl-C is quiet from the first moment, while the rest is
    being imported too.
    """
    if signal.getsignal(signal.SIGINT) is not signal.SIG_IGN:
        signal.signal(signal.SIGINT, lambda number, _: os._exit(128 + number))
    gc.set_threshold(_SELDOM)  # what a command imports is no garbage: a tenth of the start went into looking
    run = import_module(module).main
    try:
        run()
    finally:
        gc.freeze()  # nor is it when the process ends
