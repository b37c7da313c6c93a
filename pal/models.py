"""What differs between the models of the PDP-8: 8, 8/S, 8/I, 8/L, 8/E.

A rule is a pattern of words, and what they do on which models. Of a model that a rule does not name the
sources say nothing.

Sources: PDP-8/L Users Handbook 1968; Small Computer Handbook 1970 (8/I, 8/L) and 1972 (8/E); the identify
routines of Kermit-12 and FOCAL-69, which know a model by 7354, 7601 and 7203; M220 and M706 schematics;
SIMH (8/E).
"""

from typing import NamedTuple

MODELS = ("8", "8/S", "8/I", "8/L", "8/E")


class Rule(NamedTuple):
    """What the words of which `word & mask == value` do, by model."""

    mask: int
    value: int
    does: dict[str, str]


_UNDEFINED = "is not defined"
_NOTHING = "does nothing"
_FIELD = "needs the memory extension"

RULES = (
    Rule(0o7416, 0o7002, dict.fromkeys(MODELS, "rotates nothing") | {"8/E": "swaps the halves of AC (BSW)"}),
    Rule(
        0o7416,
        0o7014,
        dict.fromkeys(("8", "8/S"), _UNDEFINED)
        | dict.fromkeys(("8/I", "8/L"), "gives the AND of both rotations")
        | {"8/E": "gives the AND of AC and the word itself"},
    ),
    Rule(
        0o7416,
        0o7016,
        dict.fromkeys(("8", "8/S"), _UNDEFINED)
        | dict.fromkeys(("8/I", "8/L"), "gives the AND of both rotations")
        | {"8/E": "puts an address into AC"},
    ),
    *(
        Rule(
            0o7415,
            0o7001 | rotate,
            dict.fromkeys(("8", "8/S"), _UNDEFINED)
            | dict.fromkeys(("8/I", "8/L", "8/E"), "increments, then rotates"),
        )
        for rotate in (0o10, 0o04)
    ),
    *(
        Rule(
            0o7454,
            0o7040 | rotate,
            dict.fromkeys(("8", "8/I", "8/L", "8/E"), "complements, then rotates") | {"8/S": _UNDEFINED},
        )
        for rotate in (0o10, 0o04)
    ),
    Rule(0o7601, 0o7601, {"8/L": _NOTHING, "8/I": "clears AC", "8/E": "clears AC"}),
    *(
        Rule(
            0o7401 | bit,
            0o7401 | bit,
            dict.fromkeys(("8", "8/I"), "needs the EAE")
            | dict.fromkeys(("8/S", "8/L"), _NOTHING)
            | {"8/E": "uses MQ"},
        )
        for bit in (0o020, 0o100)
    ),
    Rule(
        0o7441,
        0o7441,
        dict.fromkeys(("8", "8/I", "8/E"), "needs the EAE") | dict.fromkeys(("8/S", "8/L"), _NOTHING),
    ),
    *(
        Rule(
            0o7557,
            0o7401 | code,
            dict.fromkeys(("8", "8/I", "8/E"), "needs the EAE") | dict.fromkeys(("8/S", "8/L"), _NOTHING),
        )
        for code in range(0o02, 0o20, 0o02)
    ),
    Rule(0o7777, 0o6000, dict.fromkeys(MODELS, _NOTHING) | {"8/E": "skips if ION, and clears it (SKON)"}),
    *(
        Rule(0o7777, word, dict.fromkeys(MODELS, _UNDEFINED) | {"8/E": on_the_8e})
        for word, on_the_8e in (
            (0o6003, "skips on an interrupt request (SRQ)"),
            (0o6004, "gets the flags (GTF)"),
            (0o6005, "restores the flags (RTF)"),
            (0o6006, "skips on the greater-than flag (SGT)"),
            (0o6007, "clears all flags (CAF)"),
        )
    ),
    *(
        Rule(0o7777, word, dict.fromkeys(MODELS, on_the_others) | {"8/E": on_the_8e})
        for word, on_the_others, on_the_8e in (
            (0o6010, _NOTHING, "enables interrupts of reader and punch (RPE)"),
            (0o6020, _NOTHING, "disables interrupts of reader and punch (PCE)"),
            (0o6030, _NOTHING, "clears the keyboard's flag (KCF)"),
            (0o6033, "skips on the keyboard's flag, then clears it", _UNDEFINED),
            (0o6035, "skips on the keyboard's flag, and reads", "sets the interrupt enable from AC 11 (KIE)"),
            (0o6037, "skips on the keyboard's flag, clears it, and reads", _UNDEFINED),
            (0o6040, _NOTHING, "sets the printer's flag (TFL)"),
            (0o6045, "skips on the printer's flag, and prints", "skips on a request of the Teletype (TSK)"),
        )
    ),
    Rule(
        0o7700,
        0o6200,
        dict.fromkeys(("8", "8/I", "8/E"), _FIELD)
        | {"8/S": _NOTHING, "8/L": "needs the MC8/L for a second field"},
    ),
)


def rules(word: int) -> list[Rule]:
    """Return the rules that `word` falls under."""
    return [rule for rule in RULES if word & rule.mask == rule.value]


def differs(word: int, model: str) -> str:
    """Return what `word` does on `model` and otherwise on others; "" if it does the same on all.

    Raises ValueError for a model that is not one of MODELS.
    """
    if model not in MODELS:
        raise ValueError(f"{model!r} is not one of {', '.join(MODELS)}")
    named = [rule for rule in rules(word) if model in rule.does]
    return "; ".join(sentence for rule in named if (sentence := _sentence(rule, model)))


def _sentence(rule: Rule, model: str) -> str:
    """Return what the words of `rule` do on `model`, and what on the others."""
    here = rule.does[model]
    others: dict[str, list[str]] = {}
    for other, does in rule.does.items():
        if does != here:
            others.setdefault(does, []).append(other)
    elsewhere = ", ".join(f"on {', '.join(models)} it {does}" for does, models in others.items())
    return f"{here} on {model}; {elsewhere}" if elsewhere else ""
