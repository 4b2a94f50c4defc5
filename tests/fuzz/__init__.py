"""A fuzzing campaign over all readers: `python -m tests.fuzz --minutes 10`.

`readers` lists what is fuzzed, `seeds` makes valid files for a machine, `mutate` and `expressions` make hostile ones of
them, `judge` says what a reader and a command may do with those, `campaign` runs them in a process that is watched.
"""
