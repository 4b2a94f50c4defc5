"""The whole job on the paper's machine: derive, simulate, identify, fit, compensate, and show what it gained."""
