"""Writes readings.csv beside itself: the fixed data set of the polynomial fits.

position_mm: 0 to 540 in steps of 20, the 28 positions that the paper's printed t tests imply
(docs/errata/statistics.md). drawn_urad: Eq. (52) plus normal noise of the printed residual standard error,
0.2717 urad. u_urad: standard uncertainties for the weighted fit of the same values. implied_urad: Eq. (49)
plus residuals outside the powers 1 to 7, of the size that the printed t tests of Eq. (50) imply, so that
every statistic of every polynomial of these powers is that of the paper's own data, which are not published.
walk_urad: a random walk from 0 in steps of 1 urad on which R's step leaves a term out and takes it in again.
"""

import csv
from pathlib import Path

import numpy as np

EQ49 = {
    1: 1.16302e-1, 2: -1.43581e-3, 3: 8.16363e-6, 4: -2.21082e-8, 5: 2.76963e-11, 6: -1.15323e-14, 7: -2.13978e-18,
}  # fmt: skip
EQ52 = {1: 8.22104e-2, 2: -6.40509e-4, 3: 1.87087e-6, 5: -7.44546e-12, 6: 7.93764e-15}


def main() -> None:
    x = np.arange(0.0, 541.0, 20.0)
    random = np.random.default_rng(52)
    drawn = sum(a * x**k for k, a in EQ52.items()) + random.normal(0.0, 0.2717, x.size)
    u = np.round(0.2 + 0.3 * x / 540.0, 3)
    basis, _ = np.linalg.qr(np.column_stack([(x / 540.0) ** k for k in range(1, 8)])[1:])
    outside = random.normal(size=x.size - 1)
    for _ in range(2):
        outside -= basis @ (basis.T @ outside)
    outside *= 0.43853 * np.sqrt(21.0) / np.linalg.norm(outside)
    implied = sum(a * x**k for k, a in EQ49.items()) + np.append(0.0, outside)  # zero at home by definition
    walk = np.random.default_rng(1746).normal(size=x.size).cumsum()
    walk -= walk[0]
    with Path(__file__).with_name("readings.csv").open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["position_mm", "drawn_urad", "u_urad", "implied_urad", "walk_urad"])
        for position, *row in zip(x, drawn, u, implied, walk, strict=True):
            writer.writerow([f"{position:g}", *(repr(float(value)) for value in row)])


if __name__ == "__main__":
    main()
