"""The monitor's prompt: sessions word for word, and what no session shows."""

from pdp8.monitor import commands
from pdp8.monitor.prompt import Monitor


def do(monitor: Monitor, *lines: str) -> None:
    for line in lines:
        commands.do(monitor, line)
