"""Expressions over the stopped machine, for conditions, log messages and watched expressions.

    AC == 7402 && COUNT > 5         registers; a symbol is the word at its address
    core[CHK+1] & 7000              the word at an address; in the brackets a symbol is its address
    {AC} at {core[17]}              a log message: expressions in braces

Numbers are octal. Operators are those of C: || && ! == != < <= > >= + - & |. A sum has 12 bits; a comparison
is 1 or 0.
"""

import ast
import operator
import re
from collections.abc import Callable

from pdp8.monitor import debugging
from pdp8.monitor.arguments import MonitorError, octal
from pdp8.monitor.prompt import Monitor

Value = Callable[[], int]
"""An expression that was read: called, it gives what it is now."""

_TOKEN = re.compile(r"\s*(?:([0-9]+)|([A-Za-z][A-Za-z0-9]*)|(&&|\|\||[=!<>]=|[-+&|<>!()\[\]]))")
_OPERATORS = "&& || ! == != < <= > >= + - & |"
_WORDS = {"&&": " and ", "||": " or ", "!": " not "}
_MADE: dict[type[ast.AST], Callable[[int, int], int]] = {
    ast.Add: operator.add, ast.Sub: operator.sub, ast.BitAnd: operator.and_, ast.BitOr: operator.or_,
    ast.Eq: operator.eq, ast.NotEq: operator.ne, ast.Lt: operator.lt, ast.LtE: operator.le,
    ast.Gt: operator.gt, ast.GtE: operator.ge,
}  # fmt: skip
_BRACED = re.compile(r"\{([^{}]*)\}")


def read(text: str, monitor: Monitor) -> Value:
    """Return the expression that `text` is. Raises MonitorError, saying what it cannot be."""
    try:
        tree = ast.parse(_python(text, monitor.machine.memory - 1), mode="eval").body
    except (SyntaxError, RecursionError, MemoryError):
        raise MonitorError(f"{text}: an expression such as AC == 17 && core[CHK] != 0 was expected") from None
    return _value(tree, text, monitor, False)


def message(text: str, monitor: Monitor) -> Callable[[], str]:
    """Return a function that fills octal values into a log message. Raises MonitorError."""
    pieces = _BRACED.split(text)
    values = [read(piece, monitor) for piece in pieces[1::2]]

    def made() -> str:
        shown = [f"{value():04o}" for value in values]
        return "".join(a + b for a, b in zip(pieces[::2], [*shown, ""], strict=True))

    return made


def _python(text: str, most: int) -> str:
    """Return the expression in Python's words. Raises MonitorError for a sign that none has, a number beyond
    `most`.
    """
    found, at = [], 0
    while at < len(text.rstrip()):
        token = _TOKEN.match(text, at)
        if token is None:
            raise MonitorError(f"{text}: {text[at:].strip()[:1]} is not an operator; there are {_OPERATORS}")
        number, name, sign = token.groups()
        found.append(
            f"0o{octal(number, most):o}" if number else f"_{name}" if name else _WORDS.get(sign, sign)
        )
        at = token.end()
    return " ".join(found).strip()


def _value(node: ast.expr, text: str, monitor: Monitor, address: bool) -> Value:
    """Return a node's value, or a symbol's address if `address` is wanted."""
    match node:
        case ast.Constant(value=int(number)):
            return lambda: number
        case ast.Name(id=name):
            return _named(name[1:], monitor, address)
        case ast.Subscript(value=ast.Name(id="_core"), slice=inner):
            at, core = _value(inner, text, monitor, True), monitor.machine
            return lambda: core.core[at()]
        case ast.BinOp(left, sign, right):
            one, other = (_value(each, text, monitor, address) for each in (left, right))
            made = _MADE[type(sign)]
            joins = isinstance(sign, ast.BitAnd | ast.BitOr)
            most = monitor.machine.memory - 1 if address or joins else 0o7777
            return lambda: made(one(), other()) & most
        case ast.Compare(left, [sign], [right]):
            one, other = (_value(each, text, monitor, address) for each in (left, right))
            made = _MADE[type(sign)]
            return lambda: int(made(one(), other()))
        case ast.UnaryOp(op=ast.Not(), operand=operand):
            of = _value(operand, text, monitor, address)
            return lambda: int(not of())
        case ast.BoolOp(op, values):
            parts, joined = [_value(each, text, monitor, address) for each in values], _JOINED[type(op)]
            return lambda: int(joined(bool(part()) for part in parts))
    raise MonitorError(f"{text}: an expression such as AC == 17 && core[CHK] != 0 was expected")


_JOINED: dict[type[ast.boolop], Callable[..., bool]] = {ast.And: all, ast.Or: any}


def _named(name: str, monitor: Monitor, address: bool) -> Value:
    machine = monitor.machine
    symbol = monitor.listing.symbols.get(name.upper()[:6])
    if symbol is None and debugging.is_register(monitor, name):
        debugging.value(machine, name)
        return lambda: debugging.value(machine, name)
    if symbol is None:
        raise MonitorError(f"{name}: neither a register nor a symbol of the program")
    return (lambda: symbol) if address else (lambda: machine.core[symbol])
