"""The machine beside the reference, in random situations: after every piece of a run they differ in nothing.

situations  what is in core, and what the operator does
sides       the machine and the reference, each doing the same
play        one situation, on both
shrink      the smallest situation that still differs
__main__    `make lockstep N=...`
"""
