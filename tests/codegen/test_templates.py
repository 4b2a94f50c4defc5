"""A template uses exactly the variables that it is given: no more, and none for nothing."""

from collections.abc import Callable
from typing import Any

import jinja2
import pytest
from jinja2 import meta

from tests.derivation.test_routine import models
from trueaxis.codegen.equations import equations_page
from trueaxis.codegen.numpy_source import numpy_source
from trueaxis.codegen.templates import environment

MODEL = "five_axis"


def given(monkeypatch: pytest.MonkeyPatch, emit: Callable[[], object]) -> dict[str, set[str]]:
    """Template -> names of the variables that an emitter renders it with."""
    found: dict[str, set[str]] = {}
    render = jinja2.Template.render

    def noting(template: jinja2.Template, *args: Any, **variables: Any) -> str:
        found[str(template.name)] = set(dict(*args, **variables))
        return render(template, *args, **variables)

    monkeypatch.setattr(jinja2.Template, "render", noting)
    emit()
    return found


EMITTERS: dict[str, Callable[[], object]] = {
    "kernels.py.j2": lambda: numpy_source(models()[MODEL].machine, models()[MODEL].routines),
    "equations.md.j2": lambda: equations_page(models()[MODEL]),
}


PARTS = {"equations.md.j2": ("systems.md.j2", "paper.md.j2")}
"""What a template includes."""
MACROS = {"aligned"}


@pytest.mark.parametrize("name", EMITTERS)
def test_a_template_is_given_what_it_uses(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    env = environment()
    assert env.loader is not None
    sources = [env.loader.get_source(env, each)[0] for each in (name, *PARTS.get(name, ()))]
    used = set().union(*(meta.find_undeclared_variables(env.parse(source)) for source in sources)) - MACROS
    assert given(monkeypatch, EMITTERS[name])[name] == used  # a page runs kernels, too, which have their own template


def test_an_unknown_variable_is_an_error_and_not_an_empty_text() -> None:
    with pytest.raises(jinja2.UndefinedError):
        environment().from_string("{{ nothing }}").render()


C_TEMPLATES = {f"{name}.{end}.j2" for name in ("kernels", "control") for end in "ch"}  # see test_c_source
# of a diagnosis, of error values, of a fleet; the style of the latter two
PAGES = ("report.html.j2", "certificate.html.j2", "fleet.html.j2", "page_style.css.j2")


def test_every_template_is_used() -> None:
    parts = {part for each in PARTS.values() for part in each}
    assert set(environment().list_templates()) == {*EMITTERS, *parts, *C_TEMPLATES, *PAGES}
