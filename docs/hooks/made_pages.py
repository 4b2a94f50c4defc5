"""Pages of the reference that are made when the site is built: commands from their parsers, Python from docstrings."""

import argparse
import inspect
import re

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files

import trueaxis
from trueaxis.cli.main import VERBOSITY, build_parser

_WIDTH = 80  # of usage lines
_EVERYWHERE = frozenset((*VERBOSITY, "-h", "--help"))  # options that every command has: said once


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Add the pages."""
    files.append(File.generated(config, "reference/commands.md", content=commands_page()))
    files.append(File.generated(config, "reference/python.md", content=python_page()))
    return files


def commands_page() -> str:
    """Every command with its usage, arguments and options, as its parser has them."""
    parser = build_parser()
    (commands,) = (action for action in parser._actions if isinstance(action, argparse._SubParsersAction))
    shared = option_table(parser, leaving_out=frozenset())
    parts = [
        "# Commands",
        escaped(parser.description),
        "Options of the program; `-v` and `-q` stand before or behind the name of any command:",
        *shared,
    ]
    for name, command in commands.choices.items():
        parts += [f"## trueaxis {name}", *command_section(command)]
    parts += ["## Exit codes", escaped((parser.epilog or "").partition("Exit codes: ")[2].capitalize())]
    return "\n\n".join(parts) + "\n"


def command_section(command: argparse.ArgumentParser) -> list[str]:
    """Description, usage and options of one command."""
    return [
        escaped(command.description),
        f"```text\n{usage(command)}\n```",
        *option_table(command),
        escaped(command.epilog),
    ]


def usage(command: argparse.ArgumentParser) -> str:
    """The usage line, broken at the width of the site."""
    command.formatter_class = lambda prog: argparse.HelpFormatter(prog, width=_WIDTH)
    return command.format_usage().removeprefix("usage: ").rstrip()


def option_table(parser: argparse.ArgumentParser, leaving_out: frozenset[str] = _EVERYWHERE) -> list[str]:
    """Arguments and options as a table; leaving_out: options that stand elsewhere."""
    rows = []
    formatter = argparse.HelpFormatter(parser.prog)
    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction) or action.help == argparse.SUPPRESS:
            continue
        if leaving_out.intersection(action.option_strings):
            continue
        names = formatter._format_action_invocation(action).replace("|", "\\|")
        meaning = escaped(formatter._expand_help(action)) if action.help else ""
        rows.append(f"| `{names}` | {meaning} |")
    return ["\n".join(["| argument or option | meaning |", "|---|---|", *rows])] if rows else []


def escaped(text: str | None) -> str:
    """Text of a help page that Markdown leaves as it is, on one line a paragraph."""
    paragraphs = re.split(r"\n\s*\n", (text or "").strip())
    return "\n\n".join(re.sub(r"([\\`*_{}\[\]<>|$])", r"\\\1", " ".join(one.split())) for one in paragraphs)


def python_page() -> str:
    """The public interface: functions, then the records they give and take, then what they raise."""
    public = {name: getattr(trueaxis, name) for name in trueaxis.__all__}
    functions = [name for name, value in public.items() if inspect.isfunction(value)]
    raised = [name for name, value in public.items() if inspect.isclass(value) and issubclass(value, Exception)]
    records = [name for name in public if name not in functions and name not in raised]
    parts = ["# Python", "`import trueaxis` gives these names ([how they go together](../python.md))."]
    for title, names in (("Functions", functions), ("Records", records), ("Exceptions", raised)):
        parts += [f"## {title}", *(f"::: {public[name].__module__}.{name}" for name in names)]
    return "\n\n".join(parts) + "\n"
