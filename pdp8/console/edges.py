"""What is written on the edges of a frame: plain words, a file may be called anything, when they change."""

from rich.text import Text
from textual.content import Content
from textual.widget import Widget


def write_above(widget: Widget, words: str) -> None:
    """Write on the upper edge of the widget's frame."""
    if widget.border_title != Content(words).markup:
        widget.border_title = Text(words)


def write_below(widget: Widget, words: str) -> None:
    """Write on the lower edge of the widget's frame."""
    if widget.border_subtitle != Content(words).markup:
        widget.border_subtitle = Text(words)
