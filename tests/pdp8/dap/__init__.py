"""Tests of pdp8/dap/."""
