"""Worlds: random machines, measuring plans and shops, which share no code with the package that they judge.

    design = draw_design(seed)                        # design.py: machine, plan, shop, ingredients
    truth = draw_machine(design.machine, seed)        # truth.py: curves, location errors; truth.deviation(...)
    data = measure(design, truth, seed)               # readings.py: exact readings and what the shop makes of them
    write_world(folder, design, truth, data)          # files.py: machine.toml, errors.json, data/
    fit = oracle(design).fit(truth.sizes, data.reading)    # oracle.py: the fit that knows noise, spreads and sizes

A design serves any number of machines: `measure_all` takes many at once, `design.jacobian` is the linear map from
errors to readings, made from generator matrices. `truth.hiding(Effect(...))` hides effects (effects.py); stale.py makes
given values that are no longer true.

    python -m tests.worlds SEED --out DIR             # one world as files
    python -m tests.worlds SEED --out DIR --angles    # with angle runs beside (angles.py); the rest stays as it is
    python -m tests.worlds --table N                  # designs 1 to N, their ingredients, the oracle's figures
    python -m tests.worlds --shares N                 # in how many designs each ingredient is
    python -m tests.worlds.campaign --out DIR         # the package's estimate on many designs and machines
    python -m tests.worlds.diagnosis --out DIR        # what the package's diagnosis makes of what they hide

Of the modules, `layouts`, `lines`, `circles`, `probing`, `schedule`, `shop` draw; `machine`, `plan` hold; `kinematics`,
`jacobian`, `readings`, `curves` compute. Lengths mm, angles rad, rotary positions deg, time s.
"""
