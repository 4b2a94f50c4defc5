"""Readings that cannot be what the set-up says: runs that contradict the others, and all readings too small."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

import numpy as np

from trueaxis.estimation.misread import LEAST_NOISE, SURE, Misread
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.result import Estimate
from trueaxis.estimation.runs import noise_groups
from trueaxis.estimation.tails import LEAST_P
from trueaxis.estimation.tool_point import ORIGIN, moved_without
from trueaxis.identification.far_scales import as_scale, far_scales
from trueaxis.identification.far_zeros import far_zeros
from trueaxis.identification.fit_quality import MISFIT_OF_RUN, FitQuality
from trueaxis.identification.stuck import stuck_runs
from trueaxis.identification.tip_lengths import doubted, resting_on_length
from trueaxis.identification.tips import tip_notes
from trueaxis.identification.words import READS, enumerated, in_digits

# By which errors of a machine may be smaller than [prior] says, all classes of them at once: 0.7 um and 1.7 urad by the
# default sizes are better than machines are, and a factor of 1000 in the unit is far beyond.
LEAST_MACHINE = 1.0 / 30.0
MOST_RUNS = 10  # that are listed


@dataclass(frozen=True, slots=True, kw_only=True)
class Contradicting:
    """Runs that contradict the others, the surest first. times: how far the farthest is off, over its noise; log_p: of
    the least sure, logarithm of the probability of being as far by noise; zeros_free: times where zeros may be
    anything; moved, u: how far the tool point moves without them, and how uncertain it is then, mm; undone: whether
    these are by readings with the faults of misread runs undone.
    """

    runs: tuple[str, ...]
    times: float
    log_p: float
    zeros_free: float
    moved: float
    u: float
    undone: bool = False

    @property
    def matter(self) -> bool:
        """Whether they are off by more than noise of any form and a zero that is far off, or what is said of the tool
        point does not hold where they are wrong.
        """
        return self.moved > self.u or self.zeros_free > MISFIT_OF_RUN

    def __str__(self) -> str:
        verb, them = ("contradicts", "it") if len(self.runs) == 1 else ("contradict", "them")
        others = "all others" + (", with that undone, too" if self.undone else "")
        left = len(self.runs) - MOST_RUNS
        named = [*self.runs[:MOST_RUNS], f"{left} more"] if left > 0 else self.runs
        return (
            f"run{'s' if len(self.runs) > 1 else ''} {enumerated(named)} {verb} {others}: noise alone takes all "
            "readings of a sound run as far from what the others predict with a probability of "
            f"{_probability(self.log_p)} (together; the farthest combination of them is {in_digits(self.times)} "
            f"standard deviations off); without {them} the tool point moves by {in_digits(self.moved * 1e3)} um (RMS "
            f"over the volume), and its u is {in_digits(self.u * 1e3)} um then (does the model lack an effect, such as "
            "lost motion? Was the machine warmer, or a compensation active, in some runs only? Are runs swapped, is a "
            "target, reference, home, ball or the length of a tool not as setup.toml says? diagnose tells more)"
        )


def with_misread(judged: FitQuality, observed: Observations, found: Estimate, *, prior: bool) -> FitQuality:
    """A misfit where runs are misread for sure, contradict the others by much, show the same again and again, are of a
    ball bar whose zero or a laser whose scale is far off, of a probe whose length would explain a large location error,
    or is not as it is stated: the values follow them, or what they contradict.

    prior: whether one holds what the others do not tell; else it may be that which a run shows, and none contradicts.
    """
    sure = {index: one for index, one in found.readings.misread.items() if one.sure}
    sure = dict(sorted(sure.items(), key=lambda item: len(item[1].together)))  # those of fewest runs first
    ids = tuple(observed.runs[index].id for index in sure)
    reasons, named = [_of_runs(observed, sure) if sure else _of_all(found)], ids
    contradicting = _contradicting(observed, found) if prior else None
    if contradicting is not None and contradicting.matter:
        reasons, named = [*reasons, str(contradicting)], named + contradicting.runs
    for one in far_zeros(observed, found):
        if one.of_bars and not ids:
            reasons, named = [*reasons, str(one)], tuple(dict.fromkeys([*named, *one.of_run]))
    for still in stuck_runs(observed, found):
        reasons, named = [str(still), *reasons], tuple(dict.fromkeys([still.run, *named]))
    if not ids and (scales := [one for one in far_scales(observed, found) if one.of_scale]):
        runs = (run for one in scales for run in one.runs)
        reasons, named = [*reasons, as_scale(scales)], tuple(dict.fromkeys([*named, *runs]))
    for resting in resting_on_length(observed, found):
        if resting.far:
            reasons, named = [*reasons, str(resting)], tuple(dict.fromkeys([*named, *resting.runs]))
    for length in found.readings.doubted:
        if length.log_odds > SURE:
            runs = (observed.runs[index].id for index in length.runs)
            reasons, named = [*reasons, doubted(observed, length)], tuple(dict.fromkeys([*named, *runs]))
    reason = "; ".join(filter(None, reasons))
    if not reason:
        return judged
    reason = "; ".join([*tip_notes(found.layout.model, observed), reason])  # which may be why
    return replace(judged, fit=replace(judged.fit, state="misfit", runs=named), reason=reason, misread=ids)


def misread_notes(observed: Observations, found: Estimate, *, prior: bool) -> tuple[str, ...]:
    """Runs that may be misread, with the odds, and those that contradict the others but change little."""
    contradicting = _contradicting(observed, found)
    little: tuple[str, ...] = () if contradicting is None or (contradicting.matter and prior) else (str(contradicting),)
    if contradicting is not None and not prior:
        named = enumerated(contradicting.runs[:MOST_RUNS])
        little = (
            f"{named}: the readings are not what the other runs let expect. Without a prior the others hold errors "
            "that they do not determine at zero, so that this is no proof of a wrong run: --prior spec judges it",
        )
    likelier = "that makes the readings {} times as likely, which is not enough to be sure"
    little += tuple(
        f"{doubted(observed, one)}: {likelier.format(in_digits(float(np.exp(one.log_odds))))}"
        for one in found.readings.doubted
        if one.log_odds <= SURE
    )
    unsure = {index: one for index, one in found.readings.misread.items() if not one.sure}
    return little + tuple(
        f"{text}: {likelier.format(in_digits(float(np.exp(one.log_odds))))}"
        for text, one in _each(observed, unsure, "may read")
    )


def _each(observed: Observations, misread: Mapping[int, Misread], verb: str) -> Iterator[tuple[str, Misread]]:
    """`run X reads ...` of each, `runs X and Y ...` once of two that are swapped."""
    done = set[int]()
    for index, one in misread.items():
        if index in done:
            continue
        who = _who(observed, index, one)
        if one.partner is not None:
            done |= {index, one.partner}
            yield (
                f"{who} {verb.removesuffix('s')} as if each had the other's readings (run in readings.csv, or what "
                "setup.toml says of them)",
                one,
            )
        elif one.direction is not None:
            done.add(index)
            along = ", ".join(f"{part:g}" for part in one.direction)
            yield f"{who} {verb} as if its direction were [{along}] (direction in setup.toml)", one
        elif one.frame is not None:
            done |= set(one.together)
            verb, its = (verb.removesuffix("s"), "their") if len(one.together) > 1 else (verb, "its")
            yield f'{who} {verb} as if {its} frame were "{one.frame}" (frame in setup.toml)', one
        else:
            done |= {index, *one.together}
            yield f"{who} {verb.removesuffix('s') if one.together else verb} {READS[one.how]}", one


def _who(observed: Observations, index: int, one: Misread) -> str:
    """`run X`, `runs X and Y` of two that are swapped, `all 8 runs of laser in session B`, or along a line, of one
    fault; `the 3 runs X, Y and Z of laser together` where these are not all such runs.
    """
    if len(one.together) < 2:
        among = (index,) if one.partner is None else (index, one.partner)
        return f"run{'s' if len(among) > 1 else ''} {enumerated([observed.runs[each].id for each in among])}"
    groups, mine = noise_groups(observed.runs), [observed.runs[each] for each in one.together]
    others = [run for run, group in zip(observed.runs, groups, strict=True) if group == groups[index]]
    sessions, lines = {run.session for run in mine}, {run.line for run in mine}
    along, within = len(lines) == 1, len(sessions) == 1
    alike = [run for run in others if (run.line in lines or not along) and (run.session in sessions or not within)]
    if len(alike) > len(mine):
        return f"the {len(mine)} runs {enumerated([run.id for run in mine])} of {groups[index]} together"
    which = f"{'both' if len(mine) == 2 else f'all {len(mine)}'} runs of {groups[index]}"
    if along and len({run.line for run in others if run.session in sessions}) > 1:
        which += f" along [{', '.join(f'{part:g}' for part in lines.pop() or ())}]"
    if within and len({run.session for run in others}) > 1:
        which += f" in session {sessions.pop()}"
    return which


def _of_runs(observed: Observations, sure: Mapping[int, Misread]) -> str:
    kinds = {one.how for one in sure.values()}
    who = list(dict.fromkeys(_who(observed, index, one) for index, one in sure.items()))
    if len(who) == 1 or len(kinds) > 1 or kinds & {"swapped", "turned", "framed"}:
        return "; ".join(text for text, _ in _each(observed, sure, "reads"))
    wrong = READS[kinds.pop()]
    if any(one.together for one in sure.values()):
        return f"{', or '.join(who)}, read {wrong}; which of these is wrong the readings cannot tell"
    return f"runs {', '.join(observed.runs[index].id for index in sure)}: one of them at least reads {wrong}"


def _contradicting(observed: Observations, found: Estimate) -> Contradicting | None:
    each = found.readings.contradicting
    if not each:
        return None
    moved, u = moved_without(found, [ORIGIN])
    return Contradicting(
        runs=tuple(observed.runs[index].id for one in each for index in one.runs),
        times=max(one.times for one in each),
        log_p=max(one.log_p for one in each),
        zeros_free=max(one.zeros_free for one in each),
        moved=moved,
        u=u,
        undone=any(one.sure for one in found.readings.misread.values()),
    )


def _probability(log_p: float) -> str:
    """`3e-07`, `below 1e-12`."""
    return f"{np.exp(log_p):.0e}" if log_p > np.log(LEAST_P) else f"below {LEAST_P:.0e}"


def _of_all(found: Estimate) -> str:
    """Why all readings together are too small to be in mm; empty where they are not."""
    off = [(found.factors[name], odds) for name, odds in found.likelier.items() if odds > 0.0]
    factors, odds = np.array(off).reshape(-1, 2).T
    if odds.sum() <= SURE or factors.max() > 1.0:
        return ""
    # each class counts by what the readings tell of its size
    size = float(np.exp(np.average(np.log(factors), weights=odds)))
    # not the noise that is estimated, which is no less than a stated resolution
    left = float(np.sqrt(np.mean(found.readings.residual[~found.readings.outliers] ** 2)))
    if size > LEAST_MACHINE or left > LEAST_NOISE:
        return ""
    return (
        f"all readings are too small to be in mm (are they in m?): errors are 1/{1.0 / size:.0f} of what [prior] says, "
        f"and the residuals are {left * 1e6:.2g} nm"
    )
