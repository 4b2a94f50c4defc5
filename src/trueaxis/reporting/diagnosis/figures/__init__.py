"""The figures of the report, one module for each subject: a diagnosis goes in, pictures as inline SVG come out."""

import trueaxis.reporting.pictures  # noqa: F401  Matplotlib is loaded there, away from the data, before any figure needs it
from trueaxis.diagnosis.result import Diagnosis
from trueaxis.reporting.diagnosis.figures.candidates import evidence, isolability
from trueaxis.reporting.diagnosis.figures.circles import around, circles
from trueaxis.reporting.diagnosis.figures.gain import amplitudes, stages
from trueaxis.reporting.diagnosis.figures.periodogram import periodograms
from trueaxis.reporting.diagnosis.figures.residuals import course, positions, whiteness
from trueaxis.reporting.diagnosis.picture import Pictures


def pictures_of(diagnosis: Diagnosis) -> Pictures:
    """All figures of the report, the same for the same diagnosis to the byte; most of the report's time."""
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
