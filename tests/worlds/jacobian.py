"""The linear map from errors to readings at the ideal machine, from generator matrices."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from tests.worlds.kinematics import coordinates, sensitivities
from tests.worlds.machine import Array, Machine
from tests.worlds.plan import Plan, Run


@dataclass(frozen=True, eq=False)
class Jacobian:
    """Per row the change of the reading per unit of a component error where the axis stands (`here`) and where the run
    was zeroed (`home`), name -> (n,), and of a location error (`located`); positions of both, axis -> (n,); `ideal`:
    readings of the machine without errors, (n,), mm. For curves E and location errors l

        readings = ideal + sum(here[c] E_c(at) - home[c] E_c(at home)) + sum(located[l] l)
    """

    here: Mapping[str, Array]
    home: Mapping[str, Array]
    located: Mapping[str, Array]
    at: Mapping[str, Array]
    at_home: Mapping[str, Array]
    ideal: Array

    def columns(self, component: str, basis: Callable[[Array], Array]) -> Array:
        """(n, k): change of the readings per coefficient of a curve; basis: positions (n,) -> (n, k)."""
        axis = component[2]
        there = basis(self.at_home[axis])
        return self.here[component][:, None] * basis(self.at[axis]) - self.home[component][:, None] * there


def jacobian(machine: Machine, plan: Plan) -> Jacobian:
    count = plan.count
    here = {name: np.zeros(count) for name in machine.components}
    home = {name: np.zeros(count) for name in machine.components}
    located = {name: np.zeros(count) for name in machine.locations}
    at_home = {axis: values.copy() for axis, values in plan.positions.items()}
    ideal = np.zeros(count)
    for index, run in enumerate(plan.runs):
        rows = plan.rows(index)
        at = plan.at(rows)
        bar = _bar(machine, run, at) if run.length is not None else np.zeros((len(rows), 3))
        if run.length is not None:
            length = np.linalg.norm(bar, axis=1)
            ideal[rows] = length - run.length
            direction = bar / length[:, None]
        else:
            direction = np.broadcast_to(np.array(run.direction), (len(rows), 3))
        for name, change in _sensed(machine, run, at, direction).items():
            (here if name in here else located)[name][rows] = change
        if run.home is not None:
            zeroed = {axis: np.array([value]) for axis, value in run.home.items()}
            for name, change in _sensed(machine, run, zeroed, direction[:1]).items():
                if name in home:
                    home[name][rows] = change
                else:
                    located[name][rows] -= change
            for axis, value in run.home.items():
                at_home[axis][rows] = value
    return Jacobian(here, home, located, plan.positions, at_home, ideal)


def _sensed(machine: Machine, run: Run, at: Mapping[str, Array], direction: Array) -> dict[str, Array]:
    """Change of direction . (target - reference) per unit of each error, (n,)."""
    found: dict[str, Array] = {}
    for (on, point), sign in ((run.target, 1.0), (run.reference, -1.0)):
        if on != run.measuring_frame:
            for name, moved in sensitivities(machine, on, run.measuring_frame, at, np.array(point)).items():
                found[name] = found.get(name, 0.0) + sign * np.sum(direction * moved, axis=1)
    return found


def _bar(machine: Machine, run: Run, at: Mapping[str, Array]) -> Array:
    target = coordinates(machine, run.target[0], run.measuring_frame, at, np.array(run.target[1]), {}, {})
    return np.asarray(target - np.array(run.reference[1]), float)
