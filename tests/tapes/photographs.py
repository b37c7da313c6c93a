"""Pictures of tapes as a camera may see them, drawn from the geometry in ECMA-10: lengths are in pitches."""

from collections.abc import Iterable
from typing import Any

import cv2
import numpy as np

OVERSAMPLED = 4
MARGIN = 4

Picture = np.ndarray[Any, Any]


def photograph(
    frames: Iterable[int],
    *,
    pitch: int = 16,
    angle: float = 0,
    blur: float = 0,
    noise: float = 0,
    torn: int = 0,
    bright: bool = True,
    seed: int = 1,
) -> bytes:
    """Return a PNG of the tape: turned by `angle` degrees; blurred by `blur` pitches, with noise of so many
    of 256 levels; `torn` at so many places of its edges; the paper brighter or darker than what is behind it.
    """
    random = np.random.default_rng(seed)
    tape = list(frames)
    size = pitch * OVERSAMPLED
    paper, behind = (205, 60) if bright else (90, 235)
    height, width = 10 + 2 * MARGIN, len(tape) + 2 * MARGIN
    picture: Picture = np.full((height * size, width * size), behind, np.uint8)

    def cut(x: float, y: float, radius: float) -> None:
        cv2.circle(picture, (round(x * size), round(y * size)), round(radius * size), behind, -1)

    cv2.rectangle(
        picture,
        (MARGIN * size, MARGIN * size),
        ((width - MARGIN) * size, (height - MARGIN) * size),
        paper,
        -1,
    )
    for number, frame in enumerate(tape):
        x = MARGIN + number + 0.5
        cut(x, MARGIN + 3.92, 0.23)
        for channel in range(1, 9):
            if frame >> channel - 1 & 1:
                cut(x, MARGIN + 3.92 + (channel - 4 if channel < 4 else channel - 3), 0.36)
    for _ in range(torn):
        cut(
            random.uniform(MARGIN, width - MARGIN),
            random.choice([MARGIN, height - MARGIN]),
            random.uniform(0.8, 1.6),
        )
    picture = cv2.resize(picture, (width * pitch, height * pitch), interpolation=cv2.INTER_AREA)
    picture = _turned(picture, angle, behind)
    if blur:
        picture = cv2.GaussianBlur(picture, (0, 0), blur * pitch)
    noisy = picture + random.normal(0, noise, picture.shape)
    return bytes(cv2.imencode(".png", np.clip(noisy, 0, 255).astype(np.uint8))[1])


def _turned(picture: Picture, angle: float, behind: int) -> Picture:
    height, width = picture.shape
    turn = cv2.getRotationMatrix2D((width / 2, height / 2), angle, 1)
    across, along = (np.abs(turn[:, :2]) @ (width, height)).astype(int) + 2
    turn[:, 2] += (across / 2 - width / 2, along / 2 - height / 2)
    return np.asarray(cv2.warpAffine(picture, turn, (int(across), int(along)), borderValue=behind))
