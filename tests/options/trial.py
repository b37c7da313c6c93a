"""One call of a command in this process, in a folder of its own, and all that comes out of it."""

import io
import os
import re
import shlex
import sys
import tempfile
from collections.abc import Iterator, Mapping
from contextlib import chdir, contextmanager
from pathlib import Path
from typing import NamedTuple
from unittest.mock import patch

from pdp8.cli.root import pdp8
from pdp8.cli.shared import command

_MEMORY = "/dev/shm" if os.path.isdir("/dev/shm") else None
_OUR_TIME = re.compile(rb" *[\d.]+ s today| *[\d.]+ s +\d+ of the")
"""How long something took today, which differs from call to call."""


class Outcome(NamedTuple):
    """What a call did: its exit status, standard output and error, and the files that it left."""

    status: int
    shown: bytes
    said: bytes
    files: Mapping[str, bytes]

    @property
    def refused(self) -> bool:
        """Whether the call was a usage error."""
        return self.status == 2


@contextmanager
def folder(files: Mapping[str, bytes]) -> Iterator[None]:
    """Work in a folder of its own, in which are `files`."""
    with tempfile.TemporaryDirectory(dir=_MEMORY) as path, chdir(path):
        for name, content in files.items():
            Path(name).write_bytes(content)
        yield


def called(line: str, stdin: bytes = b"") -> Outcome:
    """Return what the command `line` does in the current folder, with `stdin` on its standard input."""
    given, shown, said = (io.BytesIO(content) for content in (stdin, b"", b""))
    streams = [io.TextIOWrapper(buffer, write_through=True) for buffer in (given, shown, said)]
    before = existing()
    with patch.multiple(sys, stdin=streams[0], stdout=streams[1], stderr=streams[2]):
        status = command.status(pdp8, "pdp8", shlex.split(line))
    return Outcome(status, shown.getvalue(), _OUR_TIME.sub(b"", said.getvalue()), changed(before))


def outcome(line: str, files: Mapping[str, bytes], stdin: bytes) -> Outcome:
    """Return what the command `line` does in a folder of `files`, of DECtapes those that it names."""
    with folder({name: content for name, content in files.items() if len(content) < 4096 or name in line}):
        return called(line, stdin)


def existing() -> dict[str, bytes]:
    """Return the files of the current folder."""
    return {str(path): path.read_bytes() for path in Path().rglob("*") if path.is_file()}


def changed(before: Mapping[str, bytes]) -> dict[str, bytes]:
    """Return the files of the current folder that are new, or other than `before`."""
    return {name: content for name, content in existing().items() if before.get(name) != content}
