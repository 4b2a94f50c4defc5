"""Pictures for people: curves with fits, error maps, polar plots. Same input, same bytes."""
