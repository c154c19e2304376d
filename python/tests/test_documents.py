"""The tutorial, the examples in docstrings, and the types say what is so."""

import ast
import doctest
import importlib.resources
import inspect
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import dq8
from dq8 import _core

PROJECT = Path(__file__).parents[1]


def functions():
    return [(name, f) for name, f in vars(_core).items() if inspect.isbuiltin(f)]


def stubs():
    source = importlib.resources.files(dq8).joinpath("_core.pyi").read_text()
    return {node.name: node for node in ast.parse(source).body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}


def test_the_tutorial_runs_and_plots(tmp_path):
    command = [sys.executable, PROJECT / "tutorial" / "tutorial.py", tmp_path]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    for name in ("between.png", "arm.png", "skin.png"):
        assert (tmp_path / name).read_bytes().startswith(b"\x89PNG")


def test_examples_in_docstrings_are_true():
    finder, runner = doctest.DocTestFinder(), doctest.DocTestRunner()
    named = {**vars(_core), "RigidTransform": dq8.RigidTransform}
    ran = 0
    with np.printoptions(legacy=False):
        for name, thing in named.items():
            if name.startswith("__") or not getattr(thing, "__doc__", None):
                continue
            for test in finder.find(thing, name, module=False, globs={}):
                ran += runner.run(test).attempted
    assert runner.failures == 0
    assert ran >= 8


@pytest.mark.parametrize(("name", "function"), functions())
def test_docstrings_say_shape_and_what_is_returned(name, function):
    doc = function.__doc__
    parameters = inspect.signature(function).parameters
    if "out" in parameters:
        assert "shape (" in doc
        assert "Returns" in doc
        for parameter in parameters:
            assert parameter in doc.split("Parameters")[1], parameter


def test_the_types_have_every_function_with_its_parameters():
    declared = stubs()
    for name, function in functions():
        node = declared.pop(name)
        arguments = node.args
        own = [a.arg for a in arguments.posonlyargs + arguments.args + arguments.kwonlyargs]
        assert own == list(inspect.signature(function).parameters), name
    assert list(declared) == ["Hierarchy", "Mechanism", "ReachReport"]
    for name, node in declared.items():
        methods = {node.name for node in node.body if isinstance(node, ast.FunctionDef)}
        for method in vars(getattr(dq8, name)):
            if not method.startswith("__"):
                assert method in methods, method


def test_the_package_is_typed():
    assert importlib.resources.files(dq8).joinpath("py.typed").is_file()


def test_all_names_are_there():
    for name in dq8.__all__:
        assert hasattr(dq8, name)
    assert sorted(dq8.__all__, key=lambda name: (not name[0].isupper(), name)) == dq8.__all__


def test_the_comparison_with_peers_runs(tmp_path):
    plot = tmp_path / "compare.svg"
    command = [sys.executable, PROJECT / "benches" / "compare.py", "--quick", "--plot", plot]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert "| product | SciPy |" in done.stdout
    assert plot.read_text().startswith("<?xml")
