"""The Jinja2 environment of everything emitted: strict, with layout kept as written."""

from pathlib import Path

import jinja2


def environment() -> jinja2.Environment:
    """Templates of the installed package, or of the repository beside `src`."""
    package = Path(__file__).resolve().parent.parent
    folders = [package / "templates", package.parent.parent / "templates"]
    return jinja2.Environment(
        loader=jinja2.FileSystemLoader([folder for folder in folders if folder.is_dir()]),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,  # code and Markdown are written, never HTML
    )
