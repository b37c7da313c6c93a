"""`python -m pdp8.web.translator`: check that every module of the page can be translated to JavaScript.

Prints file, line and construct of the first fault of each module, and exits with 1 if there is one.
"""

from pdp8.web.translator import faults

if found := faults():
    hint = "the page runs these modules as JavaScript: CONTRIBUTING.md says what they may contain"
    raise SystemExit("\n".join([*found, hint]))
