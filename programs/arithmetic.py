"""The arithmetic of a part program: exact, or that of a machine of its time.

                word            + -              *                /                SQRT         assignment
    exact       rational        exact            exact            exact            see below    exact
    ge635       27 bits, sign   71, truncated    71, truncated    35, truncated    27, rounded  27, truncated
    ieee32      24 bits, sign   24, rounded      24, rounded      24, rounded      24, rounded  as it is
    cdc6400     48 bits, sign   48, truncated    48, truncated    48, truncated    48, rounded  as it is
    pdp8        27 bits, sign   27, see below    27, see below    27, rounded      see below    as it is

A program is written once, with the operators of its listing, over the numbers of any arithmetic:

    ay = store(ay + 1)                          300 20 AY=AY+1.
    ar = store(sqrt(ax**2 + ay**2))             305    AR=SQRT(AX**2+AY**2)

GE-635. Expressions are computed in the register EAQ, an exponent and 71 bits and sign in two's complement.
The operand at the right of an operator comes from memory, so that a right operand which is itself an
expression has been stored on the way. FAD shifts the operand of smaller exponent right inside AQ and loses
what passes its end; FMP keeps the leading 71 bits of the product; FDV makes a quotient of 35 bits, cut as a
magnitude; FST stores the first 27 bits. Cutting a two's complement number goes towards minus infinity. X**2
is a multiplication. SQRT ends with a rounding to a word (FRD) and is exact where the root is.

CDC 6400. Ones' complement, so that cutting goes towards zero. FX adds in 96 bits, aligned to the larger
exponent, and keeps the upper 48 before they are normalised: a difference loses what alignment shifted past
the upper half.

PDP-8, the FLOAT of DEC's 8K FORTRAN II. The smaller operand of + and - is cut to the place of the larger; a
carry out is rounded, half a unit up. A product has a bit more than a word, rounded likewise; the accumulator
begins with the low 24 bits of the multiplier in it, which FLOAT does not clear, so that a product is up to an
eighth of a unit too large, and A*B, compiled as load B and multiply by A, is not B*A. SQRT makes three steps
of Newton's from a first guess by shifting the word.

Not emulated: the range of exponents (nothing here comes near its ends), the CDC's indefinite, IEEE's
infinities. It is not known which of truncating and rounding stores the compiler of 1971 chose; the GE-635 did
both.

Sources: GE-625/635 Programming Reference Manual, CPB-1004 (FAD, FMP, FDV, FST, FRD); Control Data
6400/6500/6600 Computer Systems Reference Manual (floating point arithmetic); IEEE 754; for FLOAT its results,
recorded as it ran on our PDP-8/L.
"""

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from math import floor, isqrt
from typing import Any, Final, Protocol


class Arithmetic(Protocol):
    """The arithmetic of a machine; its numbers have + - * / ** and compare with 0."""

    def real(self, value: float) -> Any:
        """Return the constant `value` as this machine holds it."""

    def store(self, value: Any) -> Any:
        """Return the value that a variable holds after it is assigned `value`."""

    def sqrt(self, value: Any) -> Any:
        """Return SQRT(value), `value` not negative."""


class Exact:
    """Rational arithmetic; a root that is not rational is cut 64 bits after the point.

    The cut changes no test of a part program: a root that differs from a rational r of denominator d does so
    by at least about 1/(2*d*d*r), far more than 2**-64 at the sizes of a part.
    """

    def real(self, value: float) -> Fraction:
        """Return the rational of the decimal digits of `value`."""
        return Fraction(str(float(value)))

    def store(self, value: Fraction) -> Fraction:
        """Return `value`."""
        return value

    def sqrt(self, value: Fraction) -> Fraction:
        """Return the root of `value`, exactly where it is rational."""
        over, under = value.numerator, value.denominator
        root, side = isqrt(over), isqrt(under)
        if root * root == over and side * side == under:
            return Fraction(root, side)
        return Fraction(isqrt((over << 128) // under), 1 << 64)


@dataclass(slots=True, eq=False)
class Float:
    """mantissa * 2**exponent, in a register of `machine`."""

    machine: "FloatingPoint"
    mantissa: int
    exponent: int

    def __add__(self, other: "Float | int") -> "Float":
        return self.machine.add(self, self._operand(other))

    def __sub__(self, other: "Float | int") -> "Float":
        return self.machine.add(self, -self._operand(other))

    def __mul__(self, other: "Float | int") -> "Float":
        return self.machine.multiply(self, self._operand(other))

    def __truediv__(self, other: "Float | int") -> "Float":
        return self.machine.divide(self, self._operand(other))

    def __pow__(self, power: int) -> "Float":
        value, base = self, self.machine.store(self)
        for _ in range(power - 1):
            value = self.machine.multiply(value, base)
        return value

    def __neg__(self) -> "Float":
        return Float(self.machine, -self.mantissa, self.exponent)

    def __le__(self, zero: int) -> bool:
        return self.mantissa <= zero

    def __lt__(self, zero: int) -> bool:
        return self.mantissa < zero

    def __gt__(self, zero: int) -> bool:
        return self.mantissa > zero

    def __int__(self) -> int:
        return int(self.exactly)

    def __float__(self) -> float:
        return float(self.exactly)

    def __floor__(self) -> int:
        return floor(self.exactly)

    @property
    def exactly(self) -> Fraction:
        """The value, exactly."""
        return self.mantissa * Fraction(2) ** self.exponent

    def _operand(self, other: "Float | int") -> "Float":
        return self.machine.store(other) if isinstance(other, Float) else Float(self.machine, other, 0)


def _nearest(mantissa: int, bits: int) -> tuple[int, int]:
    """Round a mantissa to the nearest of `bits`; return it, and how many bits were dropped."""
    dropped = max(0, mantissa.bit_length() - bits)
    if not dropped:
        return mantissa, 0
    rest = mantissa & ((1 << dropped) - 1)
    half = 1 << (dropped - 1)
    kept = mantissa >> dropped
    return kept + (rest > half or (rest == half and kept & 1)), dropped


def _chopped(mantissa: int, bits: int) -> tuple[int, int]:
    """Drop low bits of the magnitude."""
    dropped = max(0, mantissa.bit_length() - bits)
    return _towards_zero(mantissa, dropped), dropped


def _floored(mantissa: int, bits: int) -> tuple[int, int]:
    """Drop low bits of the two's complement number."""
    dropped = max(0, _magnitude_bits(mantissa) - bits)
    return mantissa >> dropped, dropped


def _half_up(mantissa: int, bits: int, least: int = 0) -> tuple[int, int]:
    """Round the magnitude, half a unit up; `least` bits are dropped at the least."""
    dropped = max(least, mantissa.bit_length() - bits)
    kept = (abs(mantissa) << 1 >> dropped) + 1 >> 1
    return kept if mantissa >= 0 else -kept, dropped


class FloatingPoint:
    """Binary floating point: the bits of a result, without sign, and how the rest is cut."""

    word: int
    register: int
    quotient: int
    cut: Callable[[int, int], tuple[int, int]]

    def keep(self, mantissa: int, exponent: int, bits: int) -> Float:
        """Return mantissa * 2**exponent, cut to `bits`."""
        return self._made(exponent, *self.cut(mantissa, bits))

    def _made(self, exponent: int, mantissa: int, dropped: int) -> Float:
        return Float(self, mantissa, exponent + dropped)

    def real(self, value: float) -> Float:
        """Return the word nearest to the decimal digits of `value`."""
        wanted = Fraction(str(value))
        return self._made(-_EXTRA, *_nearest(_quotient(wanted.numerator, wanted.denominator), self.word))

    def store(self, value: Float) -> Float:
        """Return `value` as a word of memory keeps it."""
        return self.keep(value.mantissa, value.exponent, self.word)

    def add(self, a: Float, b: Float) -> Float:
        """Return a + b."""
        if not a.mantissa or not b.mantissa:
            return a if a.mantissa else b
        return self._sum(a, b)

    def _sum(self, a: Float, b: Float) -> Float:
        low = min(a.exponent, b.exponent)
        total = (a.mantissa << (a.exponent - low)) + (b.mantissa << (b.exponent - low))
        return self.keep(total, low, self.register)

    def multiply(self, a: Float, b: Float) -> Float:
        """Return a * b."""
        return self.keep(a.mantissa * b.mantissa, a.exponent + b.exponent, self.register)

    def divide(self, a: Float, b: Float) -> Float:
        """Return a / b."""
        return self.keep(_quotient(a.mantissa, b.mantissa), a.exponent - b.exponent - _EXTRA, self.quotient)

    def sqrt(self, value: Float) -> Float:
        """Return the word nearest to the root of `value` as memory keeps it."""
        mantissa, exponent = _root(self.store(value))
        return self._made(exponent, *_nearest(mantissa, self.word))


class IEEE32(FloatingPoint):
    """IEEE 754 binary32, round to nearest even."""

    word = register = quotient = 24
    cut = staticmethod(_nearest)


class CDC6400(FloatingPoint):
    """The CDC 6400's instructions FX."""

    word = register = quotient = 48
    cut = staticmethod(_chopped)

    def _sum(self, a: Float, b: Float) -> Float:
        """The upper half of a sum of 96 bits."""
        (m, e), (n, f) = sorted((_normal(a, 48), _normal(b, 48)), key=lambda part: -part[1])
        shifted = _towards_zero(n << 48, e - f)
        return self.keep(_towards_zero((m << 48) + shifted, 48), e, 48)


class GE635(FloatingPoint):
    """The GE-635's EAQ and FST."""

    word = 27
    register = 71
    quotient = 35
    cut = staticmethod(_floored)

    def _sum(self, a: Float, b: Float) -> Float:
        """FAD: aligned to the larger exponent inside AQ, then normalised."""
        (m, e), (n, f) = _normal(a, self.register), _normal(b, self.register)
        top = max(e, f)
        return self.keep((m >> (top - e)) + (n >> (top - f)), top, self.register)

    def multiply(self, a: Float, b: Float) -> Float:
        """FMP: the leading bits of the product before normalising."""
        (m, e), (n, f) = _normal(a, self.register), _normal(b, self.word)
        return Float(self, (m * n) >> self.word, e + f + self.word)

    def divide(self, a: Float, b: Float) -> Float:
        """FDV: the quotient's magnitude is cut."""
        quotient = _chopped(_quotient(a.mantissa, b.mantissa), self.quotient)
        return self._made(a.exponent - b.exponent - _EXTRA, *quotient)


class PDP8(FloatingPoint):
    """FLOAT of DEC's 8K FORTRAN II."""

    word = register = 27
    quotient = 28
    cut = staticmethod(_half_up)

    def _sum(self, a: Float, b: Float) -> Float:
        """The smaller cut to the place of the larger."""
        (m, e), (n, f) = _word(a), _word(b)
        top = max(e, f)
        return self.keep(_towards_zero(m, top - e) + _towards_zero(n, top - f), top, self.word)

    def multiply(self, a: Float, b: Float) -> Float:
        """Return a * b: `b` is the multiplier."""
        if not a.mantissa or not b.mantissa:
            return Float(self, 0, 0)
        (m, e), (n, f) = _word(a), _word(b)
        product = 2 * abs(m * n) + (abs(n) & 0o77777777) >> 26
        mantissa, dropped = _half_up(product, self.word, least=1)
        return self._made(e + f + 25, mantissa if m * n > 0 else -mantissa, dropped)

    def divide(self, a: Float, b: Float) -> Float:
        """Return a / b, the quotient of 28 bits or 29 rounded."""
        (m, e), (n, f) = _word(a), _word(b)
        quotient = (abs(m) << self.quotient) // abs(n)
        return self.keep(quotient if m * n > 0 else -quotient, e - f - self.quotient, self.word)

    def sqrt(self, value: Float) -> Float:
        """Return SQRT(value) by three steps of Newton's."""
        if not value.mantissa:
            return value
        m, e = _word(value)
        guess = (_BIAS + e << 27 | m) // 2 + (0o1004 << 24)
        guess += 0 if guess & _HALF else 2 << 24
        root = Float(self, guess & 2 * _HALF - 1, (guess >> 27) - _BIAS)
        for _ in range(3):
            mean = self.add(self.divide(value, root), root)
            root = Float(self, mean.mantissa, mean.exponent - 1)
        return root


EXACT: Final = Exact()

ARITHMETICS: Final[dict[str, Arithmetic]] = {
    "exact": EXACT,
    "ge635": GE635(),
    "ieee32": IEEE32(),
    "cdc6400": CDC6400(),
    "pdp8": PDP8(),
}
"""Every arithmetic by its name."""
WHICH: Final = "the arithmetic of which machine"
"""The help of a part's constant `arithmetic`."""


_HALF: Final = 1 << 26
"""The leading bit of a mantissa of FLOAT."""
_BIAS: Final = 0o200 + 27
"""By how much FLOAT's exponents are greater than Float's."""
_EXTRA: Final = 256
"""Bits that a quotient and a root have behind the point, so that later rounding is exact."""


def _word(value: Float) -> tuple[int, int]:
    """Mantissa of 27 bits and exponent, as FLOAT has them."""
    shift = 27 - value.mantissa.bit_length()
    if shift < 0:  # rounded up to a power of two
        return value.mantissa >> -shift, value.exponent - shift
    return value.mantissa << shift, value.exponent - shift


def _magnitude_bits(mantissa: int) -> int:
    """Bits of a two's complement number, its sign not counted."""
    return max(mantissa, ~mantissa).bit_length()


def _normal(value: Float, bits: int) -> tuple[int, int]:
    """Mantissa and exponent of a value other than 0, shifted left until the mantissa fills `bits`."""
    shift = bits - _magnitude_bits(value.mantissa)
    return value.mantissa << shift, value.exponent - shift


def _towards_zero(mantissa: int, places: int) -> int:
    return mantissa >> places if mantissa >= 0 else -(-mantissa >> places)


def _quotient(over: int, under: int) -> int:
    return (over << _EXTRA) // under


def _root(value: Float) -> tuple[int, int]:
    odd = value.exponent & 1
    return isqrt(value.mantissa << (_EXTRA + odd)), (value.exponent - odd - _EXTRA) // 2
