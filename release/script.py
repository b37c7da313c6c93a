"""The Python example of the README, as a user's script; release/dist.py runs and types it."""

import pdp8

machine = pdp8.Machine()
machine.load(pdp8.assemble(pdp8.tape("eia.pal")).words)
machine.start(0o200)
machine.teletype.reader.load(pdp8.ascii.encode(pdp8.part("circle")))
stop = machine.run()
print(stop.reason, len(machine.teletype.punch.tape))
