"""The search for causes: candidates, their signatures, and what explains the readings about as well; see search."""
