"""The operator's prompt.

prompt    one line in, what it says out
"""

from pdp8.monitor.prompt import Monitor

__all__ = ["Monitor"]
