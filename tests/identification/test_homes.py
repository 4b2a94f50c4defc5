"""A laser that was set to zero off the line of its run is told: `home` may only have been left out."""

from dataclasses import replace

from tests.generator.dmu60p import cubic_errors
from tests.identification.data import dmu60p_model, mixed_data
from trueaxis.identification.notes import homes_notes


def test_a_home_off_the_line_is_told_with_its_axes() -> None:
    observed, model = mixed_data(cubic_errors(), 6), dmu60p_model()
    assert homes_notes(model, observed) == ()
    runs = list(observed.runs)
    still = next(axis for k, axis in enumerate(model.axes) if not observed.positions[k, observed.run == 2].any())
    runs[2] = replace(runs[2], home={**runs[2].home, still: 300.0})
    (note,) = homes_notes(model, replace(observed, runs=tuple(runs)))
    assert note.startswith(f"{runs[2].id} ({still}): on these lines")
