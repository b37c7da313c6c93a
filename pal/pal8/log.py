"""What PAL8 says of a source: DEC's messages, notes of ours, and the places that they are about."""

from typing import NamedTuple

from pal.messages import Worded, worded
from pal.notes import Mention, Note, note
from pal.pal8.lexer import Lexer, is_operator


class Fatal(Exception):
    """PAL8 stops without a tape."""


class Complaint(NamedTuple):
    """A message of DEC's: its code and location as typed; the pass; our place; the sentence and advice."""

    code: str
    location: str
    number: int
    at: int
    about: str
    advice: str


class Log:
    """Collects what is said, each with its place in the source and in core.

    number      the pass
    location    where the next word goes
    tag         the last tag, from which DEC's messages count; `tag_at`, its location
    misread     whether the statement as a whole was reported, so that its illegal characters are not
    places      [(line, first column, the one after)]: what complaints, notes and words refer to
    complaints  DEC's messages of both passes, in order
    faults      why no loader can load the tape
    notes       what DEC's or palbart does otherwise
    mentions    where each symbol is used or defined
    """

    def __init__(self, lexer: Lexer) -> None:
        self._lexer = lexer
        self.number = 0
        self.location = 0
        self.forget_tag()
        self.misread = self._has_illegal = False
        self.places: list[tuple[int, int, int]] = []
        self.complaints: list[Complaint] = []
        self.faults: list[Note] = []
        self.notes: list[Note] = []
        self.mentions: list[Mention] = []

    def begin_statement(self) -> None:
        """Start a statement without messages."""
        self.misread = self._has_illegal = False

    def forget_tag(self) -> None:
        """Let messages name the location instead of the last tag."""
        self.tag = ""
        self.tag_at = 0

    def keep(self, start: int, end: int) -> int:
        """Keep a place in the line; return its number."""
        self.places.append((self._lexer.index, start, end))
        return len(self.places) - 1

    def keep_word(self, start: int) -> int:
        """Keep the place of a word, from a column to the token, where it is needed: in pass 2."""
        return self.keep(start, self._lexer.before) if self.number == 2 else 0

    def line(self, index: int) -> int:
        """Keep a whole line as a place; return its number."""
        self.places.append((index, 0, len(self._lexer.lines[index].text)))
        return len(self.places) - 1

    def mention(self, name: str, start: int, end: int, defined: bool) -> None:
        """Keep a use of a symbol, in pass 2."""
        if self.number == 2:
            self.mentions.append(Mention(name, self.keep(start, end), defined))

    def say(self, key: str, start: int = -1, **values: str) -> None:
        """Type a message of DEC's on what was read since column `start`, or on the token."""
        self.complain(worded(key, **values), start)

    def complain(self, said: Worded, start: int = -1) -> None:
        """Type a message; of the illegal characters of a statement only the first has a sentence."""
        code, about, advice = said
        if self.number == 1 and code in ("IE", "PE", "ZE"):
            return
        location = f"{self.location:04o}"
        if self.tag:
            distance = self.location - self.tag_at & 0o7777
            location = f"{self.tag}+{distance:04o}" if distance else self.tag
        if code == "IC":
            about = "" if self._has_illegal else about
            self._has_illegal = True
        self.complaints.append(Complaint(code, location, self.number, self._since(start), about, advice))

    def die(self, key: str) -> None:
        """Type a message and raise Fatal."""
        self.say(key)
        raise Fatal(key)

    def note(self, key: str, start: int = -1, **values: str) -> None:
        """Add a note, in pass 2, on what was read since column `start`, or on the token."""
        if self.number == 2:
            self.notes.append(note(key, self._since(start), **values))

    def _since(self, start: int) -> int:
        lexer = self._lexer
        if start < 0:
            return self.keep(lexer.start, max(lexer.end, lexer.start + 1))
        return self.keep(start, max(lexer.before, start + 1))

    def drop(self, after_reference: bool) -> None:
        """Skip an illegal token and report IC for each of its characters."""
        self.complain_of_token(self._illegal(self._lexer.token, after_reference))
        self._lexer.skip()

    def complain_of_token(self, said: Worded) -> None:
        """Type a message for each character of the token."""
        for _ in range(1 if self._lexer.first == '"' else len(self._lexer.token)):
            self.complain(said)

    def _illegal(self, token: str, after_reference: bool) -> Worded:
        """Return the message for a token that is illegal here."""
        if self.misread:
            return Worded("IC", "", "")
        lexer = self._lexer
        start = lexer.start
        text = lexer.text()
        if is_operator(token[0]):
            return worded("IC after" if start == lexer.before else "IC beside", token=token)
        if text[start : start + 1] == "\xa0":
            return worded("IC no-break")
        if token in ("*", ")", "]", ">", ",", "=", ":"):
            return worded(f"IC {token}")
        if not token[0].isalnum():
            return worded("IC other", character=text[start : start + 1])
        if lexer.before == start and text[start - 1 : start].isdigit() and not token[0].isdigit():
            word = text[len(text[:start].rstrip("0123456789")) : lexer.end]
            if text[lexer.end : lexer.end + 1] == ",":
                return worded("IC tag", word=word)
            return worded("IC number", letter=token[0], word=word)
        return worded("IC reference" if after_reference else "IC token", token=token)
