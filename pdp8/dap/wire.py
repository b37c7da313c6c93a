r"""Messages of the Debug Adapter Protocol on two streams.

    Content-Length: 119\r\n
    \r\n
    {"seq": 153, "type": "request", "command": "next", "arguments": {"threadId": 3}}

A thread reads them as they come, so that a machine which runs can be told to pause.
"""

import json
from collections.abc import Callable
from queue import Queue
from threading import Thread
from typing import Any, BinaryIO

from tapes.errors import WorkError

Body = dict[str, Any]


class MessageError(WorkError):
    """A message, read to its end, that is not a JSON object."""


_HEAD, _LONGEST = 1 << 12, 1 << 24
"""Bytes of a message's head, and of a message."""


class Wire:
    """Both directions of a connection. `heard` is called with each message as it comes, by another thread."""

    def __init__(self, reader: BinaryIO, writer: BinaryIO, heard: Callable[[Body], object]) -> None:
        self._reader = reader
        self._writer = writer
        self._heard = heard
        self._sent = 0
        self._come: Queue[Body | WorkError | None] = Queue()
        Thread(target=self._listen, daemon=True).start()

    def _listen(self) -> None:
        message: Body | WorkError | None = {}
        while isinstance(message, dict | MessageError):
            try:
                message = read(self._reader)
            except WorkError as error:
                message = error
            except (OSError, ValueError):  # the stream was closed meanwhile
                message = None
            if isinstance(message, dict):
                self._heard(message)
            self._come.put(message)

    @property
    def holds(self) -> bool:
        """Whether a message, or the end, has come and was not received yet."""
        return not self._come.empty()

    def receive(self) -> Body | None:
        """The next message, None at the end. Raises MessageError, or WorkError for a bad stream."""
        message = self._come.get()
        if isinstance(message, WorkError):
            raise message
        return message

    def event(self, name: str, **body: Any) -> None:
        self._send({"type": "event", "event": name, "body": body})

    def respond(self, request: Body, body: Body | None = None, error: str = "") -> None:
        """Send the response to a request: its body, or the error that a user is to see."""
        response = {
            "type": "response",
            "request_seq": request.get("seq", 0),
            "command": request.get("command", ""),
            "success": not error,
        }
        if error:
            shown = {"id": 1, "format": "{text}", "variables": {"text": error}, "showUser": True}
            response |= {"message": error, "body": {"error": shown}}
        elif body is not None:
            response["body"] = body
        self._send(response)

    def _send(self, message: Body) -> None:
        self._sent += 1
        content = json.dumps({"seq": self._sent, **message}).encode()
        self._writer.write(b"Content-Length: %d\r\n\r\n%b" % (len(content), content))
        self._writer.flush()


def read(stream: BinaryIO) -> Body | None:
    """Return the next message of a stream, None at its end. Raises as `Wire.receive` does."""
    length, left = None, _HEAD
    line = stream.readline(left)
    if not line:
        return None
    while line not in (b"\r\n", b"\n"):
        name, _, value = line.partition(b":")
        if name.strip().lower() == b"content-length" and value.strip().isdigit():
            length = int(value)
        left -= len(line)
        line = stream.readline(left)
        if not line:
            raise WorkError(
                f"the input ends within the head of a message, or it is longer than {_HEAD:,} bytes"
            )
    if length is None or length > _LONGEST:
        raise WorkError(f"the head of a message has no Content-Length of at most {_LONGEST:,} bytes")
    content = stream.read(length)
    if len(content) < length:
        raise WorkError(f"the input ends after {len(content):,} of the {length:,} bytes of a message")
    try:
        message = json.loads(content)
    except (ValueError, RecursionError) as error:
        raise MessageError(f"a message is not JSON: {error}") from error
    if not isinstance(message, dict):
        raise MessageError("a message is not a JSON object")
    return message
