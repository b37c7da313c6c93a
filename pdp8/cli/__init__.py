"""The command line of the house; root hangs every package's commands together as `pdp8`.

root      the `pdp8` command: its subcommands, each loaded only when it is called
check     the answers of a class
run       a program and its tape in, the punched tape out;   boot, trace, saved states, keyboard
monitor   the operator's prompt        replay   the afternoon of 1971        panel     the front panel
thesis    what the scan shows, and the thesis's figures made again
program, listed   a program by name becomes words, with its listing
keyboard  the Teletype at a terminal   tracing  a trace into a file
octal     words as they are typed      progress a bar on what lasts          interrupt Ctrl-C is the STOP key
"""

import gc
import sys

_SELDOM = 50_000


def main() -> None:
    """Run the `pdp8` command; Ctrl-C is quiet from the first moment, while the rest is being imported too."""
    gc.set_threshold(_SELDOM)  # what a command imports is no garbage: a tenth of the start went into looking
    try:
        from pdp8.cli.root import main as run
    except KeyboardInterrupt:
        sys.exit(130)
    try:
        run()
    finally:
        gc.freeze()  # nor is it when the process ends
