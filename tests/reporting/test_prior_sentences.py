"""What is said of values that no reading determines, by what `identify` made of them."""

from dataclasses import replace

import pytest

from trueaxis.model.errors import CovarianceLink, ErrorValues, Undetermined
from trueaxis.model.origin import Origin
from trueaxis.reporting.reliance import prior_sentences

ORIGIN = Origin(folder="data", method="global", prior=True, runs=1, readings=5, outliers=0)
VALUES = ErrorValues(
    machine="m", parameters={"eps_xy": 1e-6}, undetermined=(Undetermined("eps_xy", ("eps_xy",)),),
    covariance=CovarianceLink("e.npz", ""), origin=ORIGIN,
)  # fmt: skip


@pytest.mark.parametrize("origin", [None, ORIGIN])
def test_they_rest_on_the_prior(origin: Origin | None) -> None:
    assert "rest on [prior]" in prior_sentences(replace(VALUES, origin=origin), ())[0]


def test_without_a_prior_they_rest_on_nothing() -> None:
    (said,) = prior_sentences(replace(VALUES, origin=replace(ORIGIN, prior=False)), ())
    assert "[prior]" not in said
    assert "neither readings nor a prior determine eps_xy" in said
