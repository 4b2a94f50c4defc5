"""Error curves to and from the objects of an error-values file."""

import math
from collections.abc import Callable, Iterable
from typing import Any

import numpy as np

from trueaxis.io.faults import Faults
from trueaxis.model.bases import travel_basis
from trueaxis.model.curves import Curve, LegendreCurve, PolynomialCurve, TableCurve
from trueaxis.model.strict_json import JsonPath, key_path, number, numbers, shown

LEAST_SPACING = 1e-6  # mm, deg: of the positions of a table; nothing is positioned closer
LARGEST_U = 1e6  # of any value in its unit: what is less certain is not known, which null says
HIGHEST_POWER = 99  # a power of a travel of 1000 mm then still is a finite number

MOST_TERMS = 99  # of a Legendre basis, as of a polynomial

_U = ("u", "u_readings", "u_prior")
_KEYS = {
    "polynomial": ("powers", "coefficients"),
    "legendre": ("range", "coefficients"),
    "turn": ("range", "harmonics", "coefficients"),
    "table": ("positions", "values"),
}


def read_curve(value: Any, path: JsonPath, faults: Faults) -> Curve | None:
    """The curve of one component; None when a fault was noted."""
    before = len(faults.found)
    if not isinstance(value, dict):
        faults.add(key_path(path), f"{shown(value)} is not an error curve", 'give {"basis": "polynomial", ...}')
        return None
    basis = value.get("basis")
    if not isinstance(basis, str) or basis not in _KEYS:
        problem = "is missing" if "basis" not in value else f"{shown(basis)} is not a basis"
        faults.add(key_path((*path, "basis")), problem, 'give "polynomial", "legendre", "turn" or "table"')
        return None
    known = ("basis", *_KEYS[basis], *(("u",) if basis == "table" else (*_U, "measured")))
    for key in value:
        if key not in known:
            faults.add(key_path((*path, key)), f"is not a key of a {basis}", f"known: {', '.join(known)}")
    missing = [key for key in _KEYS[basis] if key not in value]
    for key in missing:
        faults.add(key_path((*path, key)), "is missing")
    if missing:
        return None
    readers: dict[str, Callable[[dict[str, Any], JsonPath, Faults], Curve | None]] = {
        "polynomial": _polynomial, "legendre": _legendre, "turn": _legendre, "table": _table,
    }  # fmt: skip
    curve = readers[basis](value, path, faults)
    return curve if len(faults.found) == before else None


def read_u(value: Any, path: JsonPath, faults: Faults) -> float:
    """A standard uncertainty: a number >= 0, or null (NaN) where it is unknown."""
    if value is None:
        return math.nan
    found = number(value, path, faults)
    if found < 0.0:
        faults.add(key_path(path), f"{found!r} is negative", "a standard uncertainty is at least 0")
    elif found > LARGEST_U:
        faults.add(key_path(path), f"{found!r} is no standard uncertainty", f"at most {LARGEST_U:g}, or null")
    return found


def curve_object(curve: Curve) -> dict[str, Any]:
    """The JSON object of a curve; polynomials in rising powers."""
    if isinstance(curve, PolynomialCurve):
        order = sorted(range(len(curve.powers)), key=curve.powers.__getitem__)
        found: dict[str, Any] = {
            "basis": "polynomial",
            "powers": [int(curve.powers[i]) for i in order],
            "coefficients": [float(curve.coefficients[i]) for i in order],
        }
        return found | _uncertainty_object(curve, order) | _measured(curve)
    if isinstance(curve, LegendreCurve):
        found = {
            "basis": curve.basis.form,
            "range": [float(curve.basis.low), float(curve.basis.high)],
            **({"harmonics": curve.basis.harmonics} if curve.basis.harmonics else {}),
            "coefficients": [float(one) for one in curve.coefficients],
        }
        return found | _uncertainty_object(curve, range(len(curve.coefficients))) | _measured(curve)
    found = {
        "basis": "table",
        "positions": [float(position) for position in curve.positions],
        "values": [float(value) for value in curve.values],
    }
    if curve.u is not None:
        found["u"] = [u_value(u) for u in curve.u]
    return found


def _uncertainty_object(curve: PolynomialCurve | LegendreCurve, order: Iterable[int]) -> dict[str, Any]:
    lists = zip(_U, (curve.u, curve.u_readings, curve.u_prior), strict=True)
    return {key: [u_value(u[i]) for i in order] for key, u in lists if u is not None}


def _measured(curve: PolynomialCurve | LegendreCurve) -> dict[str, Any]:
    return {} if curve.measured is None else {"measured": [float(end) for end in curve.measured]}


def u_value(u: float) -> float | None:
    """A standard uncertainty as JSON has it: null where unknown."""
    return None if math.isnan(u) else float(u)


def _polynomial(value: dict[str, Any], path: JsonPath, faults: Faults) -> PolynomialCurve | None:
    powers = _powers(value["powers"], (*path, "powers"), faults)
    coefficients = numbers(value["coefficients"], (*path, "coefficients"), faults)
    u, u_readings, u_prior = (_uncertainties(value, key, path, faults) for key in _U)
    measured = _range(value, path, faults)
    if _same_length(value, ("powers", "coefficients", *_U), path, faults):
        return PolynomialCurve(
            powers=powers, coefficients=coefficients, u=u, measured=measured, u_readings=u_readings, u_prior=u_prior
        )
    return None


def _legendre(value: dict[str, Any], path: JsonPath, faults: Faults) -> LegendreCurve | None:
    ends = numbers(value["range"], (*path, "range"), faults)
    coefficients = numbers(value["coefficients"], (*path, "coefficients"), faults)
    u, u_readings, u_prior = (_uncertainties(value, key, path, faults) for key in _U)
    measured = _range(value, path, faults)
    same = _same_length(value, ("coefficients", *_U), path, faults)
    harmonics = _harmonics(value["harmonics"], (*path, "harmonics"), faults) if "harmonics" in value else 0
    if len(coefficients) < 2 * harmonics:
        problem = f"are {len(coefficients)}, cosine and sine of {harmonics} harmonics among them"
        faults.add(key_path((*path, "coefficients")), problem, f"at least {2 * harmonics}")
        return None
    if len(coefficients) > MOST_TERMS:
        faults.add(key_path((*path, "coefficients")), f"are {len(coefficients)}", f"at most {MOST_TERMS}")
    if len(ends) != 2 or not ends[1] - ends[0] >= LEAST_SPACING:
        faults.add(key_path((*path, "range")), "is no range", "[lowest, highest] position of the travel, mm or deg")
        return None
    if not same:
        return None
    return LegendreCurve(
        basis=travel_basis(ends, len(coefficients) - 2 * harmonics, harmonics),
        coefficients=coefficients,
        u=u,
        measured=measured,
        u_readings=u_readings,
        u_prior=u_prior,
    )


def _harmonics(value: Any, path: JsonPath, faults: Faults) -> int:
    """How many; 0 where that is no number of harmonics."""
    count = number(value, path, faults)
    if count.is_integer() and 1 <= count <= MOST_TERMS // 2:
        return int(count)
    if not math.isnan(count):  # noted already
        right = f"a whole number from 1 to {MOST_TERMS // 2}"
        faults.add(key_path(path), f"{count!r} is no number of harmonics", right)
    return 0


def _range(value: dict[str, Any], path: JsonPath, faults: Faults) -> tuple[float, float] | None:
    """The lowest and highest measured position; None where the curve does not say."""
    if "measured" not in value:
        return None
    ends = numbers(value["measured"], (*path, "measured"), faults)
    if len(ends) != 2 or not ends[0] <= ends[1]:
        faults.add(key_path((*path, "measured")), "is no range", "[lowest, highest] measured position, mm or deg")
        return None
    return ends


def _powers(value: Any, path: JsonPath, faults: Faults) -> tuple[int, ...]:
    found = []
    for index, power in enumerate(numbers(value, path, faults)):
        if math.isnan(power):
            continue  # noted already
        if not power.is_integer() or not 0 <= power <= HIGHEST_POWER:
            remedy = f"give a whole number from 0 to {HIGHEST_POWER}"
            faults.add(key_path((*path, index)), f"{power!r} is not a power", remedy)
        elif int(power) in found:
            faults.add(key_path((*path, index)), f"power {int(power)} is given more than once", "keep one")
        else:
            found.append(int(power))
    return tuple(found)


def _table(value: dict[str, Any], path: JsonPath, faults: Faults) -> TableCurve | None:
    positions = numbers(value["positions"], (*path, "positions"), faults)
    values = numbers(value["values"], (*path, "values"), faults)
    u = _uncertainties(value, "u", path, faults)
    if value["positions"] == []:
        faults.add(key_path((*path, "positions")), "is empty", "give one position at least")
    for index in np.flatnonzero(~(np.diff(positions) >= LEAST_SPACING)):
        place = key_path((*path, "positions", int(index) + 1))
        remedy = f"positions must increase, by {LEAST_SPACING:g} at least"
        faults.add(place, f"{positions[index + 1]!r} follows {positions[index]!r}", remedy)
    if _same_length(value, ("positions", "values", "u"), path, faults):
        return TableCurve(positions, values, u)
    return None


def _uncertainties(value: dict[str, Any], key: str, path: JsonPath, faults: Faults) -> tuple[float, ...] | None:
    if key not in value:
        return None
    if not isinstance(value[key], list):
        faults.add(key_path((*path, key)), f"{shown(value[key])} is not a list of standard uncertainties")
        return None
    return tuple(read_u(u, (*path, key, index), faults) for index, u in enumerate(value[key]))


def _same_length(value: dict[str, Any], keys: tuple[str, ...], path: JsonPath, faults: Faults) -> bool:
    lengths = {key: len(value[key]) for key in keys if isinstance(value.get(key), list)}
    first = keys[0]
    if first not in lengths:
        return False
    for key, length in lengths.items():
        if length != lengths[first]:
            remedy = f"as many as {first} ({lengths[first]})"
            faults.add(key_path((*path, key)), f"has {length} entries", remedy)
    return len(set(lengths.values())) == 1
