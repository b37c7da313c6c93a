"""Tests of pdp8/computer/use/."""
