"""What identified values say of the readings that they are from."""

from trueaxis.identification.report import IdentificationReport
from trueaxis.model.origin import Origin, ReadingNoise


def origin_of(report: IdentificationReport, folder: str, prior: bool) -> Origin:
    """folder: name of the data folder; prior: whether errors of the sizes of [prior] were expected."""
    groups = [
        ReadingNoise(instrument=one.instrument, value=one.noise_um, unit=one.unit, stated=one.stated)
        for one in report.noise_groups
    ]
    if not groups and report.noise_um is not None:
        stated = report.noise_origin == "stated"
        groups = [ReadingNoise(instrument="all", value=report.noise_um, unit="um", stated=stated)]
    return Origin(
        folder=folder,
        method="stepwise" if report.method == "paper" else "global",
        prior=prior,
        runs=len(report.quality.runs),
        readings=report.readings,
        outliers=report.outliers,
        noise=tuple(groups),
        usual_sizes=() if report.usual is None else report.usual.sizes,
        report=dict(report.measurement),
    )
