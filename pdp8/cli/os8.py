"""`pdp8 tape extract` and `insert`: files of PS/8 and OS/8 on a DECtape image."""

from array import array
from pathlib import Path

import click

from pdp8 import shelf
from pdp8.cli.shared import command
from pdp8.cli.shared.arguments import Command, Source, Target, output
from pdp8.cli.shared.frames import unspelled
from pdp8.cli.shared.rules import option
from tapes import dectape, os8
from tapes.errors import WorkError, naming
from tapes.text import without_mark

_FRAMES = "BN"
_AS = click.Choice(["text", "tape", "words"])
_as = option(
    "--as form",
    "The lines of a text, the frames of a BIN tape, or all words, each in two bytes, low one first.  "
    "[default: tape for .BN, words for .SV and .RL, else text]",
    _AS,
)
_image = click.argument("image", type=Source(), metavar="IMAGE.tu56")


def _form(name: str, form: str | None) -> str:
    if form is not None:
        return form
    extension = name.upper().partition(".")[2]
    return "tape" if extension == _FRAMES else "words" if extension in ("SV", "RL") else "text"


def _reel(name: str) -> dectape.Image:
    """Return the DECtape in a file."""
    content = shelf.read(name)
    with naming(name):
        found, notes = dectape.decode(content)
    command.say_of(name, notes)
    return found


@click.command(cls=Command)
@_image
@click.argument("name")
@_as
@output(Target("file"))
def extract(*, image: str, name: str, form: str | None, output: str) -> None:
    """Copy a file from a DECtape of PS/8 or OS/8. `pdp8 tape show IMAGE` lists them.

    \b
    Examples:
      pdp8 tape extract os8.tu56 CIRCLE.FT -o circle.ft
      pdp8 tape extract os8.tu56 PROG.BN | pdp8 dis -
    """
    reel = _reel(image)
    with naming(image):
        words = os8.words(reel, name)
    kind = _form(name, form)
    if kind == "words":
        command.put(output, dectape.packed(array("H", words)))
    else:
        command.put(output, os8.frames(words) if kind == "tape" else os8.text(words).encode())


@click.command(cls=Command)
@_image
@click.argument("files", type=Source(), nargs=-1, required=True)
@option("--name renamed", "The name on the tape of the one FILE.", metavar="NAME.EX")
@_as
@output(Target("image"))
def insert(*, image: str, files: tuple[str, ...], renamed: str | None, form: str | None, output: str) -> None:
    """Copy files to a DECtape of PS/8 or OS/8, each under its own name, into a new image.

    \b
    Examples:
      pdp8 tape insert ps8.tu56 CIRCLE.FT -o with-circle.tu56
      pdp8 tape insert ps8.tu56 eia.pal --name EIA.PA -o with-eia.tu56
    """
    if renamed is not None and len(files) > 1:
        raise click.UsageError(f"--name is for one FILE, not {len(files)}.")
    reel = _reel(image)
    with naming(image):
        os8.directory(reel)
    for file in files:
        name, content = Path(file).name if renamed is None else renamed, shelf.read(file)
        if (kind := _form(name, form)) == "tape":
            content, note = unspelled(file, content)
            command.say_of(file, [note] * bool(note))
        with naming(file):
            reel = os8.insert(reel, name, _packed(content, kind))
    command.put(output, reel.content())


def _packed(content: bytes, kind: str) -> list[int]:
    """Return the words of a file to insert."""
    if kind == "tape":
        return os8.pack(content)
    if kind == "text":
        content = without_mark(content)
        try:
            return os8.from_text(content.decode())
        except UnicodeDecodeError as error:
            value = f"{content[error.start]:03o}"
            raise WorkError(
                f"no text: byte {error.start} is {value}; --as tape takes the frames of a tape"
            ) from None
    words = [int.from_bytes(content[at : at + 2], "little") for at in range(0, len(content), 2)]
    if len(content) % 2 or any(word > 0o7777 for word in words):
        raise WorkError("these are no words of 12 bits, each in two bytes, the low one first")
    return words
