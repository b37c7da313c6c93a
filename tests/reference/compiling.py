"""How the reference's C is compiled, and how its structures are told to Python."""

import ctypes
import getpass
import hashlib
import os
import shutil
import subprocess
import sysconfig
import tempfile
from collections.abc import Iterable
from pathlib import Path
from typing import Any


def compiler() -> str | None:
    """Return the C compiler, if there is one."""
    named = os.environ.get("CC") or (sysconfig.get_config_var("CC") or "").split(" ")[0]
    return shutil.which(named or "cc") or shutil.which("cc")


def compile_c(program: Path, *arguments: str | Path) -> None:
    """Compile to `program`. Raises CalledProcessError with the compiler's messages on standard error."""
    cc = compiler()
    assert cc is not None
    options = ("-std=c11", "-O2", "-Wall", "-Wextra", "-Wno-parentheses", "-Werror")
    subprocess.run([cc, *options, "-o", program, *arguments], check=True)


def compiled(sources: Iterable[Path], headers: Iterable[Path]) -> ctypes.CDLL:
    """Return the library of `sources`; it is kept among the temporary files, named by all it is made from."""
    sources = tuple(sources)
    made_from = hashlib.sha256(b"".join(path.read_bytes() for path in (*sources, *headers))).hexdigest()[:16]
    path = Path(tempfile.gettempdir()) / f"pdp8l-reference-{getpass.getuser()}-{made_from}.so"
    if not path.exists():
        new = path.with_suffix(f".{os.getpid()}")
        compile_c(new, "-shared", "-fPIC", *sources)
        new.replace(path)
    return ctypes.CDLL(str(path))


def numbers(kind: Any, names: str) -> list[tuple[str, Any]]:
    return [(name, kind) for name in names.split()]
