"""Where the templates of everything written lie."""

from pathlib import Path


def template_folders() -> list[Path]:
    """Templates of the installed package, or of the repository beside `src`."""
    package = Path(__file__).resolve().parent
    folders = [package / "templates", package.parent.parent / "templates"]
    return [folder for folder in folders if folder.is_dir()]
