"""What a cause may do besides its own form, against forms written out."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt
import pytest
from scipy.integrate import solve_ivp

from tests.diagnose.prepared import field
from trueaxis.diagnose.imperfection import imperfections
from trueaxis.diagnose.refit import Fitted
from trueaxis.diagnose.signatures import Readings, parameter_signature
from trueaxis.effects.kind import Effect

FloatArray = npt.NDArray[np.float64]


def readings() -> Readings:
    return field().readings


def fitted(effect: Effect, values: Sequence[float]) -> Fitted:
    kind = readings().model.machine.kinds[effect.kind]
    at = np.array(values)
    return Fitted(effect, kind, at, np.ones_like(at), parameter_signature(readings(), effect, at)[0])


def holds(columns: FloatArray, wanted: FloatArray, signal: FloatArray, tolerance: float = 1e-9) -> bool:
    """Whether one of the columns is what is wanted, the cause's own form fitted away, but for a share of its size."""
    (share,), *_ = np.linalg.lstsq(signal[:, np.newaxis], wanted)
    off = np.abs(columns - (wanted - share * signal)[:, np.newaxis]).max(axis=0)
    return bool(off.min() < tolerance * np.abs(wanted).max())


def lever(component: str) -> FloatArray:
    return np.asarray(readings().sensitivity[readings().model.components.index(component)])


def legendre(scale: FloatArray) -> tuple[FloatArray, FloatArray]:
    """P1 and P2 on the range of the scale, written out."""
    u = (2.0 * scale - scale.max() - scale.min()) / (scale.max() - scale.min())
    return u, 1.5 * u**2 - 0.5


class TestBacklash:
    def cause(self) -> Fitted:
        return fitted(Effect("backlash", "EXX"), [6e-3])

    def signal(self) -> FloatArray:
        return np.asarray(lever("EXX") * 3e-3 * readings().rows.directions[0])

    def test_it_may_differ_by_a_tenth_along_the_travel_and_in_time(self) -> None:
        rows = readings().rows
        assert rows.time is not None
        columns = imperfections(readings(), [self.cause()])
        for scale in (rows.positions[0], rows.time):
            for shape in legendre(scale):
                assert holds(columns, 0.1 * self.signal() * shape, self.signal())

    def test_it_may_differ_by_a_tenth_from_instrument_to_instrument(self) -> None:
        rows = readings().rows
        columns = imperfections(readings(), [self.cause()])
        for instrument in ("laser", "ballbar"):
            mine = np.array([rows.runs[index].instrument == instrument for index in rows.run])
            assert holds(columns, 0.1 * self.signal() * mine, self.signal())

    @pytest.mark.parametrize("way", [0.3, 1.0])
    def test_it_may_be_taken_up_on_a_way(self, way: float) -> None:
        since = readings().context.since_reversal[0]
        wanted = self.signal() * np.exp(-since / way)
        assert np.abs(wanted).max() > 1e-4  # some reading is near a reversal
        assert holds(imperfections(readings(), [self.cause()]), wanted, self.signal())

    def test_there_is_nothing_else(self) -> None:
        """2 along X, 2 in time, 2 instruments, 2 flanks."""
        assert imperfections(readings(), [self.cause()]).shape == (readings().rows.size, 8)


class TestThermalOffset:
    def cause(self) -> Fitted:
        return fitted(Effect("thermal_offset", "EYX"), [2e-3])

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
        wanted = lever("EYX") * 2e-3 * (late - rows.temperature)
        assert holds(imperfections(readings(), [self.cause()]), wanted, self.cause().signal, 0.05)


class TestCyclic:
    AMPLITUDE, PHASE, PITCH = 1e-3, 0.7, 10.0

    def cause(self) -> Fitted:
        values = {"amplitude": self.AMPLITUDE, "phase": self.PHASE, "pitch": self.PITCH}
        kind = readings().model.machine.kinds["cyclic"]
        return fitted(Effect("cyclic", "EXX"), [values[one.name] for one in kind.parameters])

    def test_it_may_have_a_second_harmonic_of_any_phase(self) -> None:
        turn = 4.0 * np.pi * readings().rows.positions[0] / self.PITCH
        second = 0.2 * self.AMPLITUDE * lever("EXX")[:, np.newaxis] * np.stack([np.cos(turn), -np.sin(turn)], axis=1)
        signal = self.cause().signal
        second -= np.outer(signal, signal @ second / (signal @ signal))
        columns = imperfections(readings(), [self.cause()])
        found = [k for k in range(columns.shape[1]) if left(second, columns[:, k]) < 1e-9]
        assert len(found) == 2
        assert columns[:, found].T @ columns[:, found] == pytest.approx(second.T @ second, rel=1e-6, abs=1e-9)

    def test_none_of_it_is_of_the_form_of_the_cause_itself(self) -> None:
        """Its size is what is sought: chance of that form would make every cause small beside it."""
        columns, signal = imperfections(readings(), [self.cause()]), self.cause().signal
        cosines = signal @ columns / (np.linalg.norm(signal) * np.linalg.norm(columns, axis=0))
        assert cosines == pytest.approx(0.0, abs=1e-12)


def left(basis: FloatArray, column: FloatArray) -> float:
    """Share of a column that a basis does not hold."""
    fit = np.linalg.lstsq(basis, column, rcond=None)[0]
    return float(np.linalg.norm(column - basis @ fit) / np.linalg.norm(column))


def test_a_time_constant_may_be_another() -> None:
    kind = readings().model.machine.kinds["warm_up"]
    (size,) = (one.name for one in kind.parameters if one.role == "linear")
    values = {size: 5e-3, **{one.name: 900.0 for one in kind.parameters if one.role == "grid"}}
    effect = Effect("warm_up", "EYY")
    cause = fitted(effect, [values[one.name] for one in kind.parameters])
    columns = imperfections(readings(), [cause])
    for factor in (1.6, 1.0 / 1.6):
        other = {name: value * (factor if name != size else 1.0) for name, value in values.items()}
        wanted = fitted(effect, [other[one.name] for one in kind.parameters]).signal - cause.signal
        assert holds(columns, 0.3 * wanted, cause.signal)


def test_of_no_cause_there_is_nothing_and_of_two_all_of_both() -> None:
    one, other = fitted(Effect("backlash", "EXX"), [6e-3]), fitted(Effect("thermal_offset", "EYX"), [2e-3])
    assert imperfections(readings(), []).shape == (readings().rows.size, 0)
    each = [imperfections(readings(), [cause]) for cause in (one, other)]
    np.testing.assert_array_equal(imperfections(readings(), [one, other]), np.hstack(each))
