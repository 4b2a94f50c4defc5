"""Sentences that people see. Nothing that computes imports from here."""
