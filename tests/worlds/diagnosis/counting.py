"""What counts for and against a diagnosis: shares over cases, and why a case is a failure."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from tests.hidden_effects.power.grade import FAILED
from tests.worlds.diagnosis.cases import INTERVENTIONS

Line = Mapping[str, Any]
Test = Callable[[Line], bool]

NO_NAME = ("mute", "flawed")  # an effect that the library cannot name in these readings
LIBRARY = ("effect", "two", "stale_effect")
HIDDEN = ("effect", "two", "outside", "instrument")
CURVES = ("absorbed", "curve")
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
NAMED = ("unique", "in set", "partial")
NOT_ANSWERED = ("not possible", "no values")
PLAIN = 2.9  # limits from which an effect must be named


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


def is_named(line: Line) -> bool:
    return bool(line.get("sets"))


def is_without_name(line: Line) -> bool:
    return not is_named(line)


def is_unique(line: Line) -> bool:
    return bool(line["grade"] == "unique")


def is_right(line: Line) -> bool:
    return line["grade"] in NAMED


def is_quiet(line: Line) -> bool:
    return bool(line.get("verdict") == "no_discrepancy")


def is_wrong(line: Line) -> bool:
    return bool(line["grade"] == "wrong")


def says_stale(line: Line) -> bool:
    return bool(line.get("verdict") == "recalibrate" or line.get("stale"))


def is_unexplained(line: Line) -> bool:
    return bool(line.get("verdict") == "unexplained_structure" and not is_named(line))


def is_left_open(line: Line) -> bool:
    return bool(is_without_name(line) and (is_unexplained(line) or says_stale(line)))


def of_state(lines: Sequence[Line], kinds: Sequence[str], *states: str) -> list[Line]:
    """Cases of these kinds whose every hidden effect is in one of the states."""
    return [
        line
        for line in lines
        if line["kind"] in kinds and all(not states or one["state"] in states for one in line["hidden"])
    ]


def answered(lines: Sequence[Line]) -> list[Line]:
    return [line for line in lines if line["grade"] not in NOT_ANSWERED]


def shares(lines: Sequence[Line]) -> list[Share]:
    """All that is counted; lines: answered."""
    clean = [line for line in lines if line["kind"] == "nothing"]
    true = [line for line in clean if line["given"] == "truth"]
    library = [x for x in of_state(lines, LIBRARY) if all(one["state"] not in NO_NAME for one in x["hidden"])]
    single = of_state(lines, ("effect",), "isolable")
    certain = [x for x in of_state(lines, ("stale", "stale_effect")) if (x.get("stale_expected_p") or 1.0) < CERTAIN]
    certain = [x for x in certain if x["grade"] != FAILED]
    spoilt = [line for line in lines if line["kind"] in INTERVENTIONS and line.get("sound") in NAMED]

    def at(times: float) -> list[Line]:
        return [line for line in single if abs(line["hidden"][0]["times"] / times - 1.0) < 0.01]

    sure = [line for line in (*at(3.0), *at(10.0)) if line["grade"] != "unique"]
    audited = [x for x in single if x.get("audited") and x["audited"][0] and x["hidden"][0]["kind"] not in SIZELESS]
    of_shape = [line for line in at(1.0) if _mostly_of_detection(line)]
    outside = of_state(lines, ("outside",), "isolable")
    of_curves = of_state(lines, ("outside",), "curve")
    zeros = [line for line in clean if line["given"] == "zeros"]
    unseen, hopeless = of_state(lines, ("effect",), "absorbed"), of_state(lines, ("effect",), "too small", "mute")
    flawed = of_state(lines, ("effect",), "flawed")
    two, off = of_state(lines, ("two",), "isolable"), of_state(lines, ("instrument",))
    # what no reading tells from a changed curve is one for all that anybody knows
    beside = [x for x in lines if x["given"] == "truth" and x["kind"] in HIDDEN and x["grade"] != FAILED]
    beside = [x for x in beside if all(one["state"] not in CURVES for one in x["hidden"])]
    with_effect = of_state(lines, ("stale_effect",), "isolable")
    return [
        Share("a wrong name, effects of the library", "limit < 1 %", library, is_wrong),
        Share("a false name, no effect hidden", "limit < 1 %", [*clean, *of_state(lines, ("stale",))], is_named),
        Share("isolable, at 3 limits: one name, right", ">= 90 %", at(3.0), is_unique),
        Share("isolable, at 10 limits: one name, right", ">= 97 %", at(10.0), is_unique),
        Share("the rest of these: a set of at most 3 that holds it", ">= 95 %", sure, is_small_set),
        Share("at the limit, that of detection: named or in a set", "35 to 65 %", of_shape, is_right),
        Share("at the limit: named or in a set", "", at(1.0), is_right),
        Share("confounded: named or in a set", "", of_state(lines, ("effect",), "confounded"), is_right),
        Share("no reading shows it: no name", "", unseen, is_without_name),
        Share("too small, or a column is missing: no name", "", hopeless, is_without_name),
        Share("it shows by its flaws alone: a wrong name", "", flawed, is_wrong),
        Share("two: both right", "", two, is_unique),
        Share("two: a wrong name", "", of_state(lines, ("two",)), is_wrong),
        Share("outside, at 5 limits: unexplained, no name", ">= 95 %", outside, is_unexplained),
        Share("outside: a name", "", outside, is_named),
        Share("outside, read as a changed curve: unexplained or stale, no name", "", of_curves, is_left_open),
        Share(f"stale where p < {CERTAIN:g}: said", ">= 99 %", certain, says_stale),
        Share("of these, with an effect: said", "", of_state(certain, ("stale_effect",)), says_stale),
        Share("of these: the component that changed is in the list", "", certain, is_right_component),
        Share("stale: a name", "", of_state(lines, ("stale",)), is_named),
        Share("stale and an effect: named or in a set", "", with_effect, is_right),
        Share("nothing hidden, true values: no discrepancy", "", true, is_quiet),
        Share("nothing hidden: unexplained", "", clean, is_unexplained),
        Share("nothing hidden, zeros given: recalibrate", "", zeros, says_stale),
        Share("nothing hidden, true values: recalibrate", "", true, says_stale),
        Share("something hidden, true values: called stale", "", beside, says_stale),
        Share("an instrument far off: named or in a set", "", off, is_right),
        Share("an instrument far off: unexplained", "", off, is_unexplained),
        Share("an instrument far off: a wrong name", "", off, is_wrong),
        Share("the audit's limit within 20 %", "", audited, agrees),
        Share("interventions: the name stays", "never", spoilt, lambda line: bool(line.get("name_kept"))),
        Share("the diagnosis breaks down", "never", lines, lambda line: bool(line["grade"] == FAILED)),
    ]


def _mostly_of_detection(line: Line) -> bool:
    """Whether the limit is that of detection: what is larger tells rivals apart, and is found more often."""
    one = line["hidden"][0]
    return one["isolation"] is not None and one["detection"] >= one["isolation"]


def is_small_set(line: Line) -> bool:
    return line["grade"] == "in set" and max(map(len, line["sets"])) <= LARGE_SET


def is_right_component(line: Line) -> bool:
    return line["wear"]["component"] in line.get("stale", ())


def agrees(line: Line) -> bool:
    return bool(abs(line["audited"][0][0] / line["hidden"][0]["detection"] - 1.0) < NEAR)


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
    if line["grade"] in (FAILED, *NOT_ANSWERED):
        return ["broke down"] if line["grade"] == FAILED else []
    certain = (line.get("stale_expected_p") or 1.0) < CERTAIN
    if is_wrong(line):
        found.append("false name" if kind in ("nothing", "stale") else "wrong name")
    elif kind in LIBRARY and times > PLAIN and set(states) == {"isolable"} and not is_unique(line):
        size = max(map(len, line["sets"]), default=0)
        found += [line["grade"]] if line["grade"] != "in set" else ["large set"] if size > LARGE_SET else []
    if kind in ("nothing", "stale") and is_unexplained(line):
        found.append("unexplained, nothing there")
    if kind == "outside" and states == ["isolable"] and line["grade"] == "silent":
        found.append("outsider missed")
    if kind.startswith("stale") and certain and not says_stale(line):
        found.append("stale, not said")
    if line["given"] == "truth" and not kind.startswith("stale") and says_stale(line) and not certain:
        found.append("called stale")
    if line.get("name_kept") and line.get("sound") in NAMED:
        found.append("name stays")
    return found
