"""Pictures: those that were looked at by eye, each held by its digest; and what CairoSVG makes of one."""

import re
from hashlib import sha256
from io import BytesIO
from pathlib import Path

import pytest
from PIL import Image

FOLDER = Path(__file__).parent.parent / "build" / "pictures"


def assert_looked_at(name: str, svg: str, digest: str) -> None:
    """Fail unless `svg`, the picture called `name`, is the one whose `digest` was noted when it was seen."""
    now = sha256(svg.encode()).hexdigest()[: len(digest)]
    if now != digest:
        FOLDER.mkdir(parents=True, exist_ok=True)
        file = FOLDER / f"{re.sub(r'[^a-z0-9.]+', '-', name)}.svg"
        file.write_text(svg)
        said = f"{name} is not the picture that was last looked at: open {file}; if it is right, note {now}"
        pytest.fail(said, pytrace=False)


def pixels(svg: str, width: int | None = None) -> Image.Image:
    """Return what CairoSVG makes of a drawing, grey, on white paper; skip without its library."""
    try:
        from cairosvg import svg2png  # type: ignore[import-untyped]
    except OSError:
        pytest.skip("CairoSVG's library, libcairo2, is not installed")
    png = svg2png(bytestring=svg.encode(), output_width=width, background_color="white")
    return Image.open(BytesIO(png)).convert("L")
