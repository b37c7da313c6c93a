"""Every message and note, in one table for both dialects: what is wrong, and what to do.

A line has a key, what is wrong, and, after a bar or on the next line, what to do. The key is DEC's code of a
message, or our code of a note, which never changes; a word follows it where one code has several texts.
`worded` fills in the values in braces. docs/notes.md explains each note; `pal.dialects` has the hints on
other assemblers' names, `pal.models` the differences between models.

Sources: DEC-08-ASAC-D, "Diagnostics", and DEC's PAL8 V10D have the codes; the sentences are ours.
"""

from typing import NamedTuple

STOPPED = "PS01"
"""PAL III cannot continue."""
UNLOADABLE = "PS02"
"""No loader can load the tape."""

NOT_OCTAL, COLON, NO_SLASH, MEANT, DIALECT = "PN05", "PN31", "PN32", "PN33", "PN36"

_OF_PAL3 = """\
DT             duplicate tag: {name} keeps the value it has | use another name
IC             illegal character {character}: PAL III passes over it
IC figure      illegal character: the digit {figure} after a letter in a number
IC letter      illegal character: the letter {letter} in a number | a symbol begins with a letter
IC lost        so many letters in a number that PAL III loses its way | a symbol begins with a letter
IR             illegal reference: {address} is neither on page zero nor on the page of {location}
               {used} is used; go through a pointer on this page, with I
IR negative    illegal reference: {address} is neither on page zero nor on the page of {location}
               {used} is used; a negative number is referred to by a tag, as in M5, -5
RD             redefinition: {name} has a value already and takes the new one | use another name
ST             symbol table full: no place for {name}, and no tape | use fewer symbols
UA             undefined: {name} is taken as {value}, the last address of its page
               define it with {name}, or {name}=
UA EQU         undefined: {name} is taken as {value}, the last address of its page
               PAL III has no EQU: in line {line} write {name}=
UA tag         undefined: {name} is taken as {value}, the last address of its page
               if it is the tag of line {line}, write {name}, there
PS01           {why}
PS01 name      {why} | {name} is PAL III's own; give it another name
PS01 ZBLOCK    ZBLOCK makes far more words than 32K of core has | write it once for the same words
PS02 DTORG     no loader can load this tape: DTORG punches a block number
               leave DTORG out: it is for DEC's typesetting
PS02 RELOC     no loader can load this tape: it begins without an origin, as RELOC is still on at the end
               end the source with RELOC, or begin it with an origin, as in *200
"""

_OF_PAL8 = """\
BE             too many literals within literals | DEC's PAL8 takes six in each other
IC after       an operator after another | write one between two terms
IC *           * multiplies nothing: it begins an origin | ^ multiplies
IC )           ) closes nothing | take it away
IC ]           ] closes nothing | take it away
IC >           > closes no condition | take it away
IC ,           , not directly after a tag | write one comma, directly after the tag
IC =           = not directly after a symbol | write the symbol, and = without a blank
IC :           illegal character : | a tag ends with a comma
IC <           < is missing after the condition | write it on the same line
IC "           no character after " | write it directly after, as in "A
IC beside      {token} after a blank, which is an operator itself (OR) | leave no blank beside {token}
IC blank       a blank after an operator | leave no blank: it is one itself (OR)
IC no-break    a no-break space, which is no blank | write a blank
IC other       {character} does not belong here | DEC's PAL8 passes over it
IC tag         {word} is no tag | a tag begins with a letter
IC number      the letter {letter} in the number {word} | a symbol begins with a letter
IC reference   no operator before {token} | a memory reference comes first in its word
IC token       {token} does not belong here | write an operator, or a blank, between two terms
IC missing     something is missing here | write a symbol, a number, or a literal
IC address     no address after {name}, which is no name | write an address
IC Teletype    the Teletype has no {character} | write another
IC octal       the digit {figure} in the octal number {number} | after DECIMAL it is one
IC asked       {name} without a symbol | write it so: {name} A <statements>
IC FIXMRI      FIXMRI without a definition | write it so: FIXMRI NAME=5000
IC TEXT        a character that TEXT cannot have, as a TAB is | write a blank, or the code as a number
ID             duplicate tag: {name} is {value} already | each tag has one place, use another name
ID mark        {name} is no tag: it marks a memory reference | give the tag another name
ID moved       {name} is {value} from pass 1 and is at {location} in pass 2
               something before it depends on what is defined after it; define that first
IE             {name} gets no value: it is undefined | define it first
II             indirect twice | write one I
II link        {address} is not on the page of {location}, and a link cannot be indirect
               put a pointer on this page or on page zero
IP             the pseudo-operator {name} within an expression | a pseudo-operator begins its statement
IP asked       {name} is a pseudo-operator, and defined | ask for another symbol
IZ             Z with an address that is not on page zero, {address} | leave out Z
PE             this page is full: words up to {words}, literals from {literals}
               put less on the page; if it is an overlay, --w forgets what was there before
PH             a condition without its end | write > after what is left out
RD permanent   {name} is a permanent symbol, {value}, and is {now} from here on | use another name
UO             the origin is undefined here, and taken for 0000 | define it before
US             undefined: {name} | define it with {name}, or {name}=
US elsewhere   undefined: {name} | {instead}
US EQU         undefined: {name} | PAL8 has no EQU: write {name}=
US tag         undefined: {name} | if it is a tag, write {name},
ZE             page zero is full: words up to {words}, literals from {literals}
               put less on the page; if it is an overlay, --w forgets what was there before
"""

_OF_NOTES = """\
PN01 devices   {names} is {word}, neither of them | write them as two instructions
PN01 groups    {names} is {word}: {one} and {other} are of different groups | write them as two instructions
PN01 skips     {names} is {word}: of two opposite skips one is turned round | write them as two instructions
PN01 rotates   {names}: a word rotates once | write them as two instructions
PN02           {address} has a word already; the later one is loaded over it
               set the origin where nothing is loaded
PN03           text after $ is not read | put the $ at the end
PN04           {number} does not fit into twelve bits: it is {word} | the most is 7777 octal, 4095 decimal
PN04 PAL8      {number} does not fit into twelve bits: it is {word} | write it so: {octal} octal
PN05           {number} is octal here, and has an 8 or a 9 | DECIMAL before it makes it decimal
PN06           the program runs on from {before} into data at {target} | end what comes before with JMP or HLT
PN07           JMS stores the return address over the instruction at {target}
               a subroutine begins with a word of 0
PN08           JMP to {target} runs the return address; a return is JMP I | write I to go where the word says
PN09           {name} is the same symbol as {first}: six characters count
               let names differ in their first six characters
PN10           what comes before this comma is part of the word
               a space puts even the tag there; write the tag first, the comma directly after it
PN11           no symbol comes before this {mark}
               PAL III takes the symbol it looked up last; write the symbol directly before
PN12           what comes before the equals sign, {word}, is part of the value
               a space puts even the symbol there; write the equals sign directly after it
PN13           {name} at the end of a statement leaves no word | put it on its own line
PN13 Z         {name} at the end of a statement leaves no word | write Z before the address
PN14           Z makes this refer to {target} on page zero | for {address}, on this page, leave out Z
PN15           what comes before {name} is part of its address
               write what belongs to the address after the instruction, and nothing else beside it
PN16           I without a memory-reference symbol makes an AND | write the instruction before I
PN17           this makes an inclusive OR of it
               a space is an operator too, and the last one counts; leave no space after + or -
PN18           the {sign} is used for {name} and for the location
               write the location first, or a space before the point
PN19           what comes before it, {word}, is part of the operand | put it on its own line
PN19 name      {name} before the asterisk has no effect | put the origin on its own line
PN20           {name} takes {what} | write a space and the operand after {name}
PN21           FIXMRI makes {name} a memory reference, whatever it defines
               use it for the first definitions after EXPUNGE
PN22           EXPUNGE forgets the symbols that the source has used before | put it first
PN22 FIXMRI    with EXPUNGE and no FIXMRI every symbol is a memory reference
               define the memory references first after EXPUNGE, each with FIXMRI
PN23           FIXTAB keeps what is not defined yet: {names}
               it is in no symbol table and gets no UA; put FIXTAB after the definitions
PN24           this is {word} on the tape and {listed} in the listing
               each pass assigns again, with the values that the last one left
PN25           {name} is {value} from pass 1 and is at {location} in pass 2
               an origin depends on a symbol that is defined after it; define it first
PN26           what follows PAUSE on its line is lost | end the line after PAUSE
PN27           no $ at the end | PAL III would wait for more tape; it is taken as if there were one
PN27 PAL8      no $ at the end | DEC's PAL8 supplies it; palbart asks for it
PN27 empty     the source is empty | write at least a $
PN27 lost      what comes before this $ is lost | put the $ on its own line
PN27 tapes     {tapes} not read | $ ends the source; a tape that others follow ends with PAUSE
PN28           a line of {length} characters: pass 3 takes {longest}
               the tape is good, the listing is not; break the line
PN29           the symbol table is just full: in the listing {name} is 0212
               the buffer of pass 3 begins at its value; use one symbol fewer
PN30           {name} is a permanent symbol, and keeps its value | give the tag another name
PN30 value     {name} is a permanent symbol, and has another value from here on | give the symbol another name
PN30 PAL8      {name} is a permanent symbol, {value}, and becomes the source's
               DEC's PAL8 keeps the old value (ID)
PN31           a colon ends no tag in PAL III | write a comma after a tag, as in A,
PN31 PAL8      a colon ends no tag | write a comma: {name},
PN32           this reads as text | a comment begins with a slash
PN33           {name} is not defined: did you mean {other}?
PN34           {name} is not in PAL III's table; it is {octal} | define it: {name}={octal}
PN35           small letters are illegal characters in PAL III: {count} of them
               `pal --modern` reads them as capitals
PN35 PAL8      small letters are capitals here; DEC's PAL8 passes over them (IC) | write capitals
PN35 TEXT      small letters, which DEC's PAL8 leaves out (IC) | write capitals: six bits have no others
PN36           assembled as PAL8: in PAL III it has errors
               --dialect pal8 says so, --dialect pal3 keeps to PAL III
PN36 other     in {dialect} this has no error: --dialect {option}
PN37           {name}, {octal}, is no instruction of a PDP-8/L | it does nothing there, or something else
PN37 field     {octal} is for field {field}, which a PDP-8/L of 4K lacks | without the MC8/L it does nothing
PN38           {octal} {differs} | a program for all models does without
PN39           the program runs on from {before} to {target}, where nothing is loaded | end it with HLT or JMP
PN40           this waits for the printer's flag, which no TLS has raised | write TLS before it
PN41           {name} was {value}, and is {now} from here on
               a use before its first definition sees the last value
PN42           this is {value}; palbart, where a blank comes last, makes {other}
               put no other operator after a blank
PN43           a TAB after " is 0211; palbart makes 0240 | write 211
PN44           DEC's PAL8 takes this {mark} for the end of the statement | leave a blank after TEXT
PN45           {value} divided by {by} is {quotient}, without signs | palbart divides with signs
PN45 zero      division by 0 makes 0; palbart crashes
PN46           the literal {value} is stored again: the source has left this page before
               palbart finds it; keep a page in one piece
PN47           {name}, {octal}, is palbart's; in DEC's PAL8 it is undefined (US) | define it: {name}={octal}
PN48           DEC's PAL8 ends the file at PAUSE; here the rest is read
PN49           {name}, which is defined below, is defined here in pass 2
               palbart takes it for undefined; define it before
PN50           this $ is left out by a condition | palbart ends the condition here
PN51           this refers to the word at {address} | for a number write a literal, as in TAD (-5
PN52           a / begins a comment here | % divides
PN53           there is no page {page}: this is page {taken}
               a field has pages 0 to 37; FIELD goes to another
PN54           TEXT without a text is one word of 0 | write it so: TEXT /LETTERS/
PN54 name      no name: the words are 0 | write it so: DEVICE SYS
PN54 end       {mark} does not come again: the text goes to the end of the line
               a text ends with the character it begins with
PN55           a line of {length} characters; DEC's PAL8 reads {most}, and loses code here | break the line
PN57           DEC's loaders are in 7612 to 7777, and BIN overwrites itself with this | put it below 7600
PN58           no TSF waits for the printer, which loses what comes while it prints
               write TSF, JMP .-1 after the TLS, or before it
PN59           this waits for device {device}, which no PDP-8/L has | KSF waits for a key, TSF for the printer
PN60           an interrupt goes to 0001, where nothing is loaded | put the handler there, or a JMP to it
"""


class Worded(NamedTuple):
    """What is said: the code, what is wrong, and what to do or ""."""

    code: str
    message: str
    advice: str


def _table(text: str) -> dict[str, tuple[str, str]]:
    """Return {key: (what is wrong, what to do)} of the lines of a table."""
    table: dict[str, tuple[str, str]] = {}
    key = message = ""
    for line in text.split("\n"):
        if line.startswith(" "):
            table[key] = (message, line.strip())
        elif line:
            key, _, rest = line.partition("  ")
            message, _, advice = rest.strip().partition(" | ")
            table[key] = (message, advice)
    return table


MESSAGES = _table(_OF_PAL3 + _OF_PAL8 + _OF_NOTES)


def worded(key: str, **values: str) -> Worded:
    """Return an entry of the table, with `values` in place of the names in braces."""
    message, advice = MESSAGES[key]
    return Worded(key.partition(" ")[0], _filled(message, values), _filled(advice, values))


def _filled(text: str, values: dict[str, str]) -> str:
    pieces = text.split("{")
    filled = pieces[0]
    for piece in pieces[1:]:
        name, _, after = piece.partition("}")
        filled += values[name] + after
    return filled
