"""Tests of pdp8/monitor/."""
