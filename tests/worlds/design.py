"""A design: one machine, one measuring plan and one shop, drawn from a seed."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from tests.worlds.circles import draw_circle, draw_turn
from tests.worlds.ingredients import ingredients_of
from tests.worlds.jacobian import Jacobian, jacobian
from tests.worlds.layouts import draw_layout
from tests.worlds.lines import draw_diagonal, draw_line
from tests.worlds.machine import Machine
from tests.worlds.plan import Habits, Measurement, Plan
from tests.worlds.probing import draw_sphere
from tests.worlds.schedule import schedule
from tests.worlds.shop import Shop, draw_shop

Source = np.random.Generator

FEWEST, MOST = 300, 15000  # readings
MOST_IN_A_RUN = 900  # the noise of a run has a covariance matrix
THOROUGH, SAYS_SESSIONS = 0.4, 0.5  # share of the worlds
WITH_FOUR_AXES = 20_000  # first seed of worlds that may have four axes, too: earlier ones stay as they are in the docs
AXES: Mapping[int, float] = {3: 0.3, 4: 0.4, 5: 0.3}  # of such worlds: share
COLUMNS = ("time_s", "feed", "temperature_c", "directions")


@dataclass(frozen=True, eq=False)
class Design:
    """columns: which of COLUMNS the readings have; ingredients: name -> whether this design has it."""

    seed: int
    machine: Machine
    habits: Habits
    plan: Plan
    shop: Shop
    columns: tuple[str, ...]
    ingredients: Mapping[str, bool]

    @cached_property
    def jacobian(self) -> Jacobian:
        """The linear map from component errors and location errors to readings; computed once."""
        return jacobian(self.machine, self.plan)


def draw_design(seed: int, axes: int | None = None) -> Design:
    """axes: 3, 4 or 5, else drawn. The same seed gives the same design."""
    source = np.random.default_rng([seed, 1])
    if axes is None and seed >= WITH_FOUR_AXES:
        axes = int(source.choice(list(AXES), p=list(AXES.values())))
    machine = draw_layout(source, f"world_{seed}", axes)
    columns = tuple(column for column in COLUMNS if source.random() < 0.62)
    habits = _habits(source, machine, columns)
    what = int(source.integers(2**62))
    sessions = int(source.choice([1, 2, 3], p=[0.5, 0.3, 0.2]))
    for attempt in range(12):
        drawn = np.random.default_rng([what, attempt])
        measurements = _measurements(drawn, machine, habits)
        count = sum(len(track.time) for one in measurements for _, track in one.runs)
        if count * (1.0 + 0.5 * (sessions > 1)) > MOST:
            habits = replace(habits, samples=max(habits.samples * 3 // 4, 16), repeats=max(habits.repeats - 1, 1))
            habits = replace(habits, targets=max(habits.targets * 3 // 4, 5))
        elif count < FEWEST:
            habits = replace(habits, targets=habits.targets + 4, samples=habits.samples + 24)
        else:
            break
    plan = schedule(np.random.default_rng([seed, 2]), machine, measurements, sessions)
    shop = draw_shop(np.random.default_rng([seed, 3]), machine, plan)
    used = tuple(name for one in measurements for name in one.used)
    says = bool(np.random.default_rng([seed, 4]).random() < SAYS_SESSIONS)  # setup.toml names sessions and devices
    ingredients = ingredients_of(machine, habits, plan, shop, columns, used, says)
    return Design(seed, machine, habits, plan, shop, columns, ingredients)


def _habits(source: Source, machine: Machine, columns: tuple[str, ...]) -> Habits:
    directions = "directions" in columns
    orders = [order for order in ("passes", "cycles", "poses") if source.random() < 0.6] or ["passes"]
    orders = list(dict.fromkeys(["passes", *orders] if source.random() < 0.5 else orders))
    homes = [home for home in ("first", "zero", "anywhere") if source.random() < 0.5] or ["first"]
    repeats = int(source.integers(2, 6)) if source.random() < 0.72 else 1
    samples = int(np.exp(source.uniform(np.log(24.0), np.log(360.0))))
    feeds = (500.0, 1000.0, 2000.0, 4000.0)
    return Habits(
        orders=tuple(orders),
        spacing=str(source.choice(["equidistant", "jittered"])),
        targets=int(source.choice([5, 6, 8, 11, 16, 21, 31, 41, 51])),
        repeats=repeats,
        as_runs=bool(source.random() < 0.75),
        both=bool(source.random() < 0.65),
        samples=min(samples, MOST_IN_A_RUN // repeats),
        overtravel=float(source.uniform(0.5, 5.0)) if directions else 0.0,
        leave_out=not directions or bool(source.random() < 0.35),
        bracket=float(source.choice([0.0, 60.0, 150.0])),
        thorough=bool(source.random() < THOROUGH),
        homes=tuple(homes),
        feeds=tuple(sorted(float(f) for f in source.choice(feeds, int(source.integers(1, 3)), replace=False))),
    )


def _measurements(source: Source, machine: Machine, habits: Habits) -> list[Measurement]:
    laser, bars = (habits.thorough or source.random() < share for share in (0.85, 0.7))
    found: list[Measurement] = []
    if laser or not bars:
        found += _laser(source, machine, habits)
    if bars:
        found += _bars(source, machine, habits)
    if machine.rotary and source.random() < 0.8:
        for number in range(int(source.integers(1, 4))):
            frame = str(source.choice(["bed", "workpiece"]))
            found.append(draw_sphere(source, machine, habits, f"S{number + 1}", frame))
    if machine.rotary and source.random() < 0.8:
        for axis in machine.rotary:
            for number in range(int(source.integers(1, 4))):
                found.append(draw_turn(source, machine, habits, f"{axis}T{number + 1}", axis))
    return [one for one in found if one.runs]


def _laser(source: Source, machine: Machine, habits: Habits) -> list[Measurement]:
    found = []
    all_of = habits.thorough
    most = int(source.integers(3 if all_of else 1, 6))
    for axis in machine.linear:
        for number in range(int(source.integers(3 if all_of else 1, most + 1))):
            found.append(draw_line(source, machine, habits, f"{axis}{number + 1}", axis))
    if all_of or source.random() < 0.75:
        for axis in machine.linear:
            for across in machine.linear:
                for number in range(int(source.integers(int(all_of), 3)) if across != axis else 0):
                    found.append(draw_line(source, machine, habits, f"{axis}{across}s{number + 1}", axis, across))
    if source.random() < 0.5:
        for pair in ("XY", "YZ", "XZ"):
            for number in range(int(source.integers(0, 3))):
                found.append(draw_diagonal(source, machine, habits, f"D{pair}{number + 1}", pair))
    if source.random() < 0.5:
        for number in range(int(source.integers(1, 5))):
            found.append(draw_diagonal(source, machine, habits, f"D{number + 1}", "XYZ"))
    return found


def _bars(source: Source, machine: Machine, habits: Habits) -> list[Measurement]:
    found = []
    arcs = source.random() < 0.55
    planes = [plane for plane in ("XY", "YZ", "ZX") if habits.thorough or source.random() < 0.7] or ["XY"]
    centres = int(source.integers(1, 4))
    for plane in planes:
        for number in range(centres):
            arc = arcs and source.random() < 0.5
            found.append(draw_circle(source, machine, habits, f"{plane}{number + 1}", plane, arc))
    return found
