"""What a strip of holes means. A tape is `bytes`: one byte a frame, channel 8 is 0o200, channel 1 is 0o001.

frames      channels, parity, leader and trailer, rubout
ascii       ASCII text, its line ends and fill
eia         EIA RS-244, the code of N/C machines
rim         DEC's RIM loader format
binary      DEC's BIN loader format
kinds       telling a tape by its frames
hydrapoint  what a tape says to the N/C machine: blocks and codes
picture     a tape as text and as SVG in true geometry
measure     what can be said of a tape: its length, time, lines, checksum
shelf       where files are found, read and written
command     how every command ends
errors      what is raised when the work given is wrong
cli         pdp8 tape
"""
