"""Trials counted, and the page that says how often a diagnosis is right."""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from tests.hidden_effects.power.grade import FAILED, GRADES, Said, grade, upper_limit
from tests.hidden_effects.power.trials import Trial


@dataclass(frozen=True)
class Result:
    trial: Trial
    said: Said

    @property
    def grade(self) -> str:
        return grade(self.trial.truth, self.said)


@dataclass(frozen=True)
class Target:
    """A figure, what it should be, and what it is: share `count` of `of`."""

    what: str
    wanted: str
    count: int
    of: int
    met: bool


def targets(results: Sequence[Result]) -> list[Target]:
    found = []

    def add(what: str, wanted: str, chosen: Sequence[Result], good: Sequence[bool], least: float, most: float) -> None:
        if chosen:
            share = sum(good) / len(chosen)
            found.append(Target(what, wanted, sum(good), len(chosen), least <= share <= most))

    single = _of(results, "single")
    for times, least in ((3.0, 0.95), (10.0, 0.99)):
        chosen = [r for r in single if r.trial.row.endswith(f", {times:g}")]
        good = [r.grade == "unique" for r in chosen]
        add(f"observable, {times:g} times the limit: one name, right", f">= {least:.0%}", chosen, good, least, 1.0)
    inside = [r for r in results if r.trial.scenario in ("single", "reduced", "pairs", "confounded", "separated")]
    add("effects of the library: a wrong name", "< 1 %", inside, [r.grade == "wrong" for r in inside], 0.0, 0.00999)
    named = [r for r in single if r.grade == "unique" and r.said.u]
    held = [abs(abs(r.said.sizes[0]) - abs(r.trial.case.effects[0].size)) <= 2.0 * r.said.u[0] for r in named]
    add("named alone: its size is within U (k = 2)", "about 95 %", named, held, 0.9, 1.0)
    clean = _of(results, "clean")
    add("nothing hidden: a false name", "< 1 %", clean, [bool(r.said.sets) for r in clean], 0.0, 0.00999)
    told = [r.said.verdict == "unexplained_structure" for r in clean]
    add("nothing hidden: told that something is unexplained", "(none)", clean, told, 0.0, 1.0)
    out = _of(results, "outside")
    good = [r.said.verdict == "unexplained_structure" and not r.said.sets for r in out]
    add("outside the library: unexplained", ">= 97 %", out, good, 0.97, 1.0)
    add("outside the library: a name", "(as few)", out, [bool(r.said.sets) for r in out], 0.0, 1.0)
    mixed = [r for r in results if r.trial.scenario == "confounded" or r.trial.row.endswith("without the run")]
    alone = [any(len(names) == 1 for names in r.said.sets) for r in mixed]
    add("confounded: one name alone", "never", mixed, alone, 0.0, 0.0)
    apart = [r for r in results if r.trial.row.endswith("with the run")]
    add("once the run is added: one name, right", ">= 95 %", apart, [r.grade == "unique" for r in apart], 0.95, 1.0)
    spoilt = [r for r in _of(results, "tampered") if not r.trial.row.endswith("sound")]
    kept = [any(set(names) & set(r.trial.truth) for names in r.said.sets) for r in spoilt]
    add("tampered: the old name stays", "never", spoilt, kept, 0.0, 0.0)
    for given, verdict in (("exact", "no_discrepancy"), ("stale", "recalibrate")):
        chosen = [r for r in _of(results, "values") if r.trial.row == given]
        add(f"values {given}: {verdict}", ">= 95 %", chosen, [r.said.verdict == verdict for r in chosen], 0.95, 1.0)
    broken = [r.grade == FAILED for r in results]
    add("the diagnosis breaks down", "never", results, broken, 0.0, 0.0)
    return found


HOW = (
    "- **single**, **reduced**, **pairs**: effects that the audit calls observable, at multiples of the size from",
    "  which it tells them from their nearest rival. None comes to more than 0.1 mm or 0.3 mrad.",
    "- **confounded**: at ten times the size from which they are detected, a third or less of that from which they are",
    "  told apart.",
    "- **outside**: of no kind of the library, at five times the size from which they are told from up to four",
    "  candidates that imitate them best. What four imitate to 95 % in these data is not outside, and left out.",
    "- Grades: [grade.py](../tests/hidden_effects/power/grade.py); scenarios:",
    "  [trials.py](../tests/hidden_effects/power/trials.py).",
)


def page(results: Sequence[Result], command: str) -> str:
    """Markdown: targets, then every scenario row by row."""
    lines = ["# Power of the diagnosis", "", f"Measured by `{command}` on data of `tests/hidden_effects`, an exact"]
    lines += [
        "generator that shares no code with the package; upper limits are one-sided, 95 %, Clopper-Pearson.",
        "",
        *HOW,
        "",
    ]
    lines += ["| | wanted | measured | of | upper limit | met |", "|---|---|---|---|---|---|"]
    for one in targets(results):
        upper = f"{upper_limit(one.count, one.of):.2%}"
        share = f"{one.count / one.of:.2%}"
        lines.append(f"| {one.what} | {one.wanted} | {share} | {one.of} | {upper} | {'yes' if one.met else 'no'} |")
    for scenario in dict.fromkeys(r.trial.scenario for r in results):
        lines += [
            "",
            f"## {scenario}",
            "",
            "| | n | " + " | ".join(GRADES) + " |",
            "|---|" + "---|" * (1 + len(GRADES)),
        ]
        for row, counts in _rows(_of(results, scenario)).items():
            cells = " | ".join(str(counts[name]) if counts[name] else "" for name in GRADES)
            lines.append(f"| {row} | {sum(counts.values())} | {cells} |")
    return "\n".join(lines) + "\n"


def _of(results: Sequence[Result], scenario: str) -> list[Result]:
    return [result for result in results if result.trial.scenario == scenario]


def _rows(results: Sequence[Result]) -> Mapping[str, Counter[str]]:
    found: dict[str, Counter[str]] = {}
    for result in results:
        found.setdefault(result.trial.row, Counter())[result.grade] += 1
    return found
