"""What the names of the sections on chain, tool point, motion and compensation stand for, by `NumericChain`."""

import re
from typing import Any

import numpy as np

from tests.page.numeric_chain import Matrix, NumericChain
from tests.page.rows import Row

Names = dict[str, Any]
AXES = "xyz"
PARTS = ("p", "pe", "s", "se")


def column(*values: float) -> Matrix:
    return np.array(values, dtype=float).reshape(-1, 1)


def symbol_names(chain: NumericChain, values: dict[str, float]) -> Names:
    """Positions, errors, dimensions as the page writes them, with the index h and without."""
    names: Names = {}
    for axis in chain.axes:
        names[axis.lower()] = names[f"{axis.lower()}_h"] = values[axis.lower()]
    for component in chain.components:
        direction = "XYZABC".index(component[1])
        letter = r"\delta" if direction < 3 else r"\varepsilon"
        for position in (component[2].lower(), f"{component[2].lower()}_h"):
            names[f"{letter}_{AXES[direction % 3]}({position})"] = values[component]
    for name in (*chain.dimensions, *chain.located):
        names[name.replace("eps_", r"\varepsilon_") if "_" in name else rf"\mathrm{name}"] = values[name]
    return names


class ChainNames:
    """Names by section; `at` random values of everything."""

    def __init__(self, chain: NumericChain, seed: int = 3) -> None:
        self.chain, self.values = chain, chain.drawn(seed)
        rng = np.random.default_rng(seed + 1)
        self.point, self.ball, self.work_point = (column(*rng.uniform(0.3, 1.7, 3), 1) for _ in range(3))
        self.base = symbol_names(chain, self.values)
        for letter, point in (("r_", self.point), ("r_T", self.point), ("r_W", self.work_point)):
            self.base |= {f"{letter}{a}": float(point[i, 0]) for i, a in enumerate(AXES)}
        self.factors = {
            f"[S{chain.bodies[b]['lower']}{b}]_{part}": rng.uniform(-1, 1, (4, 4))
            for b in chain.bodies
            for part in PARTS
        } | {f"[SIJ]_{part}": rng.uniform(-1, 1, (4, 4)) for part in PARTS}
        self.steps = self._step_names()
        self.tool_point = self._tool_point_names()

    def of(self, row: Row) -> Names:
        """The names of a row."""
        if row.section == "The chain":
            return self._of_chain(row)
        if row.section.startswith("The tool point"):
            return self.base | self.tool_point | _error_factor()
        if row.section == "Ball bar":
            return self._ball_bar()
        if row.section == "Motion equations":
            return self.base | self._motion(row.title)
        if row.section == "Compensation":
            return self.base | self._compensation()
        raise KeyError(f"no section {row.section}")

    def _of_chain(self, row: Row) -> Names:
        if row.text.startswith("[SIJ]"):
            return self.factors | {"[SIJ]": self._product(["[SIJ]"])}
        if row.text.startswith(("[SBW]", "[SBT]")):
            ends = (("[SBW]", "workpiece"), ("[SBT]", "tool"))
            return self.factors | {name: self._product(self._joints(end)) for name, end in ends}
        if " on body " in row.title:
            return self.base | self._joint_names()
        return self.base | self.steps | _error_factor()

    def _joints(self, end: str) -> list[str]:
        return [f"[S{self.chain.bodies[b]['lower']}{b}]" for b in self.chain.branch(self.chain.ends[end])]

    def _product(self, joints: list[str]) -> Matrix:
        result = np.eye(4)
        for joint in joints:
            for part in PARTS:
                result = result @ self.factors[f"{joint}_{part}"]
        return result

    def _joint_names(self) -> Names:
        names: Names = {}
        for number, body in self.chain.bodies.items():
            joint = f"[S{body['lower']}{number}]"
            product = np.eye(4)
            for part, matrix in self.chain.factors(number, self.values, 1).items():
                names[f"{joint}_{part}"] = matrix.real
                product = product @ matrix.real
            names |= {joint: product} | elements(joint + "_", product)
        return names

    def _step_names(self) -> Names:
        names: Names = {}
        for number in self.chain.bodies:
            ideal, first = self.chain.pair(number, self.values)
            twist = first @ np.linalg.inv(ideal)
            names |= {f"[SB{number}]_0": ideal} | elements(f"[SB{number}]_0", ideal) | _twist(str(number), twist)
            names |= {rf"\Theta_{number}": _rotation(twist), f"D_{number}": twist[:3, 3]}
            if number == self.chain.ends["tool"]:
                names |= {"[SBk]": ideal + first, "[SBk]_0": ideal} | _twist("k", twist)
        return names

    def _tool_point_names(self) -> Names:
        chain, values = self.chain, self.values
        ends = {name: chain.ends[name] for name in ("workpiece", "tool")}
        names: Names = {
            name: chain.to_bed(ends[end], values, 1).real for name, end in (("[SBW]", "workpiece"), ("[SBT]", "tool"))
        }
        (work, work_first), (tool, tool_first) = (chain.pair(ends[end], values) for end in ("workpiece", "tool"))
        relative = np.linalg.inv(work) @ tool
        twist = tool_first @ np.linalg.inv(tool) - work_first @ np.linalg.inv(work)
        ideal, deviation = chain.seen(values, self.point)
        exact = np.linalg.solve(names["[SBW]"], names["[SBT]"] @ self.point)
        names |= {"P_T": self.point, "P_T^W": exact, "M": relative} | elements("M_", relative)
        names |= {"[SBW]_0": work, "[SBT]_0": tool, "P": tool @ self.point}
        names |= {r"\Theta": _rotation(twist), "D": twist[:3, 3]}
        names |= {name: vector for name, vector in self.steps.items() if re.fullmatch(r"(\\Theta|D)_\d+", name)}
        names |= _vector("P_", tool @ self.point) | _twist("", twist)
        names |= (
            {"R_W": work[:3, :3], "d": deviation[:3, 0]}
            | _vector("d_", deviation)
            | _vector("P^W_T", ideal + deviation)
        )
        return names

    def _ball_bar(self) -> Names:
        seen = self.tool_point["P_T^W"]
        vector = seen - self.ball
        length = float(np.linalg.norm(vector[:3]))
        error = length - 0.7
        names = {"P_T^W": seen, "P_W": self.ball, "P_E": vector, "l_1": 0.7, "E": error, "E_v": error * vector / length}
        names |= {f"{a}_w": float(self.ball[i, 0]) for i, a in enumerate(AXES)}
        return names | _vector("P_E", vector) | _vector("E_", error * vector / length)

    def _motion(self, title: str) -> Names:
        moves = "".join(re.findall(r"\b[XYZABC]\b", title.split(":", maxsplit=1)[0]))
        points = {"workpiece": self.work_point, "tool": self.point}
        ends = {end: points[end] for end in ("workpiece", "tool") if end in title}
        ideal, first = self.chain.displacement(moves, ends, self.values)
        return _vector(r"\Delta", ideal + first)

    def _compensation(self) -> Names:
        """Moves whose ideal effect on the tool point is d: the Jacobian of the ideal chain by central differences."""
        linear = [axis.lower() for axis in self.chain.axes if axis in "XYZ"]
        still = {**self.values, **dict.fromkeys(self.chain.components + self.chain.located, 0.0)}
        columns = []
        for axis in linear:
            ahead, back = (self.chain.seen({**still, axis: still[axis] + h}, self.point)[0] for h in (0.5, -0.5))
            columns.append((ahead - back)[:3, 0])  # positions enter linearly
        moves = np.array([0.4, -1.3, 0.8])
        effect = np.array(columns).T @ moves
        names: Names = {rf"\Delta{axis}": moves[i] for i, axis in enumerate(linear)}
        return names | {f"d_{a}": effect[i] for i, a in enumerate(AXES)}


def _error_factor() -> Names:
    """Twist that an error factor behind a pose adds in the bed frame: S N S^-1, by matrices."""
    rng = np.random.default_rng(11)
    pose, small = np.eye(4), np.zeros((4, 4))
    pose[:3, :3], pose[:3, 3] = np.linalg.qr(rng.uniform(-1, 1, (3, 3)))[0], rng.uniform(0.3, 1.7, 3)
    pose[:3, :3] *= np.linalg.det(pose[:3, :3])
    about, displacement = rng.uniform(0.3, 1.7, (2, 3))
    small[:3, :3], small[:3, 3] = np.cross(about, np.eye(3)).T, displacement
    added = pose @ small @ np.linalg.inv(pose)
    names: Names = {"R": pose[:3, :3], "p": pose[:3, 3], r"\varepsilon": about, r"\delta": displacement}
    return names | {r"\Delta\Theta": _rotation(added), r"\DeltaD": added[:3, 3]}


def elements(head: str, matrix: Matrix) -> Names:
    return {f"{head}{i + 1}{j + 1}": matrix[i, j] for i in range(3) for j in range(4)}


def _vector(head: str, vector: Matrix) -> Names:
    return {f"{head}{a}": float(np.ravel(vector)[i]) for i, a in enumerate(AXES)}


def _rotation(twist: Matrix) -> Matrix:
    return np.array([twist[2, 1], twist[0, 2], twist[1, 0]])


def _twist(label: str, twist: Matrix) -> Names:
    label = f"_{label}"
    theta = _rotation(twist)
    names = {rf"\Theta{label}{a}": theta[i] for i, a in enumerate(AXES)}
    return names | {f"D{label}{a}": twist[i, 3] for i, a in enumerate(AXES)}
