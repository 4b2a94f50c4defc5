"""Effects: terms that a machine spec may add to component errors and readings, and the library of their kinds."""
