"""Run what was emitted: kernels, error values, machine models. Nothing here knows SymPy."""
