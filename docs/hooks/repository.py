"""Files outside docs/ that pages of the site link to: README, equations, machine specs, modules.

In the repository a link is a path; on the site the same link leads to the page that is made of that file. A folder is
a list of its files. So no page is written twice, and every link that works in the repository works on the site.
"""

import json
import posixpath
import re
from pathlib import Path

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files
from mkdocs.structure.pages import Page

ROOT = Path(__file__).resolve().parents[2]
# Markdown outside docs/ -> its place on the site.
PAGES = {"README.md": "index.md"} | {
    path: path
    for path in (
        "CHANGELOG.md",
        "CONTRIBUTING.md",
        "benchmarks/README.md",
        "generated/cframe_mill/equations.md",
        "generated/dmu60p/equations.md",
        "generated/dmu60p_5axis/equations.md",
        "generated/headhead_mill/equations.md",
    )
}
_SOURCES = {uri: path for path, uri in PAGES.items()}
SHOWN = "repository"  # where files are shown that are no Markdown
LANGUAGES = {".py": "python", ".toml": "toml", ".c": "c", ".h": "c", ".json": "json", ".cff": "yaml", ".yml": "yaml"}
_LINK = re.compile(r"(?<=\]\()([^)\s#:]+)(?=[)#])")


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Add the pages outside docs/, and a page for every other file or folder that some page links to."""
    for source, uri in PAGES.items():
        files.append(File.generated(config, uri, abs_src_path=str(ROOT / source)))
    texts = {file.src_uri: file.content_string for file in files.documentation_pages()}
    wanted = {target for uri, text in texts.items() for target in targets(text, uri)}
    for target in sorted(wanted):
        uri = site_uri(target)
        if files.get_file_from_path(uri) is None:
            files.append(File.generated(config, uri, content=shown(target)))
    return files


def on_page_markdown(markdown: str, page: Page, config: MkDocsConfig, files: Files) -> str:
    """Links to files of the repository become links to their pages."""
    uri = page.file.src_uri
    if uri.startswith(f"{SHOWN}/"):
        return markdown
    here = repository_path(uri)

    def on_site(match: re.Match[str]) -> str:
        target = resolved(match[1], here)
        return posixpath.relpath(site_uri(target), posixpath.dirname(uri)) if target else match[1]

    return _LINK.sub(on_site, markdown)


def targets(text: str, uri: str) -> set[str]:
    """Files and folders of the repository that a page links to, but for what is a page or lies in docs/ already."""
    if uri.startswith(f"{SHOWN}/"):
        return set()
    found = {resolved(link, repository_path(uri)) for link in _LINK.findall(text)}
    return {one for one in found if one and site_uri(one).startswith(f"{SHOWN}/")}


def resolved(link: str, page: str) -> str | None:
    """The file or folder that a link of a page leads to, both as paths in the repository; None where there is none."""
    target = posixpath.normpath(posixpath.join(posixpath.dirname(page), link))
    return target if not target.startswith("..") and (ROOT / target).exists() else None


def repository_path(uri: str) -> str:
    """Where the source of a page lies."""
    return _SOURCES.get(uri, f"docs/{uri}")


def site_uri(path: str) -> str:
    """The source URI on the site of a file or folder of the repository."""
    if path in PAGES:
        return PAGES[path]
    if path.startswith("docs/") and not path.endswith(".ipynb") and (ROOT / path).is_file():
        return path.removeprefix("docs/")
    return f"{SHOWN}/{path}.md"


def shown(path: str) -> str:
    """The page of a file or of a folder."""
    whole = ROOT / path
    if whole.is_dir():
        names = sorted(
            f"{one.name}/" if one.is_dir() else one.name for one in whole.iterdir() if one.name[0] not in "._"
        )
        return f"# {path}/\n\nA folder of the repository:\n\n" + "".join(f"- `{name}`\n" for name in names)
    text = whole.read_text(encoding="utf-8")
    if whole.suffix == ".ipynb":
        return notebook(text)
    fence = "`" * 6
    return f"# {path}\n\n{fence}{LANGUAGES.get(whole.suffix, 'text')}\n{text}\n{fence}\n"


def notebook(text: str) -> str:
    """The cells of a notebook, which is kept without outputs."""
    cells = [(cell["cell_type"], "".join(cell["source"])) for cell in json.loads(text)["cells"]]
    return "\n\n".join(source if kind == "markdown" else f"```python\n{source}\n```" for kind, source in cells) + "\n"
