"""README.md says what docs/diagnosis-power.md says."""

import re

from tests.machines import ROOT


def test_figures_of_the_readme_are_those_of_the_page() -> None:
    page = (ROOT / "docs" / "diagnosis-power.md").read_text()
    readme = " ".join((ROOT / "README.md").read_text().split())
    rows = {
        cells[0]: (cells[2].split("%")[0], cells[3])
        for line in page.splitlines()
        if re.match(r"^\| .* \| [\d.]+% (\(\d+\) )?\| \d+ \|", line)
        for cells in [[cell.strip() for cell in line.strip("|").split("|")]]
    }
    false, clean = rows["a false name, no effect hidden"]
    wrong, named = rows["a wrong name, effects of the library"]
    right, large = rows["isolable, at 10 limits: one name, right"]
    ten, _ = rows["observable, 10 times the limit: one name, right"]
    other, _ = rows["effects of the library: a wrong name"]
    for said in (
        f"a false name in {false} % of {clean} data sets; with one a wrong name in {wrong} % of {named}",
        f"the right name alone in {right} % of {large}",
        f"it was {float(ten):.1f} %, and wrong in {other} %",
    ):
        assert said in readme
