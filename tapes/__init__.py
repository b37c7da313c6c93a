"""What a strip of holes means. A tape is `bytes`: one byte a frame, channel 8 is 0o200, channel 1 is 0o001.

frames      channels, parity, leader and trailer, rubout
ascii       ASCII text, its line ends and fill
eia         EIA RS-244, the code of N/C machines
rim         DEC's RIM loader format
binary      DEC's BIN loader format
octal       any tape spelled out as text
dump        frames of any dump: hexadecimal, octal, binary
ita2        ITA2, the five-level code of telex machines
code        a tape code as one object
codes       every tape code, and which of them a tape is in
loaders     BIN and RIM as tape codes
hydrapoint  what the digits of an EIA tape mean to the Moog Hydra-Point
controls    tapes for other numerical controls
paper       drawings on pages to print
cutting     a tape for a laser: SVG, DXF
picture     a tape as text and as SVG in true geometry
photograph  photographs of tape become frames
redundancy  what a tape says of its own frames
doubts      frames that break their tape's rule, and what they are likely to be
notebook    a tape that a notebook draws
title       letters punched for the eye
measure     what can be said of a tape: its length, time, lines, checksum
quantities  counts, times, lengths and addresses as they are said
convert     from one code to another
text        lines of text
expression  y = f(x) as a command takes it
spelled     words of core spelled out as text
nominal     the curve that a part program follows
dectape     the image of a DECtape
os8         files of OS/8 on a DECtape
errors      what is raised when the work given is wrong
"""
