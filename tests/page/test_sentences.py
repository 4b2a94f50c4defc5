"""What the page says in words, held against computation: each statement, and slips put into it that must be caught."""

import re
from collections.abc import Callable
from fractions import Fraction

import numpy as np
import pytest

from tests.page.chain_names import AXES, column
from tests.page.latex_value import names_in, value_of
from tests.page.pages import names, page
from tests.page.paper_names import RUNS
from tests.page.rows import Row, cells_of, rows_of
from tests.paper import reference
from tests.paper.claims_systems import PAPER_READINGS, SYSTEMS, undetermined
from tests.paper.entries import follows
from tests.paper.errata import ERRATA
from tests.paper.printed.tables import POINTS_LINKAGE, POINTS_SINGLE

PAGE = "dmu60p"


def rows_under(text: str, number: int) -> list[Row]:
    return [row for row in rows_of(text) if row.title.startswith(f"Eq. ({number})")]


def heading_text(text: str, number: int) -> str:
    """What stands between the heading of an equation and the next one."""
    return text[text.index(f"### Eq. ({number})") :].split("\n##", 1)[0]


def angles(text: str) -> None:
    """(22), (28), (36): where theta is 0 the line lies along the axis from which the page measures it."""
    for number, run in ((22, "XZ"), (28, "XY"), (36, "YZ")):
        (axis,) = re.findall(r"measured from the (\w) axis", heading_text(text, number))
        along = {"L_ih": 1.3, r"\delta_ih": 0.0, r"\theta": 0.0}
        for row in rows_under(text, number):
            if "=" in row.text and row.text.startswith("L_{i"):
                left, right = row.text.split("=")
                moved = value_of(right, names_in(along)) != 0
                assert moved == (left[4] == axis.lower()), (run, axis)


def views(text: str) -> None:
    """The view or the two views that the page names make the left side of a motion equation, with Eq. (11)'s sign."""
    own = names(PAGE)
    for number, run in ((12, "X"), (13, "Y"), (14, "Z"), (21, "XZ"), (27, "XY"), (35, "YZ")):
        said = heading_text(text, number)
        negative, columns, by = re.findall(
            r"(The negative of )?Eq\. \(11\) with the columns (\w+) of Table 3; "
            r"to first order the change since home of (.*):",
            said,
        )[0]
        assert columns == run
        known = own._run(run, number)  # type: ignore[attr-defined]
        changes = {
            end: np.array([known[f"{a}_{point}h"] - known[f"{a}_{point}0"] for a in AXES])
            for end, point in (("workpiece_in_bed", "l"), ("tool_in_bed", "k"))
        }
        first, *others = re.findall(r"the view `(\w+)`", by)
        assert re.sub(r"the view `\w+`", "v", by) == " less that of ".join("v" * (1 + len(others)))
        moved = changes[first] - sum((changes[other] for other in others), np.zeros(3))
        read = changes["workpiece_in_bed"] - changes["tool_in_bed"]
        assert moved == pytest.approx(-read if negative else read)
        left = [row.text.split("=")[0] for row in rows_under(text, number)]
        assert [value_of(side, names_in(known)) for side in left] == pytest.approx(list(moved))


def assumptions(text: str) -> None:
    """Beside each system and solution the location errors that its readings hold, and no others."""
    for equation, run, read, _ in SYSTEMS:
        for number in map(int, re.findall(r"\((\d+)\)", equation)):
            symbols = {str(s) for _, label, d in read for s in reference.readings(run)[_reading(label, d)].free_symbols}
            held = {name for name in symbols if re.fullmatch("epsilon_[xyz]{2}", name)}
            said = re.findall(r"\$\\varepsilon_\{(\w\w)\}\$ is assumed to be known", heading_text(text, number))
            assert {f"epsilon_{pair}" for pair in said} == held, number


def _reading(label: str, direction: str) -> object:
    return next(
        s for run in reference.RUN_LABELS for s in reference.readings(run) if str(s) == f"L_{label}{direction}h"
    )


FREE = re.compile(
    r"- (\w+) and the slope of (\w+): a change of ([+-]\S+) rad in \1 with ([+-]\S+) mm per mm in the slope of \2 "
    r"changes no reading; only \(slope of \2\) ([+-]) (?:(\S+) )?\1 is determined\."
)
ANY = re.compile(r"- ([\w, ]+): at every position one combination of them is free, because")


def combinations(text: str) -> None:
    """Each change leaves all 18 readings; what is said to be determined does not change with it."""
    own = names(PAGE)
    found = FREE.findall(text)
    assert {(a, b) for a, b, *_ in found} == {("eps_xy", "EYX"), ("eps_yz", "EYZ"), ("eps_xz", "EXZ")}
    for location, curve, turn, slope, sign, factor in found:
        at = own.values[curve[2].lower()]
        changed = {**own.values, location: own.values[location] + float(turn)}
        changed[curve] += float(slope) * at
        assert readings(changed) == pytest.approx(readings(own.values))
        both = Fraction(slope) + (1 if sign == "+" else -1) * Fraction(factor or 1) * Fraction(turn)
        assert both == 0
    (free,) = ANY.findall(text)
    expected = {
        re.sub(
            r"(\w+)_(\w)\((\w)\)",
            lambda m: f"E{('XYZ' if m[1] == 'delta' else 'ABC')[AXES.index(m[2])]}{m[3].upper()}",
            name,
        )
        for name in undetermined()
    }
    assert set(free.split(", ")) == expected


def readings(values: dict[str, float]) -> list[float]:
    """The 18 readings to first order, by the numeric chain."""
    own = names(PAGE)
    found = []
    for run, label, direction in PAPER_READINGS:
        table = POINTS_SINGLE if len(run) == 1 else POINTS_LINKAGE[run]
        ends: dict[str, np.ndarray] = {
            end: column(*table[name], 1)
            for end, name in zip(("tool", "workpiece"), reference.point_names(run, label), strict=True)
            if name is not None
        }
        _, first = own.chain.displacement(run, ends, values)
        found.append(float(first[AXES.index(direction), 0]))
    return found


def runs_of_points(text: str) -> None:
    """Tables 4 and 5: each point is that of the readings that the paper takes at it."""
    _, *table = cells_of(text, "### Tables 4 and 5")
    named = {tuple(map(float, at.strip("()").split(", "))): runs.split(", ") for _, at, _, runs in table}
    expected: dict[tuple[float, ...], list[str]] = {}
    for run, label, direction in PAPER_READINGS:
        points = POINTS_SINGLE if len(run) == 1 else POINTS_LINKAGE[run]
        for point in filter(None, reference.point_names(run, label)):
            name = f"{run}-{label}{direction if len(run) > 1 else ''}"
            expected.setdefault(tuple(map(float, points[point])), []).append(name)
    assert {at: sorted(runs) for at, runs in named.items()} == {at: sorted(runs) for at, runs in expected.items()}


def meanings(text: str) -> None:
    """The table of symbols calls each error what Table 1 calls it."""
    _, *table = cells_of(text, "## Symbols")
    said = {re.sub(r"[{}$]", "", symbol): meaning for symbol, _, _, meaning in table}
    for (source, label), cells in follows().items():
        if source != "Table 1" or not isinstance(cells, tuple) or "perpendicularity" in str(label):
            continue
        for axis, cell in zip("XYZ", cells, strict=True):
            if cell:
                symbol = re.sub("delta|epsilon", lambda m: {"delta": r"\delta"}.get(m[0], r"\varepsilon"), cell)
                kind = f"straightness error of {axis} in {label[0].upper()}" if "direction" in label else ""
                assert said[symbol] == (kind or f"{label.lower()} of {axis}")


def errata(text: str) -> None:
    """Every erratum stands beside every equation and table that it concerns."""
    for erratum in ERRATA:
        numbers = {int(n) for n in re.findall(r"\((\d+)\)", erratum.where)}
        for first, last in re.findall(r"\((\d+)\)-\((\d+)\)", erratum.where):
            numbers |= set(range(int(first), int(last) + 1))
        link = f"[E{erratum.number}](../../docs/errata.md#e{erratum.number})"
        for number in numbers:
            if 12 <= number <= 43:
                assert link in heading_text(text, number).splitlines()[0], (number, link)
            elif number <= 11 or number >= 53:
                (said,) = re.findall(PLACES[number], text, re.DOTALL)
                assert link in said, (number, link)
        if tables := re.search(r"Tables? ([\d, ]+)", erratum.where):
            for table in re.findall(r"\d", tables[1]):
                if table in "1345":
                    heading = next(line for line in text.splitlines() if re.match(rf"### Tables? .*\b{table}\b", line))
                    assert link in heading, heading


_GENERAL = r"less that of the tool's \(7\)-\(10\)([^\n]*)"
PLACES = {
    1: r"motion error \(errata: ([^)]*\))",
    2: r"Eq\. \(2\)([^\n]*)",
    3: r"Eq\. \(3\)([^\n]*)",
    6: r"Eq\. \(6\)([^\n]*)",
    **dict.fromkeys((9, 10, 11), _GENERAL),
    **dict.fromkeys((53, 54, 55, 56), r"the iteration \(55\),\n([^\n]*)"),
}


def notation(text: str) -> None:
    """Every letter that a formula uses is in the table of symbols or of notation."""
    listed = "".join(row[0] for heading in ("## Symbols", "## Notation") for row in cells_of(text, heading)[1:])
    missing = {head for row in rows_of(text) for head in _heads(row.text)} - _heads(listed)
    # R, p, \delta, \varepsilon of an error factor and R_W are explained in their sentence, [SIL] .. in Sect. 3.1.
    assert missing <= {"R", "p", r"\delta", r"\varepsilon"}, missing


def _heads(text: str) -> set[str]:
    """Letters outside indices, arguments and commands; the letters in brackets of transforms."""
    commands = "mathrm|left|right|sin|cos|arccos|frac|sqrt|sum|pi|times|quad"
    plain = re.sub(rf"\\\\|\\(?:begin|end)\{{\w+\}}|\\(?:{commands})(?![a-zA-Z])", " ", text)
    plain = re.sub(r"\[S\w+\]", " ", plain)
    plain = re.sub(r"[_^](?:\{[^{}]*\}|\\?\w)", "", plain)
    plain = re.sub(r"(\\(?:delta|varepsilon))\([^)]*\)", r"\1", plain)
    return set(re.findall(r"\\[a-zA-Z]+|[a-zA-Z]", plain)) - {r"\Delta"}


STATEMENTS: dict[str, tuple[Callable[[str], None], tuple[tuple[str, str], ...]]] = {
    "angles": (
        angles,
        (
            ("measured from the Z axis", "measured from the Y axis"),
            ("measured from the Y axis", "measured from the X axis"),
        ),
    ),
    "views": (
        views,
        (
            ("less that of the view", "plus that of the view"),
            ("of the view `workpiece_in_bed` less", "of the view `tool_in_bed` less"),
            ("The negative of Eq. (11)", "Eq. (11)"),
            ("the columns XZ", "the columns YZ"),
        ),
    ),
    "assumptions": (assumptions, ((r"$\varepsilon_{xz}$ is assumed", r"$\varepsilon_{yz}$ is assumed"),)),
    "combinations": (
        combinations,
        (
            ("(slope of EYX) + eps_xy", "(slope of EYX) - eps_xy"),
            ("(slope of EYZ) - eps_yz", "(slope of EYZ) + eps_yz"),
            ("with -1 mm per mm in the slope of EXZ", "with +1 mm per mm in the slope of EXZ"),
            ("EYZ, EZZ, EAZ, EBZ: at every", "EYZ, EZZ, EAZ: at every"),
        ),
    ),
    "runs of points": (
        runs_of_points,
        (("TCS | X-1 |", "TCS | X-2 |"), ("| XZ-1x, XZ-1z |", "| XZ-2x, XZ-2z |"), ("| XY-2x |", "| XY-1x |")),
    ),
    "meanings": (
        meanings,
        (
            ("roll error of X", "pitch error of X"),
            ("yaw error of Z", "pitch error of Z"),
            ("straightness error of X in Y", "straightness error of X in Z"),
        ),
    ),
    "errata": (
        errata,
        (
            ("[E27](../../docs/errata.md#e27), ", ""),
            ("[E29](../../docs/errata.md#e29), [E30](../../docs/errata.md#e30)", "[E29](../../docs/errata.md#e29)"),
            (", [E41](../../docs/errata.md#e41)", ""),
            ("(errata: [E8](../../docs/errata.md#e8), ", "(errata: "),
        ),
    ),
    "notation": (notation, (("| $b_k$ |", "| - |"), ("| $M$ |", "| - |"))),
}


@pytest.mark.parametrize("name", STATEMENTS)
def test_the_statement_holds(name: str) -> None:
    STATEMENTS[name][0](page(PAGE))


@pytest.mark.parametrize(("name", "slip"), [(name, slip) for name, (_, slips) in STATEMENTS.items() for slip in slips])
def test_a_slip_in_the_statement_is_caught(name: str, slip: tuple[str, str]) -> None:
    holds, right, wrong = STATEMENTS[name][0], *slip
    assert right in page(PAGE)
    with pytest.raises(AssertionError):
        holds(page(PAGE).replace(right, wrong))


def test_runs_have_the_equations_of_their_sections() -> None:
    assert {run for run, *_ in PAPER_READINGS} == set(RUNS.values())
