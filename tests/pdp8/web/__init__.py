"""Tests of pdp8/web/."""
