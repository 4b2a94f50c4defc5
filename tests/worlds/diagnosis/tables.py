"""The campaign on hidden effects as tables of Markdown: pooled, by world, by ingredient, by kind."""

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence

import numpy as np
from scipy.stats import binom

from tests.hidden_effects.power.grade import GRADES, upper_limit
from tests.worlds.campaign_tables import head, row
from tests.worlds.design import Design, draw_design
from tests.worlds.diagnosis.counting import Line, Share, answered, is_failure, reasons, shares

RATE, SURE = 0.01, 0.999  # a world has at most as many failures as this rate gives with this probability


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
        "missed at 3 limits and more", "stale missed", "broke down", "failures", f"most at {RATE:.0%}",
        "seconds, median",
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
        "ingredient", "worlds", "cases", "wrong or false names", "unexplained, nothing there",
        "unique at 3 and 10 limits", "outside: unexplained", "stale: said",
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
        limits = [(one["detection"], one["isolation"], one.get("own")) for one in line.get("hidden", ())]
        yield f"  - noise {line.get('noise')} um, true {line.get('true_noise')}; {limits}, {line.get('audited')} said"
        said = f"{line.get('verdict')} {line.get('sets')} sizes {line.get('sizes')} stale {line.get('stale')}"
        yield f"  - said: {line.get('error') or said}; checks {line.get('checks')}"
        yield f"  - {design.plan.count} readings, {len(design.plan.runs)} runs: {has}"
