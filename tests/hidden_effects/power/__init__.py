"""How often a diagnosis of data with hidden effects is right: trials, grades, tallies."""
