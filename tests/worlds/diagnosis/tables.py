"""The campaign on hidden effects as tables of Markdown: pooled, by world, by ingredient, by kind."""

from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.stats import binom

from tests.hidden_effects.power.grade import FAILED, GRADES, upper_limit
from tests.worlds.campaign_tables import head, row
from tests.worlds.design import Design, draw_design
from tests.worlds.diagnosis.cases import INTERVENTIONS

Line = Mapping[str, Any]
Test = Callable[[Line], bool]

LIBRARY = ("effect", "two", "stale_effect")
CERTAIN = 1e-6  # p value of the given values below which they must be called stale
LARGE_SET = 3
NEAR = 0.2  # by how much the audit's limit may differ
SIZELESS = (
    "cyclic",
    "warm_up",
    "reversal_spike",
    "reversal_spike_time",
    "laser_step",
    "point_offset",
)  # limit: of a shape
RATE, SURE = 0.01, 0.999  # a world has at most as many failures as this rate gives with this probability
NAMED = ("unique", "in set", "partial")


@dataclass(frozen=True)
class Share:
    """A share that issue and method ask for: least and most are what is wanted."""

    what: str
    wanted: str
    lines: Sequence[Line]
    good: Test

    @property
    def count(self) -> int:
        return sum(map(self.good, self.lines))


def named(line: Line) -> bool:
    return bool(line.get("sets"))


def is_wrong(line: Line) -> bool:
    return bool(line["grade"] == "wrong")


def says_stale(line: Line) -> bool:
    return bool(line.get("verdict") == "recalibrate" or line.get("stale"))


def unexplained(line: Line) -> bool:
    return bool(line.get("verdict") == "unexplained_structure" and not named(line))


def of_state(lines: Sequence[Line], kinds: Sequence[str], *states: str) -> list[Line]:
    """Cases of these kinds whose every hidden effect is in one of the states."""
    return [
        line
        for line in lines
        if line["kind"] in kinds and all(not states or one["state"] in states for one in line["hidden"])
    ]


def answered(lines: Sequence[Line]) -> list[Line]:
    return [line for line in lines if line["grade"] not in ("not possible", "no values")]


def shares(lines: Sequence[Line]) -> list[Share]:
    """All that is counted; lines: answered."""
    clean = [line for line in lines if line["kind"] == "nothing"]
    true = [line for line in clean if line["given"] == "truth"]
    library = [line for line in of_state(lines, LIBRARY) if all(one["state"] != "mute" for one in line["hidden"])]
    single = of_state(lines, ("effect",), "isolable")
    certain = [x for x in of_state(lines, ("stale", "stale_effect")) if (x.get("stale_expected_p") or 1.0) < CERTAIN]
    certain = [x for x in certain if x["grade"] != FAILED]
    spoilt = [line for line in lines if line["kind"] in INTERVENTIONS and line.get("sound") in NAMED]

    def at(times: float) -> list[Line]:
        return [line for line in single if abs(line["hidden"][0]["times"] / times - 1.0) < 0.01]

    sure = [line for line in (*at(3.0), *at(10.0)) if line["grade"] != "unique"]
    audited = [x for x in single if x.get("audited") and x["audited"][0] and x["hidden"][0]["kind"] not in SIZELESS]
    return [
        Share("a wrong name, effects of the library", "limit < 1 %", library, is_wrong),
        Share("a false name, no effect hidden", "limit < 1 %", [*clean, *of_state(lines, ("stale",))], named),
        Share("isolable, at 3 limits: one name, right", ">= 90 %", at(3.0), lambda x: x["grade"] == "unique"),
        Share("isolable, at 10 limits: one name, right", ">= 97 %", at(10.0), lambda x: x["grade"] == "unique"),
        Share("the rest of these: a set of at most 3 that holds it", ">= 95 %", sure, _small_set),
        Share(
            "at the limit, that of detection: named or in a set",
            "35 to 65 %",
            [x for x in at(1.0) if x["hidden"][0]["detection"] >= (x["hidden"][0]["isolation"] or np.inf)],
            lambda x: x["grade"] in NAMED,
        ),
        Share("at the limit: named or in a set", "", at(1.0), lambda x: x["grade"] in NAMED),
        Share("confounded: in a set or named", "", of_state(lines, ("effect",), "confounded"), lambda x: x["grade"] in NAMED[:2]),
        Share("no reading shows it: no name", "", of_state(lines, ("effect",), "absorbed"), lambda x: not named(x)),
        Share("too small, or a column is missing: no name", "", of_state(lines, ("effect",), "too small", "mute"), lambda x: not named(x)),
        Share("two: both right", "", of_state(lines, ("two",), "isolable"), lambda x: x["grade"] == "unique"),
        Share("two: a wrong name", "", of_state(lines, ("two",)), is_wrong),
        Share("outside, at 5 limits: unexplained, no name", ">= 95 %", of_state(lines, ("outside",), "isolable"), unexplained),
        Share("outside: a name", "", of_state(lines, ("outside",), "isolable"), named),
        Share(f"stale where p < {CERTAIN:g}: said", ">= 99 %", certain, says_stale),
        Share("of these, with an effect: said", "", of_state(certain, ("stale_effect",)), says_stale),
        Share("of these: the component that changed is in the list", "", certain, _right_component),
        Share("stale: a name", "", of_state(lines, ("stale",)), named),
        Share("stale and an effect: the effect named or in a set", "", of_state(lines, ("stale_effect",), "isolable"), lambda x: x["grade"] in NAMED),
        Share("nothing hidden, true values: no discrepancy", "", true, lambda x: x.get("verdict") == "no_discrepancy"),
        Share("nothing hidden: unexplained", "", clean, unexplained),
        Share("nothing hidden, zeros given: recalibrate", "", [x for x in clean if x["given"] == "zeros"], says_stale),
        Share("nothing hidden, true values: recalibrate", "", true, says_stale),
        Share("an instrument far off: named or in a set", "", of_state(lines, ("instrument",)), lambda x: x["grade"] in NAMED),
        Share("an instrument far off: unexplained", "", of_state(lines, ("instrument",)), unexplained),
        Share("an instrument far off: a wrong name", "", of_state(lines, ("instrument",)), is_wrong),
        Share("the audit's limit within 20 %", "", audited, _agrees),
        Share("interventions: the name stays", "never", spoilt, lambda x: bool(x.get("name_kept"))),
        Share("the diagnosis breaks down", "never", lines, lambda x: x["grade"] == FAILED),
    ]  # fmt: skip


def _small_set(line: Line) -> bool:
    return line["grade"] == "in set" and max(map(len, line["sets"])) <= LARGE_SET


def _right_component(line: Line) -> bool:
    return line["wear"]["component"] in line.get("stale", ())


def _agrees(line: Line) -> bool:
    return abs(line["audited"][0][0] / line["hidden"][0]["detection"] - 1.0) < NEAR


def is_failure(line: Line) -> bool:
    """What counts against a world: a wrong or false name, structure where there is none, a plain effect missed or an
    outsider, given values that are certainly stale and are not said to be, a breakdown.
    """
    return bool(reasons(line))


def reasons(line: Line) -> list[str]:
    """Why a case is a failure; empty where it is none."""
    states = [one["state"] for one in line.get("hidden", ())]
    times = min((one["times"] for one in line.get("hidden", ())), default=0.0)
    kind, found = line.get("kind", ""), []
    if line["grade"] == FAILED:
        return ["broke down"]
    if line["grade"] in ("not possible", "no values"):
        return []
    if line["grade"] == "wrong":
        found.append("false name" if kind in ("nothing", "stale") else "wrong name")
    if kind in ("nothing", "stale") and unexplained(line):
        found.append("unexplained, nothing there")
    if kind in LIBRARY and times > 2.9 and set(states) == {"isolable"}:
        found += [f"{line['grade']}"] if line["grade"] not in ("unique", "in set", "wrong") else []
        found += ["large set"] if line["grade"] == "in set" and max(map(len, line["sets"])) > LARGE_SET else []
    if kind == "outside" and states == ["isolable"] and line["grade"] == "silent":
        found.append("outsider missed")
    if kind.startswith("stale") and (line.get("stale_expected_p") or 1.0) < CERTAIN and not says_stale(line):
        found.append("stale, not said")
    if (
        kind == "nothing"
        and line["given"] == "truth"
        and says_stale(line)
        and (line.get("stale_expected_p") or 1.0) > CERTAIN
    ):
        found.append("called stale")
    if line.get("name_kept") and line.get("sound") in NAMED:
        found.append("name stays")
    return found


def tables(lines: Sequence[Line]) -> Iterator[str]:
    """Lines of Markdown."""
    every = answered(lines)
    designs = {seed: draw_design(seed) for seed in sorted({line["world"] for line in every})}
    seconds = [line["seconds"] for line in every if "seconds" in line]
    yield f"- {len(designs)} worlds, {len(every)} cases; {len(lines) - len(every)} that could not be put before it"
    if seconds:
        yield (
            f"- seconds of CPU a case: median {np.median(seconds):.1f}, 95 % {np.quantile(seconds, 0.95):.1f}, "
            f"most {max(seconds):.1f}"
        )
    yield from _standardised(every)
    yield ""
    yield from _pooled(every)
    yield ""
    yield from _by_world(designs, every)
    yield ""
    yield from _by_ingredient(designs, every)
    yield ""
    yield from _by_kind(every)


def _standardised(lines: Sequence[Line]) -> Iterator[str]:
    """Of clean data: nothing hidden."""
    clean = [line["standardised"] for line in lines if line["kind"] == "nothing" and line.get("standardised")]
    for key in dict.fromkeys(key for one in clean for key in one):
        values = np.array([one[key] for one in clean if key in one])
        inside = np.mean((values >= 0.9) & (values <= 1.1))
        low, middle, high = np.quantile(values, [0.05, 0.5, 0.95])
        yield (
            f"- held-out residuals of clean data, standardised, {key}: median {middle:.3f}, 5 to 95 % {low:.2f} to "
            f"{high:.2f}, {inside:.0%} of {len(values)} from 0.9 to 1.1"
        )


def _pooled(lines: Sequence[Line]) -> Iterator[str]:
    yield from head("", "wanted", "share", "cases", "upper limit, 95 %")
    for one in shares(lines):
        if one.lines:
            of = len(one.lines)
            yield row(
                one.what, one.wanted, f"{one.count / of:.1%} ({one.count})", of, f"{upper_limit(one.count, of):.1%}"
            )


def _by_world(designs: Mapping[int, Design], lines: Sequence[Line]) -> Iterator[str]:
    yield from head(
        "world", "axes", "readings", "runs", "cases", "wrong", "false", "unexplained, nothing there",
        "missed at 3 limits and more", "stale missed", "broke down", "failures", f"most at {RATE:.0%}", "seconds, median",
    )  # fmt: skip
    for seed, design in designs.items():
        own = [line for line in lines if line["world"] == seed]
        why = Counter(reason for line in own for reason in reasons(line))
        missed = sum(why[reason] for reason in ("silent", "unexplained", "partial", "large set", "outsider missed"))
        seconds = [line["seconds"] for line in own if "seconds" in line]
        yield row(
            seed, len(design.machine.axes), design.plan.count, len(design.plan.runs), len(own),
            why["wrong name"], why["false name"], why["unexplained, nothing there"], missed, why["stale, not said"],
            why["broke down"], sum(map(is_failure, own)), int(binom.ppf(SURE, len(own), RATE)),
            f"{np.median(seconds):.1f}" if seconds else "",
        )  # fmt: skip


def _by_ingredient(designs: Mapping[int, Design], lines: Sequence[Line]) -> Iterator[str]:
    yield from head(
        "ingredient", "worlds", "cases", "wrong or false names", "unexplained, nothing there", "unique at 3 and 10 limits",
        "outside: unexplained", "stale: said",
    )  # fmt: skip
    for name in next(iter(designs.values())).ingredients:
        chosen = {seed for seed, design in designs.items() if design.ingredients[name]}
        own = [line for line in lines if line["world"] in chosen]
        if not own:
            yield row(name, 0, 0, *[""] * 5)
            continue
        found = {one.what: one for one in shares(own)}
        false = [one for key, one in found.items() if key.startswith(("a wrong name", "a false name"))]
        plain = [one for key, one in found.items() if key.startswith(("isolable, at 3", "isolable, at 10"))]
        cells = [false, plain, [o for k, o in found.items() if k.startswith("outside, at 5")]]
        cells.append([o for k, o in found.items() if k.startswith("stale where")])
        quiet = [o for k, o in found.items() if k == "nothing hidden: unexplained"]
        texts = [_share(some) for some in (cells[0], quiet, *cells[1:])]
        yield row(name, len(chosen), len(own), *texts)


def _share(some: Sequence[Share]) -> str:
    count, of = sum(one.count for one in some), sum(len(one.lines) for one in some)
    return f"{count / of:.1%} of {of}" if of else ""


def _by_kind(lines: Sequence[Line]) -> Iterator[str]:
    """Single effects of each kind at each size."""
    yield from head("hidden", "state", "limits", "cases", *GRADES)
    counts: dict[tuple[str, str, float], Counter[str]] = {}
    for line in lines:
        if len(line["hidden"]) == 1 and line["kind"] in ("effect", "outside", "instrument"):
            one = line["hidden"][0]
            times = round(one["times"]) if one["state"] in ("isolable", "confounded", "mute", "imitated") else 0
            counts.setdefault((one["kind"], one["state"], times), Counter())[line["grade"]] += 1
    for (kind, state, times), found in sorted(counts.items()):
        yield row(kind, state, times or "", sum(found.values()), *(found[grade] or "" for grade in GRADES))


def failures(lines: Sequence[Line]) -> Iterator[str]:
    """One paragraph per failure: the case, what was said, the ingredients of its world."""
    designs: dict[int, Design] = {}
    for line in answered(lines):
        why = reasons(line)
        if not why:
            continue
        design = designs.setdefault(line["world"], draw_design(line["world"]))
        hidden = "; ".join(
            f"{one['name']} {one['state']} at {one['times']:g} limits (r2 {one['r2']} with {one['rival']})"
            for one in line.get("hidden", ())
        )
        wear = line.get("wear")
        has = " ".join(name for name, there in design.ingredients.items() if there)
        yield f"- world {line['world']} case {line['case']}: {', '.join(why)}"
        yield f"  - {line.get('kind')}, given {line.get('given')}; hidden: {hidden or 'nothing'}" + (
            f"; worn {wear['component']} {wear['form']} by {wear['size']:.2g}, p {line.get('stale_expected_p')}"
            if wear
            else ""
        )
        said = f"{line.get('verdict')} {line.get('sets')} sizes {line.get('sizes')} stale {line.get('stale')}"
        yield f"  - said: {line.get('error') or said}; checks {line.get('checks')}"
        yield f"  - {design.plan.count} readings, {len(design.plan.runs)} runs: {has}"
