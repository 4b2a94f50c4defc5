"""From derived records to files: NumPy and C kernels, readable equations, a manifest."""
