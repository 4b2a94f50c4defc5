"""What was gained: residuals over all readings and over held-out ones, as given, refitted and extended.

Held-out readings are predicted from the others: errors of the machine are as likely as [prior] has them, about the
values given, and as the other readings tell. What nobody knows of the instrument of a run is fitted to the run itself,
held out or not, and counted.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.linalg import solve_triangular

from trueaxis.diagnosis.causes.signature import Fitted
from trueaxis.diagnosis.null_model.base import Base
from trueaxis.diagnosis.null_model.by_run import ByRun
from trueaxis.diagnosis.null_model.noise import UNKNOWN
from trueaxis.diagnosis.null_model.null import Null, less_own
from trueaxis.diagnosis.null_model.rows import Rows
from trueaxis.diagnosis.null_model.whiten import Whitening
from trueaxis.diagnosis.result import BoolArray, FloatArray, Gain, GainOfAngles, IntArray, Stage
from trueaxis.estimation.runs import noise_groups
from trueaxis.measurement.readings import angle_rows

HELD = 0.4  # share of the repeats that is held back, one at least
EVERY = 4  # without repeats, every fourth reading
VAGUE = 1e3  # mm, of a cause: what nothing is expected of


@dataclass(frozen=True, slots=True, eq=False)
class Left:
    """(n,) mm: what is left of each reading."""

    given: FloatArray
    refitted: FloatArray
    extended: FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class Prediction:
    """left: of some rows, fitted on some; freedom: of them, what was fitted to each run's own taken away;
    standardised: root mean square of the extended model's left, by its predictive covariance: where one reading is
    predicted badly, its neighbours are, alike.
    """

    left: Left
    freedom: float
    standardised: float

    def stage(self) -> Stage:
        """RMS, mm; NaN of no rows at all."""
        if self.freedom <= 0:
            return Stage(np.nan, np.nan, np.nan)
        parts = (self.left.given, self.left.refitted, self.left.extended)
        return Stage(*(float(np.sqrt(part @ part / self.freedom)) for part in parts))


def held_out(rows: Rows) -> tuple[BoolArray, str]:
    """(n,) which rows are held back, and how they were chosen: whole runs or passes where there are repeats."""
    held = np.zeros(rows.size, dtype=bool)
    whole = passes = 0
    for number in np.unique(rows.setup):
        mine = rows.setup == number
        blocks = _repeats(rows, np.flatnonzero(mine))
        for repeats in blocks:
            if len(repeats) < 2:
                continue
            last = repeats[-max(1, round(HELD * len(repeats))) :]
            for one in last:
                held[one] = True
                if (rows.run == rows.run[one[0]]).sum() == one.size:
                    whole += 1
                else:
                    passes += 1
    if held.any():
        what = [f"{count} {name}" for count, name in ((whole, "whole runs"), (passes, "passes of runs")) if count]
        return held, f"the last repeats held back: {' and '.join(what)}"
    held = np.arange(rows.size) % EVERY == EVERY // 2
    return held, f"nothing is repeated: every {EVERY}th reading held back"


def _repeats(rows: Rows, mine: IntArray) -> list[list[IntArray]]:
    """Passes over (nearly) the same targets, together, in order of time."""
    found: list[tuple[set[int], list[IntArray]]] = []
    key = rows.run[mine] * 10**6 + rows.passing[mine]
    for number in dict.fromkeys(key.tolist()):
        one = mine[key == number]
        targets = set(rows.target[one].tolist())
        for theirs, passes in found:
            if len(theirs & targets) >= 0.8 * max(len(theirs), len(targets)):
                passes.append(one)
                break
        else:
            found.append((targets, [one]))
    return [passes for _, passes in found]


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Fit:
    """Errors of the machine and sizes of causes from some rows.

    columns: (n, q), mm, of all rows; refitted, extended: (q,); root: (q, q), of their covariance; known: (n,), mm, what
    causes do besides.
    """

    columns: ByRun
    refitted: FloatArray
    extended: FloatArray
    root: FloatArray
    known: FloatArray


def fit(base: Base, whitening: Whitening, values: FloatArray, causes: Sequence[Fitted], rows: BoolArray) -> Fit:
    """From the rows (n,) chosen; values: (n,) mm, readings less what is expected.

    What a cause does elsewhere alone, as in one run of an instrument, is taken as it was found there.
    """
    signals = [one.signal[:, np.newaxis] / max(float(np.abs(one.signal).max()), 1e-300) for one in causes]
    apart = [k for k, one in enumerate(signals) if not one[rows].any()]
    known = sum((causes[k].signal for k in apart), np.zeros(values.size))
    signals = [one for k, one in enumerate(signals) if k not in apart]
    columns = base.columns.times(np.diag(base.expected)).beside(np.hstack([base.by_chance, *signals]))
    q = columns.weights.shape[1]
    p = q - len(signals)
    white = columns.beside(values[:, np.newaxis]).only(rows).whitened(whitening.only(rows)).weights
    prior = np.diag(np.concatenate([np.ones(p), np.full(q - p, 1.0 / VAGUE)]))
    r = np.asarray(np.linalg.qr(np.vstack([white, np.column_stack([prior, np.zeros(q)])]), mode="r"))
    refitted = np.concatenate([solve_triangular(r[:p, :p], r[:p, q]), np.zeros(q - p)])
    root = solve_triangular(r[:q, :q], np.eye(q))
    return Fit(columns=columns, refitted=refitted, extended=root @ r[:q, q], root=root, known=known)


def predicted(fit: Fit, whitening: Whitening, values: FloatArray, rows: BoolArray) -> Prediction:
    """What is left of some rows, (n,)."""
    own = whitening.only(rows)
    columns, mine = fit.columns.only(rows), values[rows]
    rest = [mine, mine - columns @ fit.refitted, mine - columns @ fit.extended - fit.known[rows]]
    left = [less_own(own, one) for one in rest]
    freedom = float(rows.sum() - own.own_count.sum())
    if freedom <= 0.0:
        return Prediction(Left(*left), freedom, np.nan)
    both = columns.beside(rest[-1][:, np.newaxis]).whitened(own).weights
    spread = np.column_stack([both[:, :-1] @ fit.root, both[:, -1]])
    q = spread.shape[1] - 1
    r = np.asarray(np.linalg.qr(np.vstack([spread, np.eye(q, q + 1)]), mode="r"))
    squares = float(r[-1, -1] ** 2)
    return Prediction(Left(*left), freedom, float(np.sqrt(squares / freedom)))


def gain_of(everything: Prediction, held: Prediction, split: str, floor: float) -> Gain:
    """RMS of all rows (fitted on all) and of those held back (fitted on the others)."""
    return Gain(rms=everything.stage(), held_out=held.stage(), split=split, floor=floor, standardised=held.standardised)


def gain_by_unit(fits: tuple[Fit, Fit], null: Null, chosen: tuple[BoolArray, str]) -> tuple[Gain, Stage]:
    """Of readings of lengths and, by themselves, of angles; and the RMS of all rows held back.

    fits: on all rows, and on those that are not held back; chosen: (n,) which these are, and how they were chosen.
    """
    whitening, values, rows = null.whitening, null.values, null.rows
    judged = {one.group: one.origin != UNKNOWN for one in null.noise}
    known = np.array([judged.get(group, False) for group in noise_groups(rows.runs)])[rows.run]
    (held, split), (on_all, on_others) = chosen, fits
    angle = angle_rows(rows.run, rows.runs)

    def parts(some: BoolArray) -> tuple[Prediction, Prediction, float]:
        told = some & known
        floor = float(np.sqrt(np.mean(whitening.sigma[told] ** 2))) if told.any() else np.nan
        ends = ((on_all, some), (on_others, held & some))
        all_of, held_of = (predicted(fitted, whitening, values, these) for fitted, these in ends)
        return all_of, held_of, floor

    everything, of_held, floor = parts(~angle)
    gain = gain_of(everything, of_held, split, floor)
    if not angle.any():
        return gain, gain.held_out
    everything, of_held, floor = parts(angle)
    together = predicted(on_others, whitening, values, held)
    angles = GainOfAngles(everything.stage(), of_held.stage(), floor)
    return replace(gain, angles=angles, standardised=together.standardised), together.stage()
