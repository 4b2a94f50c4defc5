"""Stepwise regression by Akaike's criterion, as R's step(direction = "both") does it."""

from collections.abc import Iterator

from trueaxis.identification.polynomial.records import Step
from trueaxis.identification.polynomial.reduced import ReducedSystem


def step_by_aic(
    system: ReducedSystem, start: tuple[int, ...], scope: tuple[int, ...]
) -> tuple[tuple[int, ...], tuple[Step, ...]]:
    """Powers at which no term put in (out of `scope`) or taken out lowers the AIC, and the steps there.

    Of equally good moves the first counts, staying before leaving out before putting in, as in R. Every move
    lowers the AIC, so that no model comes twice and the search ends.
    """
    powers, criterion = start, system.aic(start)
    steps: list[Step] = []
    while True:
        candidates = [(system.aic(to), to, change) for change, to in _neighbours(powers, scope)]
        best, to, change = min(candidates, key=lambda candidate: candidate[0], default=(criterion, powers, ""))
        if best >= criterion:
            return powers, tuple(steps)
        powers, criterion = to, best
        steps.append(Step("AIC", change, powers, criterion))


def _neighbours(powers: tuple[int, ...], scope: tuple[int, ...]) -> Iterator[tuple[str, tuple[int, ...]]]:
    for power in powers:
        yield f"-{power}", tuple(other for other in powers if other != power)
    for power in scope:
        if power not in powers:
            yield f"+{power}", tuple(sorted((*powers, power)))
