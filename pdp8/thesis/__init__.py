"""The thesis page by page: its figures, tables and listings reproduced, its programs line by line.

catalogue    every figure, table, listing and program: its words, what there is here, what makes it
making       an item of it made: a sheet or a text, with its caption
gallery      the page that sets all of them beside the thesis

numbers      every number of the chapters: its page, its words, ours, what makes it
measures     what we make of each                      (measured.json: those that take long, kept)
inputs       what that is made from, and what may be said of it

collate      what a rescan would settle, a letter that asks for it, answers (pages: a line on a picture)
evidence     the surviving programs line by line: scan, ours, why; scan/ has the tables
supplied     which characters the scan does not show, and how each output marks them
tei          the same, for editors
reading      what a legible line of the scan says: six rules
facsimile    listings B, C and D as they were on their pages

The makers:
slopes       the two techniques            diagrams    the element; drawn/ has what nothing computes
codes        tapes and codes                           (machine, die, construction, test, flow charts)
work         parts, polar graphs, traces   tables      the tables, computed
listings     the listings and programs     chain       a part program's tape, translated and cut
paper        a figure on its sheet         table       text in columns
"""
