"""Error values as a document: what they are, how certain, what they do over the volume, what has changed."""
