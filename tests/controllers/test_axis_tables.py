"""Tables of single axes: what a control makes of them is what the machine does."""

from collections.abc import Mapping
from itertools import product
from pathlib import Path

import numpy as np
import pytest

from tests.controllers import control_files
from tests.controllers.machines import GANTRY, TABLE, FloatArray, model_of, random_model
from tests.machines import machine_of
from trueaxis.controllers import heidenhain, linuxcnc, siemens
from trueaxis.controllers.axis_tables import AxisTable, axis_tables, nodes, round_step
from trueaxis.controllers.formats import AS_USUAL, TABLE_FORMATS, Layout, all_pairs, export_tables
from trueaxis.controllers.remaining import remaining, taken_by_tables, untabled_effects
from trueaxis.model.curves import PolynomialCurve
from trueaxis.model.effect_values import EffectValues
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel
from trueaxis.reporting.export import export_sentences

ORIGIN = np.zeros((3, 1))


def grid(model: MachineModel, each: int = 4) -> FloatArray:
    return np.array(list(product(*(np.linspace(*model.travel[axis], each) for axis in model.axes)))).T


def written(
    name: str, model: MachineModel, folder: Path, step: float | None = None, layout: Layout = AS_USUAL
) -> control_files.Tables:
    """The files of a format, read again."""
    export = export_tables(name, model, ORIGIN, step, grid(model), layout)
    for file, text in export.files.items():
        (folder / (file or "file")).write_text(text)
    if name == "siemens-enc":
        return control_files.siemens_enc((folder / "file").read_text())
    if name == "siemens-cec":
        return control_files.siemens_cec((folder / "file").read_text())
    return control_files.linuxcnc(folder) if name == "linuxcnc-comp" else control_files.heidenhain(folder)


def rebuilt(tables: control_files.Tables, positions: Mapping[str, FloatArray], of: str) -> FloatArray:
    total = np.zeros(next(iter(positions.values())).size)
    for (corrected, by), (at, forward, _) in tables.items():
        if corrected == of:
            total += np.interp(positions[by], at, forward)
    return total


@pytest.mark.parametrize("text", [GANTRY, TABLE], ids=["gantry", "moving table"])
@pytest.mark.parametrize("names", [("siemens-enc", "siemens-cec"), ("heidenhain-com",)])
def test_the_tables_of_a_machine_without_rotations_are_its_deviations(
    tmp_path: Path, text: str, names: tuple[str, ...]
) -> None:
    """Without rotations every deviation is a sum of functions of single axes: the files hold all of it."""
    for seed in range(3):
        model = random_model(text, seed, rotations=0.0, locations=0.0)
        tables: dict[tuple[str, str], tuple[FloatArray, FloatArray, FloatArray]] = {}
        for name in names:
            folder = tmp_path / f"{name}-{seed}"
            folder.mkdir()
            tables |= written(name, model, folder)
        assert len(tables) == 9
        draw = np.random.default_rng(seed)
        home = {axis: min(max(0.0, low), high) for axis, (low, high) in model.travel.items()}
        at = np.array([draw.choice(tables[axis, axis][0], 20) for axis in model.axes])
        off = model.deviation(at, ORIGIN) - model.deviation(np.array([[home[axis]] for axis in model.axes]), ORIGIN)
        moves = model.correction(at, off)  # in the direction in which the axes count
        for row, axis in enumerate(model.axes):
            positions = dict(zip(model.axes, at, strict=True))
            np.testing.assert_allclose(rebuilt(tables, positions, axis), moves[row], atol=3e-6)
        assert np.abs(moves).max() > 5e-3


@pytest.mark.parametrize("name", TABLE_FORMATS)
def test_a_positive_value_is_an_axis_that_goes_too_far(tmp_path: Path, name: str) -> None:
    """The number of the documents: sent to X100 the axis is at 100.010; EYX 4 um at X100; and a scale of Y."""
    curves = {
        "EXX": PolynomialCurve(powers=(1,), coefficients=(1e-4,)),
        "EYX": PolynomialCurve(powers=(1,), coefficients=(4e-5,)),
        "EYY": PolynomialCurve(powers=(1,), coefficients=(-2e-4,)),
    }
    model = model_of(TABLE, ErrorValues(machine="moving_table", motion_errors=curves))
    tables = written(name, model, tmp_path, step=50.0)
    if name != "siemens-cec":
        at, forward, backward = tables["X", "X"]
        assert at[2] == 100.0
        assert (forward[2], backward[2]) == pytest.approx((0.010, 0.010), abs=1e-9)
        # Y counts towards Y- of the table (sense = -1): a table 10 um too far in Y- has overshot
        assert tables["Y", "Y"][1][1] == pytest.approx(0.010, abs=1e-9)
    if name in ("siemens-cec", "heidenhain-com"):
        # the table carries X' : 4 um of its Y+ are 4 um of the axis Y too little, which counts towards Y-
        assert tables["Y", "X"][1][2] == pytest.approx(-0.004, abs=1e-9)


def test_leadscrew_values_as_in_the_manual_of_the_control() -> None:
    """Function Manual Extended Functions 6FC5397-1BP40-3BA1 (03/2013), 4.4.2.3: X1 from -200 to 600 mm."""
    positions = np.arange(-200.0, 601.0)
    values = np.zeros(801)
    values[:3] = 0.003, 0.01, 0.012
    lines = siemens.encoder_text(
        [AxisTable(of="X", by="X", positions=positions, forward=values, backward=values)]
    ).splitlines()
    published = """$AA_ENC_COMP[0,0,X1]=0.003
$AA_ENC_COMP[0,1,X1]=0.01
$AA_ENC_COMP[0,2,X1]=0.012
$AA_ENC_COMP[0,800,X1]=-0.0
$AA_ENC_COMP_STEP[0,X1]=1.0
$AA_ENC_COMP_MIN[0,X1]=-200.0
$AA_ENC_COMP_MAX[0,X1]=600.0
$AA_ENC_COMP_IS_MODULO[0,X1]=0"""
    ours = dict(line.split("=") for line in lines if line.startswith("$"))
    for line in published.splitlines():
        name, value = line.split("=")
        assert float(ours[name]) == float(value)
    assert lines[:2] == ["%_N_AX_EEC_INI", "CHANDATA(1)"]
    assert lines[2].endswith(">= 801")
    assert lines[-1] == "M17"


def test_actual_positions_as_in_the_manual_of_linuxcnc() -> None:
    """docs/src/config/ini-config.adoc, COMP_FILE_TYPE, type 0 example."""
    table = AxisTable(
        of="X", by="X", positions=np.array([-1.0, 0.0, 1.0]),
        forward=np.array([-0.005, 0.002, 0.003]), backward=np.array([0.005, -0.003, -0.002]),
    )  # fmt: skip
    published = "-1.000 -1.005 -0.995\n0.000 0.002 -0.003\n1.000 1.003 0.998\n"
    ours = [[float(cell) for cell in line.split()] for line in linuxcnc.comp_text(table).splitlines()]
    assert ours == [[float(cell) for cell in line.split()] for line in published.splitlines()]


def test_offsets_as_in_the_source_of_linuxcnc() -> None:
    """src/emc/motion/usrmotintf.cc, usrmotLoadComp: a file of type 1 has what one of type 0 becomes, nominal less
    actual. The first row is that of the type 1 example of ini-config.adoc; its others have the opposite sign.
    """
    forward, backward = np.array([-0.005, 0.002, 0.003]), np.array([0.005, -0.003, -0.002])
    table = AxisTable(of="X", by="X", positions=np.array([-1.0, 0.0, 1.0]), forward=forward, backward=backward)
    ours = [[float(cell) for cell in line.split()] for line in linuxcnc.comp_text(table, 1).splitlines()]
    assert ours == [[-1.0, 0.005, -0.005], [0.0, -0.002, 0.003], [1.0, -0.003, 0.002]]


def test_sag_values_have_the_names_of_the_manual() -> None:
    """Function Manual 6FC5397-1CP10-5BA0 (11/2012), 11.3: sag of Y1 on X1, from -400 to 400 mm."""
    values = np.array([0.0, 0.01, 0.012, 0.0])
    table = AxisTable(of="X", by="Y", positions=np.linspace(-400, 400, 4), forward=values, backward=values)
    lines = siemens.sag_text([table]).splitlines()
    assert lines[:2] == ["%_N_NC_CEC_INI", "CHANDATA(1)"]
    for line in ("$AN_CEC[0,0]=0", "$AN_CEC[0,1]=0.01", "$AN_CEC[0,2]=0.012", "$AN_CEC_INPUT_AXIS[0]=(Y1)",
                 "$AN_CEC_OUTPUT_AXIS[0]=(X1)", "$AN_CEC_MIN[0]=-400", "$AN_CEC_MAX[0]=400", "$AN_CEC_DIRECTION[0]=0",
                 "$AN_CEC_MULT_BY_TABLE[0]=0", "$AN_CEC_IS_MODULO[0]=0"):  # fmt: skip
        assert line in lines


def test_errors_as_in_a_manual_of_the_maker(tmp_path: Path) -> None:
    """Technical Manual TNC 406/306 (3/97), 1.6: Y = F(Z), the error curve as it is entered, every 16.384 mm."""
    published = {0: ("-990", "0"), 1: ("-973.616", "-0.06"), 2: ("-957.232", "-0.09"), 5: ("-908.08", "-0.12"),
                 6: ("-891.696", "-0.12"), 7: ("-875.312", "-0.1"), 8: ("-858.928", "-0.09")}  # fmt: skip
    curve = np.array([0.0, -0.06, -0.09, -0.1, -0.11, -0.12, -0.12, -0.1, -0.09])
    positions = np.array([-990.0 + 16.384 * number for number in range(9)])
    table = AxisTable(of="Y", by="Z", positions=positions, forward=curve, backward=curve)
    rows = heidenhain.com_files([table], reversed_too=False)["zaxis.com"].splitlines()
    assert rows[1].split() == ["NR", "AXISPOS", "Y"]
    for number, (position, value) in published.items():
        assert rows[2 + number].split() == [str(number), position, value]


def test_directions_go_where_the_format_has_room_for_them(tmp_path: Path) -> None:
    at = np.array([0.0, 100.0])
    own = AxisTable(of="X", by="X", positions=at, forward=np.array([0.0, 0.010]), backward=np.array([-0.004, 0.006]))
    cross = AxisTable(of="Y", by="X", positions=at, forward=np.array([0.0, 0.002]), backward=np.array([0.0, 0.004]))
    for name, text in heidenhain.com_files([own, cross], reversed_too=True).items():
        (tmp_path / name).write_text(text)
    tables = control_files.heidenhain(tmp_path)
    np.testing.assert_allclose(tables["X", "X"][1:], [own.forward, own.backward])
    np.testing.assert_allclose(tables["Y", "X"][1:], [cross.mean, cross.mean])
    np.testing.assert_allclose(control_files.siemens_enc(siemens.encoder_text([own]))["X", "X"][1], [-0.002, 0.008])
    assert own.reversal == pytest.approx(0.004)


def test_what_remains_is_what_the_tables_do_not_hold() -> None:
    model = random_model(GANTRY, 5, scale=0.01, rotations=0.0, locations=0.0)
    positions = grid(model)
    tables = axis_tables(model, ORIGIN, all_pairs(model.axes), 1.0)
    left = remaining(model, ORIGIN, positions, taken_by_tables(model, tables, both_directions=False))
    assert left.before > 1e-4
    assert left.after < 5e-9  # nothing but the bend of curves between nodes 1 mm apart, and errors of errors
    coarse = axis_tables(model, ORIGIN, all_pairs(model.axes), 250.0)
    worse = remaining(model, ORIGIN, positions, taken_by_tables(model, coarse, both_directions=False))
    assert worse.after > 100 * left.after
    # of a machine that turns, the levers remain; no other tables of single axes leave less
    turning = random_model(GANTRY, 5)
    tables = axis_tables(turning, ORIGIN, all_pairs(turning.axes), 10.0)
    best = remaining(turning, ORIGIN, positions, taken_by_tables(turning, tables, both_directions=False))
    assert 1e-3 < best.after < 0.5 * best.before


def test_the_mean_over_the_volume_leaves_least() -> None:
    """Tables measured on lines through another place leave more: (1 + x)(1 + y) is 1 + x + y about the middle."""
    model = model_of(
        GANTRY, ErrorValues(machine="gantry", motion_errors={"ECX": PolynomialCurve(powers=(1,), coefficients=(1e-7,))})
    )
    positions = grid(model, 9)
    tables = axis_tables(model, ORIGIN, all_pairs(model.axes), 100.0)
    best = remaining(model, ORIGIN, positions, taken_by_tables(model, tables, both_directions=False)).after
    for y in (-200.0, 400.0):
        line = [(0.0 if table.of != "X" or table.by != "X" else -1e-7 * y) * table.positions for table in tables]
        other = [
            AxisTable(of=table.of, by=table.by, positions=table.positions, forward=values, backward=values)
            for table, values in zip(tables, line, strict=True)
        ]
        assert remaining(model, ORIGIN, positions, taken_by_tables(model, other, both_directions=False)).after > best


def test_nodes_reach_from_end_to_end() -> None:
    np.testing.assert_allclose(nodes((0.0, 540.0), 10.0), np.arange(55) * 10.0)
    assert nodes((-350.0, 0.0), 100.0).tolist() == [-350.0, -262.5, -175.0, -87.5, 0.0]
    for high in (0.7, 1.0, 199.0, 540.0, 2999.0):
        assert 40 <= nodes((0.0, high), None).size <= 200
    assert [round_step(value) for value in (0.013, 1.0, 2.0001, 7.0)] == [0.02, 1.0, 5.0, 10.0]


def test_lost_motion_is_in_the_tables_of_both_directions(tmp_path: Path) -> None:
    text = GANTRY + '[[effect]]\nkind = "backlash"\ncomponent = "EXX"\n'
    (effect,) = machine_of(text).effects
    curves = {"EXX": PolynomialCurve(powers=(1,), coefficients=(2e-5,))}
    values = (EffectValues(effect, {"width": 0.006}),)
    model = model_of(text, ErrorValues(machine="gantry", motion_errors=curves, effects=values))
    both, mean = (tmp_path / name for name in ("both", "mean"))
    both.mkdir()
    mean.mkdir()
    at, forward, backward = written("linuxcnc-comp", model, both)["X", "X"]
    np.testing.assert_allclose(forward, 2e-5 * at + 0.003, atol=1e-7)
    np.testing.assert_allclose(backward, 2e-5 * at - 0.003, atol=1e-7)
    offsets = tmp_path / "offsets"
    offsets.mkdir()
    at, forward, backward = written("linuxcnc-comp", model, offsets, layout=Layout(file_type=1))["X", "X"]
    np.testing.assert_allclose(forward, 2e-5 * at + 0.003, atol=1e-7)
    np.testing.assert_allclose(backward, 2e-5 * at - 0.003, atol=1e-7)
    at, one, _ = written("siemens-enc", model, mean)["X", "X"]
    np.testing.assert_allclose(one, 2e-5 * at, atol=1e-6)
    exports = {name: export_tables(name, model, ORIGIN, None, grid(model)) for name in ("linuxcnc-comp", "siemens-enc")}
    assert exports["linuxcnc-comp"].remaining.after < 1e-6
    assert exports["siemens-enc"].remaining.after == pytest.approx(0.003, rel=1e-3)  # half of the lost motion
    sentence = "mean reversal error of X: 6 um, which the table cannot hold"
    assert sentence in export_sentences("siemens-enc", model, exports["siemens-enc"])
    assert sentence not in export_sentences("linuxcnc-comp", model, exports["linuxcnc-comp"])


def test_effects_that_no_table_holds_are_named() -> None:
    drift = '[[effect]]\nkind = "thermal_expansion"\ncomponent = "EYY"\n'
    text = GANTRY + '[[effect]]\nkind = "backlash"\ncomponent = "EXX"\n' + drift
    effects = machine_of(text).effects
    values = tuple(EffectValues(effect, {}) for effect in effects)
    model = model_of(text, ErrorValues(machine="gantry", effects=values))
    assert untabled_effects(model) == (effects[1].label,)


@pytest.mark.parametrize(
    ("name", "layout"), [*((name, AS_USUAL) for name in TABLE_FORMATS), ("linuxcnc-comp", Layout(file_type=1))]
)
@pytest.mark.parametrize("text", [GANTRY, TABLE], ids=["gantry", "moving table"])
def test_what_is_said_to_remain_is_what_a_control_with_these_files_leaves(
    tmp_path: Path, name: str, text: str, layout: Layout
) -> None:
    model = random_model(text, 11)
    tables = written(name, model, tmp_path, layout=layout)
    positions = grid(model)
    said = export_tables(name, model, ORIGIN, None, positions).remaining
    home = np.array([[min(max(0.0, low), high)] for low, high in (model.travel[axis] for axis in model.axes)])

    def off(at: FloatArray, *, corrected: bool) -> FloatArray:
        places = dict(zip(model.axes, at, strict=True))
        sent = at - np.array([rebuilt(tables, places, axis) for axis in model.axes]) * corrected
        return model.ideal(sent, ORIGIN) + model.deviation(sent, ORIGIN) - model.ideal(at, ORIGIN)

    for corrected, rms in ((False, said.before), (True, said.after)):
        left = off(positions, corrected=corrected) - off(home, corrected=corrected)
        assert rms == pytest.approx(np.sqrt((left**2).sum(axis=0).mean()), rel=1e-9)
    assert said.after < said.before
