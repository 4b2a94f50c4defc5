"""What error values rest on: the readings that they were identified from, as their file says it."""

from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from typing import Any, Literal, get_args

from trueaxis.io.faults import Faults
from trueaxis.model.strict_json import JsonPath, key_path, number, shown

KEY = "origin"
OriginMethod = Literal["global", "stepwise"]
METHODS: tuple[OriginMethod, ...] = get_args(OriginMethod)


@dataclass(frozen=True, slots=True, kw_only=True)
class ReadingNoise:
    """Standard deviation of the readings of an instrument, in `unit` (um, urad); stated: by the user, else estimated
    from the readings.
    """

    instrument: str
    value: float
    unit: str
    stated: bool


@dataclass(frozen=True, slots=True, kw_only=True)
class UsualSize:
    """A class of instrument unknowns whose size the readings make far smaller than usual.

    unknown: the class; size: as the readings make it likely, usual: as it usually is, one standard deviation, in `unit`
    (mm, rad or 1); values: how many unknowns of the class the size comes from.
    """

    unknown: str
    size: float
    usual: float
    unit: str
    values: int


@dataclass(frozen=True, slots=True, kw_only=True)
class Origin:
    """folder: name of the data folder; method: of identification; prior: whether errors of the sizes of [prior] were
    expected; runs, readings: how many were used; outliers: readings that were left out; noise: of each instrument;
    usual_sizes: by which the second covariance of the values counts, empty where there is none; report: free text of
    setup.toml about the measurement.
    """

    folder: str
    method: OriginMethod
    prior: bool
    runs: int
    readings: int
    outliers: int
    noise: tuple[ReadingNoise, ...] = ()
    usual_sizes: tuple[UsualSize, ...] = ()
    report: Mapping[str, str] = field(default_factory=dict)


def read_origin(entry: Any, faults: Faults) -> Origin | None:
    """The record of the key `origin`; None, with a fault, where it is none."""
    path: JsonPath = (KEY,)
    before = len(faults.found)
    if not _has_keys(entry, Origin, path, faults):
        return None
    texts = entry["report"]
    if not isinstance(texts, dict) or not all(isinstance(one, str) for one in texts.values()):
        faults.add(key_path((*path, "report")), "is not an object of texts")
    if entry["method"] not in METHODS:
        faults.add(key_path((*path, "method")), f"is {shown(entry['method'])}", f"one of {', '.join(METHODS)}")
    for key, kind, what in (("folder", str, "text"), ("prior", bool, "true or false")):
        if not isinstance(entry[key], kind):
            faults.add(key_path((*path, key)), f"{shown(entry[key])} is not a {what}")
    counts = {key: int(_number(entry[key], (*path, key), faults)) for key in ("runs", "readings", "outliers")}
    noise = _records(entry, "noise", ReadingNoise, faults)
    sizes = _records(entry, "usual_sizes", UsualSize, faults)
    if len(faults.found) > before:
        return None
    return Origin(
        folder=entry["folder"],
        method=entry["method"],
        prior=entry["prior"],
        **counts,
        noise=tuple(ReadingNoise(**one) for one in noise),
        usual_sizes=tuple(UsualSize(**one) for one in sizes),
        report=dict(texts),
    )


def read_chain(value: Any, faults: Faults) -> str:
    """The axes of the spec that values were identified with, see `Machine.chain`; empty, with a fault, where wrong."""
    if isinstance(value, str):
        return value
    faults.add("chain", f"{shown(value)} is not a text", 'such as "-X -Y bed +Z"')
    return ""


def _records(entry: dict[str, Any], key: str, record: type, faults: Faults) -> list[dict[str, Any]]:
    """The objects of a list whose values are those of a record of texts, numbers and truths."""
    if not isinstance(entry[key], list):
        faults.add(key_path((KEY, key)), f"{shown(entry[key])} is not a list")
        return []
    for index, one in enumerate(entry[key]):
        path: JsonPath = (KEY, key, index)
        if not _has_keys(one, record, path, faults):
            continue
        for of in fields(record):
            value, at = one[of.name], (*path, of.name)
            if of.type in (float, int):
                _number(value, at, faults)
            elif not isinstance(value, bool if of.type is bool else str):
                faults.add(key_path(at), f"{shown(value)} is not {'true or false' if of.type is bool else 'a text'}")
    return list(entry[key])


def _number(value: Any, path: JsonPath, faults: Faults) -> float:
    """A number that is not negative; 0, with a fault, where it is none."""
    before = len(faults.found)
    found = number(value, path, faults)
    if len(faults.found) > before:
        return 0.0
    if found < 0.0:
        faults.add(key_path(path), f"is {found:g}", "a number of at least 0")
    return found


def _has_keys(entry: Any, record: type, path: JsonPath, faults: Faults) -> bool:
    keys = {one.name for one in fields(record)}
    if isinstance(entry, dict) and set(entry) == keys:
        return True
    faults.add(key_path(path), f"is not an object of {', '.join(sorted(keys))}", "as identify wrote it")
    return False
