"""A headless Firefox, driven by Marionette, the protocol that Firefox speaks."""

import json
import shutil
import socket
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

FIREFOX = shutil.which("firefox-esr") or shutil.which("firefox")
_KEYS = {  # of the WebDriver protocol
    "Enter": "\ue007", "Space": " ", "Control": "\ue009", "PageDown": "\ue00f", "End": "\ue010",
    "ArrowLeft": "\ue012", "ArrowUp": "\ue013", "ArrowRight": "\ue014", "ArrowDown": "\ue015",
}  # fmt: skip


class Firefox:
    """A headless Firefox; `call` sends one command of the WebDriver protocol over Marionette's socket."""

    def __init__(self, connection: socket.socket) -> None:
        self._number = 0
        self._socket = connection
        self._answers = connection.makefile("rb")
        self._read()  # it says hello

    def call(self, name: str, **parameters: Any) -> Any:
        """Return what the command answers."""
        self._number += 1
        message = json.dumps([0, self._number, name, parameters])
        self._socket.sendall(f"{len(message)}:{message}".encode())
        _, _, error, result = self._read()
        assert error is None, error
        return result

    def _read(self) -> Any:
        length = b"".join(iter(lambda: self._answers.read(1), b":"))
        return json.loads(self._answers.read(int(length)))

    def run(self, script: str) -> Any:
        """Return what a script in the page returns."""
        answer = self.call("WebDriver:ExecuteScript", script=script, args=[], sandbox=None, newSandbox=False)
        return answer["value"]

    def until(self, condition: str) -> None:
        """Wait until it holds."""
        for _ in range(600):
            if self.run(f"return Boolean({condition})"):
                return
            time.sleep(0.1)
        raise AssertionError(condition)

    def press(self, keys: str) -> None:
        """Press a key, "a" or "ArrowDown", or some at once, "Control+a"."""
        codes = [_KEYS.get(key, key) for key in keys.split("+")]
        down = [{"type": "keyDown", "value": code} for code in codes]
        up = [{"type": "keyUp", "value": code} for code in reversed(codes)]
        self._act(type="key", id="keyboard", actions=[*down, *up])

    def point(self, selector: str, which: int, pointer: str) -> None:
        """Click or tap one of the elements that a selector finds; the pointer is "mouse" or "touch"."""
        element = self.call("WebDriver:FindElements", using="css selector", value=selector)[which]
        found = f"document.querySelectorAll({json.dumps(selector)})[{which}]"
        self.run(f"{found}.scrollIntoView({{ block: 'center' }})")
        to = {"type": "pointerMove", "x": 0, "y": 0, "origin": element}
        down, up = ({"type": kind, "button": 0} for kind in ("pointerDown", "pointerUp"))
        kind = {"pointerType": pointer}
        self._act(type="pointer", id=pointer, parameters=kind, actions=[to, down, up])

    def _act(self, **actions: Any) -> None:
        self.call("WebDriver:PerformActions", actions=[actions])
        self.call("WebDriver:ReleaseActions")


def _connected(port: int) -> socket.socket:
    """Return a socket to Marionette, as soon as it listens."""
    for _ in range(240):
        with suppress(OSError):
            return socket.create_connection(("127.0.0.1", port), timeout=60)
        time.sleep(0.25)
    raise TimeoutError(f"no Firefox at port {port}")


@contextmanager
def opened(folder: Path) -> Iterator[Firefox]:
    """A Firefox with its profile in `folder`."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    (folder / "user.js").write_text(
        f'user_pref("marionette.port", {port});\n'
        'user_pref("browser.download.alwaysOpenPanel", false);\n'  # it would take the keyboard's focus,
        'user_pref("browser.download.panel.shown", true);\n'  # at the first download too
        'user_pref("browser.download.folderList", 2);\n'
        f'user_pref("browser.download.dir", "{folder}");\n'
        'user_pref("remote.prefs.recommended", false);\n'  # they let all files on disk share what is kept
    )
    command = [str(FIREFOX), "--headless", "--marionette", "--no-remote", "--profile", str(folder)]
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
        try:
            with _connected(port) as connection:
                driver = Firefox(connection)
                driver.call("WebDriver:NewSession")
                yield driver
        finally:
            process.terminate()
