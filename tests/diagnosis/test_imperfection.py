"""What a cause may do besides its own form, against forms written out."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt
import pytest
from scipy.integrate import solve_ivp

from tests.diagnosis.prepared import SIGMA, field
from tests.hidden_effects.design import Design
from trueaxis.diagnosis.causes.imperfection import beside_forms, imperfection, imperfections, open_harmonics
from trueaxis.diagnosis.causes.search import search
from trueaxis.diagnosis.causes.signature import Fitted, Readings
from trueaxis.diagnosis.causes.signatures import parameter_signature
from trueaxis.effects.kind import Effect

FloatArray = npt.NDArray[np.float64]


def readings() -> Readings:
    return field().readings


def fitted(effect: Effect, values: Sequence[float], u: Sequence[float] = ()) -> Fitted:
    kind = readings().model.machine.kinds[effect.kind]
    at = np.array(values)
    known = np.array(u) if u else np.zeros_like(at)
    return Fitted(effect=effect, kind=kind, values=at, u=known, signal=parameter_signature(readings(), effect, at)[0])


def holds(columns: FloatArray, wanted: FloatArray, tolerance: float = 1e-9) -> bool:
    """Whether one of the columns is what is wanted, but for a share of its size."""
    off = np.abs(columns - wanted[:, np.newaxis]).max(axis=0)
    return bool(off.min() < tolerance * np.abs(wanted).max())


def besides(cause: Fitted) -> FloatArray:
    """(n, k), mm."""
    return np.stack(list(imperfections(readings(), cause)), axis=1)


def lever(component: str) -> FloatArray:
    return np.asarray(readings().sensitivity[readings().model.components.index(component)])


def legendre(scale: FloatArray) -> tuple[FloatArray, FloatArray]:
    """P1 and P2 on the range of the scale, written out."""
    u = (2.0 * scale - scale.max() - scale.min()) / (scale.max() - scale.min())
    return u, 1.5 * u**2 - 0.5


class TestBacklash:
    def cause(self) -> Fitted:
        return fitted(Effect(kind="backlash", component="EXX"), [6e-3])

    def signal(self) -> FloatArray:
        return np.asarray(lever("EXX") * 3e-3 * readings().rows.directions[0])

    def test_it_may_differ_by_a_tenth_along_the_travel_and_in_time(self) -> None:
        rows = readings().rows
        assert rows.time is not None
        columns = besides(self.cause())
        for scale in (rows.positions[0], rows.time):
            for shape in legendre(scale):
                assert holds(columns, 0.1 * self.signal() * shape)

    def test_it_may_differ_by_a_tenth_from_instrument_to_instrument(self) -> None:
        """Beside what both read together, which is its size: u of that holds nothing of how they differ."""
        rows, signal = readings().rows, self.signal()
        columns = besides(self.cause())
        for instrument in ("laser", "ballbar"):
            mine = np.array([rows.runs[index].instrument == instrument for index in rows.run])
            share = (signal[mine] ** 2).sum() / (signal**2).sum()
            assert 0.0 < share < 1.0
            wanted = 0.1 * signal * (mine - share)
            assert holds(columns, wanted)
            assert abs(wanted @ signal) < 1e-12 * (signal @ signal)

    @pytest.mark.parametrize("way", [0.3, 1.0])
    def test_it_may_be_taken_up_on_a_way(self, way: float) -> None:
        since = readings().context.since_reversal[0]
        wanted = self.signal() * np.exp(-since / way)
        rows = readings().rows
        for instrument in ("laser", "ballbar"):  # where lines turn is not read: circles say nothing of it
            mine = np.array([rows.runs[index].instrument == instrument for index in rows.run])
            assert wanted[mine].any()  # some reading is near a reversal
            assert holds(besides(self.cause()), wanted * mine)

    def test_there_is_nothing_else(self) -> None:
        """2 along X, 2 in time, 2 instruments, 2 flanks by each."""
        assert besides(self.cause()).shape == (readings().rows.size, 10)


@pytest.mark.parametrize(
    ("kind", "variable", "way"),
    [("reversal_spike_path", "path_since", 0.3), ("reversal_spike_time", "time_since", 0.06)],
)
def test_a_spike_is_taken_up_over_what_it_decays_with(kind: str, variable: str, way: float) -> None:
    cause = fitted(Effect(kind=kind, component="EXX"), [4e-3, 2.0])
    passed = getattr(readings().context, variable)[0]
    wanted = cause.signal * np.exp(-passed / way)
    assert wanted.any()
    assert holds(besides(cause), wanted)


class TestThermalOffset:
    def cause(self) -> Fitted:
        return fitted(Effect(kind="thermal_offset", component="EYX"), [2e-3])

    @pytest.mark.parametrize("constant", [250.0, 1000.0, 4000.0])
    def test_it_may_follow_the_temperature_late(self, constant: float) -> None:
        """The lag as a differential equation, constant y' = T - y, integrated by SciPy."""
        rows = readings().rows
        assert rows.time is not None
        assert rows.temperature is not None
        order = np.argsort(rows.time)
        time, air = rows.time[order], rows.temperature[order]
        found = solve_ivp(
            lambda t, y: (np.interp(t, time, air) - y) / constant,
            (time[0], time[-1]),
            [air[0]],
            t_eval=np.unique(time),
            max_step=20.0,
            rtol=1e-6,
        )
        late = np.interp(rows.time, found.t, found.y[0])
        wanted = lever("EYX") * 2e-3 * (late - rows.temperature) / np.sqrt(3.0)  # one of three
        assert holds(besides(self.cause()), wanted, 0.05)


class TestCyclic:
    AMPLITUDE, PHASE, PITCH = 1e-3, 0.7, 10.0

    def cause(self, u_pitch: float = 0.0) -> Fitted:
        values = {"amplitude": self.AMPLITUDE, "phase": self.PHASE, "pitch": self.PITCH}
        names = [one.name for one in readings().model.machine.kinds["cyclic"].parameters]
        u = [u_pitch * (name == "pitch") for name in names]
        return fitted(Effect(kind="cyclic", component="EXX"), [values[name] for name in names], u)

    def test_it_may_have_a_second_harmonic_of_any_phase(self) -> None:
        turn = 4.0 * np.pi * readings().rows.positions[0] / self.PITCH
        second = 0.2 * self.AMPLITUDE * lever("EXX")[:, np.newaxis] * np.stack([np.cos(turn), -np.sin(turn)], axis=1)
        columns = besides(self.cause())
        found = [k for k in range(columns.shape[1]) if left(second, columns[:, k]) < 1e-9]
        assert len(found) == 2
        assert columns[:, found].T @ columns[:, found] == pytest.approx(second.T @ second, rel=1e-6, abs=1e-9)

    def test_the_second_harmonic_has_any_pitch_that_the_readings_leave_open(self) -> None:
        """By one turn over the axis, which is two of the harmonic: at even targets each of these is another curve."""
        at = readings().rows.positions[0]
        a_turn = self.PITCH**2 / float(np.ptp(at))
        turn = 4.0 * np.pi * at / (self.PITCH + 0.37 * a_turn)
        second = 0.1 * self.AMPLITUDE * lever("EXX") * np.cos(turn)
        known = besides(self.cause())
        open_ = np.stack(list(open_harmonics(readings(), self.cause(0.25 * a_turn))), axis=1)
        assert self.likely(known, second) > 10.0 * self.likely(open_, second)
        assert self.likely(open_, second) < 2.0
        assert len(list(open_harmonics(readings(), self.cause(1e3 * a_turn)))) < 20  # another peak is another cause
        assert len(list(open_harmonics(readings(), self.cause()))) == 2

    def likely(self, columns: FloatArray, signal: FloatArray) -> float:
        """By how many standard deviations of the columns a signal comes about, the rest of it as noise of 1 %."""
        noise = 0.01 * float(np.abs(signal).max())
        root = np.vstack([columns / noise, np.eye(columns.shape[1])])
        fit = np.linalg.lstsq(root, np.append(signal / noise, np.zeros(columns.shape[1])), rcond=None)[0]
        left = (signal - columns @ fit) / noise
        return float(np.sqrt(left @ left / left.size + fit @ fit))


def test_lobes_on_circles_may_have_a_second_harmonic() -> None:
    kind = readings().model.machine.kinds["ballbar_lobes"]
    values = {"amplitude": 4e-3, "phase": 0.3}
    cause = fitted(Effect(kind="ballbar_lobes"), [values[one.name] for one in kind.parameters])
    on_circles = np.array([run.instrument == "ballbar" for run in readings().rows.runs])[readings().rows.run]
    for wave in (np.cos, np.sin):
        wanted = np.where(on_circles, 0.2 * 4e-3 * wave(6.0 * np.nan_to_num(readings().reading.theta)), 0.0)
        assert holds(besides(cause), wanted) or holds(besides(cause), -wanted)


def left(basis: FloatArray, column: FloatArray) -> float:
    """Share of a column that a basis does not hold."""
    fit = np.linalg.lstsq(basis, column, rcond=None)[0]
    return float(np.linalg.norm(column - basis @ fit) / np.linalg.norm(column))


def test_a_time_constant_may_be_another() -> None:
    kind = readings().model.machine.kinds["warm_up"]
    (size,) = (one.name for one in kind.parameters if one.role == "linear")
    values = {size: 5e-3, **{one.name: 900.0 for one in kind.parameters if one.role == "grid"}}
    effect = Effect(kind="warm_up", component="EYY")
    cause = fitted(effect, [values[one.name] for one in kind.parameters])
    columns = besides(cause)
    for factor in (1.6, 1.0 / 1.6):
        other = {name: value * (factor if name != size else 1.0) for name, value in values.items()}
        wanted = fitted(effect, [other[one.name] for one in kind.parameters]).signal - cause.signal
        assert holds(columns, 0.3 * wanted)


def test_what_is_driven_by_the_clock_alone_does_not_vary_along_the_travel() -> None:
    """It would be of another kind: thermal expansion, warm-up. In time it may, and from instrument to instrument."""
    assert besides(fitted(Effect(kind="drift", component="EXX"), [1e-6])).shape[1] == 2 + 2


def test_of_no_cause_there_is_nothing_and_of_two_all_of_both() -> None:
    one, other = (
        fitted(Effect(kind="backlash", component="EXX"), [6e-3]),
        fitted(Effect(kind="thermal_offset", component="EYX"), [2e-3]),
    )
    assert imperfection(readings(), [], seen).columns.shape == (readings().rows.size, 0)
    each = [imperfection(readings(), [cause], seen) for cause in (one, other)]
    both = imperfection(readings(), [one, other], seen)
    np.testing.assert_array_equal(both.columns, np.hstack([found.columns for found in each]))
    np.testing.assert_array_equal(both.beside, np.hstack([found.beside for found in each]))


def seen(columns: FloatArray) -> FloatArray:
    """What the base leaves, whitened."""
    return field().base.rest(field().whitening(columns))


@pytest.mark.parametrize("name", ["backlash", "drift", "cyclic"])
def test_nothing_that_a_change_of_size_would_do_is_chance(name: str) -> None:
    """As the readings see it: chance of that form would make every cause small beside it, the larger the smaller."""
    values = {"backlash": [6e-3], "drift": [1e-6], "cyclic": [1e-3, 0.7, 10.0]}
    cause = fitted(Effect(kind=name, component="EXX"), values[name])
    found = imperfection(readings(), [cause], seen)
    signal = seen(cause.signal[:, np.newaxis])[:, 0]
    assert np.abs(signal @ found.columns).max() > 1e-3 * (signal @ signal)
    assert np.abs(signal @ found.beside).max() < 1e-9 * (signal @ signal)
    lost = found.columns - found.beside
    assert np.linalg.matrix_rank(lost, tol=1e-6 * np.linalg.norm(lost)) == (2 if name == "cyclic" else 1)


def test_how_circles_take_play_up_makes_no_spike_where_lines_turn() -> None:
    """Lines show all of it in the reading after a turn, which lies beyond their targets; circles little at first."""
    where = field(Design(lines=4, repeats=3, targets=21, samples=180))
    rows, effect = where.readings.rows, Effect(kind="backlash", component="EZZ")
    kind = where.readings.model.machine.kinds["backlash"]
    width = np.array([5e-3])
    signal = parameter_signature(where.readings, effect, width)[0]
    since = where.readings.context.since_reversal[rows.axes.index("Z")]
    circles = np.array([run.instrument == "ballbar" for run in rows.runs])[rows.run]
    taken_up = np.where(circles, np.exp(-np.where(np.isnan(since), np.inf, since) / 0.6), 0.0)
    noise = SIGMA * np.random.default_rng(3).standard_normal(rows.size)
    ground = where.ground(signal * (1.0 - taken_up) + noise)
    known = Fitted(effect=effect, kind=kind, values=width, u=np.ones(1), signal=signal)
    assert [one.scan.effect for one in search(ground).causes] != [effect]  # its own form says less than the readings
    assert [one.scan.effect for one in search(beside_forms(ground, (known,))).causes] == [effect]
