"""What a class does on the workbench, in Chromium and in Firefox: tapes, files, sound.

Both are asked in the same words: a script of the page, and a condition to wait for.
"""

import base64

from pdp8 import shelf
from pdp8.computer.hardware.devices import one_of_each
from pdp8.computer.machine import Machine
from pdp8.computer.past.state import LARGEST, restore, save
from tapes import binary
from tests.pdp8.web.browsing import Tab
from tests.pdp8.web.follower import state as values

_TTY = "workbench.machine.teletype"
_NEXT = "document.getElementById('next').textContent"


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
        "window.file = null; workbench.download = async (_, content) => {"
        "  window.file = [...new Uint8Array(await new Blob([content]).arrayBuffer())]; };"
    )
    tab.point(button, 0, "mouse")
    tab.until("window.file")
    return bytes(tab.run("return window.file"))


def test_a_file_dropped_on_the_page(tab: Tab) -> None:
    """ASCII goes into the reader, EIA to the mill, a source into the editor, shown; their names are text.

    A file that is neither is refused by its name; dropped on the reader, or put there, it is a tape.
    """
    drop(tab, "<b>mine.asc", b"\xb1\xb2\xb3\x8d\x8a")
    tab.until(f"{_TTY}.reader.tape.length === 5")
    tab.until("document.getElementById('reader').getBoundingClientRect().bottom <= innerHeight")
    assert "<b>mine.asc" in tab.run("return document.querySelector('#reader .name').textContent")
    assert tab.run("return document.querySelectorAll('#reader .name b').length") == 0
    drop(tab, "mine.eia", shelf.read_bundled("circle.eia"))
    tab.until("workbench.mill.name === 'mine.eia'")
    drop(tab, "mine.p8", b"\xef\xbb\xbf*200\r\n\tHLT\r\n$\r\n")
    tab.until("workbench.editor.name === 'mine.p8'")
    assert tab.run("return workbench.editor.text") == "*200\n\tHLT\n$\n"
    assert tab.run("return document.querySelector('#program').hidden") is False
    picture = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR" + bytes(range(255, 100, -1))
    for name, content, said in (
        ("photo.png", picture, "photo.png is no tape"),
        ("photo.pal", picture, "photo.pal is no tape"),
        ("power.pal", "*200\n$\n".encode("utf-16"), "power.pal: UTF-16"),
    ):
        drop(tab, name, content)
        tab.until(f"{_NEXT}.includes('{said}')")
    tab.run(f"workbench.take(new File([new Uint8Array({LARGEST + 1})], 'long.tape'))")
    tab.until(f"{_NEXT}.includes('long.tape: longer than')")
    drop(tab, "other.pal", b"*200\n$\n")
    tab.until("workbench.editor.name === 'other.pal'")
    assert "longer than" not in tab.run(f"return {_NEXT}")
    assert tab.run(f"return {_TTY}.reader.tape.length") == 5
    drop(tab, "dump.txt", b"0200: 7300 7402\n")
    tab.until(f"{_NEXT}.includes('dump.txt: read as octal addresses and words')")
    assert bytes(tab.run(f"return [...{_TTY}.reader.tape]")) == binary.encode({0o200: 0o7300, 0o201: 0o7402})
    tape = binary.encode({0o200: 0o1252, 0o201: 0o6260, 0o202: 0o6040})  # "*200 " is in it, as an origin
    drop(tab, "own.bin", tape)
    tab.until(f"{_TTY}.reader.tape.length === {len(tape)}")
    drop(tab, "photo.png", picture, "#reader")
    tab.until(f"{_TTY}.reader.tape.length === {len(picture)}")
    chosen = "workbench.taken({ name: this.name, files: [new File(['*200'], 'a.pal')] })"
    tab.run(f"document.getElementById('file').click = function () {{ {chosen}; }};")
    tab.point("#put-file", 0, "mouse")
    tab.until(f"{_TTY}.reader.tape.length === 4")


def test_states_and_tapes_go_in_and_out(tab: Tab) -> None:
    """What `pdp8 run --save` wrote in the middle of a character is dropped in, and saved as it was.

    A punched tape is saved; torn off, it goes from the shelf into the reader, and the punch is empty.
    """
    machine = Machine(one_of_each())
    machine.load({0o200: 0o6032, 0o201: 0o6031, 0o202: 0o5201})
    machine.teletype.reader.load(b"\xc1\xc2\xc3")
    machine.start(0o200)
    machine.run(seconds=0.15)
    machine.stop()
    tab.run("workbench.clock.wake = () => {};")  # the Teletype goes on although the processor stands still
    drop(tab, "noon.state", save(machine).encode())
    tab.until(f"{_TTY}.reader.tape.length === 3")
    assert values(restore(saved(tab, "#save").decode())) == values(machine)
    tab.run(f"{_TTY}.punch.frames.extend([0o301, 0o302, 0o215]); workbench.touched();")
    assert saved(tab, "#store") == b"\xc1\xc2\x8d"
    tab.point("#tear", 0, "mouse")
    tab.run("workbench.teletype.mount('punched')")
    found = tab.run(f"return [{_TTY}.punch.frames, {_TTY}.reader.tape].map((each) => [...each])")
    assert found == [[], [0o301, 0o302, 0o215]]


def test_sound_is_made_on_request_only(tab: Tab) -> None:
    """While hello.pal prints, no AudioContext is asked for until the box is ticked."""
    tab.run(
        "window.contexts = 0; const Real = AudioContext;"
        "window.AudioContext = class extends Real { constructor() { super(); window.contexts++; } };"
    )
    tab.run("workbench.enter();")
    tab.point("#write", 0, "mouse")
    tab.until(f"{_TTY}.printer.frames.length > 3")
    assert tab.run("return window.contexts") == 0
    tab.point("#sound", 0, "mouse")
    assert tab.run("return window.contexts") == 1
