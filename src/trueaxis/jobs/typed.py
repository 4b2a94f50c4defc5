"""Arguments of another class, told as `errors: expected Errors, from load_errors or identify; given 'e.json'`."""

import inspect
from collections.abc import Callable, Mapping, Sequence
from functools import wraps
from numbers import Integral, Real
from os import PathLike
from types import NoneType, UnionType
from typing import Any, Literal, ParamSpec, TypeVar, Union, get_args, get_origin

import numpy as np

from trueaxis.machine.fields import shown

AnyPath = str | PathLike[str]
P = ParamSpec("P")
R = TypeVar("R")

# how a record is called, and where it comes from, by the name of its class; others are called by that
_FROM: Mapping[str, str] = {
    "MachineModel": "a MachineModel, from load_model",
    "Machine": "a Machine, from load_machine",
    "Errors": "Errors, from load_errors or identify",
    "DataFolder": "a DataFolder, from load_data or simulate",
    "Context": "a Context",
}
_PLAIN: Mapping[type, tuple[type, str]] = {
    float: (Real, "a number"),
    int: (Integral, "a whole number"),
    str: (str, "a text"),
    bool: (bool, "True or False"),
    PathLike: (PathLike, "a path"),
    NoneType: (NoneType, "None"),
}


def typed(function: Callable[P, R]) -> Callable[P, R]:
    """The function, which raises ValueError for arguments of another class than its annotations have.

    Only what is certain counts: numbers, texts, paths, records, sequences of these; arrays and the like pass, and the
    function itself says what is wrong with them.
    """
    signature = inspect.signature(function)
    named = [one for one in signature.parameters.values() if one.kind not in (one.VAR_KEYWORD, one.VAR_POSITIONAL)]
    wanted = {one.name: choices for one in named if (choices := _choices(one.annotation)) is not None}

    @wraps(function)
    def checked(*args: P.args, **kwargs: P.kwargs) -> R:
        for name, value in signature.bind(*args, **kwargs).arguments.items():
            choices = wanted.get(name, ())
            if choices and not any(_is(value, one) for one in choices):
                raise ValueError(f"{name}: expected {_named_all(choices)}; given {shown_value(value)}")
        return function(*args, **kwargs)

    return checked


def _choices(annotation: Any) -> tuple[Any, ...] | None:
    """What an annotation lets through, one by one; None where that is not for these checks to say."""
    parts = get_args(annotation) if get_origin(annotation) in (Union, UnionType) else (annotation,)
    found: list[Any] = []
    for part in parts:
        origin = get_origin(part)
        if origin in (Union, UnionType):
            inner = _choices(part)
            if inner is None:
                return None
            found += inner
        elif origin in (Sequence, Mapping, Literal) or part in _PLAIN or origin is PathLike or _is_record(part):
            found.append(part)
        else:
            return None
    return tuple(found)


def _is_record(part: object) -> bool:
    return isinstance(part, type) and part.__module__.startswith("trueaxis.")


def _is(value: object, wanted: Any) -> bool:
    origin = get_origin(wanted)
    if origin is Literal:
        return isinstance(value, str)  # which ones there are the function says
    if origin is Sequence and get_origin(get_args(wanted)[0]) is Literal:
        return True  # so it does here
    if origin is Sequence:
        return isinstance(value, Sequence | np.ndarray) and not isinstance(value, str | bytes)
    if origin is Mapping:
        return isinstance(value, Mapping)
    plain = _PLAIN.get(origin or wanted)
    if plain is None:
        return isinstance(value, wanted)
    truth = isinstance(value, bool | np.bool_)
    return truth if wanted is bool else isinstance(value, plain[0]) and not truth


def _named_all(wanted: Sequence[Any]) -> str:
    names = dict.fromkeys(_named(each) for each in wanted)
    if "a path" in names:
        names.pop("a text", None)  # a path, too
    return " or ".join(names)


def _named(wanted: Any) -> str:
    origin = get_origin(wanted)
    if origin is Literal:
        return ", ".join(repr(one) for one in get_args(wanted))
    if origin is Sequence:
        return "a list"
    if origin is Mapping:
        return "a dict"
    plain = _PLAIN.get(origin or wanted)
    return _FROM.get(wanted.__name__, wanted.__name__) if plain is None else plain[1]


def shown_value(value: object) -> str:
    """A text, a number or a truth value, shortened; else its class."""
    return shown(value) if isinstance(value, str | float | int) else f"a value of class {type(value).__name__}"
