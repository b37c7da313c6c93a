"""Translate the loop of pdp8/computer/speed/piece.py to C that jumps from each operation to the next.

Cython makes one `switch` of the operations, and the compiler one jump of the switch. A processor predicts a
jump by where it stands: with one behind every operation, it knows which operations follow which in the PDP-8
program. That is up to twice as fast (benchmarks/README.md). GNU C and Clang have such jumps; for others it is
a switch.

The names of the operations become an enum. The function holds assignments to integers and elements, `if`,
`break`, `min` of two, and one loop:

    while LIVE:                 #define NEXT  if (!LIVE) goto ended; op = ...; x = ...; goto *labels[op]
        op = ...
        x = ...
        if op == TAD_X:         operation_1:
            ...                     ... NEXT
        elif op == DCA_X:       operation_2:
            ...                     ... NEXT
        else:
            break               ended:

The function is translated twice, `execute_across` with all its parameters; in `execute` what is in SAME is
the parameter that it names. What has no translation is an error. setup.py calls this.
"""

import ast
from collections.abc import Iterator
from copy import deepcopy
from pathlib import Path

OPERATORS: dict[type[ast.AST], str] = {
    ast.Add: "+",
    ast.Sub: "-",
    ast.Mult: "*",
    ast.FloorDiv: "/",
    ast.BitAnd: "&",
    ast.BitOr: "|",
    ast.BitXor: "^",
    ast.LShift: "<<",
    ast.RShift: ">>",
    ast.And: "&&",
    ast.Eq: "==",
    ast.Lt: "<",
    ast.Gt: ">",
    ast.GtE: ">=",
}
TYPES = {
    "int": "int64_t ",
    "list[int]": "int64_t *",
    "MutableSequence[int]": "uint16_t *",
    "bytes": "const unsigned char *",
}
"""Of the parameters, by their annotations."""
LABELS = 32
"""As many operations have room."""
SAME = {"data": "core", "data_ops": "ops"}


class _Same(ast.NodeTransformer):
    """Puts the parameter that another one is the same as in its place."""

    def visit_FunctionDef(self, node: ast.FunctionDef) -> ast.FunctionDef:
        node.args.args = [each for each in node.args.args if each.arg not in SAME]
        self.generic_visit(node)
        return node

    def visit_Name(self, node: ast.Name) -> ast.Name:
        return ast.Name(SAME.get(node.id, node.id), node.ctx)


def translate(source: Path) -> str:
    """Return the C of the function `execute` in `source`. Raises ValueError for what has no translation."""
    tree = ast.parse(source.read_text())
    functions = [node for node in tree.body if isinstance(node, ast.FunctionDef)]
    across = next(node for node in functions if node.name == "execute")
    within = _Same().visit(deepcopy(across))
    across.name += "_across"
    constants = dict(_constants(tree))
    lines = [
        f"/* Translated from {source.name} by release/threaded.py. */",
        "#include <stdint.h>",
        "#ifdef __GNUC__",
        "#define JUMP goto *labels[op];",
        "#else",
        "#define JUMP goto jump;",
        "#endif",
        f"enum {{ {', '.join(f'{name} = {number}' for name, number in constants.items())} }};",
    ]
    return "\n".join([*lines, *_function(within, constants), *_function(across, constants), ""])


def _function(function: ast.FunctionDef, constants: dict[str, int]) -> Iterator[str]:
    """Yield the lines of the C of `function`."""
    place, loop = next((i, node) for i, node in enumerate(function.body) if isinstance(node, ast.While))
    *fetch, branches = loop.body
    operations = dict(_operations(branches, constants))
    names = {node.id for node in ast.walk(function) if isinstance(node, ast.Name) and _is_set(node)}
    yield "#undef NEXT"
    yield f"#define NEXT if (!{_expression(loop.test)}) goto ended; {' '.join(_statements(fetch))} JUMP"
    yield f"static int {function.name}({', '.join(_parameters(function))}) {{"
    yield f"int64_t {', '.join(sorted(names))};"
    yield from _statements(function.body[1:place])  # the first is the docstring
    yield "#ifdef __GNUC__"
    yield f"static void *labels[] = {{{', '.join('&&' + _label(i, operations) for i in range(LABELS))}}};"
    yield "NEXT"
    yield "#else"
    yield "NEXT"
    yield "jump: switch (op) {"
    yield from (f"case {number}: goto {_label(number, operations)};" for number in operations)
    yield "default: goto ended; }"
    yield "#endif"
    for number, body in operations.items():
        yield f"{_label(number, operations)}:"
        yield from _statements(body)
        yield "NEXT"
    yield "ended:"
    yield from _statements(function.body[place + 1 :])
    yield "}"


def _constants(tree: ast.Module) -> Iterator[tuple[str, int]]:
    """Yield name and number of each constant of a file."""
    for node in tree.body:
        match node:
            case ast.Assign([ast.Name(name)], ast.Constant(int(number))):
                yield name, number
            case ast.Assign([ast.Tuple(names)], ast.Tuple(numbers)):
                yield from zip(map(ast.unparse, names), map(ast.literal_eval, numbers), strict=True)


def _operations(node: ast.stmt, numbers: dict[str, int]) -> Iterator[tuple[int, list[ast.stmt]]]:
    """Yield number and statements of each branch of `if op == TAD_X: ... elif ...: ... else: break`."""
    match node:
        case ast.If(ast.Compare(ast.Name("op"), [ast.Eq()], [ast.Name(name)]), body, [following]) if (
            numbers.get(name, LABELS) < LABELS
        ):
            yield numbers[name], body
            yield from _operations(following, numbers)
        case ast.Break():
            pass
        case _:
            raise ValueError(f"{ast.unparse(node)}: not an operation")


def _label(number: int, operations: dict[int, list[ast.stmt]]) -> str:
    return f"operation_{number}" if number in operations else "ended"


def _parameters(function: ast.FunctionDef) -> Iterator[str]:
    for parameter in function.args.args:
        kind = ast.unparse(parameter.annotation) if parameter.annotation else "no type"
        if kind not in TYPES:
            raise ValueError(f"{parameter.arg}: {kind}: no translation")
        yield TYPES[kind] + parameter.arg


def _is_set(name: ast.Name) -> bool:
    return isinstance(name.ctx, ast.Store)


def _statements(nodes: list[ast.stmt]) -> Iterator[str]:
    for node in nodes:
        yield from _statement(node)


def _statement(node: ast.stmt) -> Iterator[str]:
    match node:
        case ast.Assign([target], value):
            yield f"{_expression(target)} = {_expression(value)};"
        case ast.AugAssign(target, operator, value):
            yield f"{_expression(target)} {_operator(operator)}= {_expression(value)};"
        case ast.If(test, body, otherwise):
            yield f"if ({_expression(test)}) {{"
            yield from _statements(body)
            yield "} else {"
            yield from _statements(otherwise)
            yield "}"
        case ast.Break():
            yield "goto ended;"
        case ast.Return(value) if value:
            yield f"return (int){_expression(value)};"
        case _:
            raise ValueError(f"{ast.unparse(node)}: no translation")


def _expression(node: ast.expr) -> str:
    match node:
        case ast.Name(name):
            return name
        case ast.Constant(int(value)):
            return str(value)
        case ast.Subscript(array, index):
            return f"{_expression(array)}[{_expression(index)}]"
        case ast.BinOp(left, operator, right) | ast.Compare(left, [operator], [right]):
            return f"({_expression(left)} {_operator(operator)} {_expression(right)})"
        case ast.BoolOp(operator, values):
            return f"({f' {_operator(operator)} '.join(_expression(value) for value in values)})"
        case ast.Call(ast.Name("min"), [one, other]):
            return f"({_expression(one)} < {_expression(other)} ? {_expression(one)} : {_expression(other)})"
        case _:
            raise ValueError(f"{ast.unparse(node)}: no translation")


def _operator(operator: ast.AST) -> str:
    if type(operator) not in OPERATORS:
        raise ValueError(f"{type(operator).__name__}: no translation")
    return OPERATORS[type(operator)]
