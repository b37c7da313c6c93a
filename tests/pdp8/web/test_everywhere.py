"""What a class does on the workbench, in Chromium and in Firefox: tapes, files, sound, messages.

Both are asked in the same words: a script of the page, and a condition to wait for.
"""

import base64
import re
from pathlib import Path

from pdp8.computer.machine import Machine
from pdp8.computer.past import state
from pdp8.computer.past.state import LARGEST
from tapes import shelf
from tests.commands import run
from tests.pdp8.web.browsing import Tab

_TTY = "workbench.machine.teletype"
_NEXT = "document.getElementById('next').textContent"


def click(tab: Tab, *selectors: str) -> None:
    """Click the elements, one after the other."""
    for selector in selectors:
        tab.run(f'document.querySelector("{selector}").click()')


def choose(tab: Tab, selector: str, value: str) -> None:
    """Choose from a list."""
    tab.run(
        f'const field = document.querySelector("{selector}"); field.value = "{value}";'
        'field.dispatchEvent(new Event("change", { bubbles: true }));'
    )


def start(tab: Tab, source: str) -> None:
    """Assemble a bundled source, load it and start it, as fast as it goes."""
    choose(tab, "#sources", source)
    choose(tab, "#speed", "Infinity")
    click(tab, "#assemble", "#load", "[data-key=start]")


def drop(tab: Tab, name: str, content: bytes, place: str = "body") -> None:
    """Drop a file on the page, or on a place of it."""
    text = base64.b64encode(content).decode()
    tab.run(
        f"const bytes = Uint8Array.from(atob('{text}'), (character) => character.charCodeAt(0));"
        f"const data = new DataTransfer(); data.items.add(new File([bytes], '{name}'));"
        "const options = { dataTransfer: data, bubbles: true, cancelable: true };"
        f"document.querySelector('{place}').dispatchEvent(new DragEvent('drop', options));"
    )


def saved(tab: Tab, button: str) -> bytes:
    """Click a button that saves a file, and return what is in the file."""
    tab.run(
        "const make = URL.createObjectURL; window.file = null;"
        "URL.createObjectURL = (blob) => {"
        "  blob.arrayBuffer().then((bytes) => { window.file = [...new Uint8Array(bytes)]; });"
        "  return make.call(URL, blob); };"
        f"document.querySelector('{button}').click();"
        "URL.createObjectURL = make;"  # the page makes the script of its Worker a URL too
    )
    tab.until("window.file")
    return bytes(tab.run("return window.file"))


def test_the_circle_is_translated_and_cut(tab: Tab) -> None:
    """Assembled, loaded and started by its buttons; the tape is circle.eia, and the mill cuts it."""
    choose(tab, "#shelf", "circle.asc")
    start(tab, "eia.pal")
    tab.until("workbench.machine._out_of_tape()")
    circle = shelf.read_bundled("circle.eia")
    tab.until(f"{_TTY}.punch.frames.length === {len(circle)}")
    assert bytes(tab.run(f"return {_TTY}.punch.frames")) == circle
    click(tab, "#to-mill")
    label = tab.run("return document.getElementById('close-label').textContent")
    assert "circle of 1.750 in about 4.000, 4.000" in label
    assert tab.run("return document.querySelectorAll('#blocks li').length") == 666


def test_a_punched_tape_is_saved_torn_off_and_read(tab: Tab) -> None:
    """The file has its frames; torn off, it goes from the shelf into the reader, and the punch is empty."""
    tab.run(f"{_TTY}.punch.frames.extend([0o301, 0o302, 0o215]); workbench.touched();")
    assert saved(tab, "#store") == b"\xc1\xc2\x8d"
    click(tab, "#tear")
    choose(tab, "#shelf", "punched")
    found = tab.run(f"return [{_TTY}.punch.frames, {_TTY}.reader.tape].map((each) => [...each])")
    assert found == [[], [0o301, 0o302, 0o215]]


def test_a_file_dropped_on_the_page(tab: Tab) -> None:
    """ASCII goes into the reader, EIA to the mill, a source into the editor, shown; their names are text."""
    drop(tab, "<b>mine.asc", b"\xb1\xb2\xb3\x8d\x8a")
    tab.until(f"{_TTY}.reader.tape.length === 5")
    assert "<b>mine.asc" in tab.run("return document.querySelector('#reader .name').textContent")
    assert tab.run("return document.querySelectorAll('#reader .name b').length") == 0
    drop(tab, "mine.eia", shelf.read_bundled("circle.eia"))
    tab.until("workbench.mill.name === 'mine.eia'")
    drop(tab, "mine.pal", b"\xef\xbb\xbf*200\r\n\tHLT\r\n$\r\n")
    tab.until("workbench.editor.name === 'mine.pal'")
    assert tab.run("return workbench.editor.text") == "*200\n\tHLT\n$\n"
    assert tab.run("return document.querySelector('#program').hidden") is False


def test_a_file_that_is_nothing_of_ours(tab: Tab) -> None:
    """Refused by its name, not cut, it goes nowhere; dropped on the reader itself it is a tape."""
    picture = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR" + bytes(range(255, 100, -1))
    for name, content, said in (
        ("photo.png", picture, "photo.png is no tape"),
        ("photo.pal", picture, "photo.pal is no tape"),
        ("power.pal", "*200\n$\n".encode("utf-16"), "power.pal: UTF-16"),
        ("power.asc", "1750\n".encode("utf-16"), "power.asc: UTF-16"),
    ):
        drop(tab, name, content)
        tab.until(f"{_NEXT}.includes('{said}')")
    tab.run(f"workbench.take(new File([new Uint8Array({LARGEST + 1})], 'long.tape'))")
    tab.until(f"{_NEXT}.includes('long.tape: longer than')")
    drop(tab, "mine.pal", b"*200\n$\n")
    tab.until("workbench.editor.name === 'mine.pal'")
    assert "UTF-16" not in tab.run(f"return {_NEXT}")
    assert tab.run(f"return {_TTY}.reader.loaded") is False
    drop(tab, "photo.png", picture, "#reader")
    tab.until(f"{_TTY}.reader.tape.length === {len(picture)}")


def test_what_was_typed_last_is_kept_as_the_page_is_left(tab: Tab) -> None:
    tab.run("workbench.editor.text = '/ AS IT WAS LEFT'; dispatchEvent(new Event('pagehide'));")
    found = "const { editor, programs } = workbench; return new programs.constructor().get(editor.name);"
    assert tab.run(found) == "/ AS IT WAS LEFT"


def test_a_state_goes_in_and_out(tab: Tab, tmp_path: Path) -> None:
    """A state of `pdp8 run --save` dropped in; saved out again, `pdp8 run --restore` goes on from it."""
    machine = Machine(highspeed=True)
    echo = [0o6032, 0o6046, 0o6031, 0o5202, 0o6036, 0o6041, 0o5205, 0o6046, 0o5202]
    machine.load(enumerate(echo, 0o200))
    machine.teletype.reader.load(b"\xc1\xc2\xc3")
    machine.start(0o200)
    machine.run(seconds=0.15)
    machine.stop()
    tab.run("workbench.clock.wake = () => {};")  # the Teletype goes on although the processor stands still
    drop(tab, "noon.state", state.save(machine).encode())
    tab.until(f"{_TTY}.reader.tape.length === 3")
    assert tab.run("return workbench.machine.processor.clock") == machine.processor.clock
    file = tmp_path / "page.state"
    file.write_bytes(saved(tab, "#save"))
    done = run("pdp8", "run", "--restore", file)
    assert (done.returncode, done.stdout) == (0, b"\xc1\xc2\xc3"), done.stderr


def test_sound_is_made_on_request_only(tab: Tab) -> None:
    """While hello.pal prints, no AudioContext is asked for until the box is ticked."""
    tab.run(
        "window.contexts = 0; const Real = AudioContext;"
        "window.AudioContext = class extends Real { constructor() { super(); window.contexts++; } };"
    )
    start(tab, "hello.pal")
    tab.until(f"{_TTY}.printer.frames.length > 3")
    assert tab.run("return window.contexts") == 0
    click(tab, "#sound")
    assert tab.run("return window.contexts") == 1


def test_what_the_assembler_says_is_what_pal_prints(tab: Tab, tmp_path: Path) -> None:
    """Place, message, line, carets, advice and hint, in the words of the command; notes among the errors."""
    shown = (
        "[...document.querySelectorAll('#messages li > *, #messages ol + p')].map((each) => each.textContent)"
    )
    for name, source in (
        ("error.pal", "*200\n\tJMP 400\n\tCLA!\n\tTAD FOO\n\t5 + 3\n$\n"),
        ("note.pal", "*200\n\tTAD A + 1\nA,\t5\n"),
        ("many.pal", "*200\n" + "\t5 + 3\n" * 1200 + "$\n"),
    ):
        (tmp_path / name).write_text(source)
        done = run("pal", name, folder=tmp_path)
        drop(tab, name, source.encode())
        tab.until(f"workbench.editor.name === '{name}'")
        click(tab, "#assemble")
        printed = re.split("\n(?:pal:|wrote) ", done.stderr.decode())[0].rstrip("\n")
        assert "\n".join(tab.run(f"return {shown}")) == printed
