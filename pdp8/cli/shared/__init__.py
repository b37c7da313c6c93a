"""What the commands share.

command     how a command ends, what it says, how a product leaves it
arguments   the kinds of files that a command takes
rules       what an option needs and excludes, and options declared as a dataclass
parameters  octal words and seconds as options
frames      what a command reads as frames
progress    a bar on work that lasts
extras      how to get a library that an extra brings
"""
