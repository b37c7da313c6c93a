"""Builds the compiled core where a C compiler and Cython are at hand; what is not built runs as Python."""

import os
import sysconfig

from setuptools import setup

MODULES = (
    "pal.isa",
    *(f"pdp8.computer.{name}" for name in ("bus", "processor", "teletype", "waiting", "engine")),
)
FLAGS = ["-O3", "-g0"]
if "gcc" in (os.environ.get("CC") or sysconfig.get_config_var("CC") or ""):
    # A tree of branches foretells what comes next in a PDP-8 program better than one jump through a table;
    # and a skip that is foretold is not waited for, as one that is computed would be.
    FLAGS += ["-fno-jump-tables", "-fno-if-conversion", "-fno-if-conversion2"]
DIRECTIVES = {
    "annotation_typing": False,
    "boundscheck": False,
    "cdivision": True,
    "embedsignature": False,
    "initializedcheck": False,
    "language_level": 3,
    "wraparound": False,
}


def extensions() -> list[object]:
    """Return the modules with types beside them as extensions; none without Cython."""
    try:
        from Cython.Build import cythonize
    except ImportError:
        return []
    from setuptools import Extension

    built = cythonize(
        [Extension(name, [name.replace(".", "/") + ".py"], extra_compile_args=FLAGS) for name in MODULES],
        build_dir="build",
        compiler_directives=DIRECTIVES,
    )
    for extension in built:  # cythonize does not keep it
        extension.optional = True
    return list(built)


setup(ext_modules=extensions())
