"""Tests of programs/."""
