"""An assembly as JSON, for editors and other programs.

    {"words": {"0200": "7200", ...}, "symbols": {"A": "0200", ...},
     "lines": [{"file": "a.pal", "line": 2, "address": "0200", "word": "7200", "source": "A,\\tCLA"}, ...],
     "diagnostics": [{"code": "IR", "message": ..., "file": ..., "line": ..., "column": ..., ...}]}

Words and addresses are octal, as text; addresses beyond 7777 have the field as fifth digit.
"""

import json

from pal.assembly import Assembly


def as_json(assembly: Assembly) -> str:
    """Return the assembly as a JSON text."""
    content = {
        "words": {f"{address:04o}": f"{word:04o}" for address, word in assembly.words.items()},
        "symbols": {name: f"{value:04o}" for name, value in assembly.symbols.items()},
        "lines": [
            {
                "file": assembly.names[line.tape],
                "line": line.number,
                "address": None if line.address is None else f"{line.address:04o}",
                "word": None if line.word is None else f"{line.word:04o}",
                "source": line.source,
            }
            for line in assembly.lines
        ],
        "diagnostics": [diagnostic._asdict() for diagnostic in assembly.diagnostics],
    }
    return json.dumps(content, indent=1) + "\n"
