"""DECtape: the TC08 control, and TU55 transports that move in real time.

tu55     a transport: its motion, and the tape that is mounted
tc08     the control: its registers, functions and data breaks
"""
