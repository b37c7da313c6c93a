"""The workbench in Firefox, opened from disk, driven by Marionette, the protocol that Firefox speaks."""

import json
import shutil
import socket
import subprocess
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from pdp8.web.workbench import page as workbench
from tapes import shelf

FIREFOX = shutil.which("firefox-esr") or shutil.which("firefox")
_START_SECONDS = 60

pytestmark = pytest.mark.skipif(FIREFOX is None, reason="Firefox is not installed")


class Firefox:
    """A headless Firefox; `call` sends one command of the WebDriver protocol over Marionette's socket."""

    def __init__(self, port: int) -> None:
        self._number = 0
        self._socket = self._connected(port)
        self._read()  # it says hello

    @staticmethod
    def _connected(port: int) -> socket.socket:
        """Return a socket to Marionette, as soon as it listens."""
        end = time.monotonic() + _START_SECONDS
        while True:
            try:
                return socket.create_connection(("127.0.0.1", port), timeout=60)
            except OSError:
                if time.monotonic() > end:
                    raise
                time.sleep(0.25)

    def call(self, name: str, **parameters: Any) -> Any:
        """Return what the command answers."""
        self._number += 1
        message = json.dumps([0, self._number, name, parameters])
        self._socket.sendall(f"{len(message)}:{message}".encode())
        _, _, error, result = self._read()
        assert error is None, error
        return result

    def run(self, script: str) -> Any:
        """Return what a script in the page returns."""
        answer = self.call("WebDriver:ExecuteScript", script=script, args=[], sandbox=None, newSandbox=False)
        return answer["value"]

    def until(self, condition: str) -> None:
        """Wait until it holds."""
        for _ in range(600):
            if self.run(f"return {condition}"):
                return
            time.sleep(0.1)
        raise AssertionError(condition)

    def close(self) -> None:
        """Hang up."""
        self._socket.close()

    def _read(self) -> Any:
        length = b""
        while not length.endswith(b":"):
            length += self._socket.recv(1)
        text = b""
        while len(text) < int(length[:-1]):
            text += self._socket.recv(int(length[:-1]) - len(text))
        return json.loads(text)


@pytest.fixture
def firefox(tmp_path: Path) -> Iterator[Firefox]:
    """A Firefox of its own profile, at the workbench."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    (tmp_path / "user.js").write_text(f'user_pref("marionette.port", {port});\n')
    file = tmp_path / "pdp8.html"
    file.write_text(workbench(), encoding="utf-8")
    command = [str(FIREFOX), "--headless", "--marionette", "--no-remote", "--profile", str(tmp_path)]
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
        try:
            driver = Firefox(port)
            driver.call("WebDriver:NewSession")
            driver.call("WebDriver:Navigate", url=file.as_uri())
            yield driver
            driver.close()
        finally:
            process.terminate()


def test_the_circle_is_translated_in_firefox(firefox: Firefox) -> None:
    """Assembled, loaded and started by its buttons; the tape is circle.eia, and the mill cuts it."""
    firefox.run(
        """const choose = (id, value) => {
          document.getElementById(id).value = value;
          document.getElementById(id).dispatchEvent(new Event("change"));
        };
        const click = (selector) => document.querySelector(selector).click();
        choose("sources", "eia.pal");
        click("#assemble");
        click("#load");
        choose("shelf", "circle.asc");
        document.getElementById("speed").selectedIndex = 3;
        document.getElementById("speed").dispatchEvent(new Event("change"));
        click("[data-key=start]");"""
    )
    firefox.until("window.workbench.machine.outOfTape()")
    time.sleep(0.3)
    punched = firefox.run("return window.workbench.machine.teletype.punch.frames")
    assert bytes(punched) == shelf.read_bundled("circle.eia")
    firefox.run("document.getElementById('to-mill').click()")
    label = firefox.run("return document.getElementById('close-label').textContent")
    assert "circle of 1.750 in about 4.000, 4.000" in label
