import re
import subprocess
import sys
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import get_args

import jinja2
import numpy as np
import pytest
from jinja2 import meta

from tests.reporting.diagnosis import builders
from tests.reporting.diagnosis.page import Element, read
from trueaxis.diagnosis.further_runs.of_plan import Absence, Placed
from trueaxis.diagnosis.result import BoolArray, Diagnosis, Residuals, Verdict
from trueaxis.effects.kind import Effect
from trueaxis.reporting.diagnosis import html as page_of
from trueaxis.reporting.diagnosis.figures import pictures_of
from trueaxis.reporting.diagnosis.html import TEMPLATE, mathml
from trueaxis.reporting.diagnosis.picture import Pictures
from trueaxis.reporting.diagnosis.tables import MOST_PRINTED
from trueaxis.template_folders import template_folders

VERDICTS = get_args(Verdict)
MEGABYTE = 1_000_000
ROOT = Path(__file__).parents[3]


def report_html(diagnosis: Diagnosis) -> str:
    return page_of.report_html(diagnosis, pictures_of(diagnosis))


@cache
def drawn(verdict: Verdict) -> Pictures:
    return pictures_of(builders.diagnosis(verdict))


def words_html(diagnosis: Diagnosis) -> str:
    """For what is in words and tables: with the figures of the diagnosis before it was changed, which take longest."""
    return page_of.report_html(diagnosis, drawn(diagnosis.verdict))


@cache
def html(verdict: Verdict) -> str:
    return words_html(builders.diagnosis(verdict))


@cache
def page(verdict: Verdict) -> Element:
    return read(html(verdict))


@pytest.mark.parametrize("verdict", VERDICTS)
def test_the_page_is_well_formed_and_its_ids_are_its_own(verdict: Verdict) -> None:
    ids = [one.attributes["id"] for one in page(verdict).every() if "id" in one.attributes]
    assert len(ids) == len(set(ids))
    text = html(verdict)
    for reference in re.findall(r'(?:url\(#|href="#)([^)"]+)', text):
        assert reference in ids
    for one in page(verdict).every():
        for named in one.attributes.get("aria-labelledby", "").split():
            assert named in ids


def test_the_page_begins_with_what_was_measured_by_whom_and_with_what() -> None:
    text = html("explained")
    section = text[text.index('<section id="measured"') : text.index('<section id="causes"')]
    for said in ("one &amp; all", "2024-05-06", "XL &lt;7&gt;", "Monday, Tuesday", "320", "1.5", "20.1\N{EN DASH}21.4"):
        assert said in section
    section = text[text.index('<section id="errors"') : text.index('<section id="causes"')]
    for said in ("EXX", "4.00", "6.10", "2.10", "0.30", "EC0Y", "no reading"):
        assert said in section
    assert 'id="errors"' not in words_html(replace(builders.diagnosis("explained"), errors=()))
    without = replace(builders.diagnosis("explained"), report={}, measured=builders.diagnosis("explained").measured[1:])
    section = words_html(without)
    assert ">device<" not in section
    assert ">hours<" not in section


def test_the_template_is_given_what_it_uses(monkeypatch: pytest.MonkeyPatch) -> None:
    given: set[str] = set()
    render = jinja2.Template.render

    def noting(template: jinja2.Template, *args: object, **variables: object) -> str:
        given.update(variables)
        return render(template, *args, **variables)

    monkeypatch.setattr(jinja2.Template, "render", noting)
    words_html(builders.diagnosis("explained"))
    source = next(folder / TEMPLATE for folder in template_folders()).read_text()
    assert given == meta.find_undeclared_variables(jinja2.Environment(autoescape=True).parse(source))


@pytest.mark.parametrize("verdict", VERDICTS)
def test_the_page_needs_nothing_from_elsewhere(verdict: Verdict) -> None:
    assert "http" not in html(verdict)
    assert "@import" not in html(verdict)
    for one in page(verdict).every():
        assert one.tag not in ("script", "link", "iframe", "object")
        for name in ("src", "href", "xlink:href"):
            assert one.attributes.get(name, "#").startswith(("#", "data:image/png;base64,"))


def test_the_page_is_the_same_to_the_byte_in_another_process_with_another_matplotlibrc() -> None:
    code = (
        "import sys, matplotlib; matplotlib.rcParams.update({'font.size': 30.0, 'axes.grid': False})\n"
        "from tests.reporting.diagnosis import builders\n"
        "from trueaxis.reporting.diagnosis.html import report_html\n"
        "from trueaxis.reporting.diagnosis.figures import pictures_of\n"
        "diagnosis = builders.diagnosis('explained')\n"
        "sys.stdout.buffer.write(report_html(diagnosis, pictures_of(diagnosis)).encode())"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, check=False, cwd=ROOT)
    assert done.returncode == 0, done.stderr.decode()
    assert done.stdout.decode() == html("explained")


@pytest.mark.parametrize(
    ("verdict", "said"),
    [
        ("no_discrepancy", "the residuals are noise"),
        ("recalibrate", "its values are stale"),
        ("explained", "Cause found: Backlash in EXX, width 6.10 \u00b5m \u00b1 0.20 \u00b5m (k = 2)"),
        ("ambiguous", "Backlash in EXX or Servo lag in EXX: these readings cannot tell which"),
        ("unexplained_structure", "no cause is named"),
    ],
)
def test_the_verdict_comes_first_in_plain_words(verdict: Verdict, said: str) -> None:
    (head,) = page(verdict).all("h1")
    assert said in head.text.replace("\u00a0", " ")
    (body,) = page(verdict).all("body")
    assert body.attributes["class"] == verdict


def test_a_verdict_without_cause_names_none() -> None:
    for verdict in ("no_discrepancy", "recalibrate", "unexplained_structure"):
        assert not page(verdict).all("article")
        assert 'id="causes"' not in html(verdict)
    assert "lines of X, between directions (3.00 \u00b5m RMS)" in page("unexplained_structure").text.replace(
        "\u00a0", " "
    )
    assert "as far from them with a probability of 1 \u00d7 10\u207b\u2078" in page("recalibrate").text.replace(
        "\u00a0", " "
    )


def test_a_cause_is_told_with_all_that_belongs_to_it() -> None:
    (card,) = page("ambiguous").all("article")
    text = card.text.replace("\u00a0", " ")
    for said in (
        "Backlash in EXX",
        "positioning error of the X axis (EXX)",
        "Play or elastic wind-up in the drive",
        "width 6.10 \u00b5m \u00b1 0.20 \u00b5m (k = 2)",
        "p = 1 \u00d7 10\u207b\u00b9\u00b2",
        "lower by 84 %",
        "Servo lag in EXX",
        "circles in XY at another feed, both directions",
    ):
        assert said in text
    (formula,) = card.all("math")
    assert formula.all("mfrac")
    assert "remainder" not in text


def test_a_remainder_is_said() -> None:
    diagnosis = builders.diagnosis("explained")
    (cause,) = diagnosis.causes
    told = read(words_html(replace(diagnosis, causes=(replace(cause, remainder=True),))))
    assert "a remainder is left beside it" in told.all("article")[0].text


def test_everything_found_is_in_the_page() -> None:
    text = page("explained").text.replace("\u00a0", " ")
    for said in (
        "mill <3 & more>",
        "left out as outliers: 1 reading",
        "with temperature_c empty in 3 of 9 readings: thermal offset cannot be seen",
        "separate backlash in EXX from servo lag in EXX",
        "smallest distinguishable backlash in EXX: 0.40",
        "whole runs left out, one at a time",
        "XY-500-ccw",
        "12.3",
        "lines of X, between directions",
        "differs by the direction of approach",
        "X-2, 17",
        "+9.3",
        "unobservable: lines at one offset only",
        "1100 \u00b5rad",
        "never",
        "repeats",
        "Held-out residuals have 1.03 times the predicted scatter: as expected.",
    ):
        assert said in text


def tables_of(root: Element) -> dict[str, Element]:
    return {table.all("caption")[0].text: table for table in root.all("table")}


def cells(table: Element) -> list[list[str]]:
    """Of the body, without no-break spaces."""
    rows = table.all("tbody")[0].all("tr")
    return [[one.text.replace("\u00a0", " ") for one in (*row.all("th"), *row.all("td"))] for row in rows]


def test_stale_values_are_a_table_and_said_at_the_head() -> None:
    """With the place where they have changed, and by how much; a location error has no place."""
    root = page("recalibrate")
    assert cells(tables_of(root)["Values that have changed"]) == [
        ["EYY", "300", "400 mm", "0.700 \u00b5m", "0.10 \u00b5m", "1 \u00d7 10\u207b\u2079"],
        ["EC0X", "\u2013", "\u2013", "\N{MINUS SIGN}5.20 \u00b5rad", "0.40 \u00b5rad", "2 \u00d7 10\u207b\u2077"],
    ]
    (head,) = root.all("header")
    text = head.text.replace("\u00a0", " ")
    assert "Changed: EYY from 300 to 400 mm by 0.700 \u00b5m, u 0.10 \u00b5m; EC0X by" in text
    sections = [one.attributes["id"] for one in root.all("section")]
    assert sections[:3] == ["measured", "errors", "stale"]
    assert 'id="stale"' not in html("explained")


def test_stale_values_are_shown_beside_a_cause() -> None:
    told = read(words_html(replace(builders.diagnosis("explained"), stale=builders.STALE)))
    assert [row[0] for row in cells(tables_of(told)["Values that have changed"])] == ["EYY", "EC0X"]


def test_the_noise_says_where_it_is_known_from() -> None:
    """A noise that was given has no degrees of freedom, a white one no correlation."""
    found = {row[0]: row for row in cells(tables_of(page("explained"))["Noise of a reading, \u00b5m"])}
    assert found["laser"] == ["laser", "0.301", "0.290", "0.0800", "0.40", "0.100", "0.200", "\u2013", "180", "repeats"]
    assert found["ballbar"] == ["ballbar", "0.300", "0.300", "0", "\u2013", "0", "0", "\u2013", "\u2013", "given"]


def test_no_p_value_is_one() -> None:
    """Multiplied by the number of checks most come to 1, which reads as a fault of the program."""
    checks = cells(tables_of(page("explained"))["Structure left by the final model"])
    assert [row[2] for row in checks] == ["0.3", "above 0.5"]
    evidence = next(t for c, t in tables_of(page("explained")).items() if c.startswith("Evidence of every candidate"))
    assert {row[2] for row in cells(evidence)}.isdisjoint({"1", "1.0", "0.6"})
    for verdict in VERDICTS:
        assert not re.search(r"\bp\s*=\s*1\b(?!\.|\s*\u00d7)", page(verdict).text)


def test_every_candidate_is_in_both_tables() -> None:
    tables = tables_of(page("explained"))
    evidence = next(table for caption, table in tables.items() if caption.startswith("Evidence of every candidate"))
    limits = next(table for caption, table in tables.items() if caption.startswith("Detection limits"))
    for table in (evidence, limits):
        rows = [row.all("th")[0].text for row in table.all("tbody")[0].all("tr")]
        assert sorted(rows) == sorted(
            [
                "Backlash in EXX",
                "Servo lag in EXX",
                "Cyclic in EYY",
                "Laser cosine of X-2, X-3",
                "Cross axis in EXX with Y",
                "Point offset of the target of Y-1",
            ]
        )
    assert evidence.all("tbody")[0].all("tr")[-1].all("td")[0].text == "\u2013"  # no evidence at all: last, and no nan


def test_tables_and_figures_are_accessible() -> None:
    root = page("ambiguous")
    (language,) = root.all("html")
    assert language.attributes["lang"] == "en"
    for table in root.all("table"):
        assert table.all("caption")[0].text
        columns = len(table.all("thead")[0].all("th"))
        for cell in table.all("th"):
            assert cell.attributes["scope"] in ("col", "row")
        for row in table.all("tbody")[0].all("tr"):
            assert len(row.all("td")) + len(row.all("th")) == columns
    figures = root.all("svg")
    assert len(figures) > 15
    for figure in figures:
        assert figure.attributes["role"] == "img"
        assert figure.all("title")[0].text
        assert len(figure.all("desc")[0].text) > 30
        assert not {"width", "height"} & figure.attributes.keys()  # the page scales it


def test_figures_take_their_colours_from_the_page() -> None:
    (style,) = page("explained").all("style")
    defined = set(re.findall(r"--(\w+):", style.text))
    for figure in page("explained").all("svg"):
        for one in figure.every():
            colours = re.findall(r"(?:fill|stroke): ([^;]+)", one.attributes.get("style", ""))
            assert all(colour == "none" or colour.startswith(("var(--", "url(#")) for colour in colours)
            assert {name for colour in colours for name in re.findall(r"var\(--(\w+)\)", colour)} <= defined


def test_the_numbers_in_a_figure_are_whole() -> None:
    stages = next(one for one in page("explained").all("svg") if one.all("title")[0].attributes["id"] == "stages-title")
    shown = [one.text for one in stages.all("text")]
    assert {"4.10", "3.20", "0.310", "0.319"} <= set(shown)


def test_figures_say_what_they_show() -> None:
    names = {one.all("title")[0].attributes["id"].removesuffix("-title"): one for one in page("explained").all("svg")}
    assert {"position-X", "position-Y", "position-Z", "around-XY", "around-ZX", "course-time"} <= names.keys()
    assert {"circle-XY-500", "circle-XY-3000", "circle-ZX-500", "circle-ZX-3000", "isolability"} <= names.keys()
    assert "RMS: values as given" in names["position-X"].all("desc")[0].text
    assert "Laser cosine of X-2, X-3 and Point offset of the target of Y-1" in names["isolability"].all("desc")[0].text
    assert "2 reach it" in names["evidence"].all("desc")[0].text
    assert "4 groups" in names["amplitude-1"].all("desc")[0].text  # the fifth group says nothing: NaN


def test_what_the_data_do_not_carry_is_left_out() -> None:
    plain = builders.diagnosis("no_discrepancy")
    lines = np.isin(plain.residuals.run, range(9))
    bare = read(
        report_html(replace(plain, circles=(), outliers=(), scan=(), next_runs=(), residuals=kept(plain, lines)))
    )
    names = {one.all("title")[0].attributes["id"] for one in bare.all("svg")}
    assert not [name for name in names if name.startswith(("circle", "around", "course", "evidence"))]
    assert not {"circles", "evidence", "next"} & {one.attributes["id"] for one in bare.all("section")}


def kept(diagnosis: Diagnosis, chosen: BoolArray) -> Residuals:
    """Only the chosen readings, without time and temperature."""
    data = diagnosis.residuals
    by_reading = "row run seq positions directions theta along reading given refitted extended whitened".split()
    rows = {name: getattr(data, name)[..., chosen] for name in by_reading}
    return replace(data, **rows, time=None, temperature=None, feed=None)


def test_long_tables_say_that_they_scroll_and_print_in_full() -> None:
    diagnosis = builders.diagnosis("explained")
    outliers = tuple(replace(diagnosis.outliers[0], seq=k) for k in range(40))
    root = read(words_html(replace(diagnosis, outliers=outliers)))
    frames = {one.attributes["aria-label"]: one for one in root.all("div") if "aria-label" in one.attributes}
    long, short = frames["Readings left out as outliers"], frames["Runs that would help"]
    assert long.attributes["class"] == "scroll tall"
    assert "40 rows: scroll" in long.all("caption")[0].text
    assert short.attributes["class"] == "scroll"
    assert "scroll" not in short.text
    (style,) = root.all("style")
    screen, _, paper = style.text.partition("@media print")
    assert ".tall { max-height:" in screen
    assert re.search(r"\.scroll[^}]*max-height: none", paper)
    assert ".hint { display: none; }" in paper


def test_numbers_have_minus_signs_and_kinds_are_words() -> None:
    diagnosis = builders.diagnosis("ambiguous")
    (cause,) = diagnosis.causes
    cause = replace(
        cause,
        effect=builders.LAG,
        parameters=(replace(cause.parameters[0], value=-builders.WIDTH),),
        separating=replace(builders.SEPARATING, apart=(Placed(Effect(kind="thermal_offset", component="EXX")),)),
        held_out_gain=-0.04,
    )
    outlier = replace(diagnosis.outliers[0], deviation=-0.0042, z=-9.3)
    told = replace(
        diagnosis,
        causes=(cause,),
        outliers=(outlier,),
        absences=(Absence(lack="column", place="time_s", kinds=("thermal_offset", "warm_up"), empty=(9, 9)),),
    )
    root = read(report_html(told))
    text = root.all("body")[0].text
    assert "width \N{MINUS SIGN}6.10" in text.replace("\u00a0", " ")
    assert "\N{MINUS SIGN}4.20 \N{MINUS SIGN}9.3" in text
    assert not re.search(r"(?<![\w-])-\d", text)
    assert "higher by 4" in text
    assert "thermal offset and warm up cannot be seen" in text
    assert "servo lag in EXX and servo lag in EXX make the same of these readings" in text
    assert "separates it from thermal offset in EXX" in text
    assert "without time_s:" in text  # the name of a column, to be typed so
    assert text.count("servo_lag") == 1  # once, as a spec has it


def test_the_formula_has_one_operator_for_adding_to() -> None:
    formula = mathml(r"\delta_{x}(x) \;{+}{=}\; \mathit{amplitude}\,\cos(x + 1) = 0")
    root = read(formula)
    assert [one.text for one in root.all("mo") if one.text in "+=+="] == ["+=", "+", "="]
    assert "amplitude" in [one.text for one in root.all("mi")]


def test_what_is_left_stands_beside_the_noise_floor_held_out_and_not() -> None:
    stages = next(one for one in page("explained").all("svg") if one.all("title")[0].attributes["id"] == "stages-title")
    shown = [one.text for one in stages.all("text")]
    for name in ("before: given", "before: refitted", "after: extended", "noise floor"):
        assert shown.count(name) == 2
    assert {"held out", "all readings kept"} <= set(shown)
    assert shown.count("0.300") == 2


def test_many_candidates_are_named_by_kind() -> None:
    diagnosis = builders.diagnosis("explained")
    kinds = {"cyclic": 60, "laser_scale": 1, "cross_axis": 40, "drift": 1, "thermal_offset": 8}
    many = tuple(Effect(kind=kind, runs=(f"{k}",)) for kind, count in kinds.items() for k in range(count))
    told = read(report_html(replace(diagnosis, isolability=many, correlation=builders.correlation(110))))
    figure = next(one for one in told.all("svg") if one.all("title")[0].attributes["id"] == "isolability-title")
    names = [one.text for one in figure.all("text")]
    assert names == ["cyclic (60)", "laser scale (1)", "cross axis (40)", "drift (1)", "thermal offset (8)"]
    heights = [float(one.attributes["transform"].split()[-1].rstrip(")")) if "transform" in one.attributes
               else float(one.attributes["y"]) for one in figure.all("text")]  # fmt: skip
    assert np.diff(heights).min() > 7.5  # a name is so high


def test_a_hundred_thousand_readings_and_a_hundred_candidates_stay_a_small_file() -> None:
    diagnosis = builders.diagnosis("explained")
    many = tuple(replace(builders.CYCLIC, runs=(f"run {k}",)) for k in range(110))
    large = replace(
        diagnosis,
        residuals=builders.residuals(targets=800, repeats=20, circle=4500),
        isolability=many,
        correlation=builders.correlation(110),
        limits=tuple(replace(diagnosis.limits[0], effect=one) for one in many),
        scan=tuple(replace(diagnosis.scan[0], effect=one) for one in many),
    )
    assert large.residuals.run.size > 3e5
    assert len(report_html(large).encode()) < 2 * MEGABYTE


def test_on_paper_are_the_most_telling_rows_of_a_long_table() -> None:
    diagnosis = builders.diagnosis("unexplained_structure")
    checks = tuple(replace(diagnosis.checks[0], place=f"X{k}", p_value=0.5) for k in range(40))
    root = read(words_html(replace(diagnosis, checks=(*checks, diagnosis.checks[1]))))
    hidden = [row for row in root.all("tr") if row.attributes.get("class") == "screen"]
    assert len(hidden) == 41 - MOST_PRINTED
    assert not any("FIRED" in row.text for row in hidden)
    assert f"{41 - MOST_PRINTED} more rows are on the page itself" in root.all("body")[0].text


def test_who_puts_the_page_together_need_not_be_able_to_draw() -> None:
    code = (
        "import sys, trueaxis.cli.diagnose, trueaxis.diagnosis.extended_spec, trueaxis.diagnosis.procedure\n"
        "import trueaxis.reporting.diagnosis.html\n"
        "assert 'matplotlib' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", code], check=True, cwd=ROOT)
