"""Whether a run with the sign turned is named, on random designs: python -m tests.worlds.reversed_runs 20 601"""

import sys
import tempfile
from dataclasses import replace
from pathlib import Path

import numpy as np

from tests.worlds.estimates import world
from tests.worlds.readings import measure
from tests.worlds.truth import draw_machine
from trueaxis.estimation.estimate import estimate
from trueaxis.model.errors import ErrorValues


def named(seed: int, folder: Path) -> tuple[str, list[str], list[str]]:
    """The laser or probe run that is turned, the runs that are named without that, and with it, surest first."""
    one = world(seed, folder)
    machine = seed + 7  # another one than that which the files of the world hold
    readings = measure(one.design, draw_machine(one.design.machine, machine), machine).reading
    known = ErrorValues(one.model.name, {name: one.model.errors.parameters[name] for name in one.model.dimensions})
    runs, of = one.plan.runs, one.plan.run
    turned = int(
        np.random.default_rng(seed).choice([k for k in np.unique(of).tolist() if runs[k].direction is not None])
    )
    said = []
    for sign in (1.0, -1.0):
        data = replace(one.plan, reading=np.where(of == turned, sign, 1.0) * readings)
        odds = estimate(one.model, data, known).readings.reversed
        said.append([runs[index].id for index in sorted(odds, key=lambda index: -odds[index])])
    return runs[turned].id, said[0], said[1]


def main(count: int, first: int) -> None:
    """One line per design, then the sum."""
    right = wrong = clean = 0
    for seed in range(first, first + count):
        with tempfile.TemporaryDirectory() as folder:
            turned, before, after = named(seed, Path(folder))
        print(
            f"{seed}: {turned} turned; named {', '.join(after) or 'none'}; as it was {', '.join(before) or 'none'}",
            flush=True,
        )
        right += after[:1] == [turned]
        wrong += bool(after) and after[0] != turned
        clean += not before
    print(f"of {count}: {right} named the run turned, {wrong} another; {clean} named none as they were")


if __name__ == "__main__":
    main(int(sys.argv[1]), int(sys.argv[2]))
