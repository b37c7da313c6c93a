"""The scripts of the pages: a fault of names is found without Node.js, one of syntax by it."""

import subprocess
from pathlib import Path

import pytest

from pdp8.web import bundle, names
from tests.pdp8.web.node import NODE, needs_node


@needs_node
@pytest.mark.parametrize("entry", ["workbench", "curve"])
def test_scripts_are_javascript(entry: str, tmp_path: Path) -> None:
    for number, text in enumerate(bundle.scripts(entry)):
        file = tmp_path / f"{number}.js"
        file.write_text(text, encoding="utf-8")
        done = subprocess.run([str(NODE), "--check", str(file)], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ('import { a } from "./b.mjs";\nimport { a } from "./c.mjs";\n', "m: a is declared 2 times"),
        ('import { a } from "./b.mjs";\nexport const a = 1;\n', "m: a is declared 2 times"),
        ('import { d as e } from "./b.mjs";\n', "m: ./b.mjs exports no d"),
        ('import * as x from "./gone.mjs";\n', "m: there is no module ./gone.mjs"),
        ('import * as a from "./b.mjs";\n', ""),
        ('import * as a from "./b.mjs";\nconst a = 1;\n', "m: a is declared 2 times"),
        (
            'import { a as b } from "./b.mjs";\nconst { c, d: a } = b;\nfunction f() {\n  const a = 1;\n}\n',
            "",
        ),
    ],
)
def test_names_are_declared_once_and_imported_from_where_they_are(text: str, said: str) -> None:
    found = names.faults("m", text, {"./b": ["a"], "./c": ["a"]}, by_hand=True)
    assert "; ".join(found) == said


def test_what_is_not_needed_is_left_out() -> None:
    text = (
        "const one = 1;\nexport const two = () => one;\nexport const three = 3;\nlet four;\ntwo.x = four;\n"
    )
    assert names.needed(text, ["two"], []) == text.replace("export const three = 3;\n", "")
    assert names.needed(text.replace("two.x = four;\n", ""), ["three"], []) == "export const three = 3;\n"


def test_of_a_translated_module_what_is_used_is_kept_with_what_it_uses() -> None:
    one, two, three, four = (
        "export function one() {\nlet two;\nreturn {two: 1};\n}\n",
        "export const two = 2;\n",
        "export class Three {\n}\nThree.prototype.one = [...two];\n",
        "export const { four, five } = new Three();\n",
    )
    text = f'import {{ a }} from "./b.mjs";\n{one}{two}{three}{four}'
    kept = {name: names.exported(text, [name]).partition("\n")[2] for name in ("one", "two", "five", "a")}
    assert kept == {"one": one + two, "two": two, "five": two + three + four, "a": ""}
    assert names.mentioned('import { a as b, c as d } from "./e.mjs";\nf(b);\n') == {"a", "b", "f"}
