"""What PAL III has instead of what other PDP-8 assemblers know.

Pseudo-operators of MACRO-8, PAL-D and PAL8 are undefined symbols in PAL III, and their operators illegal
characters; so the hint goes with a UA or IC message.

Sources: DEC-08-ASAC-D (what there is); the manuals of MACRO-8, PAL-D and PAL8 (what there is not).
"""

_UNKNOWN = {
    "PAGE": "in PAL III write the origin, as in *400",
    "TEXT": "in PAL III write the codes as numbers, one word each",
    "ZBLOCK": "in PAL III leave the words out with *.+20, or write zeros",
    "DUBL": "in PAL III write both words in octal",
    "FLTG": "in PAL III write the three words in octal",
    "DEFINE": "PAL III has no macros; use a subroutine",
    "XLIST": "PAL III lists everything",
    "EJECT": "PAL III's listing has no pages",
    "NOPUNC": "PAL III punches everything",
    "ENPUNC": "PAL III punches everything",
    "RELOC": "PAL III assembles for where the words are loaded",
    "EQU": "PAL III has =",
    "FILENA": "PAL III knows nothing of files",
    "DEVICE": "PAL III knows nothing of files",
    "DTORG": "PAL III knows nothing of DECtape blocks",
} | dict.fromkeys(
    ("IFDEF", "IFNDEF", "IFZERO", "IFNZRO"), "PAL III assembles everything; keep variants on separate tapes"
)
"""Of each name the first six characters, which count."""
_LATER = (
    "ACL ASR BSW CAF CAM CDF CIF DVI GTF KCF KIE LSR MQA MQL MUY NMI RDF RIB RIF RMF RTF SCA SCL SGT SHL "
    "SKON SRQ SWP TFL TSK"
)
_GROUPS = {"OPR": "7000", "IOT": "6000"}
_CHARACTERS = {
    "!": "PAL III has no ! operator: a space is inclusive OR",
    "&": "PAL III has no & operator",
    "^": "PAL III has no ^ operator",
    "%": "PAL III has no % operator",
    "(": "PAL III has no literals: give the constant a tag and refer to that; or take --dialect pal8",
    "[": "PAL III has no literals: give the constant a tag and refer to that; or take --dialect pal8",
    '"': "PAL III has no character constants: write the code, as in 301 for A",
    "<": "PAL III has no conditional assembly and no macros",
    "@": "PAL III writes an indirect reference with I, as in JMP I 20",
    "#": "PAL III's numbers are octal, or decimal after DECIMAL",
    "'": "PAL III's comments begin with /",
    "?": "a character that is not ASCII is read as ?",
}


def hint(code: str, subject: str) -> str:
    """Return one sentence for the message `code` of `subject` (a symbol, or a character in octal), or ""."""
    if code == "IC":
        character = chr(int(subject, 8) & 0o177)
        capital = "PAL III knows capital letters only"
        return capital if "a" <= character <= "z" else _CHARACTERS.get(character, "")
    if code != "UA":
        return ""
    if subject in _UNKNOWN:
        return f"{subject} is another assembler's: {_UNKNOWN[subject]}"
    if subject in _LATER.split():
        return f"{subject} is not in PAL III's table, being an option's or a later PDP-8's: define it with ="
    if subject in _GROUPS:
        return (
            f"{subject} is not in PAL III's table: write {_GROUPS[subject]}, or {subject}={_GROUPS[subject]}"
        )
    return ""
