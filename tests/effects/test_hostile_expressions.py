"""Expressions that algebra turns into something else: refused at their place, or with the values that they have."""

from pathlib import Path

import numpy as np
import pytest

from tests.fuzz.seeds import TINY
from trueaxis.cli.main import main
from trueaxis.effects.expression import HIGHEST_DEGREE, ExpressionError, parse

WAVE = TINY.replace('kind = "backlash"\ncomponent = "EXX"', 'kind = "wave"\ncomponent = "EXX"')
A, P = 2.0, 3.0


def derive(folder: Path, expression: str, grid: str = "[5.0, 10.0]") -> int:
    path = folder / "tiny.toml"
    path.write_text(WAVE.replace("a*sin(q/p)", expression).replace("[5.0, 10.0]", grid))
    return main(["derive", str(path), "--out", str(folder / "out")])


# With the value at s = 0.5, q = 250 (or without a variable), a = 2, p = 3, and the derivative by p.
FOLDED = {
    "a*p*exp(1)*sqrt(0*s)*s": (0.0, 0.0),
    "a*p*abs(0*s)": (0.0, 0.0),
    "a*p*sign(s - s)": (0.0, 0.0),
    "a*p*step(0*s)": (A * P, A),
    "a*p*exp(s - s + 1)": (A * P * np.e, A * np.e),
    "a*p*cos(s - s + 2)*s": (A * P * np.cos(2.0) * 0.5, A * np.cos(2.0) * 0.5),
    "a*p*tanh(q - q + 1/2) + a*sqrt(s - s + pi)": (A * (P * np.tanh(0.5) + np.sqrt(np.pi)), A * np.tanh(0.5)),
    "a*(p - p)": (0.0, 0.0),
    "a*p*sqrt(sqrt(0*s + 16))": (A * P * 2, A * 2),
    "a*p*((q/1000)^9)^9": (A * P * 0.25**81, A * 0.25**81),
    "a*p*1e-320*s": (A * P * 1e-320 * 0.5, A * 1e-320 * 0.5),
    "a*p/exp(s - s)": (A * P, A),
}


@pytest.mark.parametrize("expression", FOLDED)
def test_what_folds_to_a_constant_has_its_value(expression: str, tmp_path: Path) -> None:
    assert derive(tmp_path, expression) == 0
    namespace: dict[str, object] = {}
    exec((tmp_path / "out" / "tiny" / "kernels.py").read_text(), namespace)
    at = 0.5 if namespace["META"]["effects"]["kinds"]["wave"]["context"] == ["s"] else 250.0  # type: ignore[index]
    rows = len(namespace["META"]["effects"]["kinds"]["wave"]["context"])  # type: ignore[index]
    context = np.full((rows, 1), at) if rows == 1 else np.array([[250.0], [0.5]])
    found = namespace["effect_wave"](context, np.array([A, P]))  # type: ignore[operator]
    value, slope = FOLDED[expression]
    np.testing.assert_allclose(found[:, 0], [value, value / A, slope], rtol=1e-12, atol=1e-300)


# Column (from 1) of the caret.
@pytest.mark.parametrize(
    ("expression", "column"),
    [
        ("a*p*((((((((s/2)^9)^9)^9)^9)^9)^9)^9)^9", 24),
        ("a*p*(s^9*q^3)^9", 15),
        ("a*((s^9)^9*t + 1)^2", 19),
        ("a*s^9^9", 6),
        ("a*s**9", 5),
        ("(" * 10_000 + "a" + ")" * 10_000, 301),
        ("a" + "+a" * 10_000, 301),
        ("a*1e400", 3),
        ("a*\u0661", 3),
        ("a*0x10", 4),
        ("a*1_000", 4),
        ("a*s,5", 4),
        ("a*s\u00b2", 4),
    ],
)
def test_a_hostile_form_is_refused_at_its_column(expression: str, column: int) -> None:
    with pytest.raises(ExpressionError) as raised:
        parse(expression)
    assert raised.value.column == column - 1


def test_powers_of_the_highest_degree_are_read() -> None:
    assert HIGHEST_DEGREE >= 81
    assert parse("((s^9)^9)*(2^9)^9*sin(s^9)^9")


@pytest.mark.parametrize(
    ("expression", "grid", "problem"),
    [
        ("a*sqrt(p - 5)", "[5.0, 10.0]", "has a derivative by p that has no finite value where"),
        ("a*p*" + "*".join(["(q/1000)^9"] * 14), "[5.0]", "has no finite value where"),
        ("a*p/(1/3 - 1/3 + 0*s + (1 - 0.9) - 0.1)", "[1.0]", ""),
        ("a*p/(q + 0.1 - q - 0.1)", "[1.0]", "has no finite value"),
    ],
)
def test_what_has_no_value_once_it_is_derived_is_refused(
    expression: str, grid: str, problem: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert derive(tmp_path, expression, grid) == (2 if problem else 0)
    told = capsys.readouterr().err
    assert problem in told
    assert not problem or "tiny.toml: " in told
    assert not problem or "key effect_kind[0].expression: " in told
    assert (tmp_path / "out").exists() == (not problem)
