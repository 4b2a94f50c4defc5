"""Runs a tutorial as a reader does: writes its files, types its commands, executes its Python, in their order.

A block with a title (```toml title="mill.toml") is a file. In a block `console` lines behind `$ ` are commands of
trueaxis, what follows is what they print, parts of it between lines of dots; `# exit code 1` stands where it is not 0.
"""

import contextlib
import io
import re
import shlex
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from trueaxis.cli.main import main

# Printed figures agree to this: their last digits depend on the linear algebra of the processor.
RELATIVE = 0.02
NOTHING = 1e-5  # um or urad: a figure below is what rounding leaves of zero
_BLOCK = re.compile(r'^```(\w+)(?: title="([^"]+)")?\n(.*?)^```$', re.M | re.S)
_NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
_EXIT = "# exit code "


@dataclass(frozen=True)
class Command:
    """One command of a page. printed: parts of what it prints, each a run of lines."""

    words: tuple[str, ...]
    code: int
    printed: tuple[tuple[str, ...], ...]


def run(page: str, folder: Path) -> int:
    """Run a page in a folder, which must be the current one. Returns how many commands and blocks of Python ran.

    Raises AssertionError where a command ends otherwise, or prints otherwise, than the page says.
    """
    names: dict[str, object] = {}
    done = 0
    for language, title, text in _BLOCK.findall(page):
        if title:
            (folder / title).write_text(text, encoding="utf-8")
        elif language == "console":
            for command in commands(text):
                check(command)
                done += 1
        elif language == "python":
            exec(compile(text, "tutorial", "exec"), names)
            done += 1
    return done


def commands(text: str) -> Iterator[Command]:
    """The commands of a block `console`."""
    for one in re.split(r"^\$ ", text.replace("\\\n", " "), flags=re.M)[1:]:
        line, _, rest = one.partition("\n")
        lines = rest.splitlines()
        codes = [int(each.removeprefix(_EXIT)) for each in lines if each.startswith(_EXIT)]
        shown = "\n".join(each for each in lines if not each.startswith(_EXIT))
        parts = (tuple(part.splitlines()) for part in re.split(r"^\.\.\.$", shown, flags=re.M))
        yield Command(
            tuple(shlex.split(line)), codes[0] if codes else 0, tuple(part for part in map(_dense, parts) if part)
        )


def check(command: Command) -> None:
    """Run a command and hold it to what the page says of it."""
    assert command.words[0] == "trueaxis", command.words
    out = io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out):
        code = main(command.words[1:])
    assert code == command.code, f"{shlex.join(command.words)} ended with {code}:\n{out.getvalue()}"
    lines, start = _dense(tuple(out.getvalue().splitlines())), 0
    for part in command.printed:
        places = [at for at in range(start, len(lines)) if alike(lines[at : at + len(part)], part)]
        assert places, f"{shlex.join(command.words)} does not print\n" + "\n".join(part) + "\nbut\n" + out.getvalue()
        start = places[0] + len(part)


def alike(printed: tuple[str, ...], shown: tuple[str, ...]) -> bool:
    """Whether lines are the same but for white space and the last digits of numbers."""
    words, numbers = zip(
        *((_worded(" ".join(lines)), _numbers(" ".join(lines))) for lines in (printed, shown)), strict=True
    )
    if words[0] != words[1] or len(printed) != len(shown):
        return False
    return all(abs(a - b) <= max(RELATIVE * abs(b), NOTHING) for a, b in zip(*numbers, strict=True))


def _dense(lines: tuple[str, ...]) -> tuple[str, ...]:
    return tuple(line for line in lines if line.strip())


def _worded(text: str) -> str:
    return " ".join(_NUMBER.sub("#", text).split())


def _numbers(text: str) -> list[float]:
    return [float(one) for one in _NUMBER.findall(text)]
