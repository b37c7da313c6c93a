"""Tests of pdp8/computer/hardware/."""
