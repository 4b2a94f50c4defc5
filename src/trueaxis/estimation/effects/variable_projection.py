"""Amplitudes at every point of a grid, all other unknowns projected out (G. H. Golub and V. Pereyra, 1973)."""

import numpy as np

from trueaxis.measurement.machine import FloatArray

UNOBSERVABLE = 1e-9  # share of a squared signature that the other unknowns leave


def explained(
    gram: FloatArray, right: FloatArray, whole: FloatArray, *, one_sided: bool
) -> tuple[FloatArray, FloatArray]:
    """(points,) sums of squares that least squares explains, and (points, k) the amplitudes.

    gram, right: (points, k, k) and (points, k), signatures times one another and times what is to be explained, others
    projected out; whole: (points,), their squares before that. one_sided: an amplitude below zero explains nothing.
    """
    values, vectors = np.linalg.eigh(gram)
    kept = values > UNOBSERVABLE * whole[:, np.newaxis]
    turned = np.einsum("pij,pi->pj", vectors, right)
    scaled = np.divide(turned, values, out=np.zeros_like(turned), where=kept)
    amplitudes = np.einsum("pij,pj->pi", vectors, scaled)
    squares = np.sum(np.where(kept, turned * scaled, 0.0), axis=1)
    if one_sided:
        squares = np.where((amplitudes > 0.0).all(axis=1), squares, 0.0)
    return squares, amplitudes
