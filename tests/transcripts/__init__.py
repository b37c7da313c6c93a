"""Commands and all that comes out of them, in tables that are read like a terminal.

A blank line begins a new folder. It has the files of tests/options/inputs.py that the block names.

    % a.pal = *200|HLT|$|     a file of these lines, ¦ for a bar; of a.eia an EIA tape
    % a.bin = 200*8 102 000   a tape of these frames, eight of the first
    $ pal a.pal < tape.asc    a command of pdp8, and what is on its standard input
    * examine 200             a line at a monitor's prompt, the same one in all of the block
      text                    a line of its standard output; `… 9 more, 6r2kf` are nine, and the digest of all
    ! text                    a line of its standard error
    ? text                    what the prompt refuses
    = 1                       its exit status, unless 0
    ! wrote a.bin + 64, 4h3xa a line of a file that it wrote, with its bytes and digest
    + a.bin 64, 4h3xa         a file that no line names

`python -m tests.transcripts` writes what the commands answer now: read the difference before you keep it.
"""
