"""Every formula of equations.md, read back from its LaTeX and worked out in numbers against an independent chain."""
