"""The figures of docs/errata.md: `python -m tests.paper.claims` prints every table of that page."""

from __future__ import annotations

from collections.abc import Iterable
from decimal import Decimal

import numpy as np

from . import claims_systems as systems
from .claims_squareness import cases
from .errata import ERRATA
from .notation import Definition
from .numeric import counterexample
from .printed import EQUATIONS
from .printed.tables import IMPROVEMENTS, POINTS_SINGLE


def table(header: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    """A Markdown table."""
    head = list(header)
    lines = [head, ["---"] * len(head), *(list(row) for row in rows)]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def overview() -> str:
    """Every erratum in one line."""
    rows = ((f"[E{e.number}](#e{e.number})", e.where, e.kind.value, e.line) for e in ERRATA)
    return table(("No.", "Where", "Kind", "What is right"), rows)


def counterexamples() -> str:
    """What each printed formula misses, all other errata mended, beside what remains when all are."""
    rows = []
    for erratum in ERRATA:
        found = counterexample(erratum, ERRATA)
        if found is None:
            continue
        scale, unit = {"mm": (1e3, " µm"), "rad": (1e6, " µrad"), "1": (1.0, "")}[found.unit]
        printed = "undefined symbol" if found.printed is None else f"{found.printed * scale:.4g}{unit}"
        rows.append((f"E{erratum.number}", found.place, printed, f"{found.mended * scale:.1g}{unit}"))
    return table(("No.", "Equation, part", "As printed", "Mended"), rows)


def agreeing() -> list[int]:
    """Numbers of the equations that are compared and that no erratum touches."""
    touched = {mend.source for erratum in ERRATA for mend in erratum.mends}
    return [int(i.number) for i in EQUATIONS if i.number not in touched and i.number not in definitions()]


def definitions() -> list[int]:
    """Numbers of the equations that only define their left-hand side: there is nothing to compare."""
    return [int(item.number) for item in EQUATIONS if all(isinstance(part, Definition) for part in item.parts)]


def ranks() -> str:
    """Rank and condition of every system at the published points."""
    rows = []
    for (equation, run, readings, unknowns), matrix in zip(systems.SYSTEMS, systems.system_matrices(), strict=True):
        rank = int(np.linalg.matrix_rank(matrix))
        raw, scaled = systems.condition(matrix), systems.condition(systems.scaled(matrix))
        numbers = (f"{c:.4g}" if np.isfinite(c) else "singular" for c in (raw, scaled))
        names = ", ".join(unknowns)
        rows.append((equation, run, f"{len(readings)} by {len(unknowns)}", str(rank), *numbers, f"`{names}`"))
    return table(("Equation", "Run", "Size", "Rank", "Condition", "Columns scaled", "Unknowns"), rows)


def determined() -> str:
    """Rank of all 18 readings together, with squareness known and unknown, at one position and at several."""
    rows = []
    for points, single in (("Table 4", None), ("P_k9 mended", systems.with_mended_z_point())):
        for count in (1, 5):
            whole = systems.stacked(count, POINTS_SINGLE if single is None else single)
            for known, matrix in (("known", whole[:, :-3]), ("unknown", whole)):
                free = systems.null_space(matrix).shape[1]
                size = matrix.shape[1]
                rows.append((points, str(count), known, *(str(n) for n in (matrix.shape[0], size, size - free, free))))
    return table(("Points", "Positions", "Squareness", "Readings", "Unknowns", "Rank", "Undetermined"), rows)


def noise() -> str:
    """Standard deviation of each error for 1 µm in every reading."""
    rows = []
    free = systems.undetermined()
    for item in systems.amplification(systems.with_mended_z_point()):
        unit = "µrad" if item.name.startswith("epsilon") else "µm"
        rows.append(
            (
                f"`{item.name}`",
                "no" if item.name in free else "yes",
                f"{item.standard:.1f} {unit}",
                f"{100 * item.from_earlier:.0f} %",
            )
        )
    header = ("Error", "Determined as printed", "Deviation per 1 µm", "Variance handed down by earlier runs")
    return table(header, rows)


def squareness() -> str:
    """What Sect. 3.6 finds on known machines."""
    rows = ((c.machine, f"`{c.parameter}`", f"{c.truth:.1f}", _signed(c.found)) for c in cases())
    return table(("Machine", "Parameter", "True, µrad", "Sect. 3.6 as printed, µrad"), rows)


def _signed(value: float) -> str:
    """One decimal, with sign unless it rounds to zero."""
    return "0.0" if abs(value) < 0.05 else f"{value:+.1f}"


def interval(before: str, after: str) -> tuple[Decimal, Decimal]:
    """Per cent of reduction that the two printed numbers allow, their last digit being rounded."""
    (b, db), (a, da) = (
        (Decimal(n), Decimal(1).scaleb(int(Decimal(n).as_tuple().exponent)) / 2) for n in (before, after)
    )
    return 100 * (1 - (a + da) / (b - db)), 100 * (1 - (a - da) / (b + db))


def improvements() -> str:
    """The printed percentages and what the printed numbers give."""
    rows = []
    for name, (before, after, printed) in IMPROVEMENTS.items():
        low, high = interval(before, after)
        value = 100 * (1 - Decimal(after) / Decimal(before))
        rows.append((name, before, after, f"{printed} %", f"{value:.2f} %", f"{low:.1f} to {high:.1f} %"))
    return table(("Quantity", "Ordinary", "Iterative", "Printed", "Follows", "Range by rounding"), rows)


TABLES = {
    "Overview": overview,
    "Counterexamples": counterexamples,
    "Rank and condition": ranks,
    "Determined": determined,
    "Noise": noise,
    "Squareness": squareness,
    "Percentages": improvements,
}


def main() -> None:
    """Print all tables."""
    for title, make in TABLES.items():
        print(f"## {title}\n\n{make()}\n")
    print("Equations without an entry:", ", ".join(f"({n})" for n in agreeing()))
    print("Definitions:", ", ".join(f"({n})" for n in definitions()))


if __name__ == "__main__":
    main()
