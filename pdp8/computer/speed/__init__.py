"""What makes the machine fast without changing what it does.

engine       the processor for long runs: core decoded once, compiled where it can be
piece        the engine's inner loop, which setup.py translates to C
waiting      loops that only wait, passed over exactly
"""
