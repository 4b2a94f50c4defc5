"""Where the templates of everything written lie."""

from pathlib import Path


def template_folders() -> list[Path]:
    """Templates of the installed package, or of the repository beside `src`. Raises FileNotFoundError where neither has
    any.
    """
    package = Path(__file__).resolve().parent
    folders = [package / "templates", package.parent.parent / "templates"]
    found = [folder for folder in folders if folder.is_dir()]
    if not found:
        raise FileNotFoundError(f"{folders[0]}: no templates, so this copy is not complete; install trueaxis again")
    return found
