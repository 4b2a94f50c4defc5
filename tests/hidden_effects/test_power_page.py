"""README.md says what docs/diagnosis-power.md says."""

import re

from tests.machines import ROOT


def test_figures_of_the_readme_are_those_of_the_page() -> None:
    page = (ROOT / "docs" / "diagnosis-power.md").read_text()
    readme = " ".join((ROOT / "README.md").read_text().split())
    rows = {
        cells[0]: (float(cells[2].rstrip("%")), int(cells[3]))
        for line in page.splitlines()
        if re.match(r"^\| .* \| [\d.]+% \| \d+ \|", line)
        for cells in [[cell.strip() for cell in line.strip("|").split("|")]]
    }
    clean, count = rows["nothing hidden: a false name"]
    three, _ = rows["observable, 3 times the limit: one name, right"]
    ten, _ = rows["observable, 10 times the limit: one name, right"]
    wrong, _ = rows["effects of the library: a wrong name"]
    told, named = (rows[f"outside the library: {what}"][0] for what in ("unexplained", "a name"))
    assert clean == 0.0
    for said in (
        f"no name in {count} data sets without any",
        f"the right name alone in {three:.1f} %, at ten times in {ten:.1f} %; a wrong one in {wrong:.2f} %",
        f"{told:.1f} % were called unexplained, {100 - told - named:.1f} % were missed, {named:.1f} % got the name",
    ):
        assert said in readme
