"""A picture of a sheet as if it lay flat: rows of holes from left to right, tracks from top to bottom."""

from typing import NamedTuple

import cv2
import numpy as np

from tapes.photograph.pixels import Array, between
from tapes.photograph.sheet import BEYOND, Sheet
from tapes.photograph.sprockets import Sizes

SAMPLES = 12
"""Of a pitch."""
REACH = 12
"""Pitches to each side of a row of holes, which may be any track of a tape, that are flattened."""


class Flat(NamedTuple):
    """A picture of a sheet as if it lay flat: SAMPLES a pitch, from row -BEYOND and from track -REACH on.

    `light` as it is; `dark`, how much darker than the paper around, as a part of its light; `spots`, how much
    darker than what is around within a pitch.
    """

    light: Array
    dark: Array
    spots: Array

    def at(self, u: Array, v: Array) -> tuple[Array, Array]:
        """Return the columns and lines of places on the tape."""
        return (u + BEYOND) * SAMPLES, (v + REACH) * SAMPLES

    def take(self, picture: Array, u: Array | float, v: Array | float) -> Array:
        """Return what a picture of this shape has at places on the tape: arrays broadcast together."""
        return between(picture, *self.at(*np.broadcast_arrays(u, v)))


def flatten(pictures: Sizes, sheet: Sheet) -> Flat:
    """Return the sheet as if it lay flat."""
    u = np.arange(-BEYOND * SAMPLES, (sheet.length - 1 + BEYOND) * SAMPLES + 1) / SAMPLES
    v = np.arange(-REACH * SAMPLES, REACH * SAMPLES + 1) / SAMPLES
    size = pictures.for_step(float(np.median(sheet.pitches())))
    places = (sheet.place(u[None, :], v[:, None]) + 0.5) * size.scale - 0.5
    light = between(size.light, places[..., 0], places[..., 1])
    smooth = _blurred(light, 0.1)
    paper = _blurred(cv2.dilate(smooth, np.ones((SAMPLES + 1, SAMPLES + 1))), 0.5)
    dark = 1 - smooth / (paper + 2)
    return Flat(light, dark, _blurred(dark, 0.07) - _blurred(dark, 0.3))


def _blurred(picture: Array, pitches: float) -> Array:
    return cv2.GaussianBlur(picture, (0, 0), pitches * SAMPLES)
