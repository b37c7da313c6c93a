"""Photographs of tape: read as they were drawn, or refused."""

import pytest

pytest.importorskip("cv2", reason="OpenCV is not installed")
