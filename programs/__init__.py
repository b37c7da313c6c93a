"""What ran in 1971: the programs of the thesis, in PAL III and FORTRAN.

eia.pal          ASCII to EIA: the thesis's final conversion program
circle.for       Appendix C, transcribed; RESTORED, from column 73, marks lines lost in the scan
ellipse.for      Appendix D, transcribed

circle, ellipse  those two part programs, ported
arithmetic       exact, or that of a machine of the day
format           FORMAT fields
header           the six blocks that open a tape
printout         blocks as lines of 19 characters
options          a part's keywords as options of its command
cli              pdp8 part
errors           what a part program refuses
"""
