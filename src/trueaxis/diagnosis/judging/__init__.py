"""What may be said of what was found: names, stale values, instruments, wrong runs, the gain; see judgement."""
