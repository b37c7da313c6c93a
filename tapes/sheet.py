"""Where each place of a tape lies in a picture: a row of holes becomes a sheet of paper, or is refused.

    place(u, v)    u counts rows of holes from the first, v pitches across from the sprocket track

    (a(u) + v b(u) / (1 + v w(u)))      a, b, w: splines along the tape

Each row of holes is a straight line, seen in perspective; from row to row everything may change slowly. So
the sheet fits paper that lies flat or bends along its length, before any lens.

Fitted are the middles of all holes that are near their places, and the edges of the paper, which are 3.92
pitches from the sprocket track on the side of three channels and 6.08 on that of five. What is not so is no
tape: the row was another track, or a row of something else.

Source: ECMA-10 (places and sizes). Needs OpenCV, the extra `vision`.
"""

from typing import Any, NamedTuple

import cv2
import numpy as np

from tapes.errors import TapeError
from tapes.sprockets import FEWEST, Row, Sizes, follow, measured

Array = np.ndarray[Any, Any]

THREE, FIVE = 3.92, 6.08
"""Pitches from the sprocket track to the edges beside three and five channels."""

SAMPLES = 12
"""Of a pitch, in a flattened picture."""

_REACH = 8
"""Pitches from the row to each side that are flattened."""
_WINDOW = 8
_KNOTS, _STIFF_KNOTS = 6, 10
_SKEW_STEP, _WIDTH_STEP = 0.05, 0.045
_SKEWS = _SKEW_STEP * np.arange(-12, 13)
_WIDTHS = np.exp(_WIDTH_STEP * np.arange(-11, 13))
_EVERY, _STIFFNESS = 4, 0.03
_ASTRAY = 0.3
_FULL = 12
_BEYOND = 3.5
_LONGER = 12
_FAINT = 0.02
"""What places count that only hold the sheet where there are no holes."""


class Spline(NamedTuple):
    """Cubic B-splines along a tape of `length` rows, one some `knots` rows."""

    length: int
    pieces: int

    def at(self, rows: Array) -> Array:
        """Return the weight of each spline (n, pieces + 3) at each row (n,)."""
        x = rows / max(self.length - 1, 1) * self.pieces
        piece = np.clip(np.floor(x), 0, self.pieces - 1).astype(int)
        t = x - piece
        weights = np.stack(
            [(1 - t) ** 3, 3 * t**3 - 6 * t**2 + 4, -3 * t**3 + 3 * t**2 + 3 * t + 1, t**3], axis=1
        )
        found = np.zeros((len(rows), self.pieces + 3))
        for number in range(4):
            found[np.arange(len(rows)), piece + number] = weights[:, number] / 6
        return found

    def bends(self) -> Array:
        """Return the matrix of the second differences of its coefficients."""
        return np.diff(np.eye(self.pieces + 3), 2, axis=0)


class Sheet(NamedTuple):
    """A sheet: the splines' coefficients, and the pitch in pixels that they were fitted by."""

    soft: Spline
    stiff: Spline
    middle: Array
    across: Array
    narrowing: Array

    def place(self, u: Array, v: Array) -> Array:
        """Return the pixels (..., 2) of places on the tape: arrays that are broadcast together."""
        rows = u.ravel()
        soft, stiff = self.soft.at(rows), self.stiff.at(rows)
        a, b = (
            (weights @ place).reshape(*u.shape, 2)
            for weights, place in ((soft, self.middle), (stiff, self.across))
        )
        w = (stiff @ self.narrowing).reshape(u.shape)
        return np.asarray(a + b * (v / (1 + v * w))[..., None])

    def covers(self, places: Array) -> bool:
        """Tell whether it lies beneath or close beside some of the places (n, 2), in pixels."""
        u = np.linspace(-1, self.length, 4 * self.length)
        sides = [self.place(along, np.array([aside])) for along, aside in ((u, -5.5), (u[::-1], 7.5))]
        outline = np.concatenate(sides).astype(np.float32)
        inside = [cv2.pointPolygonTest(outline, (float(x), float(y)), False) >= 0 for x, y in places]
        return sum(inside) > 0.2 * len(inside)

    @property
    def length(self) -> int:
        """How many rows it has."""
        return self.soft.length

    def pitches(self) -> tuple[Array, Array]:
        """Return the pixels from row to row and from track to track, for each row the least of both sides."""
        u = np.arange(self.length, dtype=float)
        sides = [np.array([side]) for side in (-THREE, 0, THREE)]
        along = [np.hypot(*(self.place(u + 0.5, side) - self.place(u - 0.5, side)).T) for side in sides]
        across = [np.hypot(*(self.place(u, side + 0.5) - self.place(u, side - 0.5)).T) for side in sides]
        return np.min(along, axis=0), np.min(across, axis=0)


class Points(NamedTuple):
    """Places that were seen: row and track of each, pixels, the direction (a unit vector) along which its
    distance from the sheet counts, and how much it counts.
    """

    u: Array
    v: Array
    pixels: Array
    direction: Array
    weight: Array

    def and_(self, *others: "Points") -> "Points":
        """Return all of them."""
        return Points(*(np.concatenate(parts) for parts in zip(self, *others, strict=True)))


def holes_at(u: Array, v: Array, pixels: Array, weight: Array | float = 1) -> Points:
    """Return the middles of holes as points: their distance counts in all directions."""
    weights = np.broadcast_to(np.asarray(weight, dtype=float), u.shape)
    on_x, on_y = (np.tile(way, (len(u), 1)) for way in ((1.0, 0.0), (0.0, 1.0)))
    return Points(u, v, pixels, on_x, weights).and_(Points(u, v, pixels, on_y, weights))


def fit(length: int, points: Points, first: Sheet | None = None, knots: int = _STIFF_KNOTS) -> Sheet:
    """Return the sheet of `length` rows that fits the points best, by least squares.

    What crosses the tape may bend every `knots` rows. How the tracks draw together, `narrowing`, is found
    only where there is a `first` sheet that says how far each point is from the sprocket track.
    """
    soft = Spline(length, max(1, round(length / _KNOTS)))
    stiff = Spline(length, max(1, round(length / knots)))
    pitch = float(np.hypot(*np.ptp(points.pixels, axis=0))) / max(length, 10)
    a, b = soft.at(points.u), stiff.at(points.u)
    x, y = points.direction[:, :1], points.direction[:, 1:]
    v = points.v[:, None]
    base = first.place(points.u, 0 * points.v) if first else points.pixels
    away = ((points.pixels - base) * points.direction).sum(axis=1)[:, None] / pitch
    counts = [a.shape[1], a.shape[1], b.shape[1], b.shape[1], b.shape[1]]
    stiffness = _blocks(
        [(0, 0.02, soft), (1, 0.02, soft), (2, 0.15, stiff), (3, 0.15, stiff), (4, 20, stiff)], counts
    )
    small = np.concatenate([np.zeros((counts[4], sum(counts[:4]))), 3 * np.eye(counts[4])], axis=1)
    seen = np.concatenate([x * a, y * a, x * v * b, y * v * b, -v * away * b], axis=1)
    matrix = np.concatenate([seen * points.weight[:, None], stiffness, small])
    right = np.zeros(len(matrix))
    right[: len(seen)] = (points.pixels * points.direction).sum(axis=1) / pitch * points.weight
    found = np.linalg.solve(matrix.T @ matrix + 1e-9 * np.eye(sum(counts)), matrix.T @ right)
    ax, ay, bx, by, w = np.split(found, np.cumsum(counts)[:-1])
    return Sheet(soft, stiff, np.stack([ax, ay], axis=1) * pitch, np.stack([bx, by], axis=1) * pitch, w)


def _blocks(bends: list[tuple[int, float, Spline]], counts: list[int]) -> Array:
    """Return rows that hold each block of coefficients stiff, by its number and its stiffness."""
    rows = []
    for number, stiffness, spline in bends:
        row = np.zeros((spline.pieces + 1, sum(counts)))
        start = sum(counts[:number])
        row[:, start : start + counts[number]] = stiffness * spline.bends()
        rows.append(row)
    return np.concatenate(rows)


class Flat(NamedTuple):
    """A picture of a sheet as if it lay flat: SAMPLES a pitch, from `first` row and -`reach` on.

    `light` as it is; `dark`, how much darker than the paper around, as a part of its light.
    """

    light: Array
    dark: Array
    first: float
    reach: float

    def at(self, u: Array, v: Array) -> tuple[Array, Array]:
        """Return the columns and lines of places on the tape."""
        return (u - self.first) * SAMPLES, (v + self.reach) * SAMPLES

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
    first = -_BEYOND
    u = np.arange(first * SAMPLES, (sheet.length + _BEYOND - 1) * SAMPLES + 1) / SAMPLES
    v = np.arange(-reach * SAMPLES, reach * SAMPLES + 1) / SAMPLES
    along, across = sheet.pitches()
    pieces = []
    block = 24 * SAMPLES
    for start in range(0, len(u), block):
        part = u[start : start + block]
        rows = np.clip(np.rint(part).astype(int), 0, sheet.length - 1)
        step = float(np.sqrt(along[rows].mean() * across[rows].mean()))
        picture, scale = pictures.for_step(step)
        places = sheet.place(part[None, :], v[:, None])
        x, y = ((places[..., axis] + 0.5) * scale - 0.5 for axis in (0, 1))
        pieces.append(
            cv2.remap(
                picture,
                x.astype(np.float32),
                y.astype(np.float32),
                cv2.INTER_CUBIC,
                borderMode=cv2.BORDER_REPLICATE,
            )
        )
    light = np.concatenate(pieces, axis=1)
    return Flat(light, _darkness(light), first, reach)


def _darkness(light: Array) -> Array:
    smooth = cv2.GaussianBlur(light, (0, 0), 0.1 * SAMPLES)
    size = round(1.25 * SAMPLES) | 1
    kernel = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (size, size))
    paper = cv2.GaussianBlur(cv2.dilate(smooth, kernel), (0, 0), 0.5 * SAMPLES)
    return np.asarray(1 - smooth / (paper + 2))


class Found(NamedTuple):
    """A tape that was found: its sheet, with channel 1 at v = -3 and 8 at v = 5 and read as u grows; which of
    its sprocket holes were seen; by how many pitches the holes around each row are astray from their places;
    and which rows have both edges of the paper at their places.
    """

    sheet: Sheet
    seen: Array
    astray: Array
    edged: Array


class _Side(NamedTuple):
    """Which track of a sheet is the sprocket track, and on which side of it are three channels: -1 or 1."""

    track: int
    three: int
    width: float
    share: float

    @property
    def edges(self) -> tuple[float, float]:
        return self.track + self.three * THREE * self.width, self.track - self.three * FIVE * self.width


def find(pictures: Sizes, row: Row) -> Found:
    """Return the tape whose sprocket holes, or one of whose code tracks, are in a row.

    Raises TapeError, which says what is not as on a tape.
    """
    sheet = _by_holes(pictures, row)
    side = _side(flatten(pictures, sheet, _FULL), sheet)
    if side.track:
        row = _sprockets(pictures, sheet, side.track)
        sheet = _by_holes(pictures, row)
        side = _side(flatten(pictures, sheet, _FULL), sheet)
        if side.track:
            raise TapeError("the sprocket holes cannot be told from code holes")
    if side.three > 0:
        row = Row(row.places[::-1], row.seen[::-1])
        sheet = fit(len(row.places), _turned(_grid(sheet, side.width), len(row.places)), None)
    elif side.width != 1:
        sheet = fit(len(row.places), _grid(sheet, side.width), None)
    for more in reversed(range(_LONGER)):
        sheet, flat, astray, edged = _refined(pictures, sheet, row)
        longer, before = _longer(flat, sheet, row)
        if len(longer.places) == len(row.places) or not more:
            break
        known = _grid(sheet)
        row = longer
        points = _sprocket_points(row).and_(known._replace(u=known.u + before))
        sheet = fit(len(row.places), points)
    return Found(sheet, row.seen, astray, edged)


def _refined(pictures: Sizes, sheet: Sheet, row: Row) -> tuple[Sheet, Flat, Array, Array]:
    for _ in range(3):
        flat = flatten(pictures, sheet)
        edges, edged = _edges(flat, sheet)
        holes, astray = _holes(flat, sheet, range(-3, 6))
        sheet = fit(sheet.length, _sprocket_points(row).and_(holes, edges), sheet)
    return sheet, flat, astray, edged


def _longer(flat: Flat, sheet: Sheet, row: Row) -> tuple[Row, int]:
    """Return the row with sprocket holes that are seen beyond its ends, and how many were put before it."""
    spots = _spots(flat.dark)
    u = np.arange(sheet.length, dtype=float)
    limit = 0.5 * np.median(flat.take(spots, u, 0 * u))
    near = np.arange(-3, 4) / SAMPLES
    ends: list[list[Array]] = []
    for places in (-1.0 - np.arange(3), sheet.length + np.arange(3.0)):
        ends.append([])
        for place in places:
            depth = flat.take(spots, *np.broadcast_arrays(place + near[:, None], near))
            along, aside = np.unravel_index(int(depth.argmax()), depth.shape)
            if depth[along, aside] < limit:
                break
            ends[-1].append(sheet.place(np.array(place + near[along]), np.array(near[aside])))
    before, after = (np.reshape(end, (-1, 2)) for end in (ends[0][::-1], ends[1]))
    seen = np.concatenate([np.ones(len(before), bool), row.seen, np.ones(len(after), bool)])
    return Row(np.concatenate([before, row.places, after]), seen), len(before)


def _by_holes(pictures: Sizes, row: Row) -> Sheet:
    """Return the sheet of a row by the holes beside it, whatever track it is."""
    sheet = _first(pictures, row)
    for reach, knots in ((2, 60), (2, 40), (3, 30), (5, 20), (7, 14), (9, _STIFF_KNOTS)):
        flat = flatten(pictures, sheet, reach + 1.5)
        holes, _ = _holes(flat, sheet, range(-reach, reach + 1))
        sheet = fit(
            sheet.length, _sprocket_points(row).and_(holes, _grid(sheet, weight=_FAINT)), sheet, knots
        )
    return sheet


def _sprocket_points(row: Row) -> Points:
    u = np.arange(len(row.places), dtype=float)
    return holes_at(u, 0 * u, row.places, np.where(row.seen, 1, 0.05))


def _grid(sheet: Sheet, width: float = 1, weight: float = 1) -> Points:
    """Return places of the sheet as points, to fit it again with another width."""
    u, v = (
        axis.ravel() for axis in np.meshgrid(np.arange(sheet.length, dtype=float), [-3.0, -1.5, 0, 2.5, 5])
    )
    return holes_at(u, v, sheet.place(u, v * width), weight)


def _turned(points: Points, length: int) -> Points:
    return points._replace(u=length - 1 - points.u, v=-points.v)


def _first(pictures: Sizes, row: Row) -> Sheet:
    """Return the sheet of a row by the slant and distance at which most is dark beside it."""
    length = len(row.places)
    steps = np.gradient(row.places, axis=0)
    reach = min(8, length // 2)
    steps = np.stack(
        [
            np.convolve(
                np.pad(steps[:, way], reach, mode="edge"), np.ones(2 * reach + 1) / (2 * reach + 1), "valid"
            )
            for way in (0, 1)
        ],
        axis=1,
    )
    square = np.stack([-steps[:, 1], steps[:, 0]], axis=1)
    u = np.arange(length, dtype=float)
    sheet = fit(length, _beside(row, square))
    flat = flatten(pictures, sheet, 1.3 * _FULL)
    spots = np.maximum(_spots(flat.dark), 0)
    tracks = np.array([track for track in range(-6, 7) if track])
    skews, widths = (axis.ravel() for axis in np.meshgrid(_SKEWS, _WIDTHS))
    along = u[:, None, None] + skews[:, None] * tracks * widths[:, None]
    aside = np.broadcast_to(tracks * widths[:, None], along.shape)
    depth = flat.take(np.minimum(spots, np.quantile(spots, 0.98)), along, aside).mean(axis=2)
    best = _likeliest(depth, np.stack([skews / _SKEW_STEP, np.log(widths) / _WIDTH_STEP], axis=1))
    across = (square + skews[best][:, None] * steps) * widths[best][:, None]
    return fit(length, _beside(row, across), None, 60)


def _likeliest(depth: Array, states: Array) -> Array:
    """Return for each row which state (n, 2) fits best if it changes little from row to row: of all paths,
    the one that gathers most of `depth` (rows, n).
    """
    rows = np.arange(0, len(depth), _EVERY)
    gathered = cv2.blur(depth, (1, 2 * _WINDOW + 1), borderType=cv2.BORDER_REFLECT)[rows]
    score = (gathered - np.median(gathered)) / (gathered.max() - np.median(gathered) + 1e-9)
    change = _STIFFNESS * ((states[:, None] - states) ** 2).sum(axis=2)
    total, ways = score[0], []
    for here in score[1:]:
        reached = total[:, None] - change
        ways.append(reached.argmax(axis=0))
        total = reached.max(axis=0) + here
    path = [int(total.argmax())]
    for way in ways[::-1]:
        path.append(int(way[path[-1]]))
    return np.array(path[::-1])[np.minimum(np.arange(len(depth)) // _EVERY, len(path) - 1)]


def _beside(row: Row, across: Array) -> Points:
    """Return the row, and places three pitches beside it."""
    u = np.arange(len(across), dtype=float)
    sides = (holes_at(u, np.full_like(u, side), row.places + side * across, 0.3) for side in (-3.0, 3.0))
    return _sprocket_points(row).and_(*sides)


def _spots(dark: Array) -> Array:
    """Return how much darker each place is than what is around it, within a pitch."""
    return np.asarray(
        cv2.GaussianBlur(dark, (0, 0), 0.07 * SAMPLES) - cv2.GaussianBlur(dark, (0, 0), 0.3 * SAMPLES)
    )


def _holes(flat: Flat, sheet: Sheet, tracks: range) -> tuple[Points, Array]:
    """Return the holes that are seen near their places, and how far off they are around each row."""
    spots = _spots(flat.dark)
    u, v = np.meshgrid(np.arange(sheet.length, dtype=float), np.array(tracks, dtype=float), indexing="ij")
    near = np.arange(-round(_ASTRAY * SAMPLES), round(_ASTRAY * SAMPLES) + 1)
    x, y = (np.rint(axis).astype(int) for axis in flat.at(u, v))
    patch = spots[
        (y[..., None, None] + near[:, None]).clip(0, spots.shape[0] - 1),
        (x[..., None, None] + near).clip(0, spots.shape[1] - 1),
    ]
    depth = patch.reshape(*u.shape, -1)
    deep = depth.max(axis=2)
    down, aside = np.unravel_index(depth.argmax(axis=2), patch.shape[2:])
    inside = (down > 0) & (down < len(near) - 1) & (aside > 0) & (aside < len(near) - 1)
    sprocket = np.median(deep[:, list(tracks).index(0)])
    seen = inside & (deep > 0.6 * sprocket)
    patch, down, aside, at = patch[seen], down[seen], aside[seen], np.arange(seen.sum())
    off_x = near[aside] + _vertex(*(patch[at, down, aside + step] for step in (-1, 0, 1)))
    off_y = near[down] + _vertex(*(patch[at, down + step, aside] for step in (-1, 0, 1)))
    off_u = (x[seen] + off_x) / SAMPLES + flat.first - u[seen]
    off_v = (y[seen] + off_y) / SAMPLES - flat.reach - v[seen]
    u, v = u[seen], v[seen]
    squares = np.bincount(u.astype(int), off_u**2 + off_v**2, sheet.length)
    count = np.bincount(u.astype(int), minlength=sheet.length).astype(float)
    width = np.ones(7)
    astray = np.sqrt(np.convolve(squares, width, "same") / np.maximum(np.convolve(count, width, "same"), 1))
    astray = np.maximum(astray, _strays(flat, sheet, spots, 0.6 * sprocket))
    trust = 1 / (1 + (astray / 0.07) ** 4)
    weight = trust[u.astype(int)] / (1 + (off_u**2 + off_v**2) / 0.1**2)
    return holes_at(u, v, sheet.place(u + off_u, v + off_v), weight), astray


def _strays(flat: Flat, sheet: Sheet, spots: Array, limit: float) -> Array:
    """Return for each row how far from its place a spot near it is, if it is at no place of a hole at all."""
    size = round(0.6 * SAMPLES) | 1
    y, x = np.nonzero((spots > limit) & (spots >= cv2.dilate(spots, np.ones((size, size), np.uint8))))
    u, v = x / SAMPLES + flat.first, y / SAMPLES - flat.reach
    off = np.maximum(abs(u - np.rint(u)), abs(v - np.rint(v)))
    stray = (off > _ASTRAY) & (v > 0.7 - THREE) & (v < FIVE - 0.7) & (u > -0.5) & (u < sheet.length - 0.5)
    found = np.zeros(sheet.length)
    for row, away in zip(np.rint(u[stray]).astype(int), off[stray], strict=True):
        near = slice(max(0, row - 2), row + 3)
        found[near] = np.maximum(found[near], away)
    return found


def _vertex(before: Array, top: Array, after: Array) -> Array:
    curvature = before - 2 * top + after
    return np.where(curvature < -1e-9, 0.5 * (before - after) / np.minimum(curvature, -1e-9), 0).clip(
        -0.5, 0.5
    )


def _side(flat: Flat, sheet: Sheet) -> _Side:
    """Return which track is the sprocket track and on which side of it three channels are.

    Raises TapeError if the paper has not its edges where a tape has, or the holes are not as a tape's.
    """
    always, mass = {}, {}
    spots = _spots(flat.dark)
    u = np.arange(sheet.length, dtype=float)
    limit = 0.5 * np.median(flat.take(spots, u, 0 * u))
    for track in range(-5, 6):
        deep = flat.take(spots, u, 0 * u + track)
        always[track] = float((deep > limit).mean())
        mass[track] = _mass(flat, u[deep > limit], track)
    has_codes = sum(always.values()) * sheet.length > sheet.length + 12
    widths = np.array([1.0]) if has_codes else np.geomspace(0.55, 1.8, 33)
    sides = [
        _Side(track, three, float(width), 0)
        for track in range(-5, 6)
        for three in (-1, 1)
        for width in widths
        if always[track] > 0.7 and (has_codes or track == 0)
    ]
    paper = _paper(flat, sheet)
    sides = [side._replace(share=_share(flat, paper, side)) for side in sides]
    best = max((side.share for side in sides), default=0)
    if best < 0.5:
        raise TapeError("the paper's edges are not 3.92 and 6.08 rows' distances from the sprocket holes")
    likely = [side for side in sides if side.share > 0.75 * best]
    found = min(likely, key=lambda side: (round(mass[side.track] / mass[0], 1), -side.share))
    others = [
        mass[track] for track in mass if track != found.track and always[track] > 0.1 and abs(track) <= 3
    ]
    if others and np.median(others) < 1.35 * mass[found.track]:
        raise TapeError(
            "the holes are all of one size: a tape's sprocket holes are smaller than its code holes"
        )
    return found


def _mass(flat: Flat, u: Array, track: int) -> float:
    """Return how much of the light is lost in a hole of a track, its depth times its area: blur keeps it."""
    if not len(u):
        return 0.0
    away = np.arange(-5, 6) / SAMPLES
    x, y = np.meshgrid(away, away)
    disc = np.hypot(x, y) < 0.45
    x, y = x[disc], y[disc]
    dark = flat.take(flat.dark, u[:, None] + x, track + 0 * u[:, None] + y)
    return float(np.median(dark.sum(axis=1)))


_PROFILE = np.arange(-8, 9) / SAMPLES


class _Paper(NamedTuple):
    """The light of the paper between each two rows, `u`, and how dark a sprocket hole is beside it."""

    u: Array
    light: Array
    depth: float


def _paper(flat: Flat, sheet: Sheet) -> _Paper:
    u = np.arange(-0.5, sheet.length)
    light = np.median(flat.take(flat.light, *np.broadcast_arrays(u[:, None], np.arange(-2.5, 3))), axis=1)
    rows = np.arange(sheet.length, dtype=float)
    depth = float(np.median(flat.take(flat.dark, rows, 0 * rows)))
    return _Paper(u, cv2.medianBlur(light[:, None].astype(np.float32), 5)[:, 0] + 2, depth)


def _profiles(flat: Flat, paper: _Paper, edge: float, outward: float) -> tuple[Array, Array]:
    """Return the light from inside to outside an edge, between each two rows: (rows, places), as a part of
    the paper's; and which have an edge there.
    """
    rows = (paper.u[:, None] + np.array([-0.1, 0, 0.1]))[:, :, None]
    places = edge + outward * _PROFILE
    profile = flat.take(flat.light, *np.broadcast_arrays(rows, places)).mean(axis=1) / paper.light[:, None]
    inside, outside = profile[:, :5].mean(axis=1), profile[:, -5:].mean(axis=1)
    return profile, (abs(inside - outside) > 0.4 * paper.depth) & (abs(inside - 1) < 0.35)


def _share(flat: Flat, paper: _Paper, side: _Side) -> float:
    """Return at how many of the rows both edges are where they are on a tape."""
    there = (_profiles(flat, paper, edge, -1.0 if edge < side.track else 1.0)[1] for edge in side.edges)
    return float(min(edge.mean() for edge in there))


def _edges(flat: Flat, sheet: Sheet) -> tuple[Points, Array]:
    """Return the paper's edges as points, and which rows have both."""
    paper = _paper(flat, sheet)
    sides: list[Points] = []
    both: list[Array] = []
    for edge, outward in ((-THREE, -1.0), (FIVE, 1.0)):
        profile, there = _profiles(flat, paper, edge, outward)
        both.append(there[:-1] | there[1:])
        profile, u = profile[there], paper.u[there]
        inside, outside = profile[:, :4].mean(axis=1), profile[:, -4:].mean(axis=1)
        share = ((profile - outside[:, None]) / (inside - outside)[:, None]).clip(0, 1).mean(axis=1)
        off = share * (len(_PROFILE) / SAMPLES) - (len(_PROFILE) / SAMPLES) / 2
        v = np.full_like(u, edge)
        along = sheet.place(u + 0.5, v) - sheet.place(u - 0.5, v)
        normal = np.stack([-along[:, 1], along[:, 0]], axis=1) / np.hypot(*along.T)[:, None]
        sides.append(Points(u, v, sheet.place(u, v + outward * off), normal, np.full_like(u, 0.3)))
    return sides[0].and_(sides[1]), both[0] & both[1]


def _sprockets(pictures: Sizes, sheet: Sheet, track: int) -> Row:
    """Return the row of sprocket holes on a track of the sheet."""
    u = np.arange(sheet.length, dtype=float)
    places = sheet.place(u, np.full_like(u, track))
    depth = [
        measured(pictures, place, step)[1]
        for place, step in zip(places, np.gradient(places, axis=0), strict=True)
    ]
    total = np.convolve(depth, np.ones(FEWEST), "valid")
    start = int(total.argmax())
    return follow(pictures, places[start : start + FEWEST])
