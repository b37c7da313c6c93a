"""The thesis against the text of its scan, in ocr/: unchanged, with headings and dirt."""

from pathlib import Path

OCR = Path(__file__).parent / "ocr"


def scanned(name: str) -> str:
    """Return a file of the scan's text, every run of white space as one space."""
    return " ".join((OCR / f"{name}.txt").read_text().split())
