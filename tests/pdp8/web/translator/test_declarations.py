"""What TypeScript reads of a translated module, line by line."""

from pdp8.web.translator.declarations import declare

SOURCE = '''
"""A module."""
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple
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
    def __init__(self, core: list[int], say: Callable[[str], object]) -> None:
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
constructor(core: (number)[], say: ((a0: string) => unknown));
run(seconds?: number, hard?: boolean): void;
pairs(): Generator<[number, string]>;
}
export function row(of: $.Sequence<Place>, more: $.PySet<string>, dots: (number)[]): (Place)[];
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
export function bytes(of?: number): $.Bytes;
export function dict<K, V>(): $.Dict<K, V>;
"""


def test_what_a_module_declares() -> None:
    found = declare({"m.here": ("here.py", SOURCE), "m.other": ("other.py", OTHER)}, {})
    assert found["m.here"].split() == WANTED.split()
    assert found["m.here"].strip().split("\n") == WANTED.strip().split("\n")
    there = found["pdp8.web.translator.runtime"].split("\n")
    assert [line for line in RUNTIME.strip().split("\n") if line not in there] == []
    assert len(set(found)) == 3
