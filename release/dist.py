"""Build what a release consists of, install each wheel into an empty environment, and run it there.

    dist/        pdp8-V.tar.gz, and the compiled wheel for this Python: pip install dist/*.whl
    dist/other/  the compiled wheels for the other Pythons at hand, and py3-none-any, which compiles nothing

The sdist is built from the sources, each wheel from the sdist, and each of them twice: the bytes have to be
the same. SOURCE_DATE_EPOCH is the time of the last commit unless it is set. The Pythons at hand are those
that uv finds on the PATH; with pyenv, `PYENV_VERSION=3.11.7:3.12.1:3.13.0 make dist`. Wheels that PyPI takes
for Linux, macOS and Windows are built by cibuildwheel (pyproject.toml) in .github/workflows/release.yml; they
pass the same checks:

    python release/dist.py                 build and check
    python release/dist.py --check WHEEL…  check wheels that were built elsewhere
    python release/dist.py --tag v1.2.3    check that a tag is the version's

Needs uv and twine: `pip install ".[release]"`.
"""

import argparse
import filecmp
import os
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path
from zipfile import ZipFile

HOUSE = Path(__file__).parent.parent
PYTHONS = ("3.11", "3.12", "3.13", "3.14", "3.15")
SCRIPT = re.compile(r"```python\n(.*?)```", re.DOTALL)
"""The first one of docs/python.md."""


def run(*command: str | Path, env: dict[str, str] | None = None, **options: object) -> bytes:
    """Run a command; return its standard output. Exits with the output where it fails."""
    done = subprocess.run(
        [str(word) for word in command],
        env={**os.environ, **(env or {})},
        capture_output=True,
        check=False,
        **options,  # type: ignore[call-overload]
    )
    if done.returncode:
        sys.exit(
            f"{' '.join(str(word) for word in command)}: status {done.returncode}\n{done.stderr.decode()}"
        )
    return bytes(done.stdout)


def say(line: str) -> None:
    """Print a line at once, between the lines of other programs."""
    print(line, flush=True)


def epoch() -> dict[str, str]:
    """Return the environment that makes archives reproducible."""
    if "SOURCE_DATE_EPOCH" in os.environ:
        return {}
    return {"SOURCE_DATE_EPOCH": run("git", "log", "-1", "--format=%ct", cwd=HOUSE).decode().strip()}


def uv() -> str:
    """Return the path of uv."""
    beside = Path(sys.executable).with_name("uv")
    found = str(beside) if beside.exists() else shutil.which("uv")
    return found or sys.exit('uv is not installed: pip install ".[release]"')


def pythons() -> dict[str, str]:
    """Return the interpreters at hand, {version: path}, this one's version first."""
    here = f"{sys.version_info.major}.{sys.version_info.minor}"
    found = {here: sys.executable}
    for version in PYTHONS:
        asked = subprocess.run(
            [uv(), "python", "find", "--no-python-downloads", version],
            capture_output=True,
            text=True,
            check=False,
        )
        if version not in found and asked.returncode == 0:
            found[version] = asked.stdout.strip()
    return found


def build(kind: str, source: Path, out: Path, python: str, extensions: str) -> Path:
    """Build a `kind`, sdist or wheel, of `source` into folder `out`; return the archive."""
    with tempfile.TemporaryDirectory() as folder:
        run(
            *(uv(), "build", f"--{kind}", "--python", python, "--out-dir", folder, source),
            env={"PDP8_EXTENSIONS": extensions, **epoch()},
        )
        (built,) = (path for path in Path(folder).iterdir() if path.suffix in (".whl", ".gz"))
        out.mkdir(parents=True, exist_ok=True)
        return Path(shutil.copy(built, out))


def built_twice(kind: str, source: Path, out: Path, python: str, extensions: str) -> Path:
    """Build a `kind` of `source` into `out`, and once more; exit if the two differ."""
    archive = build(kind, source, out, python, extensions)
    with tempfile.TemporaryDirectory() as folder:
        again = build(kind, source, Path(folder), python, extensions)
        if not filecmp.cmp(archive, again, shallow=False):
            sys.exit(f"{archive.name}: built twice, the bytes differ")
    return archive


def check(wheel: Path, python: str) -> None:
    """Install `wheel` into an empty environment of `python`; run the main job and a user's script there."""
    pure = wheel.name.endswith("-py3-none-any.whl")
    names = ZipFile(wheel).namelist()
    compiled = {name.split(".")[0] for name in names if name.endswith((".so", ".pyd"))}
    typed = {name.removesuffix(".pxd") for name in names if name.endswith(".pxd")}
    expected = set() if pure else typed - {"pdp8/computer/speed/piece"}  # that is compiled with the engine
    if compiled != expected:
        sys.exit(f"{wheel.name}: compiled modules {sorted(compiled)}, expected {sorted(expected)}")
    with tempfile.TemporaryDirectory() as folder:
        room = Path(folder)
        run(uv(), "venv", "-q", "--python", python, room / "venv")
        bin_ = room / "venv" / ("Scripts" if os.name == "nt" else "bin")
        run(uv(), "pip", "install", "-q", "--python", bin_ / "python", wheel, "mypy")
        run(uv(), "pip", "check", "--python", bin_ / "python")
        version = run(bin_ / "pdp8", "--version").decode().strip()
        if ("interpreted" if pure else "compiled") not in version:
            sys.exit(f"{wheel.name}: pdp8 --version says {version!r}")
        tape = run(bin_ / "pdp8", "part", "circle")
        cut = run(bin_ / "pdp8l", "run", "eia.pal", "--quiet", input=tape)
        if cut != (HOUSE / "tapes" / "circle.eia").read_bytes():
            sys.exit(f"{wheel.name}: the main job punches another tape than circle.eia")
        check_pages(room, bin_, wheel if pure else None)
        check_script(room, bin_)
    say(f"{wheel.name}: {len(compiled)} compiled modules; {version}; circle.eia is right; types are right")


def check_pages(room: Path, bin_: Path, archive: Path | None) -> None:
    """Make the pages that bring their own Python; from `archive`, a zip to Python, too, and alike."""
    for page in (("workbench",), ("thesis", "page")):
        installed = run(bin_ / "pdp8", *page, "-o", "-", cwd=room)
        if archive:
            from_it = {"PYTHONPATH": str(archive.resolve())}
            zipped = run(bin_ / "python", "-m", "pdp8", *page, "-o", "-", cwd=room, env=from_it)
            if zipped != installed:
                sys.exit(f"{archive.name}: pdp8 {' '.join(page)} is another page from the zip than installed")


def check_script(room: Path, bin_: Path) -> None:
    """Run the first script of docs/python.md beside files that bear the names of our packages; type it."""
    (shown, *_) = SCRIPT.findall((HOUSE / "docs" / "python.md").read_text(encoding="utf-8"))
    script = room / "script.py"
    script.write_text(shown)
    for name in ("programs", "tapes", "nc", "pal"):
        (room / f"{name}.py").write_text("raise SystemExit('a user\\'s own file was imported')\n")
    said = run(bin_ / "python", script, cwd=room)
    if said.strip() not in shown.encode():
        sys.exit(f"docs/python.md: its first script printed {said!r}")
    typed = room / "typed"
    typed.mkdir()
    run(bin_ / "mypy", "--strict", shutil.copy(script, typed), cwd=typed)


def check_tag(tag: str) -> None:
    """Exit unless `tag` is v and the version of pyproject.toml."""
    version = tomllib.loads((HOUSE / "pyproject.toml").read_text(encoding="utf-8"))["project"]["version"]
    if tag != f"v{version}":
        sys.exit(f"tag {tag}: pyproject.toml has version {version}, which is v{version}")


def main() -> None:
    """Build and check, or check the wheels or the tag that is named."""
    parser = argparse.ArgumentParser(description="Build what a release consists of, and check it.")
    parser.add_argument("--check", nargs="+", type=Path, metavar="WHEEL", help="only check these wheels")
    parser.add_argument("--tag", help="only check that this tag is the version's")
    asked = parser.parse_args()
    if asked.tag:
        check_tag(asked.tag)
        return
    wheels = asked.check
    if wheels:
        for wheel in wheels:
            check(wheel, sys.executable)
        return
    out, here = HOUSE / "dist", sys.executable
    shutil.rmtree(out, ignore_errors=True)
    sdist = built_twice("sdist", HOUSE, out, here, "forbid")
    say(sdist.name)
    archives = [sdist]
    for version, python in pythons().items():
        place = out if python == here else out / "other"
        wheel = built_twice("wheel", sdist, place, python, "require")
        check(wheel, python)
        archives.append(wheel)
        say(f"    Python {version}")
    wheel = built_twice("wheel", sdist, out / "other", here, "forbid")
    check(wheel, here)
    archives.append(wheel)
    say(run(sys.executable, "-m", "twine", "check", "--strict", *archives).decode().strip())


if __name__ == "__main__":
    main()
