"""Hostile inputs for every command: altered tapes and sources, options at their edges."""
