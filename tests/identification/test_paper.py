"""Point by point, step by step: against the independent generator."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from tests.generator.dmu60p import PARAMETERS, cubic_errors, sine_errors
from tests.generator.dmu60p import dmu60p as generator
from tests.generator.machine import Function
from tests.identification.data import (
    P9_PRINTED,
    TRAVEL,
    line,
    moving,
    observed,
    paper_data,
    paper_runs,
    tool,
)
from tests.identification.machines import dmu60p
from trueaxis.estimation.observations import Observations
from trueaxis.identification.paper.method import identify_paper
from trueaxis.identification.paper.solution import PaperOptions
from trueaxis.identification.report import Identification
from trueaxis.io.faults import InputError
from trueaxis.measurement.setup import PointOn, Run
from trueaxis.model.curves import TableCurve
from trueaxis.model.errors import ErrorValues

LEVER = 700.0
DIMENSIONS = {name: value for name, value in PARAMETERS.items() if name.startswith("q")}
KNOWN = PaperOptions("known", ErrorValues(machine="dmu60p", parameters=PARAMETERS))
CONVENTION = PaperOptions("convention", ErrorValues(machine="dmu60p", parameters=DIMENSIONS))
SECT36 = PaperOptions("from-angles", ErrorValues(machine="dmu60p", parameters=DIMENSIONS))


def off(found: Identification, truth: dict[str, Function], name: str) -> float:
    """Largest difference from the truth over the table, mm or rad times the lever."""
    curve = found.values.motion_errors[name]
    assert isinstance(curve, TableCurve)
    true = [float(truth[name](position)) for position in curve.positions]
    return float(np.abs(np.array(curve.values) - true).max()) * (LEVER if name[1] in "ABC" else 1.0)


def _sloped(function: Function, by: float) -> Function:
    return lambda s: function(s) + by * s


def level(truth: dict[str, Function], count: int) -> dict[str, Function]:
    """The same errors with level least-squares lines of the straightness at the measured positions."""
    found = dict(truth)
    for name in ("EYX", "EXZ", "EYZ"):
        at = TRAVEL[name[2]] * np.arange(count) / (count - 1)
        slope = float(np.polynomial.polynomial.polyfit(at, [float(truth[name](s)) for s in at], 1)[1])
        found[name] = _sloped(truth[name], -slope)
    return found


@pytest.mark.parametrize("errors", [cubic_errors, sine_errors])
def test_noise_free_readings_give_the_errors_back(errors: object) -> None:
    truth = errors()  # type: ignore[operator]
    found = identify_paper(dmu60p(), paper_data(generator(truth)), KNOWN)
    assert max(off(found, truth, name) for name in truth) < 1e-12
    assert set(found.values.motion_errors) == set(truth)
    assert found.report.residual_rms_um < 1e-9


def test_blocks_come_in_the_order_of_the_paper() -> None:
    found = identify_paper(dmu60p(), paper_data(generator(cubic_errors()), 4), KNOWN)
    assert [(block.runs, set(block.components)) for block in found.report.blocks] == [
        (("X-1", "X-2", "X-3"), {"EXX", "EBX", "ECX"}),
        (("Y-4", "Y-5", "Y-6"), {"EYY", "EAY", "ECY"}),
        (("Z-7", "Z-8", "Z-9"), {"EZZ", "EAZ", "EBZ"}),
        (("XZ-1x", "XZ-2x"), {"EXZ", "ECZ"}),
        (("XZ-1z", "XZ-2z"), {"EZX", "EAX"}),
        (("XY-1x", "XY-2x"), {"EXY", "EBY"}),
        (("XY-1y",), {"EYX"}),
        (("YZ-1y",), {"EYZ"}),
        (("YZ-1z",), {"EZY"}),
    ]
    assert all(block.rank == block.unknowns for block in found.report.blocks)


def test_squareness_by_convention_comes_back_where_the_truth_obeys_it() -> None:
    truth = level(cubic_errors(), 10)
    found = identify_paper(dmu60p(), paper_data(generator(truth)), CONVENTION)
    assert max(off(found, truth, name) for name in truth) < 1e-12
    for name in ("eps_xy", "eps_yz", "eps_xz"):
        assert abs(found.values.parameters[name] - PARAMETERS[name]) * LEVER < 1e-12


def test_convention_moves_squareness_and_slope_against_each_other_only() -> None:
    truth = cubic_errors()
    found = identify_paper(dmu60p(), paper_data(generator(truth)), CONVENTION)
    for name, location, sign in (("EYX", "eps_xy", 1.0), ("EXZ", "eps_xz", 1.0), ("EYZ", "eps_yz", -1.0)):
        curve = found.values.motion_errors[name]
        at = np.array(curve.positions)  # type: ignore[union-attr]
        together = np.array(curve.values) + sign * at * found.values.parameters[location]  # type: ignore[union-attr]
        true = np.array([float(truth[name](s)) for s in at]) + sign * at * PARAMETERS[location]
        assert np.abs(together - true).max() < 1e-5  # the convention acts on other errors in second order
        assert abs(np.polyfit(at, curve.values, 1)[0]) < 1e-17  # type: ignore[union-attr]
    words = [item.combination for item in found.values.undetermined]
    assert words[0].startswith(
        "eps_xy and the slope of EYX: only their sum is determined (+1 rad of eps_xy with -1 mm/mm"
    )
    assert words[1].startswith("eps_yz and the slope of EYZ: only their difference")


def test_squareness_of_section_36_is_the_hand_worked_one() -> None:
    count, truth = 10, cubic_errors()
    found = identify_paper(dmu60p(), paper_data(generator(truth), count), SECT36)

    def slope(angle: str, axis: str) -> float:
        """Eqs. (39) and (41), the sum of P in place of the printed sum of v P."""
        at = [TRAVEL[axis] * i / (count - 1) for i in range(1, count)]
        sums = [sum(float(truth[angle](s)) * s for s in at[: h + 1]) for h in range(len(at))]
        n, v, p = len(at), sum(at), sum(sums)
        vv, vp = sum(s * s for s in at), sum(s * q for s, q in zip(at, sums, strict=True))
        return (n * vp - v * p) / (n * vv - v * v)

    yx, zx, xy = slope("ECX", "X"), slope("EBX", "X"), slope("ECY", "Y")
    zy, yz, xz = slope("EAY", "Y"), slope("EAZ", "Z"), slope("EBZ", "Z")
    x, y, z = (1 + yx**2 + zx**2) ** 0.5, (1 + xy**2 + zy**2) ** 0.5, (1 + xz**2 + yz**2) ** 0.5
    # Table 2: X runs along (1, eps_xy, 0), Y along (0, 1, 0), Z along (eps_xz, -eps_yz, 1)
    expected = {
        "eps_xy": np.pi / 2 - np.arccos((xy + yx + zx * zy) / (x * y)),
        "eps_xz": np.pi / 2 - np.arccos((xz + zx + yx * yz) / (x * z)),
        "eps_yz": np.arccos((yz + zy + xy * xz) / (y * z)) - np.pi / 2,
    }
    for name, value in expected.items():
        # the angles were found with another squareness than the true one: second order, 1e-4 of them
        assert found.values.parameters[name] == pytest.approx(value, rel=1e-3)
    assert abs(expected["eps_xz"]) > 1e-5  # the sign is seen


def test_published_points_leave_z_singular_and_it_is_said() -> None:
    truth = cubic_errors()
    found = identify_paper(dmu60p(), paper_data(generator(truth), 10, P9_PRINTED), replace(KNOWN, noise_um=0.3))
    z = found.report.blocks[2]
    assert (z.equations, z.unknowns, z.rank) == (27, 27, 18)
    assert "runs Z-8 and Z-9 are one point" in z.remark
    first, second = found.values.undetermined[:2]
    assert set(first.parameters) == {"EZZ", "EAZ", "EBZ"}
    for words in ("2 equations for 3 unknowns", "Z-7, Z-8 and Z-9", "+63.27 mm of EZZ", "+0.1087 rad of EBZ"):
        assert words in first.combination
    assert set(second.parameters) == {"EYX", "EZX", "EAX", "EZY", "EXZ", "EYZ"}
    known = {part.name: part.known for part in found.report.components}
    determined = {name for name in truth if known[name] == "determined"}
    assert determined == {"EXX", "EBX", "ECX", "EYY", "EAY", "ECY", "ECZ", "EXY", "EBY"}
    assert max(off(found, truth, name) for name in determined) < 1e-5  # what is open acts on them in second order
    for name in set(truth) - determined:
        u = found.values.motion_errors[name].u
        assert u is not None
        assert u[0] == 0.0
        assert np.isnan(u[1:]).all()


def test_the_stated_combination_changes_no_reading() -> None:
    at = line("Z", 4)
    runs = [run for run in paper_runs(P9_PRINTED) if moving(run) == "Z"]
    tilt = 1e-9  # rad: second order below 1e-16 mm
    added: dict[str, Function] = {
        "EAZ": lambda s: 46 * tilt * (s > 0),
        "EBZ": lambda s: 5 * tilt * (s > 0),
        "EZZ": lambda s: 2910.25 * tilt * (s > 0),
    }  # from the points by hand, (-98.75, -74) and (-52.75, -69) from the Z slide; 63.27 mm and 0.1087 rad per rad
    readings = observed(generator(added, DIMENSIONS), runs, [at] * 3).reading
    assert np.abs(readings).max() < 1e-14
    assert abs(2910.25 / 46 - 63.27) < 0.005


def test_home_away_from_zero_is_taken_into_account() -> None:
    truth = cubic_errors()
    home = {"X": 180.0, "Y": 0.0, "Z": 0.0}
    runs = paper_runs(home=home)
    data = observed(generator(truth), runs, [line(moving(run), 10, home) for run in runs])
    found = identify_paper(dmu60p(), data, KNOWN)
    assert max(off(found, truth, name) for name in truth) < 1e-11
    assert float(truth["EXX"](180.0)) != 0.0


def test_position_not_measured_before_is_named() -> None:
    runs = [run for run in paper_runs() if moving(run) in ("X", "Z", "XZ")]
    positions = [line(moving(run), 7 if moving(run) == "XZ" else 4) for run in runs]
    with pytest.raises(InputError) as caught:
        identify_paper(dmu60p(), observed(generator(cubic_errors()), runs, positions), KNOWN)
    text = str(caught.value)
    assert "run XZ-1x: X = 90 was not measured before" in text
    assert "Z = 100 was not measured before" in text
    assert "--method global" in text


def test_oblique_directions_make_one_block_of_six() -> None:
    truth = cubic_errors()
    points = [(30.0, -80.0, 120.0), (-90.0, 70.0, 40.0), (110.0, 20.0, -60.0)]
    oblique = [(2.0, 1.0, 2.0), (-2.0, 2.0, 1.0), (1.0, 2.0, -2.0)]
    runs = [
        replace(tool(f"{point}{way}", "x", point), direction=(x / 3.0, y / 3.0, z / 3.0))
        for point in points
        for way, (x, y, z) in enumerate(oblique)
    ]
    found = identify_paper(dmu60p(), observed(generator(truth), runs, [line("X", 6)] * len(runs)), KNOWN)
    (block,) = found.report.blocks
    assert set(block.components) == {"EXX", "EYX", "EZX", "EAX", "EBX", "ECX"}
    assert (block.rank, block.unknowns, block.equations) == (30, 30, 45)
    assert max(off(found, truth, name) for name in block.components) < 1e-12
    assert {part.name: part.known for part in found.report.components}["EXY"] == "not measured"


@pytest.mark.slow
def test_uncertainty_is_that_of_readings_moved_one_by_one() -> None:
    machine, data = dmu60p(), paper_data(generator(cubic_errors()), 3)
    options = replace(CONVENTION, noise_um=1.0)
    base = identify_paper(machine, data, options)
    step, squares = 1e-3, dict.fromkeys((*base.values.motion_errors, "eps_xy", "eps_xz", "eps_yz"), 0.0)
    for row in np.flatnonzero(data.positions.any(axis=0)):  # at home a reading holds nothing
        reading = data.reading.copy()
        reading[row] += step
        moved = identify_paper(machine, replace(data, reading=reading), options).values
        for name in squares:
            squares[name] += (last(moved, name) - last(base.values, name)) ** 2
    for name, total in squares.items():
        u = base.values.u[name] if name in base.values.u else base.values.motion_errors[name].u[-1]  # type: ignore[index]
        # levelled lines of three points end where they began, whatever is read: variances of 1e-6 cancel to rounding
        assert u == pytest.approx(np.sqrt(total) * 1e-3 / step, rel=1e-3, abs=2e-9), name


def last(values: ErrorValues, name: str) -> float:
    if name in values.motion_errors:
        return float(values.motion_errors[name].values[-1])  # type: ignore[union-attr]
    return values.parameters[name]


def test_repeats_are_averaged_and_give_the_noise() -> None:
    machine, data = dmu60p(), paper_data(generator(cubic_errors()), 4)
    noise = np.random.default_rng(5).normal(0.0, 0.5e-3, (8, data.reading.size))
    repeated = Observations(
        source=data.source,
        runs=data.runs,
        run=np.tile(data.run, 8),
        positions=np.tile(data.positions, 8),
        reading=(data.reading + noise).ravel(),
    )
    found = identify_paper(machine, repeated, KNOWN)
    mean = identify_paper(machine, replace(data, reading=(data.reading + noise).mean(axis=0)), KNOWN)
    for name, curve in mean.values.motion_errors.items():
        assert np.allclose(found.values.motion_errors[name].values, curve.values, rtol=0, atol=1e-14)  # type: ignore[union-attr]
    away = data.positions.any(axis=0)
    within = noise[:, away] - noise[:, away].mean(axis=0)
    assert found.report.freedom == 7 * away.sum()
    assert found.report.noise_um is not None
    assert found.report.noise_um == pytest.approx(0.5, rel=0.06)
    assert found.report.noise_um >= 1e3 * np.sqrt((within**2).sum() / found.report.freedom) * 0.999


def test_unknown_noise_gives_no_uncertainty_and_says_so() -> None:
    found = identify_paper(dmu60p(), paper_data(generator(cubic_errors()), 3), KNOWN)
    assert found.report.noise_um is None
    assert found.report.noise_origin.startswith("unknown")
    assert all(curve.u is None for curve in found.values.motion_errors.values())


@pytest.mark.parametrize("seed", range(3))
def test_order_of_rows_and_runs_does_not_matter(seed: int) -> None:
    machine, data = dmu60p(), paper_data(generator(cubic_errors()), 4)
    base = identify_paper(machine, data, CONVENTION)
    source = np.random.default_rng(seed)
    rows, runs = source.permutation(data.reading.size), source.permutation(len(data.runs))
    place = np.argsort(runs)
    mixed = Observations(
        source=data.source,
        runs=tuple(data.runs[i] for i in runs),
        run=place[data.run[rows]],
        positions=data.positions[:, rows],
        reading=data.reading[rows],
    )
    other = identify_paper(machine, mixed, CONVENTION)
    for name, curve in base.values.motion_errors.items():
        assert np.allclose(other.values.motion_errors[name].values, curve.values, rtol=0, atol=1e-13)  # type: ignore[union-attr]


def test_known_components_are_not_identified_but_used() -> None:
    truth = cubic_errors()
    data = paper_data(generator(truth), 4)
    full = identify_paper(dmu60p(), data, KNOWN).values
    given = {name: full.motion_errors[name] for name in ("EXX", "EBX", "ECX")}
    keep = np.flatnonzero(np.isin(data.run, [i for i, run in enumerate(data.runs) if moving(run) != "X"]))
    options = replace(KNOWN, known=ErrorValues(machine="dmu60p", parameters=PARAMETERS, motion_errors=given))
    found = identify_paper(dmu60p(), data.of(keep), options)
    assert max(off(found, truth, name) for name in truth) < 1e-12
    assert {part.name for part in found.report.components if part.known == "given"} == set(given)


def test_ball_bar_runs_are_left_out_and_alone_refused() -> None:
    bar = Run(
        id="bar",
        instrument="ballbar",
        target=PointOn("tool"),
        reference=PointOn("workpiece"),
        frame="bed",
        home={},
        length=100.0,
    )
    laser = paper_data(generator(cubic_errors()), 4)
    both = Observations(
        source=laser.source,
        runs=(*laser.runs, bar),
        run=np.append(laser.run, len(laser.runs)),
        positions=np.hstack([laser.positions, [[100.0], [0.0], [0.0]]]),
        reading=np.append(laser.reading, 0.01),
    )
    found = identify_paper(dmu60p(), both, KNOWN)
    assert found.report.left_out == ("bar",)
    assert found.report.readings == laser.reading.size
    with pytest.raises(InputError, match="--method global"):
        identify_paper(dmu60p(), both.of(np.array([laser.reading.size])), KNOWN)


def test_too_few_runs_are_named() -> None:
    """X-1 and X-2 differ in z alone: the pitch EBX follows from them and nothing else."""
    runs = [run for run in paper_runs() if run.id in ("X-1", "X-2")]
    data = observed(generator(cubic_errors()), runs, [line("X", 4)] * 2)
    found = identify_paper(dmu60p(), data, KNOWN)
    (block,) = found.report.blocks
    assert (block.rank, block.unknowns) == (6, 9)
    assert block.remark == "too few runs hold these components"
    assert [part.name for part in found.report.components if part.known == "determined"] == ["EBX"]
    assert not found.report.nothing_determined
    one = identify_paper(dmu60p(), data.of(np.flatnonzero(data.run == 0)), KNOWN)
    assert one.report.nothing_determined


def test_tables_hold_the_measured_positions() -> None:
    found = identify_paper(dmu60p(), paper_data(generator(cubic_errors()), 5), KNOWN)
    for name, curve in found.values.motion_errors.items():
        assert isinstance(curve, TableCurve)
        assert np.allclose(curve.positions, TRAVEL[name[2]] * np.arange(5) / 4)
        assert all(b > a for a, b in pairwise(curve.positions))
