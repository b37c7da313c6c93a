"""Pages for a browser: HTML files with everything inside.

translator    our Python as JavaScript: the machine, PAL III, the tapes, the milling machine, the afternoon
bundle        modules, style and data in one file, and what that file may do; start.js unpacks and starts it

workbench     the one page: the live machine, and the afternoon that plays on it
              workbench.mjs, its panes in bench/: a class NAME.mjs and a section NAME.html each, laid by
              desk.mjs while the room plays; the HTML names the method that each control calls
              (bench/wiring.mjs)
record        what it has at hand, as JSON; kept: in the user's cache, while the sources are the same
parts         the part programs' options, as the page asks for them, and their fields
findings      what an assembly says of each line, as the editor shows it
passing       the block that passes under a head
translation   the EIA tape that eia.pal makes of an ASCII tape
loosened      the circle within another tolerance, by the whole chain
curve         the page that teaches the method: curve.mjs, its figures in curve/, method what they compute
shell.html    what is around every page   base.css             how it looks
bench.html    what stands where           workbench.css        how that looks
room/         what a visitor sees first: first.html, before any script; then room.mjs leads through the
              afternoon by a tour, a camera, a scene;
              what is drawn: panel, teletype, tape, mill, plate, wall; ink, type; sound; hands, its buttons
panel.mjs     lamps and switches          written.mjs    how things are written
tape.mjs      tapes under their heads     cutter.mjs     the staircase in its band
sheet.mjs     drawing what has changed    pictures.mjs   when the next picture is due
svg.mjs       places as drawings
html.mjs      HTML in which what is put is text: the one way to write any
"""
