"""What may cost a part, of a compensation that was done: first among its sentences."""

from collections.abc import Iterator
from itertools import combinations

import numpy as np

from trueaxis.compensation.reliance import NOTICEABLE
from trueaxis.compensation.report import CompensationReport


def warnings_of(report: CompensationReport) -> tuple[str, ...]:
    """In the order in which they are told."""
    own = (_unplaced, _hardly_known, _by_usual_sizes, _shifted, _apart)
    return (*(sentence for each in own for sentence in each(report)), *report.warnings)


def _unplaced(report: CompensationReport) -> list[str]:
    """That positions count as machine coordinates, and what it may cost."""
    if report.unplaced is None:
        return []
    return [
        "no work offset is given or selected: positions count as machine coordinates. If the control is in G54 or in "
        "another work offset all the same, as most are where a program says nothing, compensated positions are wrong "
        f"by up to {report.unplaced:.4f} mm (its zero anywhere in the travel). Say --offset G54=X..,Y..,Z.. (10 mm are "
        "near enough), or G54=X0,Y0,Z0 where they are machine coordinates"
    ]


def _hardly_known(report: CompensationReport) -> list[str]:
    """That the values say less of the tool point than they correct."""
    known = None if report.reliance is None else report.reliance.uncertainty
    if known is None or report.before is None or not known.largest_u > report.before.largest:
        return []
    rests = known.largest_u_prior is not None and known.largest_u_prior > 0.5 * known.largest_u
    why = "what no reading tells rests on [prior] of the spec, and is left as it is" if rests else "measure more"
    return [
        f"the tool point is known to a standard uncertainty of {1e3 * known.largest_u:.3g} um only (from "
        f"{known.datum}, in one coordinate), and at most {1e3 * report.before.largest:.3g} um are corrected: {why}"
    ]


def _by_usual_sizes(report: CompensationReport) -> Iterator[str]:
    """That they do so by the usual sizes of what is unknown of instruments, which few values made smaller."""
    known = None if report.reliance is None else report.reliance.uncertainty
    if known is None or known.largest_u_usual is None or report.before is None:
        return
    if known.largest_u <= report.before.largest < known.largest_u_usual:
        yield (
            f"u, {1e3 * known.largest_u:.3g} um, rests on instruments that were set up far better than usual, as few "
            f"values have it; by the usual sizes it is {1e3 * known.largest_u_usual:.3g} um, more than is corrected: "
            "see the note of identify"
        )


def _shifted(report: CompensationReport) -> Iterator[str]:
    """That all words are displaced by what is hardly known."""
    known = report.reliance
    if known is not None and known.shift_is_noise:
        yield (
            f"every word holds the displacement at home, {1e3 * known.at_home:.3g} um, which is known to a standard "
            f"uncertainty of {1e3 * known.at_home_u:.3g} um only: say --touched-off of each work offset that was "
            "touched off, and it is left out"
        )


def _apart(report: CompensationReport) -> Iterator[str]:
    """That what is machined from one work offset lies off what is machined from another."""
    free = [one for one in report.offsets if not one.zero.touched_off]
    pairs = [
        (float(np.linalg.norm(np.subtract(one.zero.off, other.zero.off))), one.system, other.system)
        for one, other in combinations(free, 2)
    ]
    if not pairs or max(pairs)[0] <= NOTICEABLE:
        return
    most, one, other = max(pairs)
    yield (
        f"{', '.join(use.system for use in free)}: if they were touched off without compensation, what is machined "
        f"from one lies off what is machined from another, by {1e3 * most:.3g} um from {one} to {other}: say "
        "--touched-off of each, as proposed below"
    )
