"""All figures of the report, drawn from a diagnosis alone."""

from trueaxis.diagnosis.result import Diagnosis
from trueaxis.reporting.diagnosis.figures.candidates import evidence, isolability
from trueaxis.reporting.diagnosis.figures.circles import around, circles
from trueaxis.reporting.diagnosis.figures.gain import amplitudes, stages
from trueaxis.reporting.diagnosis.figures.periodogram import periodograms
from trueaxis.reporting.diagnosis.figures.residuals import course, positions
from trueaxis.reporting.diagnosis.figures.whiteness import whiteness
from trueaxis.reporting.diagnosis.picture import Pictures


def pictures_of(diagnosis: Diagnosis) -> Pictures:
    """The same for the same diagnosis to the byte; most of the report's time."""
    return Pictures(
        causes=tuple(tuple(amplitudes(one, number)) for number, one in enumerate(diagnosis.causes, 1)),
        sections={
            "gain": tuple(stages(diagnosis)),
            "residuals": (*positions(diagnosis), *around(diagnosis), *course(diagnosis)),
            "circles": tuple(circles(diagnosis)),
            "periods": tuple(periodograms(diagnosis)),
            "structure": tuple(whiteness(diagnosis)),
            "evidence": tuple(evidence(diagnosis)),
            "limits": tuple(isolability(diagnosis)),
        },
    )
