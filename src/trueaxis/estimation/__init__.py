"""The one estimator: what readings say about the unknowns of machine and instruments, and what they leave open."""
