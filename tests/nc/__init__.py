"""Tests of nc/."""
