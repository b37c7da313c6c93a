"""A debugger for editors: the Debug Adapter Protocol over the monitor's machine, with steps back.

    editor ◄── wire ──► session ──► debuggee: monitor, machine, history
                           └──► scopes, breakpoints, memory ──► calls, places

wire         messages on two streams
session      what the editor asks for, and what it is told: the life of a debugger
scopes       what it is shown: calls, registers, lamps, symbols and devices as variables, expressions
memory       core as bytes, and as instructions
launch       what launch.json says, and the machine made ready by it
debuggee     the machine at its monitor, and where it is to stop
places       the lines of a source and the addresses of its words
breakpoints  where a run stops: lines, addresses, words written; on a condition, at a count of hits
expressions  what a condition, a log message or a watched expression is
requests     what an editor may send
motion       into, over and out of subroutines, and back
calls        who called, from the words in core

Sources: Debug Adapter Protocol 1.68 (microsoft.github.io/debug-adapter-protocol).
"""
