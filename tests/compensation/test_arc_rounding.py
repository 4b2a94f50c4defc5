"""Arcs whose words are rounded: all of them pass, and none that is wrong by ten units."""

import math
import random

import numpy as np
import pytest

from tests.compensation.control import Bench, execute
from trueaxis.io.faults import InputError

KINDS = [("G21", 1.0, 2), ("G21", 1.0, 3), ("G21", 1.0, 4), ("G20", 25.4, 3), ("G20", 25.4, 4), ("G20", 25.4, 5)]


def arc(
    draw: random.Random, unit: float, decimals: int, wrong: float, strip: bool
) -> tuple[str, tuple[float, ...], str]:
    """Two blocks of a random arc (start, arc), its centre and radius, and whether it is by R or by the centre.

    wrong: in units of the last decimal, added to the radius at the end.
    """
    radius = math.exp(draw.uniform(math.log(2.0), math.log(300.0))) / unit
    x, y = draw.uniform(-300, 300) / unit, draw.uniform(-300, 300) / unit
    a = draw.uniform(0, 2 * math.pi)
    b = a + draw.uniform(0.2, 2 * math.pi - 0.2)
    last = radius + wrong * 10.0**-decimals

    def number(value: float) -> str:
        text = f"{value:.{decimals}f}"
        return text.rstrip("0") if strip else text

    start = f"X{number(x + radius * math.cos(a))} Y{number(y + radius * math.sin(a))}"
    end = f"X{number(x + last * math.cos(b))} Y{number(y + last * math.sin(b))}"
    centre = f"I{number(-radius * math.cos(a))} J{number(-radius * math.sin(a))}"
    return f"G0 {start}\nG3 {end} {centre} F9\n", (x * unit, y * unit, radius * unit), centre


@pytest.mark.parametrize("strip", [False, True])
@pytest.mark.parametrize(("code", "unit", "decimals"), KINDS)
def test_arcs_rounded_in_their_words_pass(bench: Bench, code: str, unit: float, decimals: int, strip: bool) -> None:
    draw = random.Random(f"{code}{decimals}{strip}")
    arcs = [arc(draw, unit, decimals, 0.0, strip) for _ in range(120)]
    text = bench.run(f"{code} G90 G17\nG0 X0. Y0. Z0.\n" + "".join(one[0] for one in arcs), chord_tolerance=0.05)
    at = execute(text)
    # followed within the rounding: every point of an arc is near its true circle
    rounding = 4.0 * unit * 10.0**-decimals
    moves = [line for line in text.decode().splitlines() if "X" in line or "Y" in line]
    starts = [n for n, line in enumerate(moves) if line.startswith("G0")]
    for (x, y, radius), first, end in zip(
        (one[1] for one in arcs), starts[1:], [*starts[2:], at.shape[1]], strict=True
    ):
        off = np.abs(np.hypot(at[0, first:end] - x, at[1, first:end] - y) - radius)
        assert off.max() <= rounding + 0.0011


@pytest.mark.parametrize(("code", "unit", "decimals"), KINDS)
def test_arcs_wrong_by_ten_units_are_refused(bench: Bench, code: str, unit: float, decimals: int) -> None:
    draw = random.Random(f"{code}{decimals}")
    arcs = [arc(draw, unit, decimals, draw.choice([-10.0, 10.0]), False) for _ in range(40)]
    with pytest.raises(InputError) as error:
        bench.run(f"{code} G90 G17\nG0 X0. Y0. Z0.\n" + "".join(one[0] for one in arcs), chord_tolerance=0.05)
    assert [fault.place for fault in error.value.faults] == [f"line {2 * n + 4}" for n in range(40)]
    assert all(
        "lie at different radii" in fault.problem and "explains" in fault.problem for fault in error.value.faults
    )


@pytest.mark.parametrize(("code", "unit", "decimals"), KINDS)
def test_half_turns_by_radius(bench: Bench, code: str, unit: float, decimals: int) -> None:
    """Rounding makes half the chord longer than R every other time."""
    draw = random.Random(decimals)
    right, wrong = [], []
    for _ in range(60):
        radius, a = draw.uniform(2, 300) / unit, draw.uniform(0, 7)
        x, y = radius * math.cos(a), radius * math.sin(a)
        head = f"G0 X{x:.{decimals}f} Y{y:.{decimals}f}\nG3 X{-x:.{decimals}f} Y{-y:.{decimals}f}"
        right.append(f"{head} R{radius:.{decimals}f} F9\n")
        wrong.append(f"{head} R{radius - 10 * 10.0**-decimals:.{decimals}f} F9\n")
    start = f"{code} G90 G17\nG0 X0. Y0. Z0.\n"
    bench.run(start + "".join(right), chord_tolerance=0.05)
    with pytest.raises(InputError) as error:
        bench.run(start + "".join(wrong), chord_tolerance=0.05)
    # beyond 2 R a chord has no arc; wrong by ten units it is beyond everywhere
    assert len(error.value.faults) == min(60, 50)


def test_increments(bench: Bench) -> None:
    draw = random.Random(1)
    text = "G21 G90 G17\nG0 X0. Y0. Z0.\nG91\n"
    for _ in range(100):
        radius, a = draw.uniform(2, 60), draw.uniform(0, 7)
        b = a + draw.uniform(0.2, 6)
        x, y = (round(radius * (f(b) - f(a)), 2) for f in (math.cos, math.sin))
        i, j = (round(-radius * f(a), 2) for f in (math.cos, math.sin))
        text += f"G3 X{x:.2f} Y{y:.2f} I{i:.2f} J{j:.2f} F9\nG90 G0 X0. Y0.\nG91\n"
    bench.run(text, chord_tolerance=0.05)


def test_a_circle_of_a_cutter_location_file(bench: Bench) -> None:
    """In inches with three decimals points are up to 0.04 mm off; a line would cut off what is meant as an arc."""
    draw = random.Random(2)
    program = "UNITS/INCHES\nFROM/0.0,0.0,1.0\nFEDRAT/10\n"
    for _ in range(100):
        radius, a = draw.uniform(0.2, 6), draw.uniform(0, 7)
        b = a + draw.uniform(0.2, 6)
        program += f"GOTO/{radius * math.cos(a):.3f},{radius * math.sin(a):.3f},0.000\n"
        program += f"CIRCLE/0.000,0.000,0.000,0.0,0.0,1.0,{radius:.3f}\n"
        program += f"GOTO/{radius * math.cos(b):.3f},{radius * math.sin(b):.3f},0.000\n"
    bench.run(program + "FINI\n", language="apt", chord_tolerance=0.05)
    with pytest.raises(InputError, match=r"the position before CIRCLE is 0\.\d+ mm off it; rounding of its numbers"):
        bench.run("FROM/0,0,0\nGOTO/10.03,0.0,0.0\nCIRCLE/0,0,0,0,0,1,10.000\nGOTO/0,10.000,0\nFINI\n", language="apt")
