"""What a diagnosis makes of worlds that hide something: drawn, sized, put before it, graded and counted.

    python -m tests.worlds.diagnosis --out DIR --first SEED --worlds N --cases K     # goes on where it stopped
    python -m tests.worlds.diagnosis --out DIR --table                               # what is there, as Markdown
    python -m tests.worlds.diagnosis --out DIR --failures                            # each failure and its world

`cases` draws what is hidden in a case; `limits` says from what size on readings can show it, apart from the package, by
the true noise; `library` holds the forms that a rival may take; `values` makes the given values; `answers` puts the
files before the diagnosis; `lines` grades one case; `tables` counts.
"""
