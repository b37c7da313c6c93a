"""The thesis page by page: its figures, tables and listings made again, its programs line by line.

evidence    the surviving programs line by line: scan, ours, why; scan/ has the tables
restoration the sources in programs/ and the tables of docs/restoration.md, made from it
reading     what a legible line of the scan says: five rules
"""
