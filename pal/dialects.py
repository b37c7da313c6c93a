"""What PAL III has instead of what other PDP-8 assemblers know.

Pseudo-operators of MACRO-8, PAL-D and PAL8 are undefined symbols in PAL III, and their operators illegal
characters; so the hint goes with a UA or IC message.

Sources: DEC-08-ASAC-D (what there is); the manuals of MACRO-8, PAL-D and PAL8 (what there is not).
"""

_SYMBOLS = {
    "PAGE": "PAGE is another assembler's: in PAL III write the origin, as in *400",
    "TEXT": "TEXT is another assembler's: in PAL III write the codes as numbers, one word each",
    "ZBLOCK": "ZBLOCK is another assembler's: in PAL III leave the words out with *.+20, or write zeros",
    "XLIST": "XLIST is another assembler's: PAL III lists everything",
    "EJECT": "EJECT is another assembler's: PAL III's listing has no pages",
    "NOPUNCH": "NOPUNCH is another assembler's: PAL III punches everything",
    "ENPUNCH": "ENPUNCH is another assembler's: PAL III punches everything",
    "DUBL": "DUBL is MACRO-8's: in PAL III write both words in octal",
    "FLTG": "FLTG is MACRO-8's: in PAL III write the three words in octal",
    "DEFINE": "PAL III has no macros: use a subroutine",
    "RELOC": "RELOC is another assembler's: PAL III assembles for where the words are loaded",
    "FILENAME": "FILENAME is another assembler's: PAL III knows nothing of files",
    "DEVICE": "DEVICE is another assembler's: PAL III knows nothing of files",
    "DTORG": "DTORG is another assembler's: PAL III knows nothing of DECtape blocks",
    "OPR": "OPR is not in PAL III's table: write 7000, or OPR=7000",
    "IOT": "IOT is not in PAL III's table: write 6000, or IOT=6000",
    "FIXMRI": "",
} | dict.fromkeys(
    ("IFDEF", "IFNDEF", "IFZERO", "IFNZRO", "IFNZRO"),
    "PAL III has no conditional assembly: keep the variants on tapes of their own",
)
_LATER = dict.fromkeys(
    (
        "BSW",
        "MQA",
        "MQL",
        "SWP",
        "ACL",
        "CAM",
        "CAF",
        "SKON",
        "SRQ",
        "GTF",
        "RTF",
        "SGT",
        "KIE",
        "KCF",
        "TFL",
        "TSK",
    ),
    "is of a later PDP-8, or of the extended arithmetic element: PAL III does not know it; define it with =",
)
_CHARACTERS = {
    "!": "PAL III has no ! operator: a space is inclusive OR",
    "&": "PAL III has no & operator",
    "^": "PAL III has no ^ operator",
    "%": "PAL III has no % operator",
    "(": "PAL III has no literals: give the constant a tag in the program and refer to that",
    ")": "",
    "[": "PAL III has no literals: give the constant a tag on page zero and refer to that",
    "]": "",
    '"': "PAL III has no character constants: write the code, as in 301 for A",
    "<": "PAL III has no conditional assembly and no macros",
    ">": "",
    "@": "PAL III writes an indirect reference with I, as in JMP I 20",
    "#": "PAL III's numbers are octal, or decimal after DECIMAL",
    "'": "PAL III's comments begin with /",
    "?": "a character that is not ASCII is read as ?",
}
_LOWER_CASE = "PAL III knows capital letters only; --modern folds lower case"
_SIGNIFICANT = 6


def hint(code: str, subject: str) -> str:
    """Return one sentence for the message `code` of `subject` (a symbol, or a character in octal), or ""."""
    if code == "UA":
        later = _LATER.get(subject)
        return f"{subject} {later}" if later else _UNDEFINED.get(subject, "")
    if code != "IC" or int(subject, 8) < 0o200:
        return ""
    character = chr(int(subject, 8) & 0o177)
    return _LOWER_CASE if character.islower() else _CHARACTERS.get(character, "")


_UNDEFINED = {name[:_SIGNIFICANT]: sentence for name, sentence in _SYMBOLS.items()}
