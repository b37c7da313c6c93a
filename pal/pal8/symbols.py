"""The permanent symbols of PAL8: those of DEC's, and those that palbart has besides.

Sources: PAL8 V10D under OS/8, and palbart 2.13, each asked for every symbol; PDP-8/L Users Handbook.
"""

REFERENCES = {
    "AND": 0o0000,
    "TAD": 0o1000,
    "ISZ": 0o2000,
    "DCA": 0o3000,
    "JMS": 0o4000,
    "JMP": 0o5000,
}
MARKS = {"I": 0o0400, "Z": 0o0000}
"""What may come between a memory reference and its address."""

INSTRUCTIONS = {
    **{"NOP": 0o7000, "OPR": 0o7000, "IAC": 0o7001, "BSW": 0o7002, "RAL": 0o7004, "RTL": 0o7006},
    **{"RAR": 0o7010, "RTR": 0o7012, "CML": 0o7020, "CMA": 0o7040, "CIA": 0o7041, "CLL": 0o7100},
    **{"STL": 0o7120, "CLA": 0o7200, "GLK": 0o7204, "STA": 0o7240, "HLT": 0o7402, "OSR": 0o7404},
    **{"SKP": 0o7410, "SNL": 0o7420, "MQL": 0o7421, "SZL": 0o7430, "SZA": 0o7440, "SNA": 0o7450},
    **{"SMA": 0o7500, "MQA": 0o7501, "SPA": 0o7510, "SWP": 0o7521, "LAS": 0o7604, "IOT": 0o6000},
    **{"SKON": 0o6000, "ION": 0o6001, "IOF": 0o6002, "SRQ": 0o6003, "GTF": 0o6004, "RTF": 0o6005},
    **{"SGT": 0o6006, "CAF": 0o6007, "RPE": 0o6010, "RSF": 0o6011, "RRB": 0o6012, "RFC": 0o6014},
    **{"PCE": 0o6020, "PSF": 0o6021, "PCF": 0o6022, "PPC": 0o6024, "PLS": 0o6026, "KCF": 0o6030},
    **{"KSF": 0o6031, "KCC": 0o6032, "KRS": 0o6034, "KIE": 0o6035, "KRB": 0o6036, "TFL": 0o6040},
    **{"TSF": 0o6041, "TCF": 0o6042, "TPC": 0o6044, "TSK": 0o6045, "TLS": 0o6046, "CDF": 0o6201},
    **{"CIF": 0o6202, "RDF": 0o6214, "RIF": 0o6224, "RIB": 0o6234, "RMF": 0o6244},
}

PALBARTS_REFERENCES = {
    **{"FADD": 0o1000, "FSUB": 0o2000, "FMPY": 0o3000, "FDIV": 0o4000, "FGET": 0o5000, "FPUT": 0o6000},
}

PALBARTS = {
    **PALBARTS_REFERENCES,
    **{"FEXT": 0o0000, "FNOR": 0o7000, "SQUARE": 0o0001, "SQROOT": 0o0002},
    **{"RCC": 0o6016, "CDI": 0o6203, "ACL": 0o7701, "DPI": 0o6100, "SMP": 0o6101, "SNP": 0o6101},
    **{"EPI": 0o6103, "CMP": 0o6104, "CNP": 0o6104, "CEP": 0o6106, "SPO": 0o6107, "TTI": 0o6402},
    **{"TTO": 0o6404, "TTINCR": 0o6401, "TTCL": 0o6411, "TTSL": 0o6412, "TTRL": 0o6414},
    **{"TTSKP": 0o6421, "TTXOF": 0o6422, "TTXON": 0o6424, "DCMA": 0o6601, "DMAR": 0o6603},
    **{"DMAW": 0o6605, "DCEA": 0o6611, "DCIM": 0o6611, "DSAC": 0o6612, "DEAL": 0o6615, "DIML": 0o6615},
    **{"DEAC": 0o6616, "DIMA": 0o6616, "DFSE": 0o6621, "DFSC": 0o6622, "DISK": 0o6623, "DMAC": 0o6626},
    **{"DCXA": 0o6641, "DXAL": 0o6643, "DXAC": 0o6645, "DMMT": 0o6646, "KCLR": 0o6700, "KSDR": 0o6701},
    **{"KSEN": 0o6702, "KSBF": 0o6703, "KLSA": 0o6704, "KSAF": 0o6705, "KGOA": 0o6706, "KRSB": 0o6707},
    **{"DTRA": 0o6761, "DTCA": 0o6762, "DTXA": 0o6764, "DTLA": 0o6766, "DTSF": 0o6771, "DTRB": 0o6772},
    **{"DTLB": 0o6774},
}
"""Undefined in DEC's."""

NOT_ON_THE_8L = frozenset(
    "BSW MQL MQA SWP ACL SKON SRQ GTF RTF SGT CAF KCF TFL KIE TSK RPE PCE".split()  # noqa: SIM905
)
"""Instructions of the 8/E that an 8/L lacks, or that do something else there."""

HANDLERS = {
    **{"DECIMAL": 0o0207, "DEVICE": 0o2530, "DTORG": 0o5400, "EJECT": 0o5505, "ENPUNCH": 0o0205},
    **{"EXPUNGE": 0o2667, "FIELD": 0o0415, "FILENAME": 0o2533, "FIXMRI": 0o0464, "FIXTAB": 0o4253},
    **{"IFDEF": 0o5050, "IFNDEF": 0o5051, "IFNZRO": 0o5001, "IFZERO": 0o5000, "NOPUNCH": 0o0204},
    **{"OCTAL": 0o0210, "PAGE": 0o0437, "PAUSE": 0o0361, "RELOC": 0o5466, "TEXT": 0o2601},
    **{"XLIST": 0o5453, "ZBLOCK": 0o4130},
}
"""The pseudo-operators, with the addresses of DEC's routines, which are their values in an expression."""

PSEUDO_OPERATORS = tuple(HANDLERS)

ELSEWHERE = {
    "DEFINE": "DEFINE makes a macro of MACRO-8; PAL8 has none: use a subroutine",
    "TITLE": "TITLE is for palbart's listing, with -a only",
    "BANK": "BANK is palbart's, with -a only: use FIELD",
    "EQU": "EQU is another assembler's: PAL8 has =",
    "IFNZER": "IFNZERO is palbart's: write IFNZRO",
    "DUBL": "DUBL is palbart's: write both words in octal",
    "FLTG": "FLTG is palbart's: write the three words in octal",
    "ASCII": 'ASCII is palbart\'s: write the codes so: "A;"B',
    "SEGMNT": "SEGMNT is palbart's: write the origin",
    "RIMPUN": "RIMPUNCH is palbart's: pal --rim punches a RIM tape",
    "BINPUN": "BINPUNCH is palbart's: pal punches a BIN tape",
}
"""What other assemblers of its family have; of each name the first six characters, which count."""
