"""Our commands without the start of Python: a server with all of our modules loaded forks for each.

    bash ─► pdp8 (warm.c) ── arguments, folder, environment, streams ──► server ── fork ──► pdp8.cli.main()

A command has a process, streams and an exit status of its own as always; what is saved is the tenth of a
second in which Python starts and imports. The server ends when the process that started it does. Where there
is no C compiler, or where the environment says how Python starts, commands start as they are.
"""

import atexit
import os
import select
import shutil
import signal
import socket
import struct
import subprocess
import sys
import tempfile
from collections.abc import Callable
from contextlib import suppress
from functools import cache
from importlib import import_module
from pathlib import Path
from pkgutil import iter_modules
from typing import NamedTuple

from coverage import process_startup

from tests.reference.compiling import compile_c, compiler

ROOT = Path(__file__).parents[1]
COMMANDS = ("pdp8", "pal")
_STREAMS = 3
_LOADED = ("pal.cli", "tapes.cli", "nc.cli", "programs.cli", "pdp8.cli", "pdp8.lessons", "pdp8.thesis")


def environment(cold: Path) -> dict[str, str]:
    """Return what finds our commands warm; those in the folder `cold` where they cannot be."""
    path = f"{cold}{os.pathsep}{os.environ['PATH']}"
    if compiler() is None or not hasattr(socket, "AF_UNIX"):
        return {"PATH": path}
    folder = started().folder
    places = {"WARM_COMMANDS": f"{folder}/server", "COLD_COMMANDS": str(cold)}
    return {"PATH": f"{folder}{os.pathsep}{path}", **places}


class Server(NamedTuple):
    """The folder of the commands and of their server's address; the server ends when `life` does."""

    folder: Path
    life: object


@cache
def started() -> Server:
    """Start the server."""
    folder = Path(tempfile.mkdtemp(prefix="pdp8-warm-"))
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    compile_commands(folder)
    words = [sys.executable, "-m", "tests.warm", f"{folder}/server"]
    process = subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, cwd=ROOT)
    assert process.stdout is not None
    process.stdout.read(1)
    return Server(folder, process)


def compile_commands(folder: Path) -> None:
    """Put into a folder the commands that the server there is asked by."""
    compile_c(folder / COMMANDS[0], "-D_GNU_SOURCE", Path(__file__).with_suffix(".c"))
    for name in COMMANDS[1:]:
        (folder / name).symlink_to(COMMANDS[0])


def load() -> None:
    """Import all that a command may."""
    for package in _LOADED:
        module = import_module(package)
        for inner in iter_modules(getattr(module, "__path__", []), f"{package}."):
            with suppress(ImportError):
                import_module(inner.name)


def serve(address: str) -> None:
    """Run commands until standard input ends."""
    with socket.socket(socket.AF_UNIX) as listening:
        listening.bind(address)
        listening.listen(64)
        os.write(1, b".")
        signal.signal(signal.SIGCHLD, signal.SIG_IGN)
        while listening.fileno() in select.select([listening.fileno(), 0], [], [])[0]:
            taken, _ = listening.accept()
            if os.fork() == 0:
                listening.close()
                _watch(taken)
            taken.close()


def _watch(client: socket.socket) -> None:
    """Run one command in a process of its own, and tell the client how it ended."""
    signal.signal(signal.SIGCHLD, signal.SIG_DFL)
    size, streams, _, _ = socket.recv_fds(client, 4, _STREAMS)
    sent = client.recv(struct.unpack("i", size)[0], socket.MSG_WAITALL)
    fields = [os.fsdecode(field) for field in sent.split(b"\0")[:-1]]
    child = os.fork()
    if child == 0:
        client.close()
        _become(fields, streams)
    for stream in streams:
        os.close(stream)
    status = os.waitpid(child, 0)[1]
    with suppress(OSError):
        client.sendall(struct.pack("i", status))
    os._exit(0)


def _become(fields: list[str], streams: list[int]) -> None:
    """Be the command: its folder, arguments, environment and streams; end as Python ends."""
    folder, count, *rest = fields
    words, variables = rest[: int(count)], rest[int(count) :]
    for stream, number in zip(streams, range(_STREAMS), strict=True):
        os.dup2(stream, number)
        os.close(stream)
    os.chdir(folder)
    os.environ.clear()
    os.environ.update({name: value for name, _, value in (one.partition("=") for one in variables)})
    sys.argv = words
    sys.path.insert(0, os.path.dirname(words[0]))
    sys.stdin = os.fdopen(0, closefd=False)
    sys.stdout = os.fdopen(1, "w", closefd=False)
    sys.stderr = os.fdopen(2, "w", buffering=1, errors="backslashreplace", closefd=False)
    signal.signal(signal.SIGINT, signal.default_int_handler)
    from pdp8 import cli

    measured = process_startup(force=True)  # by what the environment says, as where a command starts cold
    status = _status_of(cli.pal if words[0] == "pal" else cli.main)
    if measured:
        measured.stop()
        measured.save()
    for out in (sys.stdout, sys.stderr):
        try:
            out.flush()
        except (OSError, ValueError):
            status = 120
    os._exit(status)


def _status_of(run: Callable[[], object]) -> int:
    """Run the command; return its exit status as Python does."""
    try:
        run()
    except SystemExit as end:
        if end.code is None or isinstance(end.code, int):
            return (end.code or 0) & 0xFF
        print(end.code, file=sys.stderr)
        return 1
    except BaseException:
        sys.excepthook(*sys.exc_info())
        return 1
    return 0


if __name__ == "__main__":
    load()
    serve(sys.argv[1])
