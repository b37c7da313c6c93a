"""What ran in 1971: the thesis's programs, in PAL III and FORTRAN, and its other parts, reconstructed.

eia.pal          ASCII to EIA: the thesis's final conversion program; eia1.pal and eia2.pal, the two before it
circle.for       Appendix C, transcribed; a mark from column 73 says what the scan shows of a line
ellipse.for      Appendix D, transcribed

The part programs, each with a `part(...)` that returns its printout:

circle           Appendix C, ported statement by statement
ellipse          Appendix D, the same
polynomial       the third degree polynomial of Chapters 6 and 7
slope            a slope, Chapter 3's by default
curve            any function of x
profile          a closed profile: the radius as a function of the angle, or points
die              the steel die: ellipses of three sets of axes
drill            the four-hole tape of Chapter 3
drawn            a curve drawn by hand, in the pages
fluidic          the fluidic element of Chapter 8

What they are made of:

stretches        lines, arcs and graphs, split into stretches of one direction, each with its band
stepwise         the Step-wise Linear Technique
piecewise        the Piece-wise Linear Technique
milling          a curve made into blocks, by either
function         y = f(x) on the table, and the exact path of a cutter beside it
units            inches as thousandths
arithmetic       exact, or that of a machine of its time
header           the six blocks that open a tape
printout         blocks as lines of 19 characters
format           FORMAT fields
constants        a part's keywords as a command or a form asks for them
points           points of a file: measured ones, or an outline
least_squares    a function from measured points
mirror           the other hand of a part
parts            which part programs there are
nominals         the nominal curve of each, from its constants
thesis           what the thesis says of each part
"""
