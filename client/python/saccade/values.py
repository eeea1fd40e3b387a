"""What values are: checks that give a value as the messages take it, or raise Invalid."""
from __future__ import annotations

import math
import numbers
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from google.protobuf.internal.enum_type_wrapper import EnumTypeWrapper

Check = Callable[[Any], Any]
MOST_U32, MOST_U64 = (1 << 32) - 1, (1 << 64) - 1
SHOWN = 80  # characters of a value


class Invalid(Exception):
    """valid: what a value must be. at: which part of the setting is at fault, such as ".leak_hz"."""

    def __init__(self, value: Any, valid: str, at: str = "") -> None:
        super().__init__(valid)
        self.value, self.valid, self.at = value, valid, at


def check(name: str, value: Any, rule: Check) -> Any:
    """The checked value. Raises ValueError, which names the setting, the value and what is valid."""
    try:
        return rule(value)
    except Invalid as wrong:
        shown = " ".join(repr(wrong.value).split())
        shown = shown if len(shown) <= SHOWN else shown[:SHOWN] + "..."
        raise ValueError(f"{name}{wrong.at}: {shown} is not {wrong.valid}") from None


def number(value: Any, valid: str = "a finite number") -> float:
    try:
        if isinstance(value, numbers.Real) and not isinstance(value, bool) and math.isfinite(value):
            return float(value)
    except OverflowError:
        pass
    raise Invalid(value, valid)


def positive(value: Any) -> float:
    """Where the messages take 0 for unset."""
    valid = "a finite number above 0"
    if (found := number(value, valid)) <= 0:
        raise Invalid(value, valid)
    return found


def whole(low: int, high: int) -> Check:
    def rule(value: Any) -> int:
        if isinstance(value, numbers.Integral) and not isinstance(value, bool) and low <= int(value) <= high:
            return int(value)
        raise Invalid(value, f"a whole number from {low} to {high}")
    return rule


def flag(value: Any) -> bool:
    if isinstance(value, (bool, np.bool_)):
        return bool(value)
    raise Invalid(value, "True or False")


def text(valid: str) -> Check:
    def rule(value: Any) -> str:
        if isinstance(value, str) and value:
            return value
        raise Invalid(value, valid)
    return rule


def one_of(enum: EnumTypeWrapper) -> Check:
    """Texts such as "paced"; gives the number of the enum."""
    prefix = enum.Name(0).removesuffix("UNSPECIFIED")
    known = {key.removeprefix(prefix).lower(): value for key, value in enum.items() if value != 0}

    def rule(value: Any) -> int:
        if isinstance(value, str) and value in known:
            return int(known[value])
        raise Invalid(value, f"one of {', '.join(known)}")
    return rule


def items(value: Any, valid: str) -> list[Any]:
    """Of a list, a tuple or an array."""
    if isinstance(value, np.ndarray) and value.ndim > 0:
        return list(value)
    if isinstance(value, Sequence) and not isinstance(value, (str, bytes)):
        return list(value)
    raise Invalid(value, valid)


def several(valid: str, rule: Check) -> Check:
    """A list whose items keep to the rule."""
    def of_all(value: Any) -> list[Any]:
        return [rule(item) for item in items(value, valid)]
    return of_all


def numbers_of(valid: str, *counts: int) -> Check:
    """A list of so many numbers."""
    def rule(value: Any) -> list[float]:
        found = items(value, valid)
        if len(found) not in counts:
            raise Invalid(value, valid)
        try:
            return [number(item) for item in found]
        except Invalid:
            raise Invalid(value, valid) from None
    return rule


def amounts(valid: str, known: Sequence[str] = ()) -> Check:
    """Numbers by name; the names are `known`, or any."""
    def rule(value: Any) -> dict[str, float]:
        if not isinstance(value, Mapping):
            raise Invalid(value, valid)
        for name in value:
            if not isinstance(name, str) or known and name not in known:
                raise Invalid(name, f"one of {', '.join(known)}" if known else "a name")
        return {name: _named(name, item) for name, item in value.items()}
    return rule


def _named(name: str, value: Any) -> float:
    try:
        return number(value)
    except Invalid as wrong:
        raise Invalid(wrong.value, wrong.valid, f".{name}") from None
