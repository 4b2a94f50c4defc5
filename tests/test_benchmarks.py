"""Benchmarks that take the package apart by the names of its modules still find them."""

from importlib import import_module

from benchmarks.diagnose import STAGES


def test_every_stage_of_the_diagnosis_is_a_function_where_the_benchmark_looks_for_it() -> None:
    missing = [(home, name) for home, name, _ in STAGES if not hasattr(import_module(f"trueaxis.{home}"), name)]
    assert missing == []
