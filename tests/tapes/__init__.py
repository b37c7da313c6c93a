"""Tests of tapes/."""
