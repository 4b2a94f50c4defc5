"""Identification the paper's way: point by point, step by step (Sects. 3.2-3.6)."""
