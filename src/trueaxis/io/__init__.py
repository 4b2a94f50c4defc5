"""Reading and writing files: faults with their places, whole files or none, what the terminal is told."""
