"""A picture of a sheet as if it lay flat: rows of holes from left to right, tracks from top to bottom."""

from typing import NamedTuple

import cv2
import numpy as np

from tapes.photograph.pixels import Array, between
from tapes.photograph.sheet import Sheet
from tapes.photograph.sprockets import Sizes

SAMPLES = 12
"""Samples in a pitch."""

_REACH = 8
"""Pitches from the sprocket track to each side that are flattened."""
BEYOND = 3.5
"""Rows before the first and after the last that are flattened."""


class Flat(NamedTuple):
    """A sheet as if flat, SAMPLES a pitch, from row -BEYOND, track -`reach`; `dark` relative to the paper."""

    light: Array
    dark: Array
    reach: float

    def at(self, u: Array, v: Array) -> tuple[Array, Array]:
        """Return the columns and lines of places on the tape."""
        return (u + BEYOND) * SAMPLES, (v + self.reach) * SAMPLES

    def take(self, picture: Array, u: Array, v: Array) -> Array:
        """Return what a picture of this shape has at places on the tape, between its samples."""
        x, y = (
            axis.clip(0, length - 1.001)
            for axis, length in zip(self.at(u, v), picture.shape[::-1], strict=True)
        )
        column, line = x.astype(int), y.astype(int)
        right, down = x - column, y - line
        above, below = (
            picture[line + row, column] * (1 - right) + picture[line + row, column + 1] * right
            for row in (0, 1)
        )
        return np.asarray(above * (1 - down) + below * down)


def flatten(pictures: Sizes, sheet: Sheet, reach: float = _REACH) -> Flat:
    """Return the sheet as if it lay flat."""
    u = np.arange(-BEYOND * SAMPLES, (sheet.length + BEYOND - 1) * SAMPLES + 1) / SAMPLES
    v = np.arange(-reach * SAMPLES, reach * SAMPLES + 1) / SAMPLES
    area = np.multiply(*sheet.pitches())
    pieces = []
    block = 24 * SAMPLES
    for start in range(0, len(u), block):
        part = u[start : start + block]
        step = np.sqrt(np.interp(part, np.arange(sheet.length), area).mean())
        picture, scale = pictures.for_step(float(step))
        places = sheet.place(part[None, :], v[:, None])
        x, y = ((places[..., axis] + 0.5) * scale - 0.5 for axis in (0, 1))
        pieces.append(between(picture, x, y, cv2.INTER_CUBIC))
    light = np.concatenate(pieces, axis=1)
    return Flat(light, _darkness(light), reach)


def _darkness(light: Array) -> Array:
    smooth = cv2.GaussianBlur(light, (0, 0), 0.1 * SAMPLES)
    size = round(1.25 * SAMPLES)
    kernel = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (size, size))
    paper = cv2.GaussianBlur(cv2.dilate(smooth, kernel), (0, 0), 0.5 * SAMPLES)
    return np.asarray(1 - smooth / (paper + 2))


def find_spots(dark: Array) -> Array:
    """Return how much darker each place is than what is around it, within a pitch."""
    return np.asarray(
        cv2.GaussianBlur(dark, (0, 0), 0.07 * SAMPLES) - cv2.GaussianBlur(dark, (0, 0), 0.3 * SAMPLES)
    )
