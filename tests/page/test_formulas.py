"""Every formula of the pages holds, worked out in numbers against chains that share nothing with the package."""

import re

import numpy as np
import pytest

from tests.machines import ROOT
from tests.page.chain_names import AXES
from tests.page.checking import problem
from tests.page.latex_value import NotMathsError, value_of
from tests.page.pages import derived, names, page, rows
from tests.page.rows import cells_of, rows_of
from tests.paper import chain as paper_chain
from tests.paper import reference
from tests.paper.entries import follows
from tests.paper.errata import ERRATA
from tests.paper.notation import DIRECTIONS, MOTION_ERRORS, SQUARENESS, delta, eps, place
from tests.paper.printed.tables import POINTS_LINKAGE, POINTS_SINGLE
from trueaxis.codegen.paper_layout import ERRATA as BESIDE

PAGES = ("dmu60p", "dmu60p_5axis")
SIX = ("EX", "EY", "EZ", "EA", "EB", "EC")
CHECKED_IN = tuple(sorted(folder.name for folder in (ROOT / "generated").iterdir()))


@pytest.mark.parametrize("name", CHECKED_IN)
def test_every_formula_holds(name: str) -> None:
    found = {f"{row.title}: {row.text}": problem(row.text, names(name).of(row)) for row in rows(name)}
    assert {text: why for text, why in found.items() if why} == {}


SLIPS = {
    "displacement of an error factor": (r"R \delta + p \times", r"R \delta - p \times"),
    "vector product turned": (r"R \delta + p \times R \varepsilon", r"R \delta + R \varepsilon \times p"),
    "deviation by Theta": (r"D + \Theta \times P", r"D - \Theta \times P"),
    "end of the offset curves": (r"\sum_{i=1}^{h} \varepsilon_{z}(x_i)", r"\sum_{i=1}^{n} \varepsilon_{z}(x_i)"),
    "end of the least squares": (r"\frac{n \sum_{i=1}^{n} v_i\,P", r"\frac{n \sum_{i=1}^{h} v_i\,P"),
    "sign where Y stands": (r"P_{k0} = -\Delta P", r"P_{k0} = \Delta P"),
    "points exchanged where Y moves": (r"$P_{lh} - P_{l0} = \Delta P$", r"$P_{kh} - P_{k0} = \Delta P$"),
    "frame of the worktable's points": ("r_l = q_w + r_W", "r_l = q_T + r_W"),
}


@pytest.mark.parametrize("slip", SLIPS)
def test_a_slip_within_a_sentence_or_a_limit_is_caught(slip: str) -> None:
    right, wrong = SLIPS[slip]
    assert right in page("dmu60p")
    changed = set(rows_of(page("dmu60p").replace(right, wrong))) - set(rows("dmu60p"))
    assert any(problem(row.text, names("dmu60p").of(row)) for row in changed)


def test_every_equation_of_sections_2_and_3_is_a_formula_of_the_page() -> None:
    """(2), (3) and so on by their sections; a number that only a heading bore would be no formula."""
    titled = {int(n) for row in rows("dmu60p") for n in re.findall(r"^Eq\. \((\d+)\)", row.title)}
    assert titled == set(range(12, 44))
    tagged = {int(n) for n in re.findall(r"(?:\\qquad|&) \((\d+)\)", page("dmu60p"))}
    assert tagged == {1, 4, 5, 7, 8, 9, 10, 11}
    texts = {row.text.split("=")[0].strip() for row in rows("dmu60p")}
    assert {"[SBW]", "[SBT]", "E"} <= texts  # (2), (3), (6)


def test_the_two_independent_chains_agree() -> None:
    """The numeric chain of the specs against the symbolic one of tests/paper, for the point that Eq. (9) carries."""
    own = names("dmu60p")
    values = {**{str(s): v for s, v in own._symbols("XZ").items()}}  # type: ignore[attr-defined]
    for d in DIRECTIONS:
        expression = reference.places("XZ", truncated=False)[place(d, "k", "h")]
        numbers = {s: values[str(s)] for s in expression.free_symbols}
        point = np.array([values[f"r_k{a}"] for a in AXES] + [1.0])
        calm = {n: 0.0 for n in own.chain.components if n[2] == "Y"} | {"q_Tx": 0.0, "q_Ty": 0.0, "q_Tz": 0.0}
        moved = own.chain.to_bed(9, {**own.values, **calm}, 1) @ point
        assert float(expression.xreplace(numbers)) == pytest.approx(moved[AXES.index(d)].real, rel=1e-12)
    assert (*MOTION_ERRORS, *SQUARENESS) == paper_chain.UNKNOWNS


def test_sensitivities_are_derivatives() -> None:
    own = names("dmu60p")
    header, *table = cells_of(page("dmu60p"), "The sensitivity of the tool point")
    assert header == ["error", "symbol", "$x$", "$y$", "$z$"]
    assert len(table) == 21
    for link, symbol, *entries in table:
        error = link.split("`")[1]
        only = {**own.values, **dict.fromkeys(own.chain.components + own.chain.located, 0.0), error: 1.0}
        _, slope = own.chain.seen(only, own.point)
        for text, expected in zip(entries, slope[:3, 0], strict=True):
            assert value_of(text.strip("$"), lambda name, _: own.base.get(name)) == pytest.approx(expected, abs=1e-12)
        assert own.base[re.sub(r"[{}$]", "", symbol)] == own.values[error]


@pytest.mark.parametrize("name", PAGES)
def test_symbols_name_what_they_are(name: str) -> None:
    own = names(name)
    _, *table = cells_of(page(name), "## Symbols")
    listed = {cells[1].split('"')[1]: cells for cells in table}
    for file_name in (*own.chain.components, *own.chain.located, *own.chain.dimensions):
        latex, _, unit, meaning = listed[file_name]
        assert own.base[re.sub(r"[{}$]", "", latex)] == own.values[file_name], latex
        if file_name in own.chain.components:
            assert unit == ("mm" if file_name[1] in "XYZ" else "rad")
            assert f" {file_name[2]}" in meaning


def test_table_1_is_that_of_the_words() -> None:
    _, *table = cells_of(page("dmu60p"), "### Table 1")
    right = {str(label).lower(): cells for (source, label), cells in follows().items() if source == "Table 1"}
    letters = {"delta": r"\delta", "epsilon": r"\varepsilon"}
    for name, *cells in table:
        (key,) = [
            k
            for k in right
            if name.lower().removeprefix("straightness error, ").replace(" axis", "") == k.replace(" axis", "")
        ]
        expected = [re.sub("delta|epsilon", lambda m: letters[m[0]], cell) for cell in right[key]]  # type: ignore[attr-defined]
        assert [re.sub(r"[{}$]", "", cell.split(" [")[0]) for cell in cells] == expected
        for cell in filter(None, cells):
            symbol, link = cell.split(" ", 1)
            assert names("dmu60p").base[re.sub(r"[{}$]", "", symbol)] == names("dmu60p").values[link.split("`")[1]]


def test_table_3_is_that_of_the_motions() -> None:
    header, *table = cells_of(page("dmu60p"), "### Table 3")
    right = follows()
    for head, *cells in table:
        key = re.sub(r"[{}$\s]", "", head).replace("S^l_", "S_") + "^l"
        columns = dict(zip(("X", "Y", "Z", "XY", "XZ", "YZ"), right["Table 3", key], strict=True))  # type: ignore[call-overload]
        for moving, cell in zip(header[1:], cells, strict=True):
            *coordinates, weight = columns[moving]
            assert cell == f"$({', '.join(map(str, coordinates))})$"
            assert weight == 1


def test_tables_4_and_5_have_the_printed_coordinates() -> None:
    _, *table = cells_of(page("dmu60p"), "### Tables 4 and 5")
    found = {re.sub(r"[{}$]|P", "", name): tuple(map(float, at.strip("()").split(", "))) for name, at, _, _ in table}
    printed = {f"_{label}": at for label, at in POINTS_SINGLE.items()}
    printed |= {f"^{run}_{label}": at for run, points in POINTS_LINKAGE.items() for label, at in points.items()}
    assert found == printed
    assert {name: frame for name, _, frame, _ in table} == {
        name: "TCS" if "{k" in name else "WCS" for name, *_ in table
    }


@pytest.mark.parametrize("name", PAGES)
def test_tables_of_bodies_are_those_of_the_spec(name: str) -> None:
    bodies = names(name).chain.bodies
    _, *table = cells_of(page(name), "## Topology")
    assert len(table) == len(bodies)
    for number, _, lower, moves, errors, located in table:
        body = bodies[int(number)]
        assert (int(lower), moves) == (body["lower"], body.get("moves", "-"))
        assert body.get("motion_errors", "all") == "all"
        assert re.findall(r"#(\w+)", errors) == [f"{d}{moves}" for d in SIX if moves != "-"]
        assert dict(re.findall(r"(\w\w) = \[`(\w+)`", located)) == body.get("position_errors", {})
    head, *orders = cells_of(page(name), "The lower-body array")
    below = {1: 0, 0: 0} | {number: body["lower"] for number, body in bodies.items()}
    expected = [int(cell.split()[1]) for cell in head[1:]]
    for _, *cells in orders:
        assert [int(cell) for cell in cells] == expected
        expected = [below[number] for number in expected]
    assert not any(map(int, orders[-1][1:]))


def test_squareness_of_the_axes_is_that_of_their_lines() -> None:
    _, *table = cells_of(page("dmu60p"), "## Squareness of the axes")
    slopes = reference.directions()
    at = {str(symbol): value for symbol, value in slopes.items()}
    lines = {
        "X": (1, at["c_yx1"], at["c_zx1"]),
        "Y": (at["c_xy1"], 1, at["c_zy1"]),
        "Z": (at["c_xz1"], at["c_yz1"], 1),
    }
    own = names("dmu60p")
    values = {s: own.values[str(s).replace("epsilon", "eps")] for s in SQUARENESS}
    for pair, product in table:
        both = sum(a * b for a, b in zip(lines[pair[0]], lines[pair[1]], strict=True))
        first = paper_chain.first_order(both.xreplace({s: paper_chain.SCALE * s for s in SQUARENESS}))
        found = value_of(product.strip("$"), lambda name, _: own.base.get(name))
        assert found == pytest.approx(float(first.xreplace(values)))


def test_errata_stand_beside_the_equations_that_they_concern() -> None:
    """The links of the page against the mends and the places of tests/paper's errata."""
    stated: dict[int | str, set[int]] = {}
    for erratum in ERRATA:
        for mend in erratum.mends:
            source = None if mend.source in (45, 47, "Sect. 2.1", "Sect. 5.1", "Table 7") else mend.source
            if source is not None:
                stated.setdefault(source, set()).add(erratum.number)
    for source, numbers in BESIDE.items():
        missing = stated.get(source, set()) - set(numbers)
        assert not missing, (source, missing)
        for number in set(numbers) - stated.get(source, set()):
            where = ERRATA[number - 1].where
            assert _names(where, source) or ERRATA[number - 1].shown_by, (source, number)
    assert stated.keys() <= BESIDE.keys()


def _names(where: str, source: int | str) -> bool:
    """Whether "Eqs. (9)-(11), Table 3" speaks of an equation or a table."""
    if isinstance(source, str):
        return source.removeprefix("Table ") in re.findall(r"\d+", where) or "Sect. 3.1" in where
    numbers = [int(n) for n in re.findall(r"\((\d+)\)", where)]
    ranges = [(int(a), int(b)) for a, b in re.findall(r"\((\d+)\)-\((\d+)\)", where)]
    return source in numbers or any(a <= source <= b for a, b in ranges)


def test_a_name_that_stands_for_nothing_is_an_error() -> None:
    with pytest.raises(NotMathsError, match="stands for nothing"):
        value_of(r"\delta_{x}(q)", lambda _, __: None)
    assert delta("x", "x") != eps("x", "x")


def test_the_runs_of_the_page_are_those_of_the_plan() -> None:
    _, *table = cells_of(page("dmu60p"), "### Tables 4 and 5")
    named = {run for row in table for run in row[3].split(", ")}
    assert named == {run.name for run in derived("dmu60p").runs}
    assert len({row[0] for row in table}) == len(table) == 17
