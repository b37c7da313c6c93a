"""Tests of pdp8/."""
