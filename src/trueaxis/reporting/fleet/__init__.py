"""A fleet for people: the page and the text of the command."""
