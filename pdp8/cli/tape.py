"""`pdp8 tape`: a tape shown as holes, measured, converted to another code, punched from typed text."""

from collections.abc import Callable
from typing import Any, TypeVar

import click

from pdp8 import shelf
from pdp8.cli.os8 import extract, insert
from pdp8.cli.shared import command, extras, progress
from pdp8.cli.shared.arguments import Group, Source, Target, output
from pdp8.cli.shared.frames import unspelled
from pdp8.cli.shared.rules import flag, option
from tapes import (
    codes,
    cutting,
    dectape,
    doubts,
    eia,
    frames,
    hydrapoint,
    measure,
    os8,
    picture,
    redundancy,
    spelled,
)
from tapes import convert as conversion
from tapes import title as eye
from tapes.code import Characters, Code
from tapes.errors import TapeError, called, naming
from tapes.loaders import Words
from tapes.paper import PAPERS as paper_sizes
from tapes.paper import sized

_Function = TypeVar("_Function", bound=Callable[..., Any])
_AUTO = "auto"
_SHOWN = 5
_NAMES = [code.name for code in codes.CODES]
_TYPED = {code.name: code for code in codes.CODES if isinstance(code, Characters)}
_output = output(Target("tape"))
_file = click.argument("file", type=Source(), default="-")


_accept = flag("--accept", "Take doubtful frames as they were punched.")


def _frames_and_values(_context: click.Context, _option: click.Parameter, value: str) -> dict[int, int]:
    mends = {}
    for each in filter(None, value.split(",")):
        try:
            frame, octal = each.split("=")
            mends[int(frame)] = int(octal, 8)
            if int(frame) < 0 or not 0 <= mends[int(frame)] <= 0o377:
                raise ValueError
        except ValueError:
            raise click.BadParameter(
                f"{each!r} is not FRAME=OCTAL, such as 1020=116; OCTAL is 000 to 377"
            ) from None
    return mends


_mend = option(
    "--mend",
    "Read these frames as other values than were punched.",
    metavar="FRAME=OCTAL,...",
    default="",
    callback=_frames_and_values,
)


def _read(file: str) -> bytes:
    """Return the frames of a tape or dump, and say if it was a dump."""
    return _unspelled(file, shelf.read(file))


def _unspelled(file: str, content: bytes) -> bytes:
    """Return the frames of a dump, of words or of a state, or `content` if it is none; say if it was."""
    found, note = unspelled(file, content)
    command.say_of(file, [note] * bool(note))
    return found


def _mended(content: bytes, values: dict[int, int]) -> bytes:
    _check_last("--mend", max(values, default=-1), content)
    return doubts.mended(content, values)


def _say_short(file: str, last: int | None, content: bytes) -> None:
    """Say that a tape ends before the frame that --to names."""
    if last is not None and (said := _beyond("--to", last, content)):
        command.say_of(file, [said])


def _check_last(option: str, frame: int, content: bytes) -> None:
    if said := _beyond(option, frame, content):
        raise click.UsageError(said)


def _beyond(option: str, frame: int, content: bytes) -> str:
    """Say that a tape lacks the frame that an option names; "" if it has it."""
    return f"{option} {frame}: the last frame is {len(content) - 1}" * (frame >= len(content))


def _say_accepted(file: str, content: bytes, code: Code) -> None:
    """Say which doubtful frames were accepted, and which frames are a title."""
    found = [f"{doubt}; taken as punched" for doubt in doubts.find(content, code)]
    more = [f"and {len(found) - _SHOWN} more"] * (len(found) > _SHOWN)
    titles = [f"a title of {len(label)} frames from frame {label.start} on" for label in code.labels(content)]
    command.say_of(file, (*found[:_SHOWN], *more, *titles))


def _parity(code: str) -> Callable[[_Function], _Function]:
    """Return the decorator that adds --parity, for tapes whose code is in option `code`."""
    return option(
        "--parity",
        "Channel 8 of an ASCII tape.",
        click.Choice(list(frames.PARITIES)),
        default="mark",
        needs=f"{code}=ascii",
    )


@click.group(cls=Group)
def tape() -> None:
    """Show, measure, convert and punch paper tapes.

    FILE is a tape of one byte a frame, a bundled tape's name, or - for standard input.

    \b
    Examples:
      pdp8 tape show circle.eia --to 20
      pdp8 tape info circle.asc circle.eia eia.bin
      pdp8 tape convert eia.bin --to rim > eia.rim
      pdp8 tape punch typed.txt > typed.asc
    """


@tape.command()
@_file
@option(
    "--from first",
    "The first frame to show; the tape's first is 0.",
    click.IntRange(0),
    metavar="FRAME",
    default=0,
    show_default=False,
)
@option("--to last", "The last frame to show.", click.IntRange(0), metavar="FRAME")
@option(
    "--code",
    "The code in which the captions read the tape.",
    click.Choice([_AUTO, *_NAMES, "none"]),
    default=_AUTO,
)
@option(
    "--svg", "Draw it in true size as SVG into FILE (- for standard output).", Target("SVG"), metavar="FILE"
)
@option(
    "--paper",
    "Draw pages of this paper, with a ruler and marks to cut: print at 100 %.",
    click.Choice(list(paper_sizes)),
    needs="--svg",
)
@option(
    "--cut",
    "Write outline and holes, in millimetres, for a laser that cuts.",
    Target("drawing"),
    metavar="FILE.svg|FILE.dxf",
    excludes="--code",
)
def show(
    *,
    file: str,
    first: int,
    last: int | None,
    code: str,
    svg: str | None,
    paper: str | None,
    cut: str | None,
) -> None:
    """Show a tape as rows of holes, each with its number, its octal and what it says; list an OS/8 DECtape.

    \b
    Examples:
      pdp8 tape show circle.eia --to 20
      pdp8 tape show circle.asc --from 162 --to 188
      pdp8 tape show eia.bin --code bin --from 60 --to 99
      pdp8 part circle | pdp8 tape show - --to 26 --svg line.svg
      pdp8 tape show eia.bin --svg eia-bin.svg --paper a4
      pdp8 tape show circle.eia --to 79 --cut block.dxf
    """
    _check_order(first, last)
    if dectape.is_image(content := shelf.read(file), file):
        if svg or cut or first or last is not None or code != _AUTO:
            raise click.UsageError(
                f"{file}: a DECtape image, of which the directory is listed; it takes no option"
            )
        with naming(file):
            image, notes = dectape.decode(content)
            command.say_of(file, notes)
            command.echo(os8.listing(image))
        return
    if code == _AUTO:
        content = _unspelled(file, content)
    with naming(file):
        _check(first, len(content))
    _say_short(file, last, content)
    stop = None if last is None else last + 1
    known = codes.recognise(content) if code == _AUTO else codes.named(code)
    if cut is not None:
        with naming(file):
            drawn = (cutting.dxf if cut.lower().endswith(".dxf") else cutting.svg)(content[first:stop])
        command.put(cut, drawn)
    if svg is not None:
        with naming(file):
            if paper:
                drawn = picture.pages(content, known.name, first, stop, paper)
            else:
                drawn = sized(picture.svg(content, known.name, first, stop))
        command.put(svg, drawn)
    elif cut is None:
        command.echo(picture.text(content, known.name, first, stop), nl=False)
        for label in known.labels(content):
            for row in frames.draw_label(content[:stop][max(first, label.start) : label.stop]):
                command.echo(f"   label    {row}".rstrip())


@tape.command()
@click.argument("files", type=Source(), nargs=-1, callback=lambda _, __, files: files or ("-",))
def info(files: tuple[str, ...]) -> None:
    """Say what each tape is, how long, how many minutes it takes, its lines or blocks, parity and checksum.

    \b
    Examples:
      pdp8 tape info circle.asc circle.eia
      pdp8 part ellipse | pdp8 tape info -
    """
    for file in files:
        report = measure.report(_read(file))
        command.echo(called(file))
        for name, value in report:
            command.echo(f"    {name:10} {value}".rstrip())


@tape.command()
@_file
@option("--code", "The code it is in.", click.Choice([_AUTO, *conversion.FORMS]), default=_AUTO)
@option("--to target", "The code to convert it to.", click.Choice(conversion.TARGETS), required=True)
@_parity("--to")
@option(
    "--fill",
    "RUBOUTs after CR LF; 6, or as an ASCII tape has them.",
    click.IntRange(0, 1000),
    metavar="FRAMES",
    needs="--to=ascii",
)
@_accept
@_mend
@flag("--force", "Take what can be read of a damaged BIN or RIM tape.")
@output(Target())
def convert(
    *,
    file: str,
    code: str,
    target: str,
    parity: str,
    fill: int | None,
    accept: bool,
    mend: dict[int, int],
    force: bool,
    output: str,
) -> None:
    """Convert a tape: characters (text, ascii, eia, ita2), words (bin, rim, or spelled out as text), or
    any to octal digits and back to frames. A frame that breaks a rule which its tape obeys is named, and no
    tape is made of it before it is mended or accepted.

    Words spelled out as text are known by their form: octal addresses and words, Verilog's $readmemh, EP,
    deposits of a SIMH script, lines of twelve bits, octal frames, an assembler's listing.

    \b
    Examples:
      pdp8 tape convert circle.eia --to text
      pdp8 tape convert circle.asc --to ascii --parity even -o even.asc
      pdp8 tape convert eia.bin --to rim -o eia.rim
      pdp8 tape convert eia.bin --to octal > eia.txt
      pdp8 tape convert eia.txt --code octal --to frames -o eia.bin
      pdp8 tape convert eia.bin --to readmemh -o eia.mem
    """
    content = _mended(_read(file) if code == _AUTO else shelf.read(file), mend)
    source = codes.recognise(content).name if code == _AUTO else code
    with naming(file):
        converted = conversion.convert(content, source, target, parity, fill, accept=accept, force=force)
    is_text = target in (conversion.TEXT, conversion.OCTAL, *spelled.FORMATS)
    command.put(output, converted.decode() if is_text else converted)
    words = codes.named(source)
    if isinstance(words, Words) and (isinstance(codes.named(target), Words) or target in spelled.FORMATS):
        damage = words.damage(content)
        said = [f"{damage}; taken as far as it can be read"] if damage else words.left_out(content)
        command.say_of(file, said)
    elif target in _TYPED or target == conversion.TEXT:
        _say_accepted(file, content, words)


def _ranges(_context: click.Context, _option: click.Parameter, value: str) -> list[range]:
    found = []
    for each in filter(None, value.split(",")):
        first, to, last = each.partition("-")
        last = last if to else first
        if not (first.isdecimal() and last.isdecimal()) or int(last) < int(first):
            raise click.BadParameter(f"{each!r} is not a frame or a range of them, such as 1001,821-826")
        found.append(range(int(first), int(last) + 1))
    return found


@tape.command()
@_file
@option(
    "--from first", "First frame to keep.", click.IntRange(0), metavar="FRAME", default=0, show_default=False
)
@option("--to last", "Last frame to keep.", click.IntRange(0), metavar="FRAME")
@option("--without", "Leave out frames: 1001,821-826.", metavar="FRAMES", default="", callback=_ranges)
@flag("--reverse", "Turn it back to front: the last frame first.")
@flag("--mirror", "Turn it over: channel 8 becomes channel 1.")
@_mend
@_output
def cut(
    *,
    file: str,
    first: int,
    last: int | None,
    without: list[range],
    reverse: bool,
    mirror: bool,
    mend: dict[int, int],
    output: str,
) -> None:
    """Cut a piece out of a tape, leave out or mend frames, turn it.

    Frames are numbered as they are on FILE.

    \b
    Examples:
      pdp8 tape cut spliced.eia --without 821-826 -o whole.eia
      pdp8 tape cut titled.eia --from 44 -o program.eia
      pdp8 tape cut wrong.eia --reverse -o right.eia
    """
    _check_order(first, last)
    content = _mended(_read(file), mend)
    with naming(file):
        _check(first, len(content))
    _say_short(file, last, content)
    kept = range(first, len(content) if last is None else min(last + 1, len(content)))
    _check_last("--without", max((each[-1] for each in without), default=-1), content)
    piece = bytes(content[at] for at in kept if not any(at in each for each in without))
    piece = redundancy.mirrored(piece) if mirror else piece
    command.put(output, piece[::-1] if reverse else piece)


@tape.command()
@click.argument("file", type=Source(), metavar="[FILE.eia]", default="-")
@_accept
@_mend
@_output
def clean(*, file: str, accept: bool, mend: dict[int, int], output: str) -> None:
    """Keep only the digits and ends of block of an EIA tape, as a second pass through a Flexowriter did.

    The thesis's second conversion program passes line feeds and rubouts on as other codes; its tapes need
    this before the Hydra-Point can read them (Chapter 5).

    \b
    Examples:
      pdp8 run eia2.pal < circle.asc | pdp8 tape clean > circle.eia
    """
    content = _mended(_read(file), mend)
    if not accept:
        with naming(file):
            doubts.check(content.replace(b"\0", b"\x7f"), codes.EIA)
    with naming(file):
        cleaned = eia.clean(content)
    command.put(output, cleaned)


@tape.command()
@_file
@option("--code", "The tape's code.", click.Choice(list(_TYPED)), default="ascii")
@_parity("--code")
@option(
    "--fill",
    "RUBOUTs after each CR LF (ascii).",
    click.IntRange(0, 1000),
    metavar="FRAMES",
    default=6,
    needs="--code=ascii",
)
@option("--leader", "Blank frames before and after.", click.IntRange(0, 100_000), metavar="FRAMES", default=0)
@option("--title", "Punch a title for the eye before it.", metavar="TITLE", default="")
@option(
    "--drop-spaces/--keep-spaces",
    "Leave out spaces that only make the text clear.  [default: in a Hydra-Point program]",
    default=None,
)
@_output
def punch(
    *,
    file: str,
    code: str,
    parity: str,
    fill: int,
    leader: int,
    drop_spaces: bool | None,
    title: str,
    output: str,
) -> None:
    """Punch a tape from typed text: each end of line becomes CR LF and fill, or what ends a line in its code.

    A Hydra-Point program may be typed as a book prints it, its 19 digits apart: 001 0 00000 00000 0 35 88.
    Such spaces and blank lines are not punched, and a line without 19 digits is named.

    \b
    Examples:
      pdp8 tape punch typed.txt > typed.asc
      pdp8 tape punch eia.pal --title "EIA.PAL" --leader 50 -o titled.asc
      pdp8 tape punch eia.pal --parity even --leader 100 -o eia.asc  # for PAL III
      echo "001 0 00000 00000 0 35 88" | pdp8 tape punch --code eia -o drill.eia
    """
    content = shelf.read(file)
    with naming(file):
        text = conversion.typed(content)
        if drop_spaces is None:
            text = hydrapoint.typed(text) or text
        punched = _TYPED[code].encode(text.replace(" ", "") if drop_spaces else text, parity, fill)
    letters = eye.punch(title) if title else b""
    command.put(output, bytes(leader) + letters + punched + bytes(leader))


def _order(_context: click.Context, _option: click.Parameter, value: str) -> tuple[int, ...]:
    try:
        order = tuple(int(number) for number in value.split(",") if value)
    except ValueError:
        order = (0,)
    if 0 in order:
        raise click.BadParameter(f"{value!r} is not numbers of strips separated by commas, such as 2,-1,3")
    return order


@tape.command()
@click.argument("photos", type=Source(), nargs=-1, required=True)
@flag("--underside", "The tape was photographed from below.")
@option(
    "--strips",
    "Read these strips in this order, such as 3,1,2; -2 is strip 2 photographed from the other side.",
    metavar="ORDER",
    default="",
    callback=_order,
)
@flag("--stitch", "The photographs show parts of one tape, which overlap.")
@option("--page", "Write a page to look at what was read, and to correct it.", Target("HTML"), metavar="FILE")
@_output
@click.pass_context
def read(
    ctx: click.Context,
    /,
    *,
    photos: tuple[str, ...],
    underside: bool,
    strips: tuple[int, ...],
    stitch: bool,
    page: str | None,
    output: str,
) -> None:
    """Read photographs or scans of a tape into frames, one picture after another.

    A picture shows both edges of the tape, which may lie in any direction, be bent, and be seen from aside.
    Several strips are read from top to bottom, upright ones from left to right; one that cannot be read is
    left out. Standard error names strips and their frames, doubtful frames with their place in the picture,
    and what `pdp8 tape info` says. Where the tape's parity, order or checksum says what a doubtful frame must
    be, that is written, and said. Needs OpenCV, the extra `vision`.

    Exit status: 0 all strips are on the tape, 1 one is left out.

    \b
    Examples:
      pdp8 tape read photo.png > photo.asc
      pdp8 tape read left.jpg right.jpg --page look.html -o found.bin
      pdp8 tape read strips.jpg --strips 2,1,-3 -o found.bin
      pdp8 tape read a.jpg b.jpg c.jpg --stitch -o long.bin
    """
    extras.need("cv2", "vision", "reading a picture needs OpenCV")
    from tapes import photograph
    from tapes.photograph import correction, pixels

    pictures = []
    for photo in photos:
        picture = shelf.read(photo, pixels.LARGEST_FILE)
        with naming(photo), progress.Busy(f"reading {called(photo)}", wanted=True):
            pictures.append(correction.Picture(called(photo), picture, photograph.strips(picture, underside)))
    reading = correction.Reading(pictures, strips, stitch)
    if reading.tape:
        for line in reading.report(underside):
            command.tell(line)
        command.put(output, reading.tape)
    if page is not None:
        command.put(page, correction.page(reading))
    if not reading.tape:
        shows = "" if page else "; --page FILE shows what was seen"
        why = [f"{name}{correction.said_place(strip)}: {strip.why}{shows}" for name, strip in reading.strips]
        raise TapeError("\n".join(why))
    ctx.exit(0 if strips or len(reading.order) == len(reading.strips) else 1)


def _check_order(first: int, last: int | None) -> None:
    if last is not None and last < first:
        raise click.UsageError(f"--to {last} lies before --from {first}")


def _check(first: int, length: int) -> None:
    if length == 0:
        raise TapeError("empty tape", 0)
    if first >= length:
        raise TapeError(f"the tape has only {length}", first)


tape.add_command(extract)
tape.add_command(insert)
