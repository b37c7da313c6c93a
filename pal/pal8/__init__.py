"""PAL8: the dialect of DEC's later assemblers, with literals, links, page operators and conditions.

assembler    the two passes, line by line and statement by statement
lexer        the source as tokens
expressions  + - ! & ^ % and the blank; memory references; literals
literals     those of each page, links included
operators    * and =, and the pseudo-operators: one method for each
output       what is punched, and where it is loaded
table        the symbols of the source; symbols   the permanent ones
log          what is said of the source
assembly     all of it together: the `Assembly` of a PAL8 source

Where a term is missing, the symbol or number looked up last is taken again, as DEC's does.

`exact` is DEC's own reading. Without it some of what authors use with palbart is allowed too, with a note:
small letters are capitals, a line is not cut after 80 characters, TEXT/AB/ needs no blank, PAUSE does not
end the file, a tag may have the name of an instruction, and palbart's names are known where they are not
defined. `wipe` is /W: what was put out of a page is forgotten, so that another overlay may go there.

Sources: DEC's PAL8 V10D under OS/8 on several thousand sources; PAL8.PA (V13, 1975); palbart 2.13.
"""
