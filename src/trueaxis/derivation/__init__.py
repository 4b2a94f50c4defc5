"""Symbolic derivation (SymPy): from a machine to its error model, motion equations and identification systems."""
