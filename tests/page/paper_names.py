"""What the names of the paper's sections stand for, by the chain and the definitions of tests/paper."""

import re
from functools import cache
from typing import Any

import numpy as np
import sympy as sp

from tests.page.chain_names import AXES, PARTS, ChainNames, Names, column
from tests.page.latex_value import SAMPLES
from tests.page.numeric_chain import NumericChain
from tests.page.rows import Row
from tests.paper import chain as paper_chain
from tests.paper import reference
from tests.paper.claims_systems import SYSTEMS
from tests.paper.notation import DIRECTIONS, MOTION_ERRORS, POSITION, SQUARENESS, place, r, reading

RUNS = {n: run for run, numbers in (
    ("X", (12, 15, 18)), ("Y", (13, 16, 19)), ("Z", (14, 17, 20)),
    ("XZ", range(21, 27)), ("XY", range(27, 35)), ("YZ", range(35, 39)),
) for n in numbers}  # fmt: skip
LINES = {22: "XZ", 28: "XY", 36: "YZ"}
_B_ROWS = {25: ("1x", "2x", "1z", "2z"), 31: ("1x", "2x")}
_LETTERS = {"delta": r"\delta", "epsilon": r"\varepsilon"}


class PaperNames(ChainNames):
    """The names of the page of the paper's machine."""

    def __init__(self, chain: NumericChain, seed: int = 3) -> None:
        super().__init__(chain, seed)
        self.rng = np.random.default_rng(seed + 2)
        self.points: dict[str, float] = {}

    def of(self, row: Row) -> Names:
        if row.section.startswith("General motion"):
            if row.title.startswith("Table 3") or row.text[0] in "r[":
                return self._carriages()
            alone = re.match(r"P_\{([lk])h\} - P_\{\1", row.text) if r"\Delta" not in row.text[:8] else None
            return self._general(alone[1] if alone else "")
        if row.section.startswith("Sect. 3."):
            number = int(re.findall(r"\((\d+)\)", row.title)[0])
            if number in LINES:
                return self._line(LINES[number])
            return self._run(RUNS[number], number) if number in RUNS else self._squareness(number)
        return super().of(row)

    def _general(self, alone: str) -> Names:
        """Eqs. (7)-(11): factors any matrices, multiplied in the order of the bodies of Table 3.

        alone: l or k where the other point stands still.
        """
        rng = np.random.default_rng(5)
        names: Names = {f"[{j}]_{part}": rng.uniform(-1, 1, (4, 4)) for j in ("SIL", "SIJ", "SJK") for part in PARTS}
        names |= {"r_l": column(*rng.uniform(-1, 1, 3), 1), "r_k": column(*rng.uniform(-1, 1, 3), 1)}
        for point, joints in (("l", ("SIL",)), ("k", ("SIJ", "SJK"))):
            for pose, parts in (("h", PARTS), ("0", PARTS[:2])):
                at = np.eye(4)
                for joint in joints:
                    for part in parts:
                        at = at @ names[f"[{joint}]_{part}"]
                names[f"P_{point}{pose}"] = at @ names[f"r_{point}"]
        for still in set("lk") - {alone} if alone else ():
            names[f"P_{still}h"] = names[f"P_{still}0"]
        moved = {p: names[f"P_{p}h"] - names[f"P_{p}0"] for p in "lk"}
        return names | {r"\DeltaP": moved["l"] - moved["k"], "h": 0.0}

    def _carriages(self) -> Names:
        """Sect. 3.1: L, J and K are the carriages that move Y, X and Z; points of WCS and TCS stand on them."""
        by_axis = {body.get("moves"): number for number, body in self.chain.bodies.items()}
        joints = {"SIL": by_axis["Y"], "SIJ": by_axis["X"], "SJK": by_axis["Z"]}
        names = dict(self.base)
        for name, number in joints.items():
            factors = self.chain.factors(number, self.values, 1)
            lower = self.chain.bodies[number]["lower"]
            names |= {f"[{name}]_{part}": matrix.real for part, matrix in factors.items()}
            names[f"[{name}]"] = names[f"[S{lower}{number}]"] = self.factors[f"[S{lower}{number}]_s"]
        for end, q, letter, point in (("workpiece", "w", "l", self.work_point), ("tool", "T", "k", self.point)):
            home = self.chain.factors(self.chain.ends[end], self.values, 1)["p"].real
            names |= {f"r_{q.upper()}": point[:3, 0], f"r_{letter}": (home @ point)[:3, 0]}
            names[f"q_{q}"] = np.array([self.values[f"q_{q}{a}"] for a in AXES])
        return names

    @cache  # noqa: B019  one object per test session
    def _run(self, run: str, number: int) -> Names:
        """Errors, points and positions drawn; readings and displacements by the first order of tests/paper's chain."""
        values = self._symbols(run)
        names = self.base | {self._point_name(run, str(s)): v for s, v in values.items() if str(s).startswith("r_")}
        known = {**reference.readings(run), **reference.places(run)}
        numbers = _evaluated(tuple(known.items()), tuple(values), tuple(values.values()))
        names |= {str(symbol): value for symbol, value in zip(known, numbers, strict=True)}
        if number in _B_ROWS:
            unknowns = next(u for equation, _, _, u in SYSTEMS if f"({number})" in equation)
            free = {s: 0.0 if str(s) in unknowns else v for s, v in values.items()}
            for k, row in enumerate(_B_ROWS[number]):
                symbol = reading(row[0], row[1])
                (without,) = _evaluated(((symbol, known[symbol]),), tuple(free), tuple(free.values()))
                names[f"b_{k + 1}"] = names[str(symbol)] - without
        return names

    def _symbols(self, run: str) -> dict[sp.Symbol, float]:
        by_name = self.values
        values: dict[sp.Symbol, float] = {POSITION[a]: by_name[a] for a in DIRECTIONS}
        for error in MOTION_ERRORS:
            kind, direction, axis = re.fullmatch(r"(\w+)_(\w)\((\w)\)", str(error)).groups()  # type: ignore[union-attr]
            index = DIRECTIONS.index(direction) + (3 if kind == "epsilon" else 0)
            values[error] = by_name["E" + "XYZABC"[index] + axis.upper()]
        for error in SQUARENESS:
            values[error] = by_name[str(error).replace("epsilon", "eps")]
        names = {"l", "k", *(n for label in reference.RUN_LABELS[run] for n in reference.point_names(run, label) if n)}
        for name in sorted(names):
            for d in DIRECTIONS:
                page_name = self._point_name(run, str(r(name, d)))
                values[r(name, d)] = self.points.setdefault(page_name, float(self.rng.uniform(0.3, 1.7)))
        return values

    def _point_name(self, run: str, symbol: str) -> str:
        """Points of linkages with a number bear the linkage."""
        return f"r^{run}_{symbol[2:]}" if len(run) > 1 and re.search(r"\d", symbol) else symbol

    def _line(self, run: str) -> Names:
        theta, length, offset = 0.6, 1.3, 0.37
        drawn = {
            sp.Symbol("theta", real=True): theta,
            sp.Symbol("L_ih", real=True): length,
            sp.Symbol("delta_ih", real=True): offset,
        }
        names = {r"\theta": theta, "L_ih": length, r"\delta_ih": offset}
        for symbol, value in reference.line(run).items():
            if str(symbol).startswith("L_i"):
                names[str(symbol)] = float(value.xreplace(drawn))
        return names

    def _squareness(self, number: int) -> Names:
        if number == 39:
            return self._offsets()
        rng = np.random.default_rng(8)
        pairs = ("yx", "zx", "xy", "zy", "yz", "xz", "uv")
        c = {f"c_{pair}{k}": float(rng.uniform(0.1, 0.5)) for pair in pairs for k in (0, 1)}
        at = {"x": 0.7, "y": 1.1, "z": 1.4, "v": 0.9}
        fitted = {f"P'_{pair}": c[f"c_{pair}0"] + c[f"c_{pair}1"] * at[pair[1]] for pair in pairs}
        if number in (40, 42):
            return c | at | fitted
        if number == 41:
            v, p = rng.uniform(0, 1, (2, SAMPLES))
            slope, intercept = np.polyfit(v, p, 1)
            return {"n": SAMPLES, "c_uv0": intercept, "c_uv1": slope, "v_i": v, "P_uvi": p}
        lines = {
            "x": (1, c["c_yx1"], c["c_zx1"]),
            "y": (c["c_xy1"], 1, c["c_zy1"]),
            "z": (c["c_xz1"], c["c_yz1"], 1),
        }
        sine = {a + b: _cosine(lines[a], lines[b]) for a, b in ("xy", "xz", "yz")}
        # By Table 2 X'.Y' = eps_xy, X'.Z' = eps_xz, Y'.Z' = -eps_yz (reference.directions).
        return c | {
            rf"\varepsilon_{pair}": (-1 if pair == "yz" else 1) * np.arcsin(value) for pair, value in sine.items()
        }

    def _offsets(self) -> Names:
        rng = np.random.default_rng(9)
        names: Names = {}
        for n, axis in enumerate(AXES):
            at = np.concatenate([[0.0], np.sort(rng.uniform(0.2, 2, SAMPLES))])
            angles = rng.uniform(0.2, 1, (SAMPLES, 3))
            names |= {f"{axis}_i": at[1:], f"{axis}_i-1": at[:-1]}
            names |= {rf"\varepsilon_{d}({axis}_i)": angles[:, k] for k, d in enumerate(AXES)}
            steps = (np.cross(angles, np.eye(3)[n]).T * np.diff(at)).T[: SAMPLES - 1]  # up to position h
            names |= {f"P_{d}{axis}": float(steps[:, k].sum()) for k, d in enumerate(AXES) if d != axis}
        return names | {"h": SAMPLES - 1, "n": SAMPLES}


def _cosine(a: tuple[float, ...], b: tuple[float, ...]) -> float:
    return float(np.dot(a, b) / np.linalg.norm(a) / np.linalg.norm(b))


@cache
def _compiled(items: tuple[Any, ...], symbols: tuple[sp.Symbol, ...]) -> Any:
    return sp.lambdify(symbols, [value for _, value in items], "math")


def _evaluated(items: tuple[Any, ...], symbols: tuple[sp.Symbol, ...], values: tuple[float, ...]) -> list[float]:
    return [float(value) for value in _compiled(items, symbols)(*values)]


__all__ = ["PaperNames", "paper_chain", "place"]
