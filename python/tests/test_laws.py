"""Laws of motions on arrays of any shape and size, by hypothesis."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

import dq8

# Coordinates of twists: turns up to beyond π, tiny ones and none, and lengths of the same order.
COORDINATES = st.one_of(st.floats(-2, 2), st.floats(-1e-9, 1e-9), st.just(0.0))
SHAPES = hnp.array_shapes(min_dims=0, max_dims=3, min_side=0, max_side=9)


@st.composite
def motions(draw, count):
    """`count` arrays of motions whose leading dimensions broadcast."""
    shapes = draw(hnp.mutually_broadcastable_shapes(num_shapes=count, max_dims=3, max_side=9)).input_shapes
    return [dq8.from_twist(draw(hnp.arrays(np.float64, (*shape, 6), elements=COORDINATES))) for shape in shapes]


@settings(deadline=None)
@given(motions(3))
def test_products_are_associative(close, abc):
    a, b, c = abc
    close(dq8.mul(dq8.mul(a, b), c), dq8.mul(a, dq8.mul(b, c)), a, b, c)


@settings(deadline=None)
@given(motions(2))
def test_a_product_acts_as_its_factors_in_turn(close, ab):
    a, b = ab
    point = np.array([1.0, -2.0, 3.0])
    moved = dq8.transform_points(a, dq8.transform_points(b, point))
    close(dq8.transform_points(dq8.mul(a, b), point), moved, a, b, point)


@settings(deadline=None)
@given(motions(1))
def test_a_motion_and_its_conjugate_are_nothing(close, one):
    (a,) = one
    close(dq8.mul(a, dq8.conjugate(a)), np.broadcast_to(dq8.identity(), a.shape), a)


@settings(deadline=None)
@given(motions(1))
def test_the_exponential_of_the_logarithm_is_the_motion(close, one):
    (a,) = one
    close(dq8.to_matrix(dq8.exp(dq8.log(a))), dq8.to_matrix(a), a)
    close(dq8.to_matrix(dq8.from_matrix(dq8.to_matrix(a))), dq8.to_matrix(a), a)
    if not near_no_turn(a):
        close(dq8.to_matrix(dq8.from_screw(dq8.to_screw(a))), dq8.to_matrix(a), a)


def near_no_turn(a):
    """Whether some turn is so small that the moment of the axis, which is divided by it, is huge."""
    return (np.linalg.norm(a[..., :3], axis=-1) < 1e-3).any()


@settings(deadline=None)
@given(motions(1), st.floats(-2, 2), st.floats(-2, 2))
def test_powers_add_their_exponents(close, one, s, t):
    (a,) = one
    parts = dq8.pow(a, s), dq8.pow(a, t)
    close(dq8.to_matrix(dq8.mul(*parts)), dq8.to_matrix(dq8.pow(a, s + t)), a, *parts)


@settings(deadline=None)
@given(motions(3), st.floats(0, 1))
def test_interpolation_does_not_depend_on_the_frame(close, abc, t):
    a, b, c = abc
    # Where the turn between a and b is π, there are two ways.
    if (dq8.angle_to(a, b) > 3.1).any():
        return
    close(
        dq8.to_matrix(dq8.sclerp(dq8.mul(c, a), dq8.mul(c, b), t)),
        dq8.to_matrix(dq8.mul(c, dq8.sclerp(a, b, t))),
        a,
        b,
        c,
    )


@settings(deadline=None)
@given(SHAPES, st.sampled_from([np.float32, np.float64]))
def test_shapes_and_dtypes_are_kept(shape, dtype):
    a = dq8.identity(shape, dtype)
    for result, core in [
        (dq8.mul(a, a), (8,)),
        (dq8.log(a), (8,)),
        (dq8.to_matrix(a), (4, 4)),
        (dq8.translation(a), (3,)),
    ]:
        assert result.shape == shape + core
        assert result.dtype == dtype


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_at_half_a_turn_a_motion_and_its_negative_have_one_logarithm(rng, dtype):
    motions = dq8.random(200, rng=rng)
    motions[:, 3] = 0
    motions[:60, 0] = 0
    motions[:20, 1] = 0
    motions = dq8.normalize(motions).astype(dtype)
    for function in (dq8.log, dq8.to_screw, dq8.to_rotation_vector, lambda m: dq8.pow(m, 0.3)):
        np.testing.assert_array_equal(function(motions), function(-motions))
    for vector in dq8.to_rotation_vector(motions):
        assert vector[vector != 0][0] > 0
