"""The formulas of docs/derivation.md, by the chains of the two machines that it takes as examples."""

import re
from functools import cache

import numpy as np

from tests.machines import ROOT
from tests.page.chain_names import Names, _error_factor
from tests.page.checking import problem
from tests.page.numeric_chain import Matrix
from tests.page.pages import names
from tests.page.rows import Row, rows_of
from tests.page.test_mutants import survivors
from tests.paper.claims_systems import null_space, stacked
from tests.paper.printed.tables import POINTS_SINGLE

TEXT = (ROOT / "docs" / "derivation.md").read_text(encoding="utf-8")


def small(displacement: Matrix, about: Matrix) -> Matrix:
    """N of a small displacement and a small rotation: the vector product, column by column."""
    result = np.zeros((4, 4))
    result[:3, :3], result[:3, 3] = np.cross(about, np.eye(3)).T, displacement
    return result


@cache
def general() -> Names:
    """Any pose, any error: nothing of a machine."""
    rng = np.random.default_rng(21)
    own = names("dmu60p")
    factor = _error_factor()
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = factor["R"], factor["p"]
    earlier = small(*rng.uniform(-1, 1, (2, 3)))
    joint: Names = {f"[SIJ]_{part}": own.factors[f"[SIJ]_{part}"] for part in ("p", "pe", "s", "se")}
    joint["[SIJ]"] = joint["[SIJ]_p"] @ joint["[SIJ]_pe"] @ joint["[SIJ]_s"] @ joint["[SIJ]_se"]
    components = {
        f"{letter}_{a}": factor[letter][n] for letter in (r"\delta", r"\varepsilon") for n, a in enumerate("xyz")
    }
    return (
        own.tool_point
        | factor
        | joint
        | components
        | {
            "N": small,
            "N_k": earlier,
            "[SBk]_0": pose,
            "[SBk]": (np.eye(4) + earlier) @ pose,
        }
    )


@cache
def turning() -> Names:
    """The five-axis machine: d of its tool point, and the rotation behind its B head."""
    own = names("dmu60p_5axis")
    (head,) = (number for number, body in own.chain.bodies.items() if body.get("moves") == "B")
    return own.base | own.tool_point | {"R": own.chain.pair(head, own.values)[0][:3, :3]}


def paper() -> Names:
    own = names("dmu60p")
    return own.base | own.tool_point | {"p": own.steps["[SB6]_0"][:3, 3]}


def formulas(text: str = TEXT) -> list[tuple[str, Names]]:
    found: list[tuple[str, Names]] = []
    for row in rows_of(re.sub(r"\$`(.*?)`\$", r"$\1$", text)):
        found.append((row.text.rstrip(" ."), _names(row)))
    return found


def _names(row: Row) -> Names:
    if "(b)" in row.text or "R_W" in row.text:
        return turning()
    return paper() if re.search(r"\([xz]\)|p = \(|q_", row.text) else general()


def test_every_equality_of_the_text_holds() -> None:
    found = {text: problem(text, known) for text, known in formulas()}
    assert len(found) == 13
    assert {text: why for text, why in found.items() if why} == {}


def test_no_slip_in_the_text_survives() -> None:
    alive, counts = survivors(formulas())
    assert alive == []
    assert counts.total() > 120


def test_numbers_of_errors_are_those_of_the_machines() -> None:
    count = {name: len(names(name).chain.components + names(name).chain.located) for name in ROTARY}
    assert count == {"dmu60p_5axis": 41, "trunnion_mill": 41, "headhead_mill": 44}
    assert "holds 41 errors (`dmu60p_5axis`, `trunnion_mill`) or 44 (`headhead_mill`)" in " ".join(TEXT.split())


def test_what_no_reading_determines_is_counted() -> None:
    """At n positions 3 + n vectors, by the numeric null space of the readings of tests/paper."""
    assert "At $n$ positions of the paper's runs $3 + n$ vectors remain" in " ".join(TEXT.split())
    for count in (1, 2, 5):
        assert null_space(stacked(count, POINTS_SINGLE)).shape[1] == 3 + count


ROTARY = ("dmu60p_5axis", "trunnion_mill", "headhead_mill")
