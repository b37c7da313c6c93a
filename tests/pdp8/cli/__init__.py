"""Tests of pdp8/cli/."""
