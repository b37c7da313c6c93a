"""Tests of pdp8/computer/speed/."""
