"""The distribution of tool point errors by draws (GUM Supplement 1): posterior of the values, noise, context."""
