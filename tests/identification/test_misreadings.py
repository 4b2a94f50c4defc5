"""What is said of runs that contradict the others."""

import numpy as np

from trueaxis.estimation.misread import Misread
from trueaxis.estimation.observations import Observations
from trueaxis.identification.misreadings import Contradicting, _who
from trueaxis.measurement.setup import PointOn, Run


def contradicting(count: int, *, zeros_free: float = 1.0, moved: float = 1e-3) -> Contradicting:
    runs = tuple(f"X{k}" for k in range(1, count + 1))
    return Contradicting(runs=runs, times=12.0, log_p=-16.0, zeros_free=zeros_free, moved=moved, u=2e-3)


def test_ten_runs_are_listed_and_the_others_counted() -> None:
    assert str(contradicting(1)).startswith(
        "run X1 contradicts all others: noise alone takes all readings of a sound run as far from what the others "
        "predict with a probability of 1e-07 (together; the farthest combination of them is 12 standard deviations off)"
    )
    assert "X9 and X10 contradict all others" in str(contradicting(10))
    assert "X9, X10 and 2 more contradict all others" in str(contradicting(12))


def test_they_matter_where_noise_and_zeros_do_not_explain_them_or_the_tool_point_moves_by_more_than_its_u() -> None:
    assert not contradicting(1).matter
    assert contradicting(1, zeros_free=20.0).matter
    assert contradicting(1, moved=3e-3).matter


def test_runs_that_have_a_fault_together_are_told_from_the_others() -> None:
    """`all 3 runs of laser in session day1` was said of those along Y, where there were nine."""
    end = PointOn("tool", (0.0, 0.0, 0.0))
    each = [("day1", "x"), ("day1", "x"), ("day1", "y"), ("day1", "y"), ("day2", "x"), ("day2", "x")]
    runs = [
        Run(
            id=str(number), instrument="laser", target=end, reference=PointOn("bed"), frame="bed", home={},
            direction=(1.0, 0.0, 0.0) if along == "x" else (0.0, -1.0, 0.0), session=session,
        )
        for number, (session, along) in enumerate(each)
    ]  # fmt: skip
    observed = Observations(
        source="", runs=tuple(runs), run=np.arange(6), positions=np.zeros((3, 6)), reading=np.zeros(6)
    )

    def said(*together: int) -> str:
        return _who(observed, together[0], Misread(how="reversed", log_odds=20.0, together=together))

    assert said(0, 1, 2, 3, 4, 5) == "all 6 runs of laser"
    assert said(2, 3) == "both runs of laser along [0, 1, 0] in session day1"
    assert said(0, 1, 4, 5) == "all 4 runs of laser along [1, 0, 0]"
    assert said(0, 1, 2, 3) == "all 4 runs of laser in session day1"
    assert said(4, 5) == "both runs of laser in session day2"
    assert said(0, 2, 4) == "the 3 runs 0, 2 and 4 of laser together"
