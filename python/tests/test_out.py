"""`out=`: everything that computes an array has it, and it is written where it fits or not at all."""

import inspect
import re

import numpy as np
import pytest
from calls import CALLS, arguments_of

import dq8
from dq8 import RigidTransform, _core


def public():
    """Functions and methods, by the names that users see."""
    # Some compute what a method has.
    own = vars(dq8.Mechanism)
    yield from ((name, f) for name, f in vars(_core).items() if inspect.isbuiltin(f) and name not in own)
    for owner in (dq8.Hierarchy, dq8.Mechanism, RigidTransform):
        for name, method in vars(owner).items():
            # Of the methods of a mechanism that Python has written, some have no kernel that could write.
            written = owner is dq8.Mechanism and inspect.isfunction(method) and "out" not in inspect.signature(method).parameters
            if not name.startswith("_") and callable(method) and not written:
                yield f"{owner.__name__}.{name}", method


def test_everything_that_returns_an_array_has_out():
    for name, function in public():
        signature = inspect.signature(function)
        documented = re.search(r"Returns\s+-+\s+(\w+ : )?ndarray", function.__doc__ or "")
        if documented or str(signature.return_annotation).startswith("NDArray"):
            assert "out" in signature.parameters, name


def test_everything_that_has_out_is_called_here():
    assert {name for name, f in public() if "out" in inspect.signature(f).parameters} == set(CALLS)


def case(name, rng):
    arguments = arguments_of(name, rng)
    return CALLS[name][0], arguments, CALLS[name][0](*arguments)


@pytest.mark.parametrize("name", CALLS)
@pytest.mark.parametrize("strided", [False, True])
def test_out_is_written_and_returned(name, strided, rng):
    function, arguments, expected = case(name, rng)
    memory = np.full((*expected.shape, 2), 7.0)
    out = memory[..., 0] if strided else memory[..., 0].copy()
    assert function(*arguments, out=out) is out
    np.testing.assert_array_equal(out, expected)
    assert (memory[..., 1] == 7.0).all()


@pytest.mark.parametrize("name", CALLS)
def test_out_that_does_not_fit_is_named_and_untouched(name, rng):
    function, arguments, expected = case(name, rng)
    shape = tuple(expected.shape)
    short, single, frozen = np.full(shape[1:], 7.0), np.full(shape, 7.0, np.float32), np.full(shape, 7.0)
    frozen.flags.writeable = False
    shapes = rf"Expected `out` to have shape {re.escape(str(shape))}.*{re.escape(str(short.shape))}"
    for out, error, message in [
        (short, ValueError, shapes),
        (single, TypeError, r"Expected `out` to have dtype float64.*float32"),
        (frozen, ValueError, r"Expected `out` to be writeable"),
        (expected.tolist(), TypeError, r"Expected `out` to be an array, got list"),
    ]:
        with pytest.raises(error, match=message):
            function(*arguments, out=out)
        assert isinstance(out, list) or (out == 7.0).all()
