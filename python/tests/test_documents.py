"""The tutorial, the examples in docstrings, and the types say what is so."""

import ast
import doctest
import functools
import importlib.resources
import inspect
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from calls import CALLS

import dq8
import dq8.dask
import dq8.plot
import dq8.retarget
from dq8 import _core
from dq8._signatures import SIGNATURES

PROJECT = Path(__file__).parents[1]


def functions():
    return [(name, f) for name, f in vars(_core).items() if inspect.isbuiltin(f)]


def stubs():
    source = importlib.resources.files(dq8).joinpath("_core.pyi").read_text()
    return {node.name: node for node in ast.parse(source).body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}


SCRIPTS = {"mocap.py": [], "robot.py": [PROJECT.parent / "robot" / "robots" / "arm7.urdf"], "scipy_script.py": [], "mesh.py": [],
           "all_solutions.py": [PROJECT.parent / "robot" / "robots" / "arm6.urdf"],
           "retarget.py": [PROJECT.parent / "robot" / "robots" / "humanoid.urdf", PROJECT.parent / "examples" / "mocap" / "walk.bvh"]}


@pytest.mark.parametrize("name", SCRIPTS)
def test_the_scripts_run_and_are_short(name):
    script = PROJECT / "examples" / name
    subprocess.run([sys.executable, script, *SCRIPTS[name]], check=True)
    assert len(script.read_text().splitlines()) <= 40


def test_every_script_is_run():
    assert {path.name for path in (PROJECT / "examples").glob("*.py")} == set(SCRIPTS)


# What has no result to show: settings of the process, and what others return.
WITHOUT_EXAMPLE = ["Comparison", "Fit", "HandEye", "ReachReport", "Solutions", "Statistics", "backend", "get_num_threads", "set_num_threads", "set_reproducible"]


def test_the_tutorial_runs_and_plots(tmp_path):
    command = [sys.executable, PROJECT / "tutorial" / "tutorial.py", tmp_path]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    for name in ("between.png", "keys.png", "deskew.png", "arm.png", "robot.png", "skin.png"):
        assert (tmp_path / name).read_bytes().startswith(b"\x89PNG")


def test_examples_in_docstrings_are_true():
    finder, runner = doctest.DocTestFinder(), doctest.DocTestRunner()
    named = {name: getattr(dq8, name) for name in dq8.__all__} | {"dq8.dask": dq8.dask, "dq8.plot": dq8.plot, "dq8.retarget": dq8.retarget}
    named["retarget.positions"] = dq8.retarget.positions
    without = []
    with np.printoptions(legacy=False):
        for name, thing in named.items():
            # Modules have examples of their own, not those of all that they import.
            found = finder.find(thing, name, module=False, globs={}) if "." not in name else [
                doctest.DocTestParser().get_doctest(thing.__doc__, {}, name, None, None)
            ]
            if not sum(runner.run(test).attempted for test in found):
                without.append(name)
    assert runner.failures == 0
    assert without == WITHOUT_EXAMPLE


def test_the_generated_types_are_those_of_the_table():
    subprocess.run([sys.executable, PROJECT / "stubs.py", "--check"], check=True)


@pytest.mark.parametrize("name", SIGNATURES)
def test_the_table_of_signatures_says_what_docstrings_say(name):
    def written(shape):
        return "(" + ", ".join(["...", *map(str, shape)]) + ")"

    parameters, result = SIGNATURES[name]
    doc = getattr(_core, name).__doc__
    found = re.findall(r"^ *([\w, ]+) : array_like, shape (\([^)]*\))", doc, re.MULTILINE)
    documented = {own.strip(): shape for names, shape in found for own in names.split(",")}
    assert documented == {own: written(shape) for own, shape in parameters.items()}
    assert f"ndarray, shape {written(result)}" in doc


# Something is computed, ``a b`` is a formula and ``'dlb'`` or ``[x, y]`` is none; matrices are written as they are.
FORMULA = re.compile(r"``[^`']*(?:[=·*/√Σ²ᵗ±−+|(σ]|R t;)[^`']*``")
UNITS = re.compile(r"radian|length|pure number|dual quaternion", re.IGNORECASE)


@pytest.mark.parametrize("name", CALLS)
def test_docstrings_of_what_computes_say_formula_shapes_units_and_dtype(name):
    thing = functools.reduce(getattr, name.split("."), dq8 if hasattr(dq8, name.split(".")[0]) else _core)
    doc = inspect.getdoc(thing)
    assert FORMULA.search(doc.split("Parameters")[0]), "formula"
    assert "shape (" in doc
    assert UNITS.search(doc), "units"
    if name.startswith("RigidTransform."):
        assert "of `dtype`" in doc.lower()
        return
    parameters, returned = doc.split("Returns\n-------\n")
    assert re.search(r"float32 if (all arrays|`targets`)[^.]*, otherwise float64\.", " ".join(returned.split())), "dtype"
    for parameter in inspect.signature(thing).parameters:
        assert parameter == "self" or re.search(rf"\b{parameter}\b.* : ", parameters), parameter


# What is there already, in another form.
GIVEN = {"as_components", "astype", "concatenate", "dtype", "identity", "motions", "shape", "single"}


def transform_members():
    return [name for name in vars(dq8.RigidTransform) if not name.startswith("_")] + ["__mul__", "__pow__"]


@pytest.mark.parametrize("name", transform_members())
def test_docstrings_of_transforms_say_formula_shapes_and_dtype(name):
    member = inspect.getattr_static(dq8.RigidTransform, name)
    function = getattr(member, "fget", None) or getattr(member, "__func__", None) or member
    doc, types = inspect.getdoc(function), function.__annotations__
    assert (name in GIVEN) != bool(FORMULA.search(doc) or re.search("``[rp]``", doc)), "formula"
    if types["return"].startswith("NDArray"):
        assert "shape (" in doc and "of `dtype`" in doc.lower()
    if name.startswith("from_"):
        assert any(given in doc for given in ("shape (", "any shape"))
    if "Rotation" in str(types) and "RigidTransform" not in types["return"]:
        assert "float64" in doc


@pytest.mark.parametrize("owner", [dq8.ReachReport, dq8.Mechanism, dq8.Trajectory, dq8.Spline])
def test_docstrings_of_properties_say_the_dtype_of_arrays(owner):
    declared = {node.name: node for node in stubs()[owner.__name__].body if isinstance(node, ast.FunctionDef)}
    for name, member in vars(owner).items():
        if inspect.isgetsetdescriptor(member):
            types = ast.unparse(declared[name].returns)
            dtypes = {"NDArray[np.bool]": "bool", "NDArray[np.uint8]": "uint8", "NDArray[np.uint32]": "uint32"}
            expected = next((dtype for array, dtype in dtypes.items() if array in types), "float64")
            assert any(plain in types for plain in ("list", "str", "tuple")) or expected in member.__doc__, name


def test_the_package_says_what_all_functions_have_in_common():
    for said in ("64 bits", "float32 if all of them are", "Angles are radians", "lengths the unit of the caller", "q is a length"):
        assert said in " ".join(dq8.__doc__.split())


def test_the_types_have_every_function_with_its_parameters():
    declared = stubs()
    for name, function in functions():
        node = declared.pop(name)
        arguments = node.args
        own = [a.arg for a in arguments.posonlyargs + arguments.args + arguments.kwonlyargs]
        assert own == list(inspect.signature(function).parameters), name
    assert list(declared) == ["Hierarchy", "PackedClip", "Mechanism", "Trajectory", "Spline", "ReachReport", "Person", "Humanoid", "Stop"]
    for name, node in declared.items():
        methods = {node.name for node in node.body if isinstance(node, ast.FunctionDef)}
        for method in vars(getattr(dq8, name, None) or getattr(_core, name)):
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
