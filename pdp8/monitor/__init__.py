"""The operator's prompt: one line in, what it says out. A script feeds it as well as a person.

prompt       a machine at a prompt, and the places that a line names
arguments    the words of a line: quotes and escapes, octal, seconds
commands     every command by its name: a line becomes one
debugging    words, registers, switches and keys; breakpoints, steps, traces
running      running until a time, a text on the page, or a value
rack         DECtapes on their drives
keystrokes   the Teletype's keys, as the program asks for them
past         undoing what the machine has done
simh         the words of SIMH's that are not the monitor's own
tapes        programs, tapes, the Teletype's page, saved states

Not here: the terminal with its history, and the script's file, are the command's (pdp8/cli/monitor).
"""
