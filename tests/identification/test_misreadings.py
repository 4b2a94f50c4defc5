"""What is said of runs that contradict the others."""

from trueaxis.identification.misreadings import Contradicting


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
