"""What readings would be without any cause: what recalibration could change, set-ups, and noise; see null."""
