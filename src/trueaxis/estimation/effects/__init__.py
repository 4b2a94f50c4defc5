"""Effects of a machine as unknowns: their signatures in the readings, and where the fit of them starts."""
