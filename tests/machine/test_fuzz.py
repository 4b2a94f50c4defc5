"""Whatever a spec says, reading it gives a machine or faults: nothing else, and soon."""

from datetime import timedelta

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.machine.test_faults import BASE
from tests.machines import DMU60P, FIVE_AXIS, machine_of
from trueaxis.io.faults import InputError
from trueaxis.machine import Machine
from trueaxis.machine.topology import branches, lower_body_array

CODE = """\
schema = 1
name = "code"
structure = "[w C' Y' b X Z B t]"
rotations = "true"

[axis.X]
travel = [0.0, 500.0]

[axis.Y]
travel = [0.0, 500.0]
sense = -1

[axis.Z]
travel = [0.0, 500.0]

[axis.C]
position = [1.0, "q_C", 2.0]

[tool]
position = ["q_x", "q_y", "q_z"]
"""
EFFECTS = (
    DMU60P.read_text()
    + """
[[effect_kind]]
name = "sag"
expression = "depth*s_b*exp(-d/way)*(1 - s^2)"
components = ["EZY", "turn"]
other_axis = true

[effect_kind.parameters.depth]
unit = "u"

[effect_kind.parameters.way]
unit = "axis"
grid = [1.0, 2.0]

[[effect]]
kind = "sag"
component = "EZY"
axis = "X"

[[effect]]
kind = "point_offset"
runs = ["X1"]
end = "reference"

[[effect]]
kind = "squareness"
component = "EB0X"
"""
)
SEEDS = [BASE, FIVE_AXIS.read_text(), DMU60P.read_text(), CODE, EFFECTS]

# Values that some key takes, and such as none does.
VALUES = st.sampled_from(
    '1 2 3 4 5 9 -1 0 0x7fffffffffffffff nan inf -inf 1e400 true "X" "Y" "C" "U" "all" "" "q_wx" "eps_c" "lambda" '
    '[] [0.0,1.0] [1.0,0.0] [0,0,0] ["q_wx","q_wx",1] ["EXY"] ["EXX","EXX"] [[1]] {} {EC="eps_c"} {EC=1} {E=2} '
    '"XFYZ" "b" "XYZ+C" "CbXt" "true" "backlash" "EB0X" "a*s" "depth*(s" "depth/s_b" "u/K" "s" '
    "1979-05-27 07:32:00 'a\"b'".split()
)


@st.composite
def mutated(draw: st.DrawFn) -> str:
    lines = draw(st.sampled_from(SEEDS)).split("\n")
    for _ in range(draw(st.integers(1, 6))):
        at = draw(st.integers(0, len(lines) - 1))
        match draw(st.sampled_from(["delete", "duplicate", "swap", "value", "key", "text"])):
            case "delete":
                del lines[at]
                lines = lines or [""]
            case "duplicate":
                lines.insert(draw(st.integers(0, len(lines))), lines[at])
            case "swap":
                other = draw(st.integers(0, len(lines) - 1))
                lines[at], lines[other] = lines[other], lines[at]
            case "value" if "=" in lines[at]:
                lines[at] = lines[at].partition("=")[0] + "= " + draw(VALUES)
            case "key" if "=" in lines[at]:
                key = draw(
                    st.sampled_from(
                        "number lower moves sense travel position motion_errors tool structure a.b kind component axis "
                        "runs end name expression components unit grid".split()
                    )
                )
                lines[at] = key + " = " + lines[at].partition("=")[2]
            case _:
                lines[at] = draw(st.text(max_size=12))
    return "\n".join(lines)


def read(text: str) -> Machine | None:
    try:
        return machine_of(text)
    except InputError as error:
        faults = error.faults
    assert faults
    # One line, but for the caret under a place in an expression.
    assert all(fault.problem and ("\n" not in str(fault) or str(fault).endswith("^")) for fault in faults)
    return None


# A loop that is followed for ever must fail here: a spec is read in milliseconds.
@settings(deadline=timedelta(seconds=5), max_examples=300, suppress_health_check=[HealthCheck.too_slow])
@given(mutated())
def test_a_mutated_spec_gives_a_machine_or_faults(text: str) -> None:
    machine = read(text)
    if machine is None:
        return
    # What passed the checks can be walked: every body leads down to the bed, every axis has its one body.
    assert lower_body_array(machine)[-1] == (0,) * (len(machine.bodies) + 1)
    assert all(body in sum(branches(machine), ()) for body in machine.bodies)
    assert len({body.number for body in machine.bodies}) == len(machine.bodies)
    assert all(low < high for low, high in machine.travel.values())
    assert len(set(machine.parameters)) == len(machine.parameters)


@settings(deadline=timedelta(seconds=5), max_examples=100)
@given(st.text())
def test_any_text_gives_faults(text: str) -> None:
    assert read(text) is None


@settings(deadline=timedelta(seconds=5))
@given(st.lists(st.tuples(st.integers(0, 6), st.integers(0, 6)), min_size=1, max_size=6), st.integers(0, 6))
def test_any_wiring_of_bodies_gives_a_machine_or_faults(wires: list[tuple[int, int]], tool: int) -> None:
    bodies = [f'[[body]]\nnumber = {n}\nname = "b{k}"\nlower = {lower}\n' for k, (n, lower) in enumerate(wires)]
    text = f'schema = 1\nname = "m"\n{"".join(bodies)}[ends]\nworkpiece = 1\ntool = {tool}\n'
    machine = read(text)
    tree = dict(wires)
    chain = [tool]
    while chain[-1] in tree and len(chain) <= len(tree):
        chain.append(tree[chain[-1]])
    numbers = [n for n, _ in wires]
    right = (
        len(set(numbers)) == len(numbers)
        and min(numbers) >= 2
        and tool != 1
        and chain[-1] == 1
        and set(chain) == {1, *numbers}
    )
    assert (machine is not None) == right


def test_an_effect_of_a_mutation_is_seen() -> None:
    # The fuzz would prove nothing if every text failed.
    assert all(read(text) is not None for text in SEEDS)
    with pytest.raises(InputError):
        machine_of(BASE.replace("lower = 5", "lower = 9"))
