"""The campaign as tables of Markdown: by design, by ingredient, by what [prior] says."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from tests.worlds.design import Design, draw_design

Line = Mapping[str, Any]
NEAR = 2.0  # factor within which a size counts as estimated
# heading -> figure of a machine: fits of what knows more than the estimate can
YARDSTICKS = {
    "one family": "one_family",
    "class sizes": "class_sizes",
    "set-ups expected": "set_ups_expected",
    "oracle": "oracle",
}
BESIDE = ("one family", "class sizes", "set-ups expected")  # in every table
RATIOS = tuple(f"estimate/{name}" for name in BESIDE)
SIZED = ("true", "error", "u", *YARDSTICKS.values())  # figures of a machine that are lengths, um
OFF = (1.0, 2.0, 3.0, 5.0, 20.0, np.inf)  # factors by which [prior] is off


@dataclass(frozen=True, kw_only=True)
class Figures:
    """Of some machines: root mean squares of a coordinate, um; share of the mean square that is left of doing nothing;
    ratios: yardstick -> error over its error, and the standard uncertainty of that; coverage of smooth curves and of
    draws of a prior, and the standard uncertainty of that of all; share of machines worse than doing nothing, and the
    worst one's factor.
    """

    machines: int
    true: float
    error: float
    oracle: float
    one_family: float
    left: float
    ratios: Mapping[str, tuple[float, float]]
    u: float
    smooth: float
    prior: float
    u_coverage: float
    oracle_coverage: float
    worse: float
    worst: float


def figures(lines: Sequence[Line]) -> Figures:
    """All machines count the same."""
    lengths = {name: np.array([line[name] for line in lines]) for name in SIZED}
    true, error = lengths["true"], lengths["error"]
    coverage = np.array([line["coverage"] for line in lines])
    smooth = np.array([line["curves"] == "smooth" for line in lines])
    return Figures(
        machines=len(lines),
        true=rms(true),
        error=rms(error),
        oracle=rms(lengths["oracle"]),
        one_family=rms(lengths["one_family"]),
        left=float(np.mean(error**2) / np.mean(true**2)),
        ratios={name: _ratio(error, lengths[figure]) for name, figure in YARDSTICKS.items()},
        u=rms(lengths["u"]),
        smooth=_mean(coverage[smooth]),
        prior=_mean(coverage[~smooth]),
        u_coverage=_u_of_mean(coverage),
        oracle_coverage=_mean(np.array([line["oracle_coverage"] for line in lines])),
        worse=float(np.mean(error > true)),
        worst=float(np.max(error / true)),
    )


def _ratio(error: np.ndarray, other: np.ndarray) -> tuple[float, float]:
    """Of two root mean squares over machines, and its standard uncertainty."""
    ratio = rms(error) / rms(other)
    of_logarithm = error**2 / np.mean(error**2) - other**2 / np.mean(other**2)
    return ratio, 0.5 * ratio * _u_of_mean(of_logarithm)


def rms(values: np.ndarray) -> float:
    return float(np.sqrt(np.mean(values**2)))


def _mean(values: np.ndarray) -> float:
    return float(np.mean(values)) if values.size else float("nan")


def _u_of_mean(values: np.ndarray) -> float:
    return float(np.std(values, ddof=1) / np.sqrt(values.size)) if values.size > 1 else float("nan")


def tables(lines: Sequence[Line]) -> Iterator[str]:
    """Lines of Markdown."""
    seeds = sorted({line["design"] for line in lines})
    designs = {seed: draw_design(seed) for seed in seeds}
    of_design = {seed: [line for line in lines if line["design"] == seed] for seed in seeds}
    each = {seed: figures(own) for seed, own in of_design.items()}
    yield from _summary(lines, each.values())
    yield ""
    yield from _by_design(designs, each)
    yield ""
    yield from _by_ingredient(designs, of_design)
    yield ""
    yield from _by_given(lines)
    yield ""
    yield from _sizes(lines)


def _summary(lines: Sequence[Line], each: Iterable[Figures]) -> Iterator[str]:
    designs = list(each)
    coverage = [line["coverage"] for line in lines]
    of_draws = [line["coverage"] for line in lines if line["curves"] == "prior"]
    others = [line["coverage"] for line in lines if line["curves"] == "smooth"]
    together = figures(lines)
    yield f"- {len(designs)} designs, {len(lines)} machines, {np.mean([line['seconds'] for line in lines]):.1f} s each"
    yield f"- mean square left of doing nothing, median of the designs: {np.median([one.left for one in designs]):.3f}"
    for name in YARDSTICKS:
        ratios = [one.ratios[name][0] for one in designs]
        yield (
            f"- estimate/{name} of the designs: median {np.median(ratios):.2f}, {min(ratios):.2f} to "
            f"{max(ratios):.2f}; {sum(ratio <= 1.15 for ratio in ratios)} of {len(ratios)} at most 1.15"
        )
    yield (
        f"- coverage: {np.mean(coverage):.3f} ± {together.u_coverage:.3f}; of draws of a prior "
        f"{_mean(np.array(of_draws)):.3f}, "
        f"of curves that are none {_mean(np.array(others)):.3f}; oracle {together.oracle_coverage:.3f}"
    )
    yield f"- worse than doing nothing: {together.worse:.1%} of the machines, at worst by {together.worst:.2f} times"
    yield f"- not converged: {np.mean([not line['converged'] for line in lines]):.1%}"


def _by_design(designs: Mapping[int, Design], each: Mapping[int, Figures]) -> Iterator[str]:
    yield from head(
        "seed", "axes", "readings", "runs", "machines", "doing nothing, um", "estimate", "one family", "oracle",
        *RATIOS, "u", "coverage: smooth", "draws of a prior",
        "worse than nothing; most",
    )  # fmt: skip
    for seed, one in each.items():
        plan, axes = designs[seed].plan, len(designs[seed].machine.axes)
        yield row(
            seed, axes, plan.count, len(plan.runs), one.machines, f"{one.true:.1f}", f"{one.error:.2f}",
            f"{one.one_family:.2f}", f"{one.oracle:.2f}", *_beside(one), f"{one.u:.2f}",
            f"{one.smooth:.3f}", f"{one.prior:.3f}", f"{one.worse:.0%}, {one.worst:.2f}",
        )  # fmt: skip


def _by_ingredient(designs: Mapping[int, Design], of_design: Mapping[int, Sequence[Line]]) -> Iterator[str]:
    """Machines count relative to the true deviation of their design: no large machine outweighs the others."""
    yield from head(
        "ingredient", "share of designs", "mean square left", *RATIOS,
        "coverage: smooth", "draws of a prior", "worse than nothing",
    )  # fmt: skip
    names = next(iter(designs.values())).ingredients
    scale = {seed: rms(np.array([line["true"] for line in own])) for seed, own in of_design.items()}
    for name in names:
        chosen = [seed for seed, design in designs.items() if design.ingredients[name]]
        if not chosen:
            yield row(name, "0 %", *[""] * (len(RATIOS) + 4))
            continue
        own = [_relative(line, scale[seed]) for seed in chosen for line in of_design[seed]]
        one = figures(own)
        yield row(
            name, f"{len(chosen) / len(designs):.0%}", f"{one.left:.3f}", *_beside(one),
            f"{one.smooth:.3f}", f"{one.prior:.3f}", f"{one.worse:.1%}",
        )  # fmt: skip


def _beside(one: Figures) -> Iterator[str]:
    """Cells of RATIOS."""
    for ratio, u in (one.ratios[name] for name in BESIDE):
        yield f"{ratio:.2f} ± {u:.2f}"


def _relative(line: Line, scale: float) -> Line:
    return {**line, **{name: line[name] / scale for name in SIZED}}


def _by_given(lines: Sequence[Line]) -> Iterator[str]:
    yield from head(
        "[prior]", "machines", "mean square left", *RATIOS,
        "coverage: smooth", "draws of a prior", "worse than nothing; most",
    )  # fmt: skip
    for given in dict.fromkeys(line["given"] for line in lines):
        one = figures([line for line in lines if line["given"] == given])
        yield row(
            given, one.machines, f"{one.left:.3f}", *_beside(one), f"{one.smooth:.3f}",
            f"{one.prior:.3f}", f"{one.worse:.1%}, {one.worst:.2f}",
        )  # fmt: skip


def _sizes(lines: Sequence[Line]) -> Iterator[str]:
    """By class and by how far [prior] is off: how far the estimated size is, and how often [prior] is said to be."""
    yield from head(
        "sizes of", "[prior] off by", "machines", f"estimated within {NEAR:g}", "estimated/true: 16 %, median, 84 %",
        "said to be off",
    )  # fmt: skip
    for kind in dict.fromkeys(kind for line in lines for kind in line["sizes"]):
        every = np.array([line["sizes"][kind] for line in lines if kind in line["sizes"]])
        told = np.array([kind in line["said"] for line in lines if kind in line["sizes"]])
        off = np.exp(np.abs(np.log(every[:, 0] / every[:, 1])))
        for low, high in pairwise(OFF):
            among = (off >= low) & (off < high)
            _, true, estimated = every[among].T
            if not true.size:
                continue
            spread = ", ".join(f"{value:.2f}" for value in np.quantile(estimated / true, [0.16, 0.5, 0.84]))
            near = np.mean(np.abs(np.log(estimated / true)) < np.log(NEAR))
            beyond = f"{low:g} to {high:g}" if np.isfinite(high) else f"more than {low:g}"
            yield row(kind, beyond, true.size, f"{near:.0%}", spread, f"{told[among].mean():.0%}")


def head(*names: str) -> Iterator[str]:
    yield row(*names)
    yield row(*["---"] * len(names))


def row(*cells: object) -> str:
    return f"| {' | '.join(map(str, cells))} |"
