"""Uncertainty of the tool point: from a covariance, from the values' own u, and what nothing determines."""

import json
import re
import tracemalloc
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.machines import ROOT
from trueaxis.cli.main import main
from trueaxis.error_name import ErrorName
from trueaxis.io.faults import InputError
from trueaxis.model.bases import HatBasis, LegendreBasis, PowerBasis, unmeasured_basis
from trueaxis.model.context import Context
from trueaxis.model.covariance import Covariance, digest_of_numbers, digest_of_values, factor
from trueaxis.model.covariance_file import dump_covariance, linked, read_covariance
from trueaxis.model.curves import Curve, FloatArray, PolynomialCurve, TableCurve
from trueaxis.model.errors import ErrorValues, Fit, Undetermined, dump_errors
from trueaxis.model.extent import travel_positions, uncertainty_extent
from trueaxis.model.measured_range import beyond_measured
from trueaxis.model.model import MachineModel, home_of, load_errors, load_model
from trueaxis.model.own_uncertainty import own_uncertainty
from trueaxis.model.uncertainty import (
    curve_u,
    derivative,
    load_uncertainty,
    prior_size,
    tool_uncertainty,
)

SOURCE = np.random.default_rng(11)
AT = np.array([[0.0, 120.0, 540.0, 333.0], [0.0, 700.0, 20.0, 350.0], [0.0, 600.0, 444.0, 10.0]])
TOOL = np.array([[12.0], [-35.0], [60.0]])


@pytest.fixture(scope="module")
def model() -> MachineModel:
    return load_model(ROOT / "machines" / "dmu60p.toml", None, ROOT / "generated", backend="numpy")


def mixed_covariance(model: MachineModel) -> Covariance:
    """A component in each kind of basis, two location errors, a full covariance."""
    bases = (LegendreBasis(low=0.0, high=540.0, degree=3), HatBasis((0.0, 200.0, 500.0)), PowerBasis((1, 3)))
    scale = np.array([3e-3] * 3 + [5e-6] * 3 + [1e-8, 1e-14] + [4e-6, 7e-6])
    mixing = SOURCE.normal(size=(10, 10))
    return Covariance(
        machine=model.name,
        components=tuple(map(ErrorName, ("EXX", "EBX", "ECY"))),
        bases=bases,
        locations=("eps_xy", "eps_xz"),
        root=scale[:, np.newaxis] * mixing,
        open=np.zeros((10, 0)),
    )


def test_derivatives_of_every_basis_are_finite_differences(model: MachineModel) -> None:
    covariance = mixed_covariance(model)
    by_value = derivative(model, covariance, AT, TOOL)
    scale = np.sqrt(np.diag(covariance.matrix))
    for index in range(covariance.count):
        ends = []
        for sign in (1.0, -1.0):
            step = np.zeros(covariance.count)
            step[index] = sign * scale[index]
            ends.append(model.with_values(with_steps(covariance, step)).deviation(AT, TOOL))
        slope = (ends[0] - ends[1]) / (2.0 * scale[index])
        np.testing.assert_allclose(by_value[:, index], slope, rtol=1e-4, atol=1e-6 * np.abs(slope).max() + 1e-12)


def with_steps(covariance: Covariance, step: FloatArray) -> ErrorValues:
    """Error values whose coefficients are the steps."""
    legendre, table, powers = covariance.bases
    assert isinstance(legendre, LegendreBasis)
    assert isinstance(table, HatBasis)
    assert isinstance(powers, PowerBasis)
    plain = step[:3] @ legendre.powers
    curves: dict[str, Curve] = {
        "EXX": PolynomialCurve(powers=(1, 2, 3), coefficients=tuple(plain.tolist())),
        "EBX": TableCurve(table.positions, tuple(step[3:6].tolist())),
        "ECY": PolynomialCurve(powers=powers.powers, coefficients=tuple(step[6:8].tolist())),
    }
    return ErrorValues(
        machine="dmu60p", parameters={"eps_xy": float(step[8]), "eps_xz": float(step[9])}, motion_errors=curves
    )


@pytest.mark.parametrize("from_home", [False, True])
def test_u_is_the_scatter_of_drawn_values(model: MachineModel, from_home: bool) -> None:
    """8000 draws through the exact model; a standard deviation of them is known to 0.8 %."""
    covariance = mixed_covariance(model)
    assert isinstance(covariance.root, np.ndarray)
    draws = SOURCE.normal(size=(8000, 10)) @ covariance.root.T
    home = home_of(model)
    deviations = []
    for draw in draws:
        drawn = model.with_values(with_steps(covariance, draw))
        at_home = drawn.deviation(home, TOOL) if from_home else 0.0
        deviations.append(drawn.deviation(AT, TOOL) - at_home)
    u = tool_uncertainty(model, covariance, AT, TOOL, datum=home if from_home else None).u
    np.testing.assert_allclose(np.std(deviations, axis=0), u, rtol=0.04, atol=1e-9)


def test_memory_is_bounded_and_pieces_change_nothing(model: MachineModel, monkeypatch: pytest.MonkeyPatch) -> None:
    covariance = mixed_covariance(model)
    tools = SOURCE.uniform(-50.0, 50.0, (3, 4))
    whole = tool_uncertainty(model, covariance, AT, tools, datum=home_of(model)).u
    monkeypatch.setattr("trueaxis.model.uncertainty._ENTRIES", 31)  # a point at a time
    pieces = tool_uncertainty(model, covariance, AT, tools, datum=home_of(model)).u
    # on some processors BLAS adds up a matrix of another width in another order: the last digit
    np.testing.assert_allclose(pieces, whole, rtol=1e-14, atol=0.0)


def test_a_combination_that_moves_no_tool_is_not_open(model: MachineModel) -> None:
    """Squareness and the slope of straightness: +1 rad of eps_xy with -1 mm/mm of EYX (the paper's Sect. 3.6)."""
    open_pair = np.array([[-1.0], [1.0]])
    pair = Covariance(
        machine=model.name,
        components=(ErrorName("EYX"),),
        bases=(PowerBasis((1,)),),
        locations=("eps_xy",),
        root=np.zeros((2, 1)),
        open=open_pair,
    )
    assert not tool_uncertainty(model, pair, AT, np.zeros((3, 1)), datum=None).open.any()
    assert not tool_uncertainty(model, pair, AT, TOOL, datum=home_of(model)).open.any()
    # the carriage is askew itself, and a tool that reaches out shows it: a slope of 20 um on 540 mm, on 35 and 12 mm
    reaching = tool_uncertainty(model, pair, AT, TOOL, datum=None).open
    np.testing.assert_allclose(reaching, np.array([[35.0], [12.0], [0.0]]) * 0.02 / 540.0 * np.ones((1, 4)), rtol=1e-6)
    assert uncertainty_extent(model, pair, AT, TOOL).shift == pytest.approx(35.0 * 0.02 / 540.0, rel=1e-6)
    alone = replace(pair, open=np.array([[0.0], [1.0]]))
    moved = tool_uncertainty(model, alone, AT, TOOL, datum=home_of(model))
    # 100 urad of the prior: the X carriage stands askew and carries the tool off by 100 urad times its way
    assert moved.open[1, 2] == pytest.approx(100e-6 * 540.0, rel=1e-6)
    assert np.isnan(moved.u[1, 2])
    assert moved.u[0, 2] == 0.0


def test_what_nothing_holds_is_open_at_the_size_of_the_prior(model: MachineModel) -> None:
    nothing = Covariance(
        machine=model.name, components=(), bases=(), locations=(), root=np.zeros((0, 0)), open=np.zeros((0, 0))
    )
    opened = nothing.with_open_components({ErrorName("EXX"): unmeasured_basis(model.travel, ErrorName("EXX"))})
    moved = tool_uncertainty(model, opened, AT, TOOL, datum=None)
    assert 0.01 < moved.open[0].max() <= 0.02 + 1e-12
    assert not moved.open[1:].any()
    assert np.isnan(moved.u[0, 1:]).all()
    assert (moved.u[1:] == 0.0).all()
    assert uncertainty_extent(model, opened, travel_positions(model, opened), TOOL).components == ("EXX",)


def test_own_uncertainties_count_as_independent(model: MachineModel) -> None:
    errors = ErrorValues(
        machine="dmu60p",
        parameters={"eps_xy": 1e-5, "eps_yz": 2e-5, "eps_xz": 0.0},
        motion_errors={
            "EXX": TableCurve((0.0, 540.0), (0.0, 0.01), (0.0, 3e-3)),
            "EYY": PolynomialCurve(powers=(1,), coefficients=(1e-5,), u=(4e-6,)),
        },
        u={"eps_xy": 2e-6, "eps_yz": 1e-6, "eps_xz": 0.0},
    )
    covariance = own_uncertainty(model.machine, errors)
    u = tool_uncertainty(model, covariance, np.array([[270.0], [0.0], [0.0]]), np.zeros((3, 1)), datum=None).u
    np.testing.assert_allclose(u[:, 0], [1.5e-3, 270.0 * 2e-6, 0.0], rtol=1e-6, atol=1e-12)


def test_tables_of_a_thousand_values_cost_as_much_as_they_hold(model: MachineModel) -> None:
    travel = np.linspace(0.0, 540.0, 1001)
    table = TableCurve(tuple(travel), tuple(1e-5 * travel), u=(1e-4,) * travel.size)
    errors = ErrorValues(machine="dmu60p", parameters={}, motion_errors=dict.fromkeys(model.components, table))
    tracemalloc.start()
    try:
        tool_uncertainty(model, own_uncertainty(model.machine, errors), AT, np.zeros((3, 1)), datum=None)
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert peak < 50e6, "a matrix of all values times all has 2.6e9 bytes"


@pytest.mark.parametrize("nodes", [(20.0,), (0.0, 500.0), (-3.0, 0.0, 200.0, 500.0)])
def test_hat_functions_are_interpolation(nodes: tuple[float, ...]) -> None:
    positions = np.concatenate([np.linspace(-50.0, 600.0, 40), nodes])
    expected = [np.interp(positions, nodes, row) for row in np.eye(len(nodes))]
    np.testing.assert_allclose(HatBasis(nodes)(positions), expected, rtol=0.0, atol=1e-15)


def test_a_value_without_u_among_others_is_open(model: MachineModel) -> None:
    curves: dict[str, Curve] = {
        "EXX": TableCurve((0.0, 540.0), (0.0, 0.01), (0.0, np.nan)),
        "EYY": PolynomialCurve(powers=(1,), coefficients=(1e-5,), u=(0.0,)),
    }
    moved = tool_uncertainty(
        model,
        own_uncertainty(model.machine, ErrorValues(machine="dmu60p", parameters={}, motion_errors=curves)),
        AT,
        np.zeros((3, 1)),
        datum=None,
    )
    assert (moved.open[0, 1:] > 0.0).all()
    assert not moved.open[1:].any()


def test_values_without_any_u_are_not_known_but_not_open(model: MachineModel) -> None:
    errors = ErrorValues(
        machine="dmu60p", parameters={}, motion_errors={"EXX": PolynomialCurve(powers=(1,), coefficients=(1e-5,))}
    )
    moved = tool_uncertainty(model, own_uncertainty(model.machine, errors), AT, np.zeros((3, 1)), datum=None)
    assert np.isnan(moved.u).all()
    assert not moved.open.any()
    named = replace(errors, undetermined=(Undetermined("EZX: no run holds it", ("EZX",)),))
    moved = tool_uncertainty(model, own_uncertainty(model.machine, named), AT, np.zeros((3, 1)), datum=None)
    assert moved.open[2].any()


def test_a_file_comes_back_as_it_was(model: MachineModel, tmp_path: Path) -> None:
    covariance = mixed_covariance(model)
    file = tmp_path / "c.npz"
    file.write_bytes(dump_covariance(covariance))
    assert file.read_bytes() == dump_covariance(covariance)
    again = read_covariance(file, model.machine)
    assert again.bases == covariance.bases
    np.testing.assert_array_equal(again.matrix, covariance.matrix)
    unknown = replace(covariance, root=None, open=np.eye(10)[:, :2])
    file.write_bytes(dump_covariance(unknown))
    again = read_covariance(file, model.machine)
    assert again.root is None
    np.testing.assert_array_equal(again.open, unknown.open)


def test_the_second_uncertainty_stands_beside_the_first(model: MachineModel, tmp_path: Path) -> None:
    """The second covariance, by usual sizes, doubles one component and halves the others; its file keeps it."""
    covariance = mixed_covariance(model)
    assert isinstance(covariance.root, np.ndarray)
    factors = np.full(covariance.count, 0.5)
    factors[covariance.rows_of(covariance.components[0])] = 2.0
    second = replace(covariance, root=factors[:, np.newaxis] * covariance.root)
    file = tmp_path / "c.npz"
    file.write_bytes(dump_covariance(replace(covariance, usual=second)))
    both = read_covariance(file, model.machine)
    home = home_of(model)
    one, other, found = (
        tool_uncertainty(model, known, AT, np.zeros((3, 1)), datum=home) for known in (covariance, second, both)
    )
    assert (other.u > one.u).any()
    assert (other.u < one.u).any()
    np.testing.assert_allclose(found.u, one.u, rtol=1e-12)
    assert found.u_usual is not None
    np.testing.assert_allclose(found.u_usual, other.u, rtol=1e-12)
    assert one.u_usual is None
    part = both.of(both.components[:1], (), ())
    assert part.usual is not None
    assert curve_u(part.usual, part.components[0], np.array([100.0])) == pytest.approx(
        2.0 * curve_u(part, part.components[0], np.array([100.0]))
    )


def test_edited_values_do_not_keep_their_uncertainties(model: MachineModel, tmp_path: Path) -> None:
    machine = model.machine
    covariance = mixed_covariance(model)
    values, content = linked(
        with_steps(covariance, np.full(10, 1e-16)), covariance, tmp_path / "e.json", tmp_path / "e.npz"
    )
    (tmp_path / "e.npz").write_bytes(content)
    path = tmp_path / "e.json"
    path.write_text(dump_errors(values, components=machine.components, parameters=machine.parameters))
    errors = load_errors(path, machine)
    np.testing.assert_array_equal(load_uncertainty(path, errors, machine).matrix, covariance.matrix)
    tree = json.loads(path.read_text())
    tree["parameters"]["eps_xy"] = 2e-9
    path.write_text(json.dumps(tree))
    with pytest.raises(InputError, match=r"e\.npz is the covariance of other values"):
        load_uncertainty(path, load_errors(path, machine), machine)
    (tmp_path / "e.npz").unlink()
    with pytest.raises(InputError, match=r"e\.npz, the covariance of these values, is not there"):
        load_uncertainty(path, replace(errors), machine)


def test_the_digest_is_of_values_and_of_what_is_decided_by() -> None:
    curve = PolynomialCurve(powers=(2, 1), coefficients=(1e-8, 1e-5), u=(1e-9, 1e-6), measured=(0.0, 100.0))
    plain = PolynomialCurve(powers=(1, 2), coefficients=(1e-5, 1e-8), u=None, measured=(0.0, 100.0))
    values = ErrorValues(
        machine="m", parameters={"a": 1.0}, motion_errors={"EXX": plain}, fit=Fit("misfit", 9.0, ("X-1",))
    )
    assert digest_of_values(replace(values, motion_errors={"EXX": curve}, u={"a": 0.1})) == digest_of_values(values)
    edited = [
        replace(values, parameters={"a": 1.0 + 1e-15}),
        replace(values, fit=Fit("converged")),
        replace(values, fit=None),
        replace(values, motion_errors={"EXX": replace(plain, measured=(0.0, 500.0))}),
        replace(values, determined={"EXX": "data"}),
        replace(values, undetermined=(Undetermined("EXX: x^1", ("EXX",)),)),
    ]
    assert len({digest_of_values(one) for one in (values, *edited)}) == 1 + len(edited)


def test_a_misfit_that_was_edited_away_is_refused_and_older_files_are_read(model: MachineModel, tmp_path: Path) -> None:
    machine, covariance, path = model.machine, mixed_covariance(model), tmp_path / "e.json"
    misfit = replace(with_steps(covariance, np.full(10, 1e-16)), fit=Fit("misfit", 9.0, ("X-1",)))
    values, content = linked(misfit, covariance, path, tmp_path / "e.npz")
    text = dump_errors(values, components=machine.components, parameters=machine.parameters)
    (tmp_path / "e.npz").write_bytes(content)
    path.write_text(text)
    assert load_uncertainty(path, load_errors(path, machine), machine).count == covariance.count
    path.write_text(text.replace('"misfit"', '"converged"'))
    with pytest.raises(InputError, match=r"or how they were judged \(fit, determined"):
        load_uncertainty(path, load_errors(path, machine), machine)
    (tmp_path / "e.npz").write_bytes(dump_covariance(replace(covariance, sha256_of_values=digest_of_numbers(values))))
    assert load_uncertainty(path, load_errors(path, machine), machine).count == covariance.count


def test_a_factor_gives_its_matrix_back_whatever_the_units() -> None:
    scale = np.array([1.0, 1e-6, 1e-12, 0.0])
    mixing = SOURCE.normal(size=(4, 4))
    matrix = np.outer(scale, scale) * (mixing @ mixing.T)
    root = factor(matrix)
    np.testing.assert_allclose(root @ root.T, matrix, rtol=1e-12, atol=0.0)


def test_smoothing_acts_on_noise_and_leaves_open_what_is_open(model: MachineModel) -> None:
    """A table whose values become their mean: its independent noise shrinks by the root of their number."""
    table = Covariance(
        machine=model.name,
        components=(ErrorName("EAX"), ErrorName("EXX")),
        bases=(PowerBasis((1,)), HatBasis((0.0, 180.0, 360.0, 540.0))),
        locations=("eps_xz",),
        root=np.diag([1e-9, 2e-3, 2e-3, 2e-3, 2e-3, 1e-6]),
        open=np.eye(6)[:, 4:5],
    )
    smooth = table.smoothed({"EXX": np.full((4, 4), 0.25)})
    at = np.array([[180.0, 360.0], [0.0, 0.0], [0.0, 0.0]])
    before, after = (tool_uncertainty(model, one, at, np.zeros((3, 1)), datum=None) for one in (table, smooth))
    np.testing.assert_allclose(after.u[0], 0.5 * before.u[0], rtol=1e-12)
    np.testing.assert_array_equal(after.u[1:], before.u[1:])
    np.testing.assert_array_equal(smooth.open, table.open)


def test_the_prior_at_the_tool_is_the_scatter_of_drawn_errors(model: MachineModel) -> None:
    """Of a three-axis machine without a tool offset: 20 um three times in each direction, and every lever arm."""
    at_home = prior_size(model, np.zeros((3, 1)), np.zeros((3, 1)))[0]
    assert at_home == pytest.approx(0.02 * 3.0, rel=1e-9)
    assert prior_size(model, AT[:, 1:2], np.zeros((3, 1)))[0] > 1.5 * at_home


def test_use_beyond_what_was_measured_is_told_by_axis_and_range() -> None:
    curves: dict[str, Curve] = {
        "EXX": PolynomialCurve(powers=(1,), coefficients=(1e-5,), u=None, measured=(10.0, 480.0)),
        "EYX": PolynomialCurve(powers=(1,), coefficients=(1e-5,), u=None, measured=(10.0, 480.0)),
        "EZX": PolynomialCurve(powers=(1,), coefficients=(1e-5,)),
        "EYY": TableCurve((0.0, 700.0), (0.0, 0.0)),
    }
    found = beyond_measured(
        ErrorValues(machine="m", parameters={}, motion_errors=curves),
        ("X", "Y"),
        np.array([[0.0, 10.0, 500.0], [0.0, 700.0, 30.0]]),
    )
    (one,) = found
    assert (one.axis, one.components, one.low, one.high) == ("X", ("EXX", "EYX"), 10.0, 480.0)
    assert (one.lowest, one.highest, one.count) == (0.0, 500.0, 2)


def test_uncertainty_of_an_effect_depends_on_its_context(tmp_path: Path) -> None:
    """Backlash of 20 um with a u of 15 um: half of it on either side of a reversal."""
    text = (ROOT / "machines" / "dmu60p.toml").read_text()
    spec = tmp_path / "dmu60p.toml"
    spec.write_text(re.sub(r"(?m)^runs.*\n", "", text) + '\n[[effect]]\nkind = "backlash"\ncomponent = "EXX"\n')
    assert main(["derive", str(spec), "--out", str(tmp_path)]) == 0
    effect = {"kind": "backlash", "component": "EXX", "parameters": {"width": -0.02}, "u": {"width": 0.015}}
    path = tmp_path / "e.json"
    path.write_text(json.dumps({"schema": 1, "machine": "dmu60p", "effects": [effect]}))
    loaded = load_model(spec, path, tmp_path, backend="numpy")
    covariance = load_uncertainty(path, loaded.errors, loaded.machine)
    still = Context.at_rest(3, 4)
    moved = replace(still, directions=np.ones((3, 4)))
    for context, u in ((None, 0.0), (still, 0.0), (moved, 0.0075)):
        found = tool_uncertainty(loaded, covariance, AT, np.zeros((3, 1)), datum=None, context=context).u
        np.testing.assert_allclose(found[0], u, atol=1e-12)
    assert uncertainty_extent(loaded, covariance, AT, np.zeros((3, 1))).largest_u == pytest.approx(0.0075)


def test_a_grid_over_the_travel_holds_every_position_of_a_table(model: MachineModel) -> None:
    covariance = mixed_covariance(model)
    assert {0.0, 200.0, 500.0} <= set(travel_positions(model, covariance)[0].tolist())


def test_values_of_two_origins_are_joined_and_parted(model: MachineModel) -> None:
    whole = mixed_covariance(model)
    first = whole.of({"EXX", "EBX"}, {"eps_xy"}, ())
    second = whole.of({"ECY"}, {"eps_xz"}, ())
    again = first.joined(second)
    assert again.components == ("EXX", "EBX", "ECY")
    assert again.locations == ("eps_xy", "eps_xz")
    expected = whole.matrix.copy()
    mine = [*range(6), 8]
    others = [6, 7, 9]
    expected[np.ix_(mine, others)] = 0.0
    expected[np.ix_(others, mine)] = 0.0
    np.testing.assert_allclose(again.matrix, expected, rtol=1e-12)
