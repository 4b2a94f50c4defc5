"""The Jinja2 environment of everything emitted: strict, with layout kept as written."""

from functools import cache

import jinja2

from trueaxis.template_folders import template_folders


@cache
def environment() -> jinja2.Environment:
    """Templates of the installed package, or of the repository beside `src`."""
    return jinja2.Environment(
        loader=jinja2.FileSystemLoader(template_folders()),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,  # code and Markdown are written, never HTML
    )
