"""Tests of tapes/photograph/."""
