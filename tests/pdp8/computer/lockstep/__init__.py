"""The machine in all its forms beside the reference: after every act of a situation they differ in nothing.

situations  what is in core, and what the operator does
sides       the machine, compiled, plain and in JavaScript, and the reference, each doing the same
side.mjs    the machine in JavaScript
play        one situation, on all of them
shrink      the smallest situation that still differs
__main__    `make lockstep N=...`
"""
