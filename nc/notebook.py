"""A path that a notebook draws."""

from nc.path import Path


class DrawnPath(Path):
    """A path with the drawing that a notebook shows."""

    def _repr_svg_(self) -> str:
        """Return the path and the cut surface as SVG."""
        from nc.plot import plot

        return plot(self)
