"""What the page says of the terms that first order drops, against draws made by the numeric chain."""

import itertools
import re
from functools import cache
from typing import Any

import numpy as np
import pytest

from tests.machines import ROOT
from tests.page.chain_names import column
from tests.page.pages import derived, names, page
from trueaxis.codegen.chain_section import DIMENSION

BATCHES = 20
SAID = re.compile(
    r"\((\d+) um and (\d+) urad of every motion, (\d+) urad and (\d+) um of location; .*, all home positions (\d+) mm, "
    r".*deviation to first order is (\S+) um \(rms\); what is dropped is (\S+) um \(rms\), (\S+) um at the largest of "
    r"(\d+) drawings"
)
CHECKED = ("dmu60p", "cframe_mill", "dmu60p_5axis", "trunnion_mill")


def said(text: str) -> list[float]:
    """Sizes of errors (um, urad, urad, um), home positions (mm), rms, dropped rms and largest (um), drawings."""
    found = SAID.search(" ".join(text.split()))
    assert found
    return [float(number) for number in found.groups()]


@cache
def lengths(name: str, *sizes: float) -> tuple[np.ndarray, np.ndarray]:
    """Deviation to first order and what it lacks, um: (positions, batches, drawings)."""
    moved, turned, place_turned, placed, home, *_, drawings = sizes
    chain, rng = names(name).chain, np.random.default_rng(17)
    travel = derived(name).machine.travel
    ends = [travel[axis] for axis in chain.axes]
    at = [*itertools.product(*ends), [sum(end) / 2 for end in ends]]
    size = {component: moved * 1e-3 if component[1] in "XYZ" else turned * 1e-6 for component in chain.components}
    for body in chain.bodies.values():
        for direction, error in body.get("position_errors", {}).items():
            size[error] = placed * 1e-3 if direction[1] in "XYZ" else place_turned * 1e-6
    values: dict[str, Any] = {error: size[error] * rng.choice((-1.0, 1.0), (BATCHES, int(drawings))) for error in size}
    values |= dict.fromkeys(chain.dimensions, home)
    first, dropped = [], []
    for position in at:
        pose = values | {axis.lower(): value for axis, value in zip(chain.axes, position, strict=True)}
        ideal, slope = chain.seen(pose, column(0, 0, 0, 1))
        work, tool = (chain.to_bed(chain.ends[end], pose, 1).real for end in ("workpiece", "tool"))
        exact = np.linalg.solve(work, tool @ column(0, 0, 0, 1))
        first.append(1e3 * np.linalg.norm(slope[..., :3, 0], axis=-1))
        dropped.append(1e3 * np.linalg.norm((exact - ideal - slope)[..., :3, 0], axis=-1))
    return np.array(first), np.array(dropped)


def holds(name: str, text: str) -> bool:
    """Root mean squares to 10 %, the largest of 64 drawings within what such batches give."""
    stated = said(text)
    first, dropped = lengths(name, *stated[:5], stated[8])
    largest = dropped.max(axis=(0, 2))
    rms = [float(np.sqrt(np.mean(each**2))) for each in (first, dropped)]
    within = 0.95 * largest.min() <= stated[7] <= 1.05 * largest.max()
    return stated[5:7] == pytest.approx(rms, rel=0.1) and bool(within)


@pytest.mark.parametrize("name", CHECKED)
def test_the_stated_sizes_are_those_of_independent_drawings(name: str) -> None:
    assert said(page(name))[4] == DIMENSION
    assert holds(name, page(name))


@pytest.mark.parametrize("place", [5, 6, 7])
def test_a_wrong_size_is_caught(place: int) -> None:
    stated = said(page("dmu60p"))[place]
    for wrong in (10 * stated, stated / 10, 2 * stated):
        assert not holds("dmu60p", page("dmu60p").replace(f"{stated:g} um", f"{wrong:g} um"))


def test_the_document_has_the_sizes_of_the_pages() -> None:
    text = " ".join((ROOT / "docs" / "derivation.md").read_text(encoding="utf-8").split())
    deviation, rms, largest = said(page("dmu60p"))[5:8]
    assert f"{rms:g} um (rms) beside {deviation:g} um on the paper's machine" in text
    assert f"{largest:g} um at the largest of 64 drawings" in text
    rotary = [said(page(name))[5:8] for name in ("dmu60p_5axis", "headhead_mill", "trunnion_mill")]
    low, high = min(sizes[1] for sizes in rotary), max(sizes[1] for sizes in rotary)
    assert (
        f"{low:g} to {high:g} um beside {min(s[0] for s in rotary) / 1e3:g} to {max(s[0] for s in rotary) / 1e3:g} mm"
        in text
    )
