"""Optimal polynomials of the position-dependent errors (Sects. 4.2-4.4 of the paper)."""

from trueaxis.identification.polynomial.optimal import MAX_ORDER, fit_optimal, fit_samples, statistics_table
from trueaxis.identification.polynomial.records import OptimalFit, PolynomialFit, Samples, Step, checked_samples
from trueaxis.identification.polynomial.regression import fit_terms

__all__ = [
    "MAX_ORDER",
    "OptimalFit",
    "PolynomialFit",
    "Samples",
    "Step",
    "checked_samples",
    "fit_optimal",
    "fit_samples",
    "fit_terms",
    "statistics_table",
]
