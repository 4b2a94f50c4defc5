"""The effects of a machine on its page of equations, bound to their axes."""

import pytest

from tests.codegen.test_equations import balanced, blocks, inline
from tests.kernels import model_of
from tests.machine.test_effects import SAG, effect
from tests.machines import DMU60P, serial_text
from trueaxis.codegen.equations import equations_page


def section(*tables: str, text: str = "") -> str:
    page = equations_page(model_of((text or DMU60P.read_text()) + "".join(tables)))
    return page[page.index("## Effects") : page.index("## Kernels")]


def test_a_machine_without_effects_has_no_such_section() -> None:
    assert "## Effects" not in equations_page(model_of(DMU60P.read_text() + SAG))


EQUATIONS = {
    r"\delta_{x}(x) \leftarrow \delta_{x}(x) + \frac{\sigma_{x} \mathrm{width}_{1}}{2}": effect(
        kind="backlash", component="EXX"
    ),
    r"\varepsilon_{z}(x) \leftarrow \varepsilon_{z}(x) + \mathrm{rate}_{1} t": effect(kind="drift", component="ECX"),
    r"\delta_{y}(y) \leftarrow \delta_{y}(y) - \mathrm{tau}_{1} v_{y}": effect(kind="servo_lag", component="EYY"),
    r"\delta_{z}(x) \leftarrow \delta_{z}(x) + \mathrm{k}_{1} s_{x} s_{y}^{2}": effect(
        kind="cross_axis", component="EZX", axis="Y"
    ),
    r"\delta_{x}(x) \leftarrow \delta_{x}(x) + T \mathrm{coefficient}_{1} x": effect(
        kind="thermal_expansion", component="EXX"
    ),
    r"L \leftarrow L + \mathrm{jump}_{1} H\left(t - t_{0,1}\right)": effect(kind="laser_step", runs=["X1"]),
    r"L \leftarrow L - \frac{\ell \mathrm{angle}_{1}^{2}}{2}": effect(kind="laser_cosine"),
    r"L \leftarrow L + w \mathrm{slope}_{1}": effect(kind="reading_slope", runs=["X1"]),
    r"L \leftarrow L + \mathrm{zero}_{1}": effect(kind="reading_zero", runs=["X1"]),
    r"\delta_{x}(x) \leftarrow \delta_{x}(x) + \sigma_{x} \mathrm{height}_{1} "
    r"e^{- \frac{\Delta t_{x}}{\mathrm{tau}_{1}}}": effect(kind="reversal_spike_time", component="EXX"),
    r"P_{\mathrm{target}} \leftarrow P_{\mathrm{target}} + (\mathrm{x}_{1}, \mathrm{y}_{1}, \mathrm{z}_{1})^T": effect(
        kind="point_offset"
    ),
}


@pytest.mark.parametrize("equation", EQUATIONS)
def test_equations(equation: str) -> None:
    assert [block.strip() for block in blocks(section(EQUATIONS[equation]))] == [equation]


def test_every_symbol_has_a_row_with_the_unit_of_its_place() -> None:
    text = section(
        effect(kind="backlash", component="EXX"),
        effect(kind="reversal_spike", component="ECC"),
        text=serial_text("C", "XYZ"),
    )
    assert r"| $\mathrm{width}_{1}$ | `width` | mm |" in text
    assert r"| $\mathrm{height}_{2}$ | `height` | rad |" in text
    assert r"| $\mathrm{decay}_{2}$ | `decay` | deg |" in text
    assert r"| $d_{c}$ | - | deg | C: distance" in text
    assert r"| $\sigma_{x}$ | - | 1 | X: direction" in text


def test_hostile_texts_leave_markdown_and_maths_whole() -> None:
    own = SAG.replace("sag*s*(1 - s)*T", "sag*sqrt(abs(s))^3*sign(v)^2*step(T)*abs(T)^2*tanh(q)^2")
    text = section(
        own, effect(kind="table_sag", component="EZY"), effect(kind="laser_step", runs=["a|$b_*`<i>", "```"])
    )
    for maths in [*blocks(text), *inline(text)]:
        assert balanced(maths)
        assert maths.count(r"\left") - maths.count(r"\leftarrow") == maths.count(r"\right")
    assert text.count("```") == 2 * len(list(blocks(text)))
    assert "<i>" not in text
    for row in (line for line in text.splitlines() if line.startswith("|")):
        assert row.count("|") == 5, row


def test_a_squareness_needs_no_equation_of_its_own() -> None:
    page = equations_page(model_of(DMU60P.read_text() + effect(kind="squareness", component="EB0X")))
    row = r'| $\mathrm{EB0X}$ | <a id="EB0X"></a>`EB0X` | rad | '
    assert f"{row}location error: squareness error of X to Z, about Y" in page
    assert "### 1. squareness EB0X" in page
    assert not list(blocks(page[page.index("## Effects") : page.index("## Kernels")]))
