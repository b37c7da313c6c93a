"""The command line of the project: one file a command, each loaded only when it is called.

root      the `pdp8` command, which hangs the others together
run       a program and its tape in, the punched tape out
panel     the front panel             monitor    the operator's prompt       dap      a debugger for editors
assemble  `pal` and `pdp8 dis`        tape       `pdp8 tape`                 part     `pdp8 part`
os8       `pdp8 tape insert` and `extract`: files of OS/8 on a DECtape
part_options  the constants of a part as options     nc      `pdp8 nc`; nc_options, what its commands share
check     the answers of a class      cards      cards to print              replay   the afternoon of 1971
thesis    its figures and tables      workbench  the machine in a page       vectors  what every word does

running/  what `run` puts around the machine: tapes, pace, terminal, trace
shared/   what the commands share: how they end, files, options, progress
"""

import gc
import os
import signal
import sys
from importlib import import_module

_SELDOM = 50_000


def main() -> None:
    _run("pdp8.cli.root")


def pal() -> None:
    _run("pdp8.cli.assemble")


def _run(module: str) -> None:
    """Run `main` of `module`, quiet at Ctrl-C from the first import on."""
    _keep_docstrings()
    if signal.getsignal(signal.SIGINT) is not signal.SIG_IGN:
        signal.signal(signal.SIGINT, lambda number, _: os._exit(128 + number))
    gc.set_threshold(_SELDOM)  # what a command imports is no garbage: a tenth of the start went into looking
    run = import_module(module).main
    try:
        run()
    finally:
        gc.freeze()  # nor is it when the process ends


def _keep_docstrings() -> None:
    """Restart Python with docstrings if it drops them (PYTHONOPTIMIZE=2, -OO): --help shows them."""
    if sys.flags.optimize > 1:
        os.environ["PYTHONOPTIMIZE"] = "1"
        os.execv(sys.executable, [sys.executable, *(word for word in sys.orig_argv[1:] if word != "-OO")])
