"""A diagnosis for people and programs: one HTML file, diagnosis.json, and a few lines for the console."""
