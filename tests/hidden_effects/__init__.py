"""Measured data that hide effects, from a generator that shares nothing with the package, and a campaign over them.

    from tests.hidden_effects.case import Case, generate
    from tests.hidden_effects.design import Design
    from tests.hidden_effects.hidden import Hidden

    case = Case(seed=7, effects=(Hidden("backlash", "EXX", size=0.002),), noise="realistic", given="identified")
    data = generate(case)        # arrays: data.reading (n,) mm, data.state.positions, .directions, .time ...
    data.write(Path("folder"))   # machine.toml, errors.json, data/setup.toml, data/readings.csv

`Case.machine`: a name of `machines.MACHINES`; `Case.design`: see `design.Design`; sizes are in mm, rad, s as the
library of effects has them. Kinds of effects are those of `hidden.KINDS` and, outside the library, `outside.KINDS`;
kinds of noise those of `noise.KINDS`. The same case always gives the same data.
"""
