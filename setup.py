"""Builds the compiled core; where it cannot be compiled, the same modules run as Python.

PDP8_EXTENSIONS says what a build does about it:
    auto      compile where Cython and a C compiler are at hand (the default)
    require   fail if one module does not compile: a release for one platform
    forbid    compile nothing: the wheel for every platform, py3-none-any

With SOURCE_DATE_EPOCH the same sources give the same archives, byte for byte: wheels by setuptools itself,
the sdist by the class below.
"""

import gzip
import os
import sys
import sysconfig
import tarfile
import threading
from pathlib import Path
from textwrap import shorten

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.sdist import sdist
from setuptools.errors import BaseError, CCompilerError

HOUSE = Path(__file__).parent
BUILD = Path("build")

DEVICES = (
    *(f"pdp8.computer.hardware.{name}" for name in ("bus", "extension", "processor", "teletype")),
    "pdp8.computer.speed.waiting",
)
PAL8 = ("expressions", "operators", "log", "lexer", "output", "table", "literals", "assembler")
MODULES = (  # the largest first: no core waits for it at the end
    *(f"pal.{name}" for name in ("assembler", "table", "notes", "listing", "source", "isa")),
    *(f"pal.pal8.{name}" for name in PAL8),
    *DEVICES,
    "pdp8.computer.speed.engine",
)
CHOICES = ("auto", "require", "forbid")
FLAGS = ["-O2", "-g0"]
PIECE = []
if "gcc" in (os.environ.get("CC") or sysconfig.get_config_var("CC") or ""):
    # A skip that is predicted is not waited for, as one that is computed would be; and each operation keeps a
    # jump of its own to the next. Where each begins should not be chance: aligned, they are a tenth faster.
    PIECE += ["-fno-if-conversion", "-fno-if-conversion2", "-fno-gcse", "-fno-crossjumping"]
    PIECE += ["-falign-labels=16", "-falign-functions=64"]
    FLAGS += ["-Wno-stringop-overread"]  # of Cython's comparison with an empty string, which compares no byte
OWN = {
    "pdp8.computer.speed.engine": PIECE,
    **{name: ["-O3"] for name in DEVICES},
}
DIRECTIVES = {
    "annotation_typing": False,
    "auto_pickle": False,
    "boundscheck": False,
    "cdivision": True,
    "embedsignature": False,
    "initializedcheck": False,
    "language_level": 3,
    "wraparound": False,
}


def choice() -> str:
    """Return PDP8_EXTENSIONS; exit if it is not one of CHOICES."""
    value = os.environ.get("PDP8_EXTENSIONS") or "auto"
    if value not in CHOICES:
        raise SystemExit(f"PDP8_EXTENSIONS={value}: it may be {', '.join(CHOICES)}")
    return value


def translate_piece() -> None:
    """Write the C of pdp8/computer/speed/piece.py, which piece.pxd asks for."""
    from release.threaded import translate

    BUILD.mkdir(exist_ok=True)
    (BUILD / "piece.h").write_text(translate(HOUSE / "pdp8/computer/speed/piece.py"))


def extensions(required: bool) -> list[Extension]:
    """Return the modules with types beside them as extensions; none without Cython, unless `required`."""
    try:
        from Cython.Build import cythonize
    except ImportError:
        if required:
            raise
        return []
    translate_piece()
    built = cythonize(
        [
            Extension(
                name,
                [name.replace(".", "/") + ".py"],
                include_dirs=[str(BUILD)],
                depends=["pdp8/computer/speed/piece.py", "release/threaded.py"],
                extra_compile_args=[*FLAGS, *OWN.get(name, ())],
            )
            for name in MODULES
        ],
        build_dir=str(BUILD),
        quiet=True,
        compiler_directives=DIRECTIVES,
    )
    for extension in built:  # cythonize does not keep it
        extension.optional = not required
    return list(built)


def readme() -> str:
    """Return the README as PyPI shows it."""
    from release.links import absolute

    return absolute((HOUSE / "README.md").read_text(encoding="utf-8"))


class SpokenBuild(build_ext):
    """A build that says which module it compiles, each core another, and once why it compiles none."""

    in_vain = threading.Lock()
    """Taken by the first module that cannot be compiled: the others then stay Python too."""

    def build_extension(self, ext: Extension) -> None:
        if self.in_vain.locked():
            return
        print(f"compiling {ext.name}", flush=True)
        try:
            super().build_extension(ext)
        except (CCompilerError, BaseError, OSError) as error:
            if not ext.optional:
                raise
            if self.in_vain.acquire(blocking=False):
                print(
                    f"it cannot be compiled: {shorten(str(error), 160)}\n"
                    "Everything works without it, as Python, but slower. To have it compiled, install a C "
                    "compiler and Python's headers (Debian: gcc, python3-dev), and begin with `make clean`.",
                    flush=True,
                )


class ReproducibleSdist(sdist):
    """An sdist that keeps no times, owners or modes of the folder it was made in."""

    def make_archive(self, base_name: str, format: str, *rest: object, **options: object) -> str:
        epoch = os.environ.get("SOURCE_DATE_EPOCH")
        if not epoch:
            return super().make_archive(base_name, format, *rest, **options)

        def entry(info: tarfile.TarInfo) -> tarfile.TarInfo:
            info.mtime, info.uid, info.gid, info.uname, info.gname = int(epoch), 0, 0, "", ""
            info.mode = 0o755 if info.isdir() else 0o644
            return info

        path = f"{base_name}.tar.gz"
        with (
            open(path, "wb") as file,
            gzip.GzipFile("", "wb", fileobj=file, mtime=int(epoch)) as zipped,
            tarfile.open(fileobj=zipped, mode="w") as archive,
        ):
            archive.add(str(options["base_dir"]), filter=entry)
        return path


sys.path.insert(0, str(HOUSE))
setup(
    long_description=readme(),
    long_description_content_type="text/markdown",
    ext_modules=[] if choice() == "forbid" else extensions(choice() == "require"),
    cmdclass={"build_ext": SpokenBuild, "sdist": ReproducibleSdist},
    options={"build_ext": {"parallel": os.cpu_count() or 1}},
)
