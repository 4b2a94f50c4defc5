"""All figures of the report, drawn from a diagnosis alone."""

from trueaxis.diagnose.report.figures.amplitudes import amplitudes
from trueaxis.diagnose.report.figures.around import around
from trueaxis.diagnose.report.figures.circles import circles
from trueaxis.diagnose.report.figures.course import course
from trueaxis.diagnose.report.figures.evidence import evidence
from trueaxis.diagnose.report.figures.isolability import isolability
from trueaxis.diagnose.report.figures.periodogram import periodograms
from trueaxis.diagnose.report.figures.positions import positions
from trueaxis.diagnose.report.figures.stages import stages
from trueaxis.diagnose.report.figures.whiteness import whiteness
from trueaxis.diagnose.report.picture import Pictures
from trueaxis.diagnose.result import Diagnosis


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
