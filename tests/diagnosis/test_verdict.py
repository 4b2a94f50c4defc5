"""When names stand: cases written out, and the share explained by squares counted by hand."""

import numpy as np
import pytest
from scipy.stats import norm

from tests.diagnosis.prepared import SIGMA, field
from trueaxis.diagnosis.causes.refit import refit
from trueaxis.diagnosis.causes.search import search
from trueaxis.diagnosis.causes.signature import Fitted
from trueaxis.diagnosis.causes.signatures import parameter_signature
from trueaxis.diagnosis.judging.amplitudes import Uneven
from trueaxis.diagnosis.judging.structure import Check, StructureClass
from trueaxis.diagnosis.judging.verdict import explained_share, names_stand, verdict_of
from trueaxis.diagnosis.result import Stale
from trueaxis.effects.kind import Effect
from trueaxis.effects.library import BY_NAME

DIRECTION, TEMPERATURE, RIPPLE = (
    StructureClass.LINE_DIRECTION,
    StructureClass.LINE_TEMPERATURE,
    StructureClass.CIRCLE_RIPPLE,
)


def check(structure: StructureClass, fired: bool = True, excess: float = 0.0) -> Check:
    return Check(structure=structure, place="X", p_value=1e-9 if fired else 0.5, fired=fired, rms=1e-4, excess=excess)


def uneven(*p_values: float) -> list[Uneven]:
    """With the squares of a normal deviate that is as unlikely."""
    return [Uneven(p, float(norm.isf(0.5 * p) ** 2)) for p in p_values]


def cause(kind: str, component: str = "EXX") -> Fitted:
    return Fitted(
        effect=Effect(kind=kind, component=component),
        kind=BY_NAME[kind],
        values=np.ones(1),
        u=np.ones(1),
        signal=np.ones(3),
    )


@pytest.mark.parametrize(
    ("share", "kind", "fired", "homogeneous_p", "stand"),
    [
        (0.95, "backlash", [], 0.5, True),
        (0.50, "backlash", [], 0.5, True),  # no check fires: nothing is left that could be told
        (0.95, "backlash", [], 1e-5, False),  # not one size everywhere
        (0.98, "backlash", [], 1e-5, True),  # but practically all is explained
        (0.98, "backlash", [RIPPLE], 0.5, True),
        (0.98, "backlash", [RIPPLE, TEMPERATURE], 1e-9, True),
        (0.93, "backlash", [DIRECTION], 0.5, True),  # what is left is of its own class
        (0.93, "backlash", [DIRECTION], 1e-5, False),
        (0.93, "backlash", [RIPPLE], 0.5, False),
        (0.93, "backlash", [DIRECTION, RIPPLE], 0.5, False),
        (0.93, "thermal_offset", [TEMPERATURE], 0.5, True),
        (0.93, "thermal_offset", [DIRECTION], 0.5, False),
        (0.93, "squareness", [DIRECTION], 0.5, False),  # without an expression: of no class
        (0.88, "backlash", [DIRECTION], 0.5, False),
        (0.97, "backlash", [RIPPLE], 0.5, True),
        (0.93, "backlash", [StructureClass.LINE_COURSE], 0.5, True),
        (0.93, "drift", [TEMPERATURE], 0.5, True),
    ],
)
def test_names_stand(share: float, kind: str, fired: list[StructureClass], homogeneous_p: float, stand: bool) -> None:
    checks = [*(check(name) for name in fired), check(StructureClass.CIRCLE_FEED, fired=False)]
    assert names_stand(share, [cause(kind)], checks, uneven(homogeneous_p)) is stand


def test_one_cause_of_two_that_is_not_one_size_is_enough() -> None:
    assert not names_stand(0.9, [cause("backlash"), cause("drift")], [], uneven(0.5, 1e-5))


def test_share_is_that_of_the_squares_beyond_noise() -> None:
    where = field()
    column = parameter_signature(where.readings, Effect(kind="backlash", component="EXX"), np.ones(1))[0]
    noise = SIGMA * np.random.default_rng(7).standard_normal(column.size)
    ground = where.ground(6e-3 * column + noise)
    found = search(ground)
    causes = refit(ground, found.causes)
    assert [one.effect for one in causes] == [Effect(kind="backlash", component="EXX")]
    explained = np.sum(where.base.rest(where.whitening(causes[0].signal)) ** 2)
    left = 0.25 * explained
    # a least-squares fit leaves what is orthogonal to it: squares of the readings less squares left are its own
    assert explained_share(ground, found, causes, [check(RIPPLE, excess=left)], uneven(0.5)) == pytest.approx(
        0.8, rel=1e-3
    )
    assert explained_share(ground, found, causes, [check(RIPPLE, fired=False, excess=left)], uneven(0.5)) > 0.99
    assert explained_share(ground, found, (), [], []) == 0.0
    # of a size that differs from place to place, what it has more at one of them is left: its squared deviation
    without = explained_share(ground, found, causes, [], uneven(0.5))
    apart = explained_share(ground, found, causes, [], uneven(2.0 * norm.sf(30.0)))
    assert apart == pytest.approx(explained / (explained + 900.0), rel=1e-3)
    assert apart < without - 0.01


def test_verdicts() -> None:
    where = field()
    stale = [Stale(component="EYY", first=100.0, last=200.0, value=1e-3, u=1e-4, unit="mm", p_value=1e-9)]
    column = parameter_signature(where.readings, Effect(kind="backlash", component="EXX"), np.ones(1))[0]
    noise = SIGMA * np.random.default_rng(7).standard_normal(column.size)
    named, nothing = (search(where.ground(size * column + noise)) for size in (6e-3, 0.0))
    assert verdict_of(named, True, [], (), ()) == "explained"
    assert verdict_of(named, False, [], stale, ()) == "unexplained_structure"
    assert verdict_of(nothing, False, [check(RIPPLE)], stale, ()) == "unexplained_structure"
    # beside effects that the machine has already a remainder of their own class is no news
    assert verdict_of(nothing, True, [check(RIPPLE)], (), ()) == "no_discrepancy"
    assert verdict_of(nothing, True, [], stale, ()) == "recalibrate"
    assert verdict_of(nothing, True, [], (), ()) == "no_discrepancy"
