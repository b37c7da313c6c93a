"""Pages for a browser: HTML files with everything inside.

translator    our Python as JavaScript: the machine, PAL III, the tapes, the milling machine
bundle        modules, style and data in one file, and what that file may do
page          the afternoon as one file, of which these are the pieces

workbench     the live machine as one file: workbench.mjs, its panes in bench/
curve         the page that teaches the method: curve.mjs, its figures in curve/
shell.html    what is around every page   base.css             how it looks
page.html     what stands where           page.css             how that looks
panel.mjs     lamps and switches
afternoon.mjs any instant again           paper.mjs      listing, printed page, blocks
tape.mjs      tapes under their heads     cutter.mjs     the staircase in its band
meaning.mjs   an instruction in words     brightness.mjs how bright a lamp is
sheet.mjs     drawing what has changed    written.mjs    how it is written
current.mjs   a list's current line       pictures.mjs   when the next picture is due
scene.mjs     all of it at one instant    page.mjs       slider, buttons and keys
"""
