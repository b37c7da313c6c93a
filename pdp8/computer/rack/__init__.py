"""What an owner could add to a PDP-8/L beside its Teletype and high-speed reader: one device a file.

kw8   the clock          lp08   a line printer       pt08   a second Teletype      df32   a fixed-head disk
"""
