"""JSON Schemas of the files that people write and programs read, for editors.

A schema says of a file what can be said without the machine: keys, types, ranges, words. The readers say the rest, and
their verdict counts; limits and words come from them, and a test holds both together.
"""
