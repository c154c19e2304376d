"""Velocities, rates and manipulabilities on lanes: what NumPy makes of the Jacobians."""

import numpy as np
import pytest
from robots import ROBOTS

import dq8

ROBOT = {name: dq8.Mechanism.from_urdf(ROBOTS / f"{name}.urdf") for name in ("arm6", "arm7", "humanoid")}
FRAMES = ["aligned", "body", "world"]
DTYPES = [(np.float64, 1e-11), (np.float32, 2e-3)]


@pytest.mark.parametrize("dtype, bound", DTYPES)
@pytest.mark.parametrize("frame", FRAMES)
@pytest.mark.parametrize("name", ROBOT)
def test_rates_are_those_of_the_pseudoinverse(name, frame, dtype, bound, rng):
    robot = ROBOT[name]
    link, values = robot.links[-1], robot.sample(45, rng=rng).astype(dtype)
    twists = robot.velocity(values, rng.normal(size=(45, len(robot.rates))).astype(dtype), link, frame)
    jacobian = robot.jacobian(values, link, frame).astype(float)
    found = robot.rates_for(values, twists, link, frame)
    assert found.dtype == twists.dtype == dtype
    np.testing.assert_allclose((jacobian @ found[..., np.newaxis])[..., 0], twists, rtol=0, atol=bound * np.abs(twists).max())
    if dtype == np.float64:
        expected = (np.linalg.pinv(jacobian, rcond=1e-13) @ twists[..., np.newaxis])[..., 0]
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-7)
    damped = robot.rates_for(values, twists, link, frame, damping=0.2)
    square = jacobian @ jacobian.swapaxes(-1, -2) + 0.04 * np.eye(6)
    expected = (jacobian.swapaxes(-1, -2) @ np.linalg.solve(square, twists[..., np.newaxis]))[..., 0]
    np.testing.assert_allclose(damped, expected, rtol=0, atol=bound * np.abs(expected).max())


@pytest.mark.parametrize("dtype, bound", [(np.float64, 1e-12), (np.float32, 1e-4)])
@pytest.mark.parametrize("name", ["arm6", "arm7"])
def test_manipulability_is_the_root_of_the_determinant(name, dtype, bound, rng):
    robot = ROBOT[name]
    link, values = robot.links[-1], robot.sample((3, 700), rng=rng).astype(dtype)
    found = robot.manipulability(values, link)
    assert found.shape == (3, 700) and found.dtype == dtype
    sizes = np.linalg.svd(robot.jacobian(values.astype(float), link), compute_uv=False)
    np.testing.assert_allclose(found, sizes.prod(axis=-1), rtol=0, atol=bound)
    one = robot.manipulability(values[1, 5], link)
    assert np.ndim(one) == 0 and one == found[1, 5]
    out = np.empty_like(found)
    assert robot.manipulability(values, link, out=out) is out
    np.testing.assert_array_equal(out, found)


def test_what_nothing_moves_has_no_rates_and_few_rates_no_volume():
    # Two hinges about one axis, and a slide: three directions that nothing moves in.
    crane = dq8.Mechanism([-1, 0, 1], ["revolute", "revolute", "prismatic"], [0, 0, 1], dq8.identity())
    assert crane.manipulability([0.1, 0.2, 0.3], 2) == 0
    rates = crane.rates_for([0.1, 0.2, 0.3], [1.0, 2, 3, 4, 5, 6], 2)
    np.testing.assert_allclose(rates, [1.5, 1.5, 6], rtol=0, atol=1e-14)
    np.testing.assert_array_equal(crane.rates_for([0.1, 0.2, 0.3], np.zeros(6), 2), np.zeros(3))
    still = dq8.Mechanism([-1], "fixed", [0, 0, 1], dq8.identity())
    assert still.rates_for(np.zeros((4, 0)), np.ones(6), 0).shape == (4, 0)
    np.testing.assert_array_equal(still.velocity(np.zeros((4, 0)), np.zeros((4, 0)), 0), np.zeros((4, 6)))
    assert (still.manipulability(np.zeros((4, 0)), 0) == 0).all()


def test_leading_dimensions_broadcast_and_results_do_not_depend_on_threads(rng, one_thread):
    robot = ROBOT["arm7"]
    values, rates = robot.sample((5, 1), rng=rng), rng.normal(size=(4000, len(robot.rates)))
    twists = robot.velocity(values, rates, "hand")
    assert twists.shape == (5, 4000, 6)
    np.testing.assert_array_equal(twists[2, 7], robot.velocity(values[2, 0], rates[7], "hand"))
    found = robot.rates_for(values, twists, "hand")
    np.testing.assert_array_equal(found[2, 7], robot.rates_for(values[2, 0], twists[2, 7], "hand"))
    dq8.set_num_threads(2)
    np.testing.assert_array_equal(robot.rates_for(values, twists, "hand"), found)
    np.testing.assert_array_equal(robot.velocity(values, rates, "hand"), twists)
    for wrong in (-1.0, np.nan, np.inf):
        with pytest.raises(ValueError, match="Expected `damping` to be finite and at least 0"):
            robot.rates_for(values, twists, "hand", damping=wrong)
    with pytest.raises(ValueError, match=r"broadcast.*`values` \(5, 1\), `twists` \(4, 3\)"):
        robot.rates_for(values, np.ones((4, 3, 6)), "hand")
