"""Diagnose: where simulation and measurement differ beyond noise, why, and what an extended model gains.

procedure       from readings to verdict: every stage in its order
null_model      what readings would be without any cause: what recalibration could change, set-ups, noise
causes          every candidate, its signature, and the search for those that readings ask for
judging         which names stand, what is stale, which instruments and runs are wrong, what was gained
further_runs    what the readings could show of every candidate, and which further runs would tell more
write_up        the record of all that (result), from which reports are made
extend          the spec with the causes that it takes over (extended_spec), its values found anew
"""
