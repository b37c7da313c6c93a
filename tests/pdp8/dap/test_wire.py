"""What is no message, and requests that no editor should send: an answer each, and no traceback."""

import json
from pathlib import Path
from typing import Any

import pytest

from tests.commands import run


def framed(*requests: Any) -> bytes:
    """Return messages as they go over the wire."""
    contents = [json.dumps(request).encode() for request in requests]
    return b"".join(b"Content-Length: %d\r\n\r\n%b" % (len(content), content) for content in contents)


@pytest.mark.parametrize(
    ("sent", "said"),
    [
        (b"junk\r\n\r\n", "has no Content-Length"),
        (b"Content-Length: 5\r\n\r\n{}", "ends after 2 of the 5 bytes"),
        (b"Content-Length: 5\r\n", "ends within the head"),
        (b"Content-Length: 1\r\n\r\n{", "not JSON"),
        (b"Content-Length: 2\r\n\r\n[]", "not a JSON object"),
    ],
)
def test_what_is_no_message_ends_the_session(sent: bytes, said: str) -> None:
    done = run("pdp8", "dap", stdin=sent)
    assert (done.returncode, done.stdout) == (1, b"")
    assert done.stderr.decode().startswith("pdp8 dap: ")
    assert said in done.stderr.decode()


def test_every_request_is_answered(tmp_path: Path) -> None:
    (tmp_path / "far.pal").write_text("*200\n\tJMP 400\n$\n")
    (tmp_path / "halt.pal").write_text("*200\nSTART,\tHLT\n$\n")
    asked = [
        ("next", {}, "launch comes first"),
        ("launch", {}, "the name of a PAL source or of a tape"),
        ("launch", {"program": "-"}, "standard input and output"),
        ("launch", {"program": "far.pal"}, "far.pal:2:2: error: IR"),
        ("launch", {"program": "halt.pal", "reader": 3}, "a text or a list of texts expected, not 3"),
        ("launch", {"program": "halt.pal", "start": "NIX"}, "NIX: neither an octal number nor a symbol"),
        ("launch", {"program": "halt.pal"}, ""),
        ("fly", {}, "no such request"),
        ("stepOut", {}, "no way out"),
        ("stepBack", {}, "nothing to undo"),
        ("setBreakpoints", [], "arguments that the protocol does not have"),
        ("readMemory", {"memoryReference": "core", "count": 1}, "a number such as 0x0100"),
        ("setVariable", {"variablesReference": 104, "name": "flag", "value": "7"}, "flag is 0 to 1"),
        ("variables", {"variablesReference": 99}, "no scope"),
        ("disconnect", {}, ""),
    ]
    requests = [{"type": "request", "command": name, "arguments": given} for name, given, _ in asked]
    done = run("pdp8", "dap", stdin=framed({}, *requests), folder=tmp_path)
    assert done.stderr == b""
    answers = [json.loads(part[part.index(b"{") :]) for part in done.stdout.split(b"Content-Length: ")[1:]]
    said = [answer.get("message", "") for answer in answers if answer["type"] == "response"][1:]
    assert len(said) == len(asked)
    for (name, _, expected), message in zip(asked, said, strict=True):
        assert (expected in message) if expected else message == "", f"{name}: {message}"
