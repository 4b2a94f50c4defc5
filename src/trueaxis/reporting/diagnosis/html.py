"""The report as one HTML file that needs nothing else: no network, no script. Its formulas are MathML."""

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass

from trueaxis.diagnosis.result import Cause, Diagnosis, Gain, GainOfAngles
from trueaxis.reporting.diagnosis import further, tables
from trueaxis.reporting.diagnosis.gain_words import given_note, held_out_change, predicted_scatter
from trueaxis.reporting.diagnosis.picture import Picture, Pictures
from trueaxis.reporting.diagnosis.quantity import UM, URAD, equals_p, micrometres, with_expanded, written
from trueaxis.reporting.diagnosis.tables import Table
from trueaxis.reporting.diagnosis.words import (
    TITLES,
    changed_instead,
    effect_title,
    explanation,
    headline,
    in_words,
    joint,
    size_open,
)
from trueaxis.template_folders import template_folders

TEMPLATE = "report.html.j2"
_SPACE = r'(?:<mspace width="[^"]*" />)?'
_ADDED = re.compile(rf"{_SPACE}<mrow><mo>&#x0002B;</mo></mrow><mrow><mo>&#x0003D;</mo></mrow>{_SPACE}")
_LETTERS = re.compile(r'(?:<mi mathvariant="italic">\w</mi>){2,}')


@dataclass(frozen=True, slots=True, kw_only=True)
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


@dataclass(frozen=True, slots=True, kw_only=True)
class Section:
    """A part of the page; left out where there is nothing in it."""

    name: str
    title: str
    intro: str = ""
    pictures: tuple[Picture, ...] = ()
    tables: tuple[Table, ...] = ()


def report_html(diagnosis: Diagnosis, pictures: Pictures) -> str:
    """The page, the same for the same diagnosis and its pictures to the byte.

    Figures are SVG within it, formulas MathML; colours follow the reader's preference, light or dark.
    """
    kinds = frozenset(one.effect.kind for one in diagnosis.limits)
    return rendered(
        TEMPLATE,
        machine=diagnosis.machine,
        verdict=diagnosis.verdict,
        title=TITLES[diagnosis.verdict],
        headline=headline(diagnosis),
        explanation=explanation(diagnosis),
        key_figures=_key_figures(diagnosis),
        warnings=[in_words(one, kinds) for one in further.warnings(diagnosis)],
        absences=[in_words(one, kinds) for one in further.absences(diagnosis)],
        report=diagnosis.report,
        measured=tables.measured(diagnosis),
        errors=tables.errors(diagnosis),
        causes_title=_causes_title(diagnosis),
        causes=[_cause(one, drawn, kinds) for one, drawn in zip(diagnosis.causes, pictures.causes, strict=True)],
        sections=[
            one
            for one in _sections(diagnosis, kinds, pictures.sections)
            if one.pictures or any(table.rows for table in one.tables)
        ],
    )


def rendered(template: str, **content: object) -> str:
    """A page by its template, whose variables are those given; texts are escaped."""
    import jinja2  # noqa: PLC0415 - right of the generated files only pages need templates

    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(template_folders()),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=True,
    )
    return environment.get_template(template).render(**content)


def _key_figures(diagnosis: Diagnosis) -> list[tuple[str, str]]:
    gain = diagnosis.gain
    scatter = written(gain.standardised, ".2f")
    return [
        *(_figures_of(gain, "", UM) if math.isfinite(gain.floor) else []),
        *([] if gain.angles is None else _figures_of(gain.angles, "angles: ", URAD)),
        *([("held-out residuals over predicted scatter", scatter)] if math.isfinite(gain.standardised) else []),
    ]


def _figures_of(gain: Gain | GainOfAngles, lead: str, unit: str) -> list[tuple[str, str]]:
    return [
        (f"{lead}RMS as given", f"{micrometres(gain.rms.given)} {unit}"),
        (f"{lead}RMS refitted", f"{micrometres(gain.rms.refitted)} {unit}"),
        (f"{lead}RMS extended", f"{micrometres(gain.rms.extended)} {unit}"),
        (f"{lead}held out, refitted", f"{micrometres(gain.held_out.refitted)} {unit}"),
        (f"{lead}held out, extended", f"{micrometres(gain.held_out.extended)} {unit}"),
        (f"{lead}noise floor", f"{micrometres(gain.floor)} {unit}"),
    ]


def _causes_title(diagnosis: Diagnosis) -> str:
    if diagnosis.verdict == "ambiguous":
        return "Possible causes"
    return "Causes" if len(diagnosis.causes) > 1 else "Cause"


def _cause(cause: Cause, pictures: tuple[Picture, ...], kinds: frozenset[str]) -> CauseText:
    return CauseText(
        title=effect_title(cause.effect),
        joint=joint(cause.effect),
        sentence=cause.sentence[:1].upper() + cause.sentence[1:],
        formula=mathml(cause.formula) if cause.formula else "",
        parameters=tuple((one.name, with_expanded(one.value, one.u, one.unit)) for one in cause.parameters),
        facts=(
            ("explains", f"{micrometres(cause.rms)} {UM} RMS of the readings"),
            ("evidence", f"{written(cause.evidence, '.3g')} ({equals_p(cause.p_value)})"),
            ("held-out RMS", held_out_change(cause)),
            ("same size everywhere", equals_p(cause.homogeneous_p)),
            ("kind, as in a spec", cause.effect.kind),
            *((("size", size_open(cause)),) if size_open(cause) else ()),
            *(("or, in its place", one) for one in changed_instead(cause)),
        ),
        rivals=tables.rivals(cause) if cause.rivals else None,
        separating="" if cause.separating is None else in_words(further.separating_run(cause.separating), kinds),
        remainder=cause.remainder,
        pictures=pictures,
    )


def _sentence(text: str) -> str:
    return f"{text[:1].upper()}{text[1:]}." if text else ""


def _sections(
    diagnosis: Diagnosis, kinds: frozenset[str], pictures: Mapping[str, tuple[Picture, ...]]
) -> list[Section]:
    return [
        Section(
            name="stale",
            title="Values that are no longer true",
            intro="The readings require other values than the given ones. Change: required minus given value, "
            "where it exceeds twice its standard uncertainty u most clearly; from, to: the range where it exceeds "
            "that; p: of the whole change.",
            tables=(tables.stale(diagnosis),),
        ),
        Section(
            name="next",
            title="What to measure next",
            tables=(tables.next_runs(diagnosis, kinds),),
        ),
        Section(
            name="gain",
            title="Before and after",
            intro=" ".join(map(_sentence, filter(None, [predicted_scatter(diagnosis.gain), given_note(diagnosis)]))),
            pictures=pictures["gain"],
            tables=(tables.circularity(diagnosis),),
        ),
        Section(
            name="residuals",
            title="Residuals",
            intro=f"Measured minus model, {UM}: with the given values, refitted, and with the extended model.",
            pictures=pictures["residuals"],
        ),
        Section(
            name="circles",
            title="Circles",
            intro="Radial deviations, measured and by the extended model.",
            pictures=pictures["circles"],
        ),
        Section(name="periods", title="Periods", pictures=pictures["periods"], tables=()),
        Section(
            name="structure",
            title="Are the residuals noise?",
            pictures=pictures["structure"],
            tables=(tables.checks(diagnosis),),
        ),
        Section(name="evidence", title="Evidence", pictures=pictures["evidence"], tables=(tables.scan(diagnosis),)),
        Section(
            name="limits",
            title="What these runs can and cannot show",
            pictures=pictures["limits"],
            tables=(tables.limits(diagnosis),),
        ),
        Section(
            name="noise",
            title="Noise and outliers",
            tables=(tables.noise(diagnosis), tables.outliers(diagnosis)),
        ),
    ]


def mathml(latex: str) -> str:
    """A math element in block style. In a page it needs no namespace.

    `+=` is one operator in it and the name of a parameter one identifier, which converters set sign by sign.
    """
    from latex2mathml.converter import convert  # noqa: PLC0415  only pages with formulas need it

    text = re.sub(r' xmlns="[^"]*"', "", convert(latex, display="block"), count=1)
    text = _ADDED.sub('<mo lspace="0.278em" rspace="0.278em">+=</mo>', text)
    return _LETTERS.sub(lambda name: f'<mi class="name">{re.sub("<[^>]*>", "", name.group())}</mi>', text)
