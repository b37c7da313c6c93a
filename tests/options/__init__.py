"""Every option alone and every two together, on small real inputs: each acts, or the call is refused.

inputs   the files, the calls that are tried, what an option is given, and what cannot show
trial    one call in this process, and all that comes out of it
pairs    the options of all commands as they are declared, and what is wrong with them

`make options` tries all; tests/options/test_pairs.py a tenth.
"""
