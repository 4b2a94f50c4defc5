"""Planning: what a set of runs can and cannot determine before any reading exists, and which runs would help."""
