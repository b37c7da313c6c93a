"""Tests of pal/."""
