"""The report as one HTML file that needs nothing else: no network, no script."""

from dataclasses import dataclass

from trueaxis.diagnose.report import tables
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
from trueaxis.diagnose.report.formula import mathml
from trueaxis.diagnose.report.quantity import UM, micrometres, percent, probability, with_expanded
from trueaxis.diagnose.report.svg import Picture
from trueaxis.diagnose.report.tables import Table
from trueaxis.diagnose.report.words import TITLES, effect_title, explanation, headline, joint
from trueaxis.diagnose.result import Cause, Diagnosis
from trueaxis.template_folders import template_folders

TEMPLATE = "report.html.j2"


@dataclass(frozen=True, slots=True)
class CauseText:
    """A cause as its card shows it. parameters: name and value with U; formula: MathML, may be empty."""

    title: str
    joint: str
    sentence: str
    formula: str
    parameters: tuple[tuple[str, str], ...]
    facts: tuple[tuple[str, str], ...]
    rivals: Table | None
    separating: str
    remainder: bool
    pictures: tuple[Picture, ...]


@dataclass(frozen=True, slots=True)
class Section:
    """A part of the page; left out where there is nothing in it."""

    name: str
    title: str
    intro: str
    pictures: tuple[Picture, ...]
    tables: tuple[Table, ...]


def report_html(diagnosis: Diagnosis) -> str:
    """The page, the same for the same diagnosis to the byte.

    Figures are SVG within it, formulas MathML; colours follow the reader's preference, light or dark.
    """
    import jinja2  # noqa: PLC0415 - diagnosing without a report needs no templates

    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(template_folders()),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=True,
    )
    return environment.get_template(TEMPLATE).render(
        machine=diagnosis.machine,
        verdict=diagnosis.verdict,
        title=TITLES[diagnosis.verdict],
        headline=headline(diagnosis),
        explanation=explanation(diagnosis),
        key_figures=_key_figures(diagnosis),
        warnings=diagnosis.warnings,
        absences=diagnosis.absences,
        causes_title=_causes_title(diagnosis),
        causes=[_cause(one, number) for number, one in enumerate(diagnosis.causes, 1)],
        sections=[one for one in _sections(diagnosis) if one.pictures or any(table.rows for table in one.tables)],
    )


def _key_figures(diagnosis: Diagnosis) -> list[tuple[str, str]]:
    gain = diagnosis.gain
    return [
        ("RMS as given", f"{micrometres(gain.rms.given)} {UM}"),
        ("RMS refitted", f"{micrometres(gain.rms.refitted)} {UM}"),
        ("RMS extended", f"{micrometres(gain.rms.extended)} {UM}"),
        ("RMS held out", f"{micrometres(gain.held_out.extended)} {UM}"),
        ("noise floor", f"{micrometres(gain.floor)} {UM}"),
    ]


def _causes_title(diagnosis: Diagnosis) -> str:
    if diagnosis.verdict == "ambiguous":
        return "Possible causes"
    return "Causes" if len(diagnosis.causes) > 1 else "Cause"


def _cause(cause: Cause, number: int) -> CauseText:
    return CauseText(
        title=effect_title(cause.effect),
        joint=joint(cause.effect),
        sentence=cause.sentence[:1].upper() + cause.sentence[1:],
        formula=mathml(cause.formula) if cause.formula else "",
        parameters=tuple((one.name, with_expanded(one.value, one.u, one.unit)) for one in cause.parameters),
        facts=(
            ("explains", f"{micrometres(cause.rms)} {UM} RMS of the readings"),
            ("evidence", f"{cause.evidence:.3g} (p = {probability(cause.p_value)})"),
            ("held-out RMS", f"lower by {percent(cause.held_out_gain)}"),
            ("same size everywhere", f"p = {probability(cause.homogeneous_p)}"),
        ),
        rivals=tables.rivals(cause) if cause.rivals else None,
        separating=cause.separating,
        remainder=cause.remainder,
        pictures=tuple(amplitudes(cause, number)),
    )


def _sections(diagnosis: Diagnosis) -> list[Section]:
    return [
        Section("next", "What to measure next", "", (), (tables.next_runs(diagnosis),)),
        Section("gain", "Before and after", "", tuple(stages(diagnosis)), (tables.circularity(diagnosis),)),
        Section(
            "residuals",
            "Residuals",
            f"Measured less model, {UM}: with the values given, refitted, and with the extended model.",
            (*positions(diagnosis), *around(diagnosis), *course(diagnosis)),
            (),
        ),
        Section(
            "circles",
            "Circles",
            "Radial deviations measured, and what the extended model says of them.",
            tuple(circles(diagnosis)),
            (),
        ),
        Section("periods", "Periods", "", tuple(periodograms(diagnosis)), ()),
        Section(
            "structure", "Is noise all that is left?", "", tuple(whiteness(diagnosis)), (tables.checks(diagnosis),)
        ),
        Section("evidence", "Evidence", "", tuple(evidence(diagnosis)), (tables.scan(diagnosis),)),
        Section(
            "limits",
            "What these runs can and cannot see",
            "",
            tuple(isolability(diagnosis)),
            (tables.limits(diagnosis),),
        ),
        Section("noise", "Noise and outliers", "", (), (tables.noise(diagnosis), tables.outliers(diagnosis))),
    ]
