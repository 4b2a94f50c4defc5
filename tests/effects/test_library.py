"""Every kind of the library is what its record says, and its term is the one that the literature and physics give."""

import math
from dataclasses import dataclass

import pytest

from trueaxis.effects.evaluate import evaluate, is_linear, undefined_at
from trueaxis.effects.expression import names, parse
from trueaxis.effects.kind import Effect, Kind
from trueaxis.effects.library import BY_NAME, KINDS
from trueaxis.effects.placement import FARTHEST, VARIABLES, allows, concerns, context_of, reads, variables_of, way_of
from trueaxis.error_name import ErrorName


@dataclass(frozen=True)
class Run:
    id: str
    instrument: str


WITH_TERMS = [kind for kind in KINDS if kind.expression]


def test_names_are_unique_and_none_is_both_variable_and_parameter() -> None:
    assert len(BY_NAME) == len(KINDS)
    for kind in KINDS:
        parameters = [parameter.name for parameter in kind.parameters]
        assert len(set(parameters)) == len(parameters)
        assert not set(parameters) & VARIABLES.keys()


@pytest.mark.parametrize("kind", WITH_TERMS, ids=lambda kind: kind.name)
class TestEveryTerm:
    def test_it_uses_its_parameters_and_variables_of_its_place_alone(self, kind: Kind) -> None:
        used = {name.name for name in names(parse(kind.expression))}
        parameters = {parameter.name for parameter in kind.parameters}
        assert parameters <= used
        assert used - parameters <= {variable.name for variable in variables_of(kind)}

    def test_it_is_linear_in_its_linear_parameters(self, kind: Kind) -> None:
        linear = [parameter.name for parameter in kind.parameters if parameter.role == "linear"]
        assert is_linear(parse(kind.expression), linear) is bool(linear)
        assert linear or [parameter.role for parameter in kind.parameters] == ["root"]

    def test_it_has_a_value_everywhere(self, kind: Kind) -> None:
        choices = {"along": (-500.0, 0.0, 500.0), "theta": (-3.0, 0.0, 3.0), "along_line": (-500.0, 0.0, 500.0)}
        parameters = {parameter.name: (0.01, 1.0, 500.0) for parameter in kind.parameters} | choices
        assert undefined_at(parse(kind.expression), (-300.0, 0.0, 400.0), parameters) is None


# By hand: a machine of 500 mm at q = 125 mm.
AT = {"q": 125.0, "s": 0.25, "s_b": 0.5, "direction": -1.0, "v": 20.0, "d": 3.0, "t": 60.0, "T": 2.0}
AT |= {"d_time": 0.5, "d_path": 4.0}
VALUES = [
    ("backlash", {"width": 0.006}, {}, -0.003),
    ("backlash_slope", {"change": 0.004}, {}, 0.001),
    ("cyclic", {"amplitude": 0.002, "phase": math.pi / 3, "pitch": 5.0}, {}, 0.001),
    ("cyclic", {"amplitude": 0.002, "phase": 0.0, "pitch": 10.0}, {}, -0.002),
    ("thermal_expansion", {"coefficient": 11e-6}, {}, 0.00275),
    ("thermal_offset", {"coefficient": 0.003}, {}, 0.006),
    ("warm_up", {"amplitude": 0.02, "tau": 60.0}, {}, 0.005 / math.e),
    ("drift", {"rate": 1e-5}, {}, 6e-4),
    ("servo_lag", {"tau": 1e-4}, {}, -0.002),
    ("reversal_spike", {"height": 0.004, "decay": 3.0}, {}, -0.004 / math.e),
    ("reversal_spike", {"height": 0.004, "decay": 3.0}, {"d": FARTHEST}, 0.0),
    ("reversal_spike_time", {"height": 0.004, "tau": 0.5}, {}, -0.004 / math.e),
    ("reversal_spike_time", {"height": 0.004, "tau": 0.5}, {"d_time": FARTHEST}, 0.0),
    ("reversal_spike_path", {"height": 0.004, "decay": 2.0}, {}, -0.004 / math.e**2),
    ("reversal_spike_path", {"height": 0.004, "decay": 2.0}, {"d_path": FARTHEST}, 0.0),
    ("cross_axis", {"k": 0.016}, {}, 0.001),
    ("laser_cosine", {"angle": 0.002}, {"along": 500.0}, -0.001),  # 500 (cos 0.002 - 1)
    ("laser_scale", {"k": 1e-6}, {"along": 500.0}, 5e-4),
    ("laser_step", {"jump": 0.002, "t_0": 60.0}, {}, 0.002),
    ("laser_step", {"jump": 0.002, "t_0": 60.1}, {}, 0.0),
    ("reading_zero", {"zero": 0.003}, {}, 0.003),
    ("reading_slope", {"slope": 2e-5}, {"along_line": -200.0}, -0.004),
    ("ballbar_length", {"length": 0.003}, {}, 0.003),
    ("ballbar_lobes", {"amplitude": 0.002, "phase": 0.0}, {"theta": math.pi / 3}, -0.002),
]


@pytest.mark.parametrize(("kind", "parameters", "at", "value"), VALUES)
def test_values_by_hand(kind: str, parameters: dict[str, float], at: dict[str, float], value: float) -> None:
    assert evaluate(parse(BY_NAME[kind].expression), AT | at | parameters) == pytest.approx(value, rel=1e-12, abs=1e-18)


def test_every_term_has_a_value_worked_by_hand() -> None:
    assert {kind.name for kind in WITH_TERMS} == {kind for kind, *_ in VALUES}


@pytest.mark.parametrize(
    ("text", "direction"),
    [
        ("EXX", "along"),
        ("EYX", "across"),
        ("ECX", "turn"),
        ("EAX", "turn"),
        ("ECC", "along"),
        ("EXC", "across"),
        ("EAC", "turn"),
    ],
)
def test_directions(text: str, direction: str) -> None:
    component = ErrorName(text)
    assert way_of(component) == direction
    assert allows(BY_NAME["servo_lag"], component) is (direction == "along")
    assert allows(BY_NAME["cyclic"], component) is (direction != "turn")


@pytest.mark.parametrize(
    ("kind", "by"),
    [
        ("reading_zero", {"laser", "probe", "ballbar"}),
        ("reading_slope", {"laser", "probe"}),
        ("laser_scale", {"laser"}),
        ("ballbar_centre", {"ballbar"}),
        ("backlash", {"laser", "probe", "ballbar"}),
    ],
)
def test_an_effect_is_in_the_readings_of_its_instruments_and_runs(kind: str, by: set[str]) -> None:
    runs = [Run(f"{name}-{k}", name) for name in ("laser", "probe", "ballbar") for k in (1, 2)]
    assert {one.instrument for one in runs if reads(BY_NAME[kind], one.instrument)} == by
    assert {one.id for one in runs if concerns(BY_NAME[kind], Effect(kind=kind), one)} == {
        f"{n}-{k}" for n in by for k in (1, 2)
    }
    named = Effect(kind=kind, runs=("probe-2", "ballbar-1"))
    assert {one.id for one in runs if concerns(BY_NAME[kind], named, one)} == {
        one for one in named.runs if one.split("-")[0] in by
    }


def test_what_every_set_up_has_some_of_is_a_nuisance() -> None:
    assert {kind.name for kind in KINDS if kind.nuisance} == {"reading_zero", "reading_slope"}


def test_context_rows() -> None:
    assert context_of(BY_NAME["reversal_spike"]) == ("direction", "d")
    assert context_of(BY_NAME["ballbar_length"]) == ("theta",)  # of none, it takes the number of readings
    assert context_of(BY_NAME["reading_zero"]) == ("along",)
    assert context_of(BY_NAME["point_offset"]) == ()
    assert context_of(Kind(name="own", place="component", expression="c", parameters=(), sentence="")) == ("q",)
