"""Identification systems of the paper's runs: order, closed form, use, and what they cannot determine."""

from collections.abc import Mapping, Sequence
from functools import cache
from types import ModuleType
from typing import Any

import numpy as np
import pytest
import sympy as sp

from tests.exact_chain import DIGITS, ExactChain
from tests.machines import DMU60P, ROOT, machine_at, machine_of, serial_text
from trueaxis.codegen.equations import equations_page
from trueaxis.codegen.numpy_source import numpy_source
from trueaxis.derivation.model import DerivedModel, derive_model
from trueaxis.derivation.systems import RunPattern, identification, point_values, run_motion, undetermined
from trueaxis.jobs.derive import run_patterns
from trueaxis.measurement.data import read_data
from trueaxis.view import Carrier, Frame

CHAIN = ExactChain(DMU60P.read_text())
DIMENSIONS = {"q_wx": 270.0, "q_wy": -350.0, "q_wz": 12.5, "q_Tx": 1.25, "q_Ty": 3.0, "q_Tz": 400.0}


@cache
def patterns(folder: str) -> tuple[RunPattern, ...]:
    machine = machine_at(DMU60P)
    return run_patterns(machine, read_data(ROOT / "machines" / folder, machine))


@cache
def derived(folder: str = "dmu60p_runs") -> DerivedModel:
    return derive_model(machine_at(DMU60P), patterns(folder))


def moved(chain: ExactChain, run: RunPattern, pose: Mapping[str, float], values: Mapping[str, Any]) -> Any:
    """Displacement of the target minus that of the reference since home, along the sensed direction."""
    home = dict.fromkeys(chain.axes, 0.0)
    still = {name: value for name, value in values.items() if name not in chain.components}

    def since_home(end: tuple[str, Any]) -> Any:
        body, point = end
        if body == run.frame:
            return DIGITS.matrix([0, 0, 0])
        view = f"{body}_in_{run.frame}"
        return chain.place(view, pose, values, point) - chain.place(view, home, still, point)

    difference = since_home(run.target) - since_home(run.reference)
    return sum(d * v for d, v in zip(run.direction, difference, strict=True))


def first_order_readings(
    chain: ExactChain, run: RunPattern, pose: Mapping[str, float], dimensions: Mapping[str, Any], errors: Any
) -> list[float]:
    """The run's reading per set of errors, linear in them: forward differences, step 1e-15 in forty digits."""
    step, without = DIGITS.mpf("1e-15"), moved(chain, run, pose, dimensions)
    found = []
    for each in errors:
        seen = {n: step * v for n, v in each.items() if n not in chain.components or n[2] in run.moves}
        found.append(float((moved(chain, run, pose, {**dimensions, **seen}) - without) / step) if seen else 0.0)
    return found


def pose_of(run: RunPattern, fraction: float, travel: Mapping[str, tuple[float, float]]) -> dict[str, float]:
    return {axis: fraction * span[1] if axis in run.moves else 0.0 for axis, span in travel.items()}


def test_the_order_found_is_the_papers() -> None:
    # Eqs. (18), (19), (20): one axis at a time; (26) after them; (32), (34), then (38) last.
    found = derived().identification
    assert found is not None
    assert [("".join(m), system.unknowns) for system in found.systems for m in system.moves] == [
        ("X", ("EXX", "ECX", "EBX")),
        ("Y", ("EYY", "ECY", "EAY")),
        ("Z", ("EZZ", "EBZ", "EAZ")),
        ("XZ", ("EXZ", "ECZ")),
        ("XZ", ("EZX", "EAX")),
        ("XY", ("EXY", "EBY")),
        ("XY", ("EYX",)),
        ("YZ", ("EYZ",)),
        ("YZ", ("EZY",)),
    ]
    assert found.unreached == found.unseen == ()


def test_the_order_does_not_hang_on_the_order_of_the_runs() -> None:
    backwards = identification(machine_at(DMU60P), tuple(reversed(patterns("dmu60p_runs"))))
    known: set[str] = set()
    for system in backwards.systems:
        needs = {symbol.name for value in system.known for symbol in value.free_symbols} & set(CHAIN.components)
        assert needs <= known
        known |= set(system.unknowns)
    assert known == set(CHAIN.components)


def test_each_closed_form_inverse_is_the_inverse() -> None:
    found = derived().identification
    assert found is not None
    for system in found.systems:
        assert system.inverse is not None
        assert sp.simplify(system.inverse * system.matrix) == sp.eye(len(system.unknowns))
        assert sp.simplify(system.matrix.det() - system.determinant) == 0


@pytest.mark.parametrize("fraction", [1.0, 0.37])
def test_the_routines_recover_every_component_from_exact_first_order_readings(fraction: float) -> None:
    model = derived("dmu60p_regular_runs")
    assert model.identification is not None
    runs = {run.name: run for run in patterns("dmu60p_regular_runs")}
    rng = np.random.default_rng(1)
    errors = {n: rng.uniform(-1, 1) * (1e-2 if n[1] in "XYZ" else 1e-4) for n in CHAIN.components}
    errors |= {name: rng.uniform(-1, 1) * 1e-4 for name in CHAIN.location_errors}
    location = {name: errors[name] for name in CHAIN.location_errors}
    module = systems_module()
    found: dict[str, float] = {}
    for number, system in enumerate(model.identification.systems, 1):
        first = runs[system.runs[0]]
        pose = pose_of(first, fraction, model.machine.travel)
        readings = [first_order_readings(CHAIN, runs[name], pose, DIMENSIONS, [errors]) for name in system.runs]
        points = np.array([at for _, _, at in system.points])
        known = {**DIMENSIONS, **location, **found}
        # Only what was found before may be used: a component that is still unknown is given as nonsense.
        known |= {name: 1e3 for name in CHAIN.components if name not in found}
        positions = np.array([[pose[axis]] for axis in CHAIN.axes])
        given = np.array([[known[name]] for name in CHAIN.components])
        parameters = np.array([known[name] for name in model.machine.parameters])
        unknowns = getattr(module, f"system_{number}")(np.array(readings), positions, given, parameters, points)
        found |= dict(zip(system.unknowns, unknowns[:, 0], strict=True))
    assert found.keys() == set(CHAIN.components)
    for name, value in found.items():
        assert value == pytest.approx(errors[name], rel=1e-9, abs=1e-13), name


@cache
def systems_module() -> Any:
    model = derived("dmu60p_regular_runs")
    module = ModuleType("systems")
    exec(numpy_source(model.machine, model.routines), module.__dict__)
    return module


def test_the_published_points_of_z_are_singular_and_no_others() -> None:
    # P_k8 and P_k9 differ in z alone, which the z reading of a Z motion does not feel.
    found = derived().identification
    assert found is not None
    ranks = {}
    for system in found.systems:
        matrix = np.array(
            system.matrix.subs(point_values(system.points)).subs(
                {sp.Symbol(n, real=True): v for n, v in DIMENSIONS.items()}
            )
        )
        ranks[system.runs[0]] = np.linalg.matrix_rank(matrix.astype(float)) - len(system.unknowns)
    assert ranks.pop("Z-7") == -1
    assert set(ranks.values()) == {0}


def stacked(
    chain: ExactChain, runs: Sequence[RunPattern], fraction: float, travel: Mapping[str, tuple[float, float]]
) -> tuple[list[str], np.ndarray]:
    """Rows d(reading)/d(error) of all runs at a fraction of the travels, the dimensions zero."""
    names = chain.components + chain.location_errors
    each = [{name: 1} for name in names]
    rows = [first_order_readings(chain, run, pose_of(run, fraction, travel), {}, each) for run in runs]
    return names, np.array(rows)


@pytest.mark.parametrize("folder", ["dmu60p_runs", "dmu60p_regular_runs"])
def test_undetermined_combinations_change_no_reading_and_are_all_there_are(folder: str) -> None:
    machine = machine_at(DMU60P)
    combinations = undetermined(machine, patterns(folder))
    for fraction in (1.0, 0.21):
        names, rows = stacked(CHAIN, patterns(folder), fraction, machine.travel)
        scale = np.abs(rows).max(axis=0)
        # Every component moves in some run of the plan, so each position has as many free directions as the rank lacks.
        assert len(names) - np.linalg.matrix_rank(rows / scale) == len(combinations)
        for combination in combinations:
            if not set(combination) & set(CHAIN.location_errors) and fraction != 1.0:
                continue  # these hold position by position, with factors of their own
            vector = np.array(
                [
                    float(combination.get(name, 0)) * (fraction * machine.travel[name[2]][1] if name[2] in "XYZ" else 1)
                    if name in CHAIN.components
                    else float(combination.get(name, 0))
                    for name in names
                ]
            )
            assert np.abs(rows * vector).max() > 0
            assert np.abs(rows @ vector).max() < 1e-9 * np.abs(rows * vector).max()


def test_what_the_papers_runs_cannot_determine() -> None:
    found = undetermined(machine_at(DMU60P), patterns("dmu60p_regular_runs"))
    assert [set(combination) for combination in found] == [{"EYX", "eps_xy"}, {"EYZ", "eps_yz"}, {"EXZ", "eps_xz"}]


def test_a_component_without_a_run_is_said_to_be_unseen() -> None:
    only_x = tuple(run for run in patterns("dmu60p_runs") if run.moves == ("X",))
    found = identification(machine_at(DMU60P), only_x)
    assert found.systems[0].unknowns == ("EXX", "ECX", "EBX")
    assert set(found.unseen) == set(CHAIN.components) - {"EXX", "EBX", "ECX"}


def test_too_few_runs_leave_components_unreached() -> None:
    found = identification(machine_at(DMU60P), patterns("dmu60p_runs")[:2])
    assert found.systems == ()
    assert found.unreached == ("EXX", "EBX", "ECX")


def test_more_runs_than_unknowns_make_a_system_without_closed_form() -> None:
    x = patterns("dmu60p_regular_runs")[:3]
    again = RunPattern(
        name="X-again",
        moves=x[0].moves,
        direction=x[0].direction,
        frame=x[0].frame,
        target=("tool", (5.0, 6.0, 7.0)),
        reference=x[0].reference,
    )
    (system,) = identification(machine_at(DMU60P), (*x, again)).systems
    assert system.matrix.shape == (4, 3)
    assert system.inverse is None


C_RUNS = tuple(
    RunPattern(
        name=f"C{number}",
        moves=("C",),
        direction=direction,
        frame="bed",
        target=("workpiece", point),
        reference=("bed", (0.0, 0.0, 0.0)),
    )
    for number, (direction, point) in enumerate(
        [((1.0, 0, 0), (100.0, 0, 50.0)), ((0, 1.0, 0), (100.0, 0, 50.0)), ((0, 0, 1.0), (0, 80.0, 9.0))]
    )
)
TABLE = serial_text("C", "X", C={"position_errors": {"EX": "off", "EA": "tilt", "EB": "sway"}})


def test_runs_of_a_rotary_axis_let_its_curves_take_up_its_tilts() -> None:
    # By hand: a displaced axis moves no point since home; a tilt lifts the turning point, as EZC would.
    found = undetermined(machine_of(TABLE), C_RUNS)
    assert {"off": 1} in found
    assert [set(c) for c in found if "tilt" in c or "sway" in c] == [{"EZC", "tilt"}, {"EZC", "sway"}]
    assert all(value.is_Rational for combination in found for value in combination.values())


def test_combinations_of_a_rotary_axis_are_as_many_as_numbers_tell() -> None:
    chain, poses = ExactChain(TABLE), [{"C": at, "X": 0.0} for at in (20.0, 55.0, 130.0)]
    components = [name for name in chain.components if name[2] == "C"]
    names = components + chain.location_errors
    size = len(components)
    blocks = [
        np.array([first_order_readings(chain, run, pose, {}, [{n: 1} for n in names]) for run in C_RUNS])
        for pose in poses
    ]
    whole = np.zeros((len(poses) * len(C_RUNS), len(poses) * size + len(chain.location_errors)))
    for k, block in enumerate(blocks):
        rows = slice(k * len(C_RUNS), (k + 1) * len(C_RUNS))
        whole[rows, k * size : (k + 1) * size] = block[:, :size]
        whole[rows, len(poses) * size :] = block[:, size:]
    free = [size - np.linalg.matrix_rank(block[:, :size]) for block in blocks]
    found = undetermined(machine_of(TABLE), C_RUNS)
    with_location = [c for c in found if set(c) & set(chain.location_errors)]
    assert len(found) - len(with_location) == free[0] == free[1]
    assert len(with_location) == whole.shape[1] - np.linalg.matrix_rank(whole) - sum(free)


def test_a_page_tells_what_runs_of_a_rotary_axis_leave_open() -> None:
    page = equations_page(derive_model(machine_of(TABLE), C_RUNS))
    assert "tilt: the curves of EZC can take up a change of +1 rad in tilt position by position" in page


@pytest.mark.parametrize("frame", ["bed", "workpiece"])
def test_readings_in_any_direction_frame_and_of_any_points_are_those_of_the_chain(frame: Frame) -> None:
    # Slanted and backward directions, points against points: each row of a system, and what it takes as known.
    on: tuple[Carrier, Carrier] = ("tool", "workpiece" if frame == "bed" else "bed")
    machine, dimensions = machine_at(DMU60P), DIMENSIONS
    ways = [(-0.6, 0.0, 0.8), (0.0, -1.0, 0.0), (0.48, -0.6, -0.64)]
    for number, way in enumerate(ways):
        target, reference = (on[0], (10.0, -20.0, 30.5 + number)), (on[1], (-5.0, 7.25, 11.0))
        run = RunPattern(name="r", moves=("X", "Y"), direction=way, frame=frame, target=target, reference=reference)
        pose = pose_of(run, 0.4, machine.travel)
        names = [n for n in CHAIN.components + CHAIN.location_errors if n not in CHAIN.components or n[2] in run.moves]
        wanted = dict(
            zip(names, first_order_readings(CHAIN, run, pose, dimensions, [{n: 1} for n in names]), strict=True)
        )
        labels = {end: tuple(sp.symbols(f"{end[0]}x {end[0]}y {end[0]}z")) for end in (run.target, run.reference)}
        columns = run_motion(machine, run, labels).motion.columns
        values = {sp.Symbol(name, real=True): value for name, value in dimensions.items()}
        values |= {sp.Symbol(axis.lower(), real=True): at for axis, at in pose.items()}
        values |= {symbol: c for (_, at), triple in labels.items() for symbol, c in zip(triple, at, strict=True)}
        found = {
            name: float(sum(d * entry.subs(values) for d, entry in zip(way, column, strict=True)))
            for name, column in columns.items()
        }
        for name in names:
            assert found.get(name, 0.0) == pytest.approx(wanted[name], rel=1e-12, abs=1e-9), name


@pytest.mark.parametrize("way", [(-1.0, 0.0, 0.0), (-0.6, 0.0, -0.8)])
def test_a_system_of_backward_directions_has_the_signs_of_its_readings(way: tuple[float, float, float]) -> None:
    points = [(1.0, 2.0, 3.0), (4.0, -5.0, 6.0), (7.0, 8.0, -9.0)]
    machine = machine_of(DMU60P.read_text().replace(*ONLY_THREE))
    runs = [
        RunPattern(
            name=f"r{k}",
            moves=("X",),
            direction=way,
            frame="bed",
            target=("tool", p),
            reference=("bed", (0.0, 0.0, 0.0)),
        )
        for k, p in enumerate(points)
    ]
    (system,) = identification(machine, runs).systems
    chain = ExactChain(DMU60P.read_text().replace(*ONLY_THREE))
    zero = {sp.Symbol(name, real=True): 0 for name in machine.dimensions}
    found = np.array(system.matrix.subs(point_values(system.points)).subs(zero)).astype(float)
    pose = pose_of(runs[0], 0.5, machine.travel)
    wanted = [first_order_readings(chain, run, pose, {}, [{name: 1} for name in system.unknowns]) for run in runs]
    np.testing.assert_allclose(found, wanted, rtol=1e-12, atol=1e-12)


ONLY_THREE = (
    'moves = "X"\ntravel = [0.0, 540.0]\nmotion_errors = "all"',
    'moves = "X"\ntravel = [0.0, 540.0]\nmotion_errors = ["EXX", "EBX", "ECX"]',
)


def test_large_systems_are_told_without_a_closed_form() -> None:
    # Six unknowns seen in slanted directions: their inverse in symbols would take a minute and a page each.
    rng = np.random.default_rng(0)
    runs = []
    for number in range(6):
        way = rng.normal(size=3)
        x, y, z = (float(part) for part in way / np.linalg.norm(way))
        at = (float(number), float(number**2 % 7), 3.0 * number)
        runs.append(
            RunPattern(
                name=f"r{number}",
                moves=("X",),
                direction=(x, y, z),
                frame="bed",
                target=("tool", at),
                reference=("bed", (0.0, 0.0, 0.0)),
            )
        )
    model = derive_model(machine_at(DMU60P), runs)
    assert model.identification is not None
    (system,) = model.identification.systems
    assert len(system.unknowns) == 6
    assert system.inverse is None
    assert "system_1" not in {routine.name for routine in model.routines}
    assert "### 1. EXX, EYX, EZX, ECX, EBX, EAX (X)" in equations_page(model)
