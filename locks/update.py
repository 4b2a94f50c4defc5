"""Write the lock files anew: names, versions and hashes of everything installed, from pyproject.toml.

Needs pip-tools: `pip install pip-tools`, then `python locks/update.py`.
"""

import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

HERE = Path(__file__).parent
GROUPS = {"run.txt": ["build"], "dev.txt": ["build", "test", "lint", "docs"]}
EXTRAS: dict[str, list[str]] = {"run.txt": [], "dev.txt": ["cluster", "completion"]}  # what tests need beside
# The lock names no index: whoever installs from it brings their own. Extras are pinned, too: pip before 23.3 takes the
# newest release of "optype[numpy]" where the lock has "optype" alone, and then refuses it for want of a hash.
OPTIONS = "--generate-hashes --no-header --no-annotate --no-strip-extras --allow-unsafe --no-emit-index-url"
OPTIONS += " --no-emit-trusted-host --no-emit-find-links"


def main() -> None:
    """Compile each lock."""
    project = tomllib.loads((HERE.parent / "pyproject.toml").read_text())
    for name, groups in GROUPS.items():
        extras = [r for e in EXTRAS[name] for r in project["project"]["optional-dependencies"][e]]
        grouped = [r for g in groups for r in project["dependency-groups"][g]]
        wanted = project["project"]["dependencies"] + extras + grouped
        with tempfile.TemporaryDirectory() as folder:
            source = Path(folder) / "requirements.in"
            source.write_text("\n".join(wanted) + "\n")
            command = [sys.executable, "-m", "piptools", "compile", "--quiet", *OPTIONS.split()]
            subprocess.run([*command, "--output-file", str(HERE / name), str(source)], check=True)


if __name__ == "__main__":
    main()
