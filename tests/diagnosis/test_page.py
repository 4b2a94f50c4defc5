"""docs/diagnosis.md and README.md say what their commands print."""

import contextlib
import io
import json
import math
import re
import shutil
from pathlib import Path

import numpy as np
import pytest

from tests.hidden_effects import write_case
from tests.machines import ROOT
from trueaxis.cli.main import main
from trueaxis.diagnosis.causes import imperfection, search
from trueaxis.diagnosis.further_runs.audit import CONFOUNDED, DETECTION, ISOLATION
from trueaxis.diagnosis.judging import checks_of_runs, gain, stale, verdict
from trueaxis.diagnosis.judging.structure import Check, StructureClass
from trueaxis.diagnosis.judging.structure_columns import DEGREE as DEGREE_OF_LINES
from trueaxis.diagnosis.judging.structure_columns import LOBES, RIPPLE
from trueaxis.diagnosis.null_model.base import DEGREE
from trueaxis.estimation import outliers
from trueaxis.estimation.effects.amplitudes import UNOBSERVABLE
from trueaxis.estimation.instruments import CLASSES
from trueaxis.measurement.machine import FloatArray
from trueaxis.model.model import home_of, load_model
from trueaxis.reporting.diagnosis.structures import check_name

PAGE = (ROOT / "docs" / "diagnosis.md").read_text()
README = (ROOT / "README.md").read_text()
SHARES = {0.5: "half", 1.0: "all"}
AFTER = {2: "three"}
WORDS = {0.05: "twenty"}
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e-?\d+)?")
CASES = re.compile(r"^\| (`--\S+.*?`) \| `(\w+)` \| (.*) \|$", re.MULTILINE)


def blocks(page: str) -> list[list[str]]:
    return [text.strip().splitlines() for text in re.findall(r"^```\n(.*?)^```", page, re.DOTALL | re.MULTILINE)]


def run(line: str) -> str:
    """What a command of a page prints; it must not end in a fault."""
    words = line.split()
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        if words[:2] == ["python", "-m"]:
            assert words[2] == "tests.hidden_effects.write_case"
            assert write_case.main(words[3:]) == 0
        else:
            assert words[0] == "trueaxis"
            assert main(words[1:]) in (0, 1)
    return printed.getvalue()


def alike(told: str, printed: str) -> bool:
    """The same words, numbers within 3 %, tiny ones (probabilities) within a factor of 10: processors round."""
    if NUMBER.sub("#", told) != NUMBER.sub("#", printed):
        return False
    pairs = zip(map(float, NUMBER.findall(told)), map(float, NUMBER.findall(printed)), strict=True)
    return all(
        abs(math.log10(a / b)) < 1.0 if 0.0 < min(a, b) < 1e-6 else math.isclose(a, b, rel_tol=0.03) for a, b in pairs
    )


def test_lines_are_alike_but_for_rounding() -> None:
    assert alike("p 8.2e-32, 0.322 um", "p 5.0e-32, 0.321 um")
    assert not alike("p 8.2e-32, 0.322 um", "p 8.2e-32, 0.350 um")
    assert not alike("width -1.88 um", "width 1.88 um")
    assert not alike("Backlash in EYY", "Backlash in EXX")


@pytest.fixture(scope="module")
def example(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, list[str]]:
    """The folder of the page's example, and what its last command printed."""
    place = tmp_path_factory.mktemp("page")
    with contextlib.chdir(place):
        printed = [run(line) for line in blocks(PAGE)[0]]
    return place / "example", printed[-1].splitlines()


@pytest.mark.slow
def test_the_example_prints_what_the_page_says(example: tuple[Path, list[str]]) -> None:
    printed = iter(example[1])
    for told in blocks(PAGE)[1]:
        if told != "...":
            assert any(alike(told, line) for line in printed), told


@pytest.mark.slow
def test_the_readme_shows_what_its_commands_print(tmp_path: Path) -> None:
    place = next(k for k, lines in enumerate(blocks(README)) if lines[-1].startswith("trueaxis diagnose"))
    commands, result = blocks(README)[place : place + 2]
    for folder in ("machines", "examples", "generated"):
        shutil.copytree(ROOT / folder, tmp_path / folder)
    with contextlib.chdir(tmp_path):
        printed = [run(line) for line in commands][-1].splitlines()
    assert len(result) > 3
    for told in result:
        assert any(alike(told, line) for line in printed), told
    true = deviation(tmp_path / "examples" / "worn_mill_errors.json")
    off = [deviation(tmp_path / name) - true for name in ("found/errors.json", "errors.json")]
    figures = [f"{1e3 * np.sqrt(np.mean(one**2)):.2f} um" for one in off]
    assert f"Over the volume its values are {figures[0]} off at the tool" in " ".join(README.split())
    assert f"for errors of the geometry, are {figures[1]} off." in " ".join(README.split())


def deviation(errors: Path) -> FloatArray:
    """(3, n), mm: of the tool of the C-frame mill since home, by the geometry alone."""
    tree = json.loads(errors.read_text())
    bare = {name: tree[name] for name in ("schema", "machine", "parameters", "motion_errors")}
    (errors.parent / "bare.json").write_text(json.dumps(bare))
    model = load_model(ROOT / "machines" / "cframe_mill.toml", errors.parent / "bare.json", ROOT / "generated")
    ends = np.array([model.travel[axis] for axis in model.axes])
    points = np.random.default_rng(1).uniform(ends[:, 0], ends[:, 1], (300, len(ends))).T
    return model.deviation(points, np.zeros((3, 1))) - model.deviation(home_of(model), np.zeros((3, 1)))


@pytest.mark.slow
def test_what_was_hidden_lies_within_the_uncertainties(example: tuple[Path, list[str]]) -> None:
    hidden = {"amplitude": 0.0008, "phase": -0.688, "pitch": 10.0773, "width": -0.002}
    causes = json.loads((example[0] / "found" / "diagnosis.json").read_text())["causes"]
    found = {name: at for cause in causes for name, at in cause["parameters"].items()}
    assert found.keys() == hidden.keys()
    assert {name for name, at in found.items() if abs(at["value"] - hidden[name]) > 2.0 * at["u"]} == set()
    assert "10.0773 mm, the phase -0.688 rad" in PAGE


@pytest.mark.slow
def test_figures_in_the_text_are_those_of_the_example(example: tuple[Path, list[str]]) -> None:
    told = json.loads((example[0] / "found" / "diagnosis.json").read_text())
    assert f"has {len(told['limits'])} candidates" in PAGE
    expansion = next(one for one in told["limits"] if (one["effect"], one["component"]) == ("thermal_expansion", "EXX"))
    assert f"{100 * (1 - expansion['share']):.1f} % of its squares" in PAGE


@pytest.mark.slow
@pytest.mark.usefixtures("without_second_process")
@pytest.mark.parametrize(("options", "expected", "said"), CASES.findall(PAGE), ids=lambda text: text.strip("`")[:24])
def test_other_data_get_the_verdict_of_the_table(
    example: tuple[Path, list[str]], tmp_path: Path, options: str, expected: str, said: str
) -> None:
    words = options.strip("`")
    with contextlib.chdir(tmp_path):
        run(f"python -m tests.hidden_effects.write_case example --seed 7 {words}")
        line = blocks(PAGE)[0][-1].replace("example/kernels", str(example[0] / "kernels"))
        printed = run(line)
        told = json.loads(Path("example/found/diagnosis.json").read_text())
    assert printed.startswith(f"{expected}: ")
    gain_of, floor = told["gain"]["rms_um"], told["gain"]["floor_um"]
    figures = {f"{value:.3f}" for value in (gain_of["given"], gain_of["refitted"], floor)}
    figures |= {f"{1e3 * abs(one['value']):.2f}" for one in told["stale"]}
    assert {text for text in NUMBER.findall(said) if "." in text} <= figures
    if expected == "recalibrate":
        assert len(told["stale"]) == 10
        assert "ten errors have changed, EZZ by" in said
        assert told["stale"][0]["component"] == "EZZ"
        (eyy,) = [one for one in told["stale"] if one["component"] == "EYY"]
        assert f"EYY by {1e3 * abs(eyy['value']):.2f} um" in said
    if expected == "no_discrepancy":
        assert told["stale"] == []
    if expected == "ambiguous":
        (cause,) = told["causes"]
        (rival,) = cause["cannot_be_told_from"]
        assert {(one["effect"], one["component"]) for one in (cause, rival)} == {
            ("backlash", "EYX"),
            ("backlash", "EAX"),
        }
        assert "laser, X moving" in cause["separating"]
        assert "straightness in y" in cause["separating"]
        assert "a straightness of X would tell" in said
    if expected == "unexplained_structure":
        assert "lines of X, between directions" in said
        assert "lines of X, between directions" in [one["check"] for one in told["checks"] if one["fired"]]


def test_there_is_a_case_for_each_other_verdict() -> None:
    assert [expected for _, expected, _ in CASES.findall(PAGE)] == [
        "no_discrepancy",
        "recalibrate",
        "ambiguous",
        "unexplained_structure",
    ]


@pytest.mark.parametrize(
    "text",
    [
        f"too far from the null model: noise exceeds the limit in one data set of {WORDS[outliers.EXPECTED]}",
        f"A deviation of which the repeats share more than {SHARES[outliers.SHARED]} is structure and stays, "
        f"as do {AFTER[outliers.NEIGHBOURS]} in a row",
        f"The scale of a laser ({1e6 * CLASSES['laser scale'].size:g} um/m) and its cosine "
        f"({1e6 * CLASSES['laser cosine'].size:g} um/m)",
        f"in one of {1 / stale.FALSE_ALARMS:.0f} data sets".replace("100000", "100 000"),
        "the change exceeds twice its standard uncertainty" if stale.CHANGED == 2.0 else "?",
        f"polynomial of degree {DEGREE},",
        f"Lobes have 1 to {LOBES} undulations per revolution of a circle, ripple {LOBES + 1} to {RIPPLE}. "
        f"On a line, ripple has {2 * DEGREE_OF_LINES + 1} to {RIPPLE} half periods",
        f"sqrt({DETECTION:g} / lambda)",
        f"sqrt({ISOLATION:g} / (lambda (1 - R^2)))",
        f"leaves less than {UNOBSERVABLE:.0e} of its squares".replace("e-09", "e-9"),
        f"R^2 > {CONFOUNDED}",
        f"log10(candidates / {search.FALSE_ALARMS:.4f})",
        f"needs {search.FURTHER:g} decades more",
        f"evidence within {search.RIVAL:g} decades",
        f"{100 * imperfection.MODULATED:g} % that vary along the travel",
        f"second harmonic of {100 * imperfection.HARMONIC:g} %",
        f"{100 * imperfection.OTHERWISE[0]:g} % of what a constant {imperfection.OTHERWISE[1]} times",
        f"times their number is below {checks_of_runs.FALSE_ALARMS}",
        f"(p > {verdict.HOMOGENEOUS:.0e})".replace("e-04", "e-4"),
        f"is {100 * verdict.PRACTICALLY_ALL:g} % of all that is beyond noise; or {100 * verdict.NEARLY_ALL:g} %",
        f"The last {100 * gain.HELD:g} % of the repeats",
    ],
)
def test_constants_in_the_text_are_those_of_the_code(text: str) -> None:
    assert text in " ".join(PAGE.split())


def test_every_class_of_structure_is_listed_with_its_id() -> None:
    section = PAGE.partition("\n## Checks\n")[2].partition("\n## ")[0]
    listed = re.findall(r"^\| `(\w+)` \| (axis|plane|component error|run|instrument) \|", section, re.MULTILINE)
    assert [name for name, _ in listed] == [one.value for one in StructureClass]
    nouns = {
        "axis": "lines of", "plane": "circles of", "component error": "readings that show", "run": "run",
        "instrument": "readings of the",
    }  # fmt: skip
    for name, place in listed:
        assert check_name(
            Check(structure=StructureClass(name), place="?", p_value=1.0, fired=False, rms=0.0)
        ).startswith(nouns[place])
