"""Tests of setup.py and release/."""
