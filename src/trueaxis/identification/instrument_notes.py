"""What a reader must know of sizes of instrument unknowns that come from the readings: how well a centre, a line or a
zero is taken to be known, from how few values, and what u would be by the size that is usual.
"""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from trueaxis.estimation.instrument_sizes import AsExpected
from trueaxis.estimation.instruments import CLASSES, own_kinds, states_line
from trueaxis.estimation.judgement import judged_component, judged_location
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.result import Estimate
from trueaxis.estimation.tool_point import ORIGIN, tool_point, volume
from trueaxis.identification.words import enumerated, small
from trueaxis.model.model import MachineModel

LARGER = 2.0  # times u: less is within what a reader makes of any statement of uncertainty
MOST_NAMED = 4  # errors whose u would be larger by most


def instrument_size_notes(model: MachineModel, observed: Observations, found: Estimate) -> Iterator[str]:
    """On the sizes of instrument unknowns on which u rests."""
    if found.ideal:
        return
    yield from _alignment(observed, found)
    if found.as_expected is not None:
        yield from _by_expected_sizes(model, observed, found, found.as_expected)


def _alignment(observed: Observations, found: Estimate) -> Iterator[str]:
    """How well lines of straightness are taken to be aligned: what is known of directions from home rests on it."""
    lines = [
        run.id
        for index, run in enumerate(observed.runs)
        if index in found.own and found.layout.straightness[index] and not states_line(run)
    ]
    if lines:
        size = CLASSES["straightness slope"].size * found.factors["straightness slope"]
        yield (
            f"{enumerated(lines)}: lines of straightness are taken as aligned to {size * 1e6:.2g} urad, which the "
            "readings make likely; squareness and directions from home rest on that. Lines that were turned until both "
            "ends read alike tell nothing of them: state line_u_urad = 1000 of their [device] in setup.toml"
        )


def _by_expected_sizes(
    model: MachineModel, observed: Observations, found: Estimate, expected: AsExpected
) -> Iterator[str]:
    """Where u would be far larger by the usual sizes."""
    usual = replace(found, spread=expected.spread, of_prior=0)
    pairs = [
        *(
            (name, judged_location(found, name).u, judged_location(usual, name).u, model.machine.parameter_unit(name))
            for name in found.layout.locations
        ),
        *(
            (name, judged_component(found, name).u, judged_component(usual, name).u, name.unit)
            for name in found.layout.components
        ),
    ]
    larger = sorted((one for one in pairs if one[2] > LARGER * one[1]), key=lambda one: -one[2] / one[1])
    tool = [float(np.sqrt(np.mean(tool_point(one, volume(model), [ORIGIN]).u ** 2))) for one in (found, usual)]
    if not larger and tool[1] <= LARGER * tool[0]:
        return
    counts = _counts(observed, found)
    sizes = [_size(kind, found, counts) for kind in expected.classes]
    named = [f"{name} {small(now, unit)} ({small(then, unit)})" for name, now, then, unit in larger[:MOST_NAMED]]
    rest = f" and {len(larger) - MOST_NAMED} more errors" if len(larger) > MOST_NAMED else ""
    yield (
        f"u rests on sizes of instrument unknowns that the readings make far smaller than usual: {'; '.join(sizes)}. A "
        "size that comes from few values is a guess. With the usual sizes, by which plan counts, u would be that in "
        f"brackets: tool point over the volume {small(tool[0], 'mm')} ({small(tool[1], 'mm')})"
        + "".join(f", {one}" for one in named)
        + rest
    )


def _counts(observed: Observations, found: Estimate) -> dict[str, int]:
    """How many unknowns of each class there are."""
    kinds = [one.kind for one in found.layout.shared]
    for index in found.own:
        kinds += own_kinds(observed.runs[index], found.layout.straightness[index])
    return {kind: kinds.count(kind) for kind in kinds}


def _size(kind: str, found: Estimate, counts: dict[str, int]) -> str:
    """`ballbar centre 0.083 um, from 3 values (usual 50 um)`."""
    unit, usual = CLASSES[kind].unit, CLASSES[kind].size
    values = f"{counts[kind]} value{'s' if counts[kind] > 1 else ''}"
    return f"{kind} {small(usual * found.factors[kind], unit)}, from {values} (usual {small(usual, unit)})"
