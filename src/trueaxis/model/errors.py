"""Error values of one machine: parameters and motion errors, and their JSON file."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, field
from difflib import get_close_matches
from pathlib import Path
from typing import Any, Literal, get_args

from trueaxis.effects.kind import Effect, Kind
from trueaxis.effects.library import BY_NAME
from trueaxis.io.faults import Faults, InputError
from trueaxis.io.input_files import input_bytes, utf8_text
from trueaxis.model.curve_json import curve_object, read_curve, read_u, u_value
from trueaxis.model.curves import Curve
from trueaxis.model.effect_values import EffectValues, effect_object, in_order, read_effects
from trueaxis.model.origin import Origin, read_chain, read_origin
from trueaxis.model.strict_json import JsonPath, key_path, number, parse, shown, two_levels

SCHEMA = 1
_U = ("u", "u_readings", "u_prior")
_VALUES = ("parameters", "motion_errors", "effects")
_KEYS = ("schema", "machine", "fit", "covariance", *_VALUES, *_U, "determined", "undetermined", "origin", "chain")


@dataclass(frozen=True, slots=True)
class Undetermined:
    """A combination of values that the measured data leave open.

    combination: as a reader sees it, such as `ECX: x^1 + eps_xy`; parameters: the names that take part.
    """

    combination: str
    parameters: tuple[str, ...]


Determined = Literal["data", "partly", "prior"]
DETERMINED: tuple[Determined, ...] = get_args(Determined)
FitState = Literal["converged", "misfit"]
FIT_STATES: tuple[FitState, ...] = get_args(FitState)


@dataclass(frozen=True, slots=True)
class Fit:
    """How the identification of error values ended.

    state: `converged`, or `misfit` where residuals are far from the noise that is known; chi2: weighted squares of the
    residuals per degree of freedom, None where no noise was known; runs: those that misfit, worst first; unjudged:
    instruments whose noise was not known.
    """

    state: FitState
    chi2: float | None = None
    runs: tuple[str, ...] = ()
    unjudged: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class CovarianceLink:
    """The covariance file of error values: its name, relative to theirs, and the digest of the values it belongs to."""

    file: str
    sha256_of_values: str


@dataclass(frozen=True, slots=True, kw_only=True)
class ErrorValues:
    """Error values of a machine; what is not named is zero.

    parameters: name -> value (mm or rad); motion_errors: component -> curve; u: standard uncertainties of
    parameters, NaN where unknown (those of curves are in the curves); u_readings, u_prior: their two parts, by the
    readings and by the prior, the squares of which add up to that of u; determined: by what motion errors and
    parameters are determined; undetermined: what identification left open;
    effects: values of the machine's effects; fit: how identification ended, None where nothing says so;
    covariance: the file of their covariance, None where there is none; origin: the readings they were identified from,
    None where nothing says so; chain: `Machine.chain` of the spec that they were identified with, empty where nothing
    says so.
    """

    machine: str
    parameters: Mapping[str, float] = field(default_factory=dict)
    motion_errors: Mapping[str, Curve] = field(default_factory=dict)
    u: Mapping[str, float] = field(default_factory=dict)
    undetermined: tuple[Undetermined, ...] = ()
    effects: tuple[EffectValues, ...] = ()
    fit: Fit | None = None
    covariance: CovarianceLink | None = None
    u_readings: Mapping[str, float] = field(default_factory=dict)
    u_prior: Mapping[str, float] = field(default_factory=dict)
    determined: Mapping[str, Determined] = field(default_factory=dict)
    origin: Origin | None = None
    chain: str = ""


def read_errors(
    path: Path,
    *,
    machine: str,
    components: Sequence[str],
    parameters: Sequence[str],
    effects: Sequence[Effect] = (),
    kinds: Mapping[str, Kind] = BY_NAME,
) -> ErrorValues:
    """Read an error-values file for a machine with the given motion-error components, parameters and effects.

    kinds: those of the effects, by name. Effects come in the order of the machine's, whatever that of the file.
    Raises InputError with every fault of the file, each at its JSON key path.
    """
    faults = Faults(str(path))
    tree = parse(utf8_text(path, input_bytes(path)), faults)
    if not isinstance(tree, dict):
        if not faults.found:
            faults.add("", f"{shown(tree)} is not an object", 'give {"schema": 1, "machine": ..., ...}')
        raise InputError(faults.found)
    _check_head(tree, machine, faults)
    values = _numbers_by_name(tree, "parameters", parameters, number, faults)
    uncertainties = {key: _numbers_by_name(tree, key, parameters, read_u, faults) for key in _U}
    curves: dict[str, Curve] = {}
    for name, value in _named(tree, "motion_errors", components, "motion error", faults):
        curve = read_curve(value, ("motion_errors", name), faults)
        if curve is not None:
            curves[name] = curve
    undetermined = _undetermined(tree.get("undetermined", []), faults)
    determined = _determined(tree, (*components, *parameters), faults)
    fit = _fit(tree["fit"], faults) if "fit" in tree else None
    link = _covariance(tree["covariance"], faults) if "covariance" in tree else None
    origin = read_origin(tree["origin"], faults) if "origin" in tree else None
    found = read_effects(tree.get("effects", []), effects, kinds, faults)
    for one in found:
        name = one.effect.component or ""
        if kinds[one.effect.kind].place == "location" and name in values:
            place = key_path(("parameters", name))
            faults.add(place, f"is told by the effect {one.effect.label} as well", "keep one")
    chain = read_chain(tree.get("chain", ""), faults)
    faults.raise_if_any()
    return ErrorValues(
        machine=machine,
        parameters=values,
        motion_errors=curves,
        undetermined=undetermined,
        effects=found,
        fit=fit,
        covariance=link,
        determined=determined,
        origin=origin,
        chain=chain,
        **uncertainties,
    )


def dump_errors(
    errors: ErrorValues, *, components: Sequence[str], parameters: Sequence[str], effects: Sequence[Effect] = ()
) -> str:
    """JSON text of error values, in the machine's order whatever order the values came in; the same bytes each time.

    effects: those of the machine; values of others, which reading would refuse, come after them as they are.
    Floats are written so that they read back as the same numbers.
    """
    tree: dict[str, Any] = {"schema": SCHEMA, "machine": errors.machine}
    if errors.fit is not None:
        tree["fit"] = {"state": errors.fit.state}
        if errors.fit.chi2 is not None:
            tree["fit"]["chi2"] = float(errors.fit.chi2)
        if errors.fit.runs:
            tree["fit"]["runs"] = list(errors.fit.runs)
        if errors.fit.unjudged:
            tree["fit"]["unjudged"] = list(errors.fit.unjudged)
    if errors.covariance is not None:
        tree["covariance"] = {
            "file": errors.covariance.file,
            "sha256_of_values": errors.covariance.sha256_of_values,
        }
    tree["parameters"] = {name: float(errors.parameters[name]) for name in parameters if name in errors.parameters}
    for key, by_name in zip(_U, (errors.u, errors.u_readings, errors.u_prior), strict=True):
        if by_name:
            tree[key] = {name: u_value(by_name[name]) for name in parameters if name in by_name}
    tree["motion_errors"] = {
        name: curve_object(errors.motion_errors[name]) for name in components if name in errors.motion_errors
    }
    tree["effects"] = [effect_object(one) for one in in_order(errors.effects, effects)]
    if errors.determined:
        named = [name for name in (*components, *parameters) if name in errors.determined]
        tree["determined"] = {name: errors.determined[name] for name in named}
    if errors.undetermined:
        tree["undetermined"] = [
            {"combination": item.combination, "parameters": list(item.parameters)} for item in errors.undetermined
        ]
    if errors.origin is not None:
        tree["origin"] = asdict(errors.origin)
    if errors.chain:
        tree["chain"] = errors.chain
    return two_levels(tree)


def _check_head(tree: dict[str, Any], machine: str, faults: Faults) -> None:
    for key in tree:
        if key not in _KEYS:
            faults.add(key, "is not a key of an error-values file", _suggest(key, _KEYS))
    if "schema" not in tree or isinstance(tree["schema"], bool) or tree["schema"] != SCHEMA:
        problem = f"{shown(tree['schema'])} is not a known schema" if "schema" in tree else "is missing"
        faults.add("schema", problem, f"this version reads schema {SCHEMA}")
    if "machine" not in tree:
        faults.add("machine", "is missing", f'give "{machine}"')
    elif tree["machine"] != machine:
        faults.add("machine", f"{shown(tree['machine'])} is another machine", f'the machine is "{machine}"')


def _named(
    tree: dict[str, Any], key: str, known: Sequence[str], what: str, faults: Faults
) -> Iterable[tuple[str, Any]]:
    """The entries of the object under `key` whose names the machine knows, in the machine's order."""
    entries = tree.get(key, {})
    if not isinstance(entries, dict):
        faults.add(key, f"{shown(entries)} is not an object")
        return ()
    for name in entries:
        if name not in known:
            faults.add(key_path((key, name)), f"the machine has no {what} {name}", _suggest(name, known))
    return [(name, entries[name]) for name in known if name in entries]


def _numbers_by_name(
    tree: dict[str, Any], key: str, known: Sequence[str], read: Any, faults: Faults
) -> dict[str, float]:
    entries = _named(tree, key, known, "parameter", faults)
    return {name: read(value, (key, name), faults) for name, value in entries}


def _determined(tree: dict[str, Any], known: Sequence[str], faults: Faults) -> dict[str, Determined]:
    found: dict[str, Determined] = {}
    for name, value in _named(tree, "determined", known, "error", faults):
        state = next((one for one in DETERMINED if value == one), None)
        if state is None:
            faults.add(key_path(("determined", name)), f"is {shown(value)}", f"one of {', '.join(DETERMINED)}")
        else:
            found[name] = state
    return found


def _undetermined(entries: Any, faults: Faults) -> tuple[Undetermined, ...]:
    if not isinstance(entries, list):
        faults.add("undetermined", f"{shown(entries)} is not a list")
        return ()
    found = []
    for index, entry in enumerate(entries):
        path: JsonPath = ("undetermined", index)
        if not isinstance(entry, dict) or set(entry) != {"combination", "parameters"}:
            faults.add(key_path(path), "is not an object of combination and parameters")
            continue
        names = entry["parameters"]
        if not isinstance(entry["combination"], str):
            faults.add(key_path((*path, "combination")), f"{shown(entry['combination'])} is not a text")
        elif not isinstance(names, list) or not all(isinstance(name, str) for name in names):
            faults.add(key_path((*path, "parameters")), "is not a list of names")
        else:
            found.append(Undetermined(entry["combination"], tuple(names)))
    return tuple(found)


def _fit(entry: Any, faults: Faults) -> Fit | None:
    if not isinstance(entry, dict):
        faults.add("fit", f"{shown(entry)} is not an object", 'give {"state": "converged"} or leave it out')
        return None
    for key in entry:
        if key not in ("state", "chi2", "runs", "unjudged"):
            faults.add(key_path(("fit", key)), "is not a key of a fit", "known: state, chi2, runs, unjudged")
    state = next((known for known in FIT_STATES if entry.get("state") == known), None)
    if state is None:
        faults.add("fit.state", f"is {shown(entry.get('state'))}", f"one of {', '.join(FIT_STATES)}")
    chi2 = number(entry["chi2"], ("fit", "chi2"), faults) if "chi2" in entry else None
    lists: dict[str, list[str]] = {}
    for key, what in (("runs", "run ids"), ("unjudged", "instruments")):
        lists[key] = entry.get(key, [])
        if not isinstance(lists[key], list) or not all(isinstance(name, str) for name in lists[key]):
            faults.add(f"fit.{key}", f"is not a list of {what}")
            lists[key] = []
    return None if state is None else Fit(state, chi2, tuple(lists["runs"]), tuple(lists["unjudged"]))


def _covariance(entry: Any, faults: Faults) -> CovarianceLink | None:
    keys = ("file", "sha256_of_values")
    if not isinstance(entry, dict) or set(entry) != set(keys) or not all(isinstance(entry[key], str) for key in keys):
        faults.add("covariance", "is not an object of the texts file and sha256_of_values", "as identify wrote it")
        return None
    file = Path(entry["file"])
    if not file.name or file.is_absolute():
        faults.add("covariance.file", f"{shown(entry['file'])} is no file name", "a name relative to this file")
        return None
    return CovarianceLink(entry["file"], entry["sha256_of_values"])


def _suggest(name: str, known: Sequence[str]) -> str:
    same = [one for one in known if one.lower() == name.lower()]
    close = same or get_close_matches(name, known, n=1)
    if close:
        return f"did you mean {close[0]}?"
    return f"known: {', '.join(known)}" if known else "it has none"
