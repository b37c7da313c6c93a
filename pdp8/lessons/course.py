"""The bundled exercises in the order of a class: sheets, then programs, the easiest first."""

COURSE = {
    "An hour in 1971: sheets": "read-a-frame follow-a-digit no-character-lost spaces-are-zeros truncation"
    " break-a-tape",
    "First programs": "add larger table subroutine multiply delay",
    "Characters and tapes": "echo message octal decimal parity backwards",
    "The tapes of 1971": "eia-digit short-block find-the-fault step-wise",
    "The whole machine": "fast-multiply interrupt loader itself",
}
"""Names by level."""
