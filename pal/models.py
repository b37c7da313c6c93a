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
_BOTH = "gives the AND of both rotations"
_EAE = {"8 8/I 8/E": "needs the EAE", "8/S 8/L": _NOTHING}
_MQ = {"8 8/I": "needs the EAE", "8/S 8/L": _NOTHING, "8/E": "uses MQ"}
_OTHERS = "8 8/S 8/I 8/L"

_GROUPS = (
    (0o7416, [0o7002], {_OTHERS: "rotates nothing", "8/E": "swaps the halves of AC (BSW)"}),
    (
        0o7416,
        [0o7014],
        {"8 8/S": _UNDEFINED, "8/I 8/L": _BOTH, "8/E": "gives the AND of AC and the word itself"},
    ),
    (0o7416, [0o7016], {"8 8/S": _UNDEFINED, "8/I 8/L": _BOTH, "8/E": "puts an address into AC"}),
    (0o7415, [0o7011, 0o7005], {"8 8/S": _UNDEFINED, "8/I 8/L 8/E": "increments, then rotates"}),
    (0o7454, [0o7050, 0o7044], {"8 8/I 8/L 8/E": "complements, then rotates", "8/S": _UNDEFINED}),
    (0o7601, [0o7601], {"8/L": _NOTHING, "8/I 8/E": "clears AC"}),
    (0o7421, [0o7421], _MQ),
    (0o7501, [0o7501], _MQ),
    (0o7441, [0o7441], _EAE),
    (0o7557, [0o7403, 0o7405, 0o7407, 0o7411, 0o7413, 0o7415, 0o7417], _EAE),
)
"""Operates: mask, values under it, and what such words do, by models."""

_IOTS = (
    (0o6000, _NOTHING, "skips if ION, and clears it (SKON)"),
    (0o6003, _UNDEFINED, "skips on an interrupt request (SRQ)"),
    (0o6004, _UNDEFINED, "gets the flags (GTF)"),
    (0o6005, _UNDEFINED, "restores the flags (RTF)"),
    (0o6006, _UNDEFINED, "skips on the greater-than flag (SGT)"),
    (0o6007, _UNDEFINED, "clears all flags (CAF)"),
    (0o6010, _NOTHING, "enables interrupts of reader and punch (RPE)"),
    (0o6020, _NOTHING, "disables interrupts of reader and punch (PCE)"),
    (0o6030, _NOTHING, "clears the keyboard's flag (KCF)"),
    (0o6033, "skips on the keyboard's flag, then clears it", _UNDEFINED),
    (0o6035, "skips on the keyboard's flag, and reads", "sets the interrupt enable from AC 11 (KIE)"),
    (0o6037, "skips on the keyboard's flag, clears it, and reads", _UNDEFINED),
    (0o6040, _NOTHING, "sets the printer's flag (TFL)"),
    (0o6045, "skips on the printer's flag, and prints", "skips on a request of the Teletype (TSK)"),
)
"""IOTs: what they do on the others, and what on an 8/E."""

_EXTENSION = {
    "8 8/I 8/E": "needs the memory extension",
    "8/S": _NOTHING,
    "8/L": "needs the MC8/L for a second field",
}

RULES = tuple(
    Rule(mask, value, {model: what for models, what in does.items() for model in models.split()})
    for mask, values, does in (
        *_GROUPS,
        *((0o7777, [word], {_OTHERS: there, "8/E": here}) for word, there, here in _IOTS),
        (0o7700, [0o6200], _EXTENSION),
    )
    for value in values
)


def rules(word: int) -> list[Rule]:
    """Return the rules that `word` falls under."""
    return [rule for rule in RULES if word & rule.mask == rule.value]


def differs(word: int, model: str) -> str:
    """Return what `word` does on `model` and not on others, "" if nothing. Raises ValueError."""
    if model not in MODELS:
        raise ValueError(f"{model!r} is not one of {', '.join(MODELS)}")
    return "; ".join(dict.fromkeys(_sentence(rule, model) for rule in rules(word) if model in rule.does))


def _sentence(rule: Rule, model: str) -> str:
    """Return what the words of `rule` do on `model`, and what on the others."""
    here = rule.does[model]
    others: dict[str, list[str]] = {}
    for other, does in rule.does.items():
        if does != here:
            others.setdefault(does, []).append(other)
    elsewhere = ", ".join(f"on {', '.join(models)} it {does}" for does, models in others.items())
    return f"{here} on {model}; {elsewhere}"
