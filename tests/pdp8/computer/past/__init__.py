"""Tests of pdp8/computer/past/."""
