"""What readings could show of every candidate, and which further runs would tell more; see audit and next_runs."""
