"""What TypeScript reads of a translated module, line by line."""

from pdp8.web.translator.declarations import declare

SOURCE = '''
"""A module."""
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import ClassVar, NamedTuple, NoReturn, Protocol
from m.other import Thing

LIMIT = 7
NAMES: dict[str, list[int]] = {}

class Place(NamedTuple):
    """A place."""
    x: int
    y: float = 0.0

@dataclass(frozen=True)
class Tape:
    frames: bytes
    name: str | None = None

    @property
    def length(self) -> int:
        return len(self.frames)

class Wrong(ValueError):
    pass

class Machine:
    def __init__(self, core: list[int], say: Callable[[str], None]) -> None:
        self.core = core
        self._own = 1
        self.thing: Thing | None = None

    def run(self, seconds: float = 1.0, *, hard: bool = False) -> None:
        self.core = []

    def _hide(self) -> None:
        self.core = []

    def pairs(self) -> Iterator[tuple[int, str]]:
        yield 1, "a"

def row(of: Sequence[Place], more: set[str], dots: tuple[int, ...]) -> tuple[Place, ...]:
    return tuple(of)

def all_kinds(
    a: bytearray, b: array, c: SupportsInt, d: bool, e: range, f: re.Pattern[str], g: Iterable[int],
    h: Collection[int], i: object, j: list[int | None], k: "Callable[[], Machine]", new: int = 1, *rest: int,
    at: int = 2, sized: Sized | None = None, **more: float,
) -> NoReturn:
    raise Wrong

class Code(IntEnum):
    MILL = 6
    READ = 9

class Colour(StrEnum):
    RED = "red"

class Named(Protocol):
    colour: Colour
    def get(self, at: int) -> Place: ...

class Later(Machine):
    LIMIT: ClassVar[int] = 5
    def __len__(self) -> int:
        return 1

    def __str__(self) -> str:
        return ""

    def __iter__(self) -> Iterator[int]:
        yield 1

    def __getitem__(self, at: int) -> int:
        return at

    def __setitem__(self, at: int, value: int) -> None: ...

    @staticmethod
    def made() -> "Later":
        return Later([], print)

    @property
    def at(self) -> int:
        return 1

    @at.setter
    def at(self, value: int) -> None:
        self.core = [value]

    def left_out(self) -> None: ...

EMPTY = []
HALF = 0.5
WHOLE = {}.keys()

def exact(a: Fraction) -> slice: ...

def _own(a: int) -> Mapping[str, bytes]:
    return {}
'''
OTHER = "class Thing:\n    def __init__(self) -> None:\n        self.at = 1\n"
WANTED = """
import type * as $ from "../pdp8/web/translator/runtime.mjs";
import type * as m_other from "../m/other.mjs";
export const LIMIT: number;
export const NAMES: $.Dict<string, (number)[]>;
export class Place {
constructor(x: number, y?: number);
[Symbol.iterator](): ArrayIterator<number>;
x: number;
y: number;
}
export class Tape {
constructor(frames: $.Bytes, name?: string | null);
frames: $.Bytes;
name: string | null;
readonly length: number;
}
export class Wrong extends $.ValueError {
}
export class Machine {
core: (number)[];
thing: m_other.Thing | null;
constructor(core: (number)[], say: ((a0: string) => void));
run(seconds?: number, hard?: boolean): void;
pairs(): Generator<[number, string]>;
}
export function row(of: $.Sequence<Place>, more: $.PySet<string>, dots: (number)[]): (Place)[];
export function all_kinds(a: $.ByteArray, b: $.Words, c: number, d: boolean, e: $.Sequence<number>,\
 f: RegExp, g: Iterable<number>, h: Iterable<number>, i: unknown, j: (number | null)[], k: (() => Machine),\
 new$: number | undefined, rest: (number)[], at: number | undefined,\
 sized: { length: number } | null | undefined, more: $.Dict<string, number>): never;
export type Code = number;
export const Code: Iterable<number> & { readonly [name in "MILL" | "READ"]: number };
export type Colour = string;
export const Colour: Iterable<string> & { readonly [name in "RED"]: string };
export interface Named {
colour: Colour;
get(at: number): Place;
}
export class Later extends Machine {
LIMIT: number;
static LIMIT: number;
readonly length: number;
toString(): string;
[Symbol.iterator](): Generator<number>;
__getitem__(at: number): number;
__setitem__(at: number, value: number): void;
made(): Later;
static made(): Later;
at: number;
}
export const EMPTY: (never)[];
export const HALF: number;
export const WHOLE: $.View<never>;
export function exact(a: $.Fraction): $.slice;
export function _own(a: number): $.Dict<string, $.Bytes>;
export {};
"""
RUNTIME = """
import type * as $ from "./runtime.mjs";
declare global { interface String {
export class Bytes extends Uint8Array<ArrayBuffer> {
export class ByteArray extends Array<number> {
declare global { interface Array<T> {
export class Words extends Uint16Array<ArrayBuffer> {
export class Dict<K, V> {
export class PySet<T> {
readonly size: number;
[Symbol.iterator](): IterableIterator<K>;
has(key: K): boolean;
delete(key: T): boolean;
set(key: K, value: V): this;
export class KeyError extends LookupError {}
split_(sep?: string): (string)[];
translate(table: $.Bytes | null, delete$?: $.Bytes): $.Bytes;
get<U>(key: K, otherwise: U): V | U;
count(item: T): number;
export function bytes(of?: number): $.Bytes;
export function dict<K, V>(): $.Dict<K, V>;
"""


def test_what_a_module_declares() -> None:
    found = declare({"m.here": ("here.py", SOURCE), "m.other": ("other.py", OTHER)}, {"m.here": "left_out"})
    assert found["m.here"].split() == WANTED.split()
    assert found["m.here"].strip().split("\n") == WANTED.strip().split("\n")
    there = found["pdp8.web.translator.runtime"].split("\n")
    assert [line for line in RUNTIME.strip().split("\n") if line not in there] == []
    assert len(set(found)) == 3
