"""Which ingredients a design has, as data, so that figures can be put into tables per ingredient."""

from collections.abc import Mapping, Sequence

import numpy as np

from tests.worlds.machine import Machine
from tests.worlds.plan import Habits, Plan
from tests.worlds.shop import Shop

UNEQUAL = 4.0  # longest over shortest travel


def ingredients_of(
    machine: Machine,
    habits: Habits,
    plan: Plan,
    shop: Shop,
    columns: Sequence[str],
    used: Sequence[str],
    says_sessions: bool,
) -> Mapping[str, bool]:
    """Name -> present; `used`: what the measurements say of themselves."""
    told = _of_columns(columns) | {"says_sessions": says_sessions}
    return _of_machine(machine) | _of_plan(machine, habits, plan, used) | told | _of_shop(plan, shop)


def _of_machine(machine: Machine) -> dict[str, bool]:
    travels = [machine.travel(axis) for axis in machine.linear]
    lengths = [high - low for low, high in travels]
    carried = [axis for axis in machine.linear if machine.carries("workpiece", axis)]
    offsets = [body for body in machine.bodies if any(body.offset)]
    return {
        "three_axes": not machine.rotary,
        "four_axes": len(machine.rotary) == 1,
        "five_axes": len(machine.rotary) == 2,
        "workpiece_axes": bool(carried),
        "tool_axes": len(carried) < 3,
        "reversed_sense": any(body.sense < 0 for body in machine.bodies),
        "travel_without_zero": any(low > 0 or high < 0 for low, high in travels),
        "travel_across_zero": any(low < 0 < high for low, high in travels),
        "negative_travel": any(high <= 0 for _, high in travels),
        "unequal_travels": max(lengths) > UNEQUAL * min(lengths),
        "named_offsets": any(body.names for body in offsets),
        "numeric_offsets": any(not body.names for body in offsets),
        "fixed_bodies": sum(not body.moves for body in machine.bodies) > 2,
        "fewer_components": len(machine.components) < 6 * len(machine.axes),
        "true_rotations": machine.true_rotations,
        "small_angle_rotations": not machine.true_rotations,
    }


def _of_plan(machine: Machine, habits: Habits, plan: Plan, used: Sequence[str]) -> dict[str, bool]:
    runs = plan.runs
    lines = {run.line for run in runs if run.instrument == "laser" and not run.across}
    per_axis = [sum(line.startswith(axis) for line in lines) for axis in machine.linear]
    bars = [run for run in runs if run.plane]
    ends = {(run.target[0], run.reference[0], run.frame) for run in runs if run.instrument == "laser"}
    repeated = habits.repeats > 1
    return {
        "thorough": habits.thorough,
        "laser": bool(lines),
        "ball_bar": any(run.instrument == "ballbar" for run in runs),
        "probe": "probe" in used,
        "rotary_turn": "rotary_turn" in used,
        "one_line_an_axis": bool(lines) and min(per_axis) == 1,
        "three_lines_an_axis": max(per_axis) >= 3,
        **{name: name in used for name in ("straightness", "diagonal_2", "diagonal_3", "circle", "arc", "long_bar")},
        "several_centres": len({run.line for run in bars}) > len({run.plane for run in bars}),
        "several_feeds": any(run.plane for run in runs) and len(habits.feeds) > 1,
        "equidistant": habits.spacing == "equidistant",
        "jittered": habits.spacing == "jittered",
        "few_targets": habits.targets <= 8,
        "many_targets": habits.targets >= 21,
        "one_way": not habits.both,
        "both_ways": habits.both,
        "single_readings": not repeated,
        "repeats": repeated,
        "repeats_2_3": habits.repeats in (2, 3),
        "repeats_4_5": habits.repeats in (4, 5),
        **{name: name in used for name in ("order_passes", "order_cycles", "order_poses", "repeats_as_runs")},
        **{name: name in used for name in ("home_first", "home_zero", "home_anywhere")},
        "several_tool_points": len({run.target[1] for run in runs if run.target[0] == "tool"}) > 1,
        "target_on_workpiece": any(on == "workpiece" for on, _, _ in ends),
        "frame_of_workpiece": any(run.frame == "workpiece" for run in runs if run.length is None),
        "reversals_kept": bool(bars) and not habits.leave_out,
        "sessions": len({run.session for run in runs}) > 1,
        "remounted": len({run.line for run in runs}) < len({run.mount for run in runs}),
        "many_readings": plan.count > 3000,
        "few_readings": plan.count < 2500,
    }


def _of_columns(columns: Sequence[str]) -> dict[str, bool]:
    names = {"time_s": "no_time", "feed": "no_feed", "temperature_c": "no_temperature", "directions": "no_directions"}
    return {missing: column not in columns for column, missing in names.items()}


def _of_shop(plan: Plan, shop: Shop) -> dict[str, bool]:
    kinds = {unknown.kind.split("_")[0] for unknown in shop.unknowns}
    names = {
        "zeros": "zero",
        "line_slopes": "slope",
        "creep": "creep",
        "drift": "drift",
        "ball_centres": "centre",
        "bar_length": "length",
        "warm_bar": "warm",
        "laser_scale": "scale",
        "cosine": "cosine",
    }
    of_instrument = [np.unique(shop.white[plan.rows(k)[:1]]) for k in range(len(plan.runs))]
    levels = {(run.instrument, float(level[0])) for run, level in zip(plan.runs, of_instrument, strict=True)}
    return {
        "uneven_noise": len(levels) > len({run.instrument for run in plan.runs}),
        "slow_noise": bool(shop.slow_mm.any()),
        "random_walk": bool(shop.walk_mm.any()),
        "display_steps": bool(shop.resolution.any()),
        "coarse_display": bool((shop.resolution > 2.2 * shop.white).any()),
        "outliers": len(shop.outliers) > 0,
        "outliers_in_twos": bool((np.diff(shop.outliers) == 1).any()),
        **{name: kind in kinds for name, kind in names.items()},
    }
