"""`fit` and `hand_eye`: what tells them nothing is said, and outliers count for little."""

import re

import numpy as np
import pytest
from scipy import integrate, stats

import dq8


def moved_points(rng, *shape, count=10, noise=0.0):
    motions, points = dq8.random(shape, rng=rng), rng.normal(size=(*shape, count, 3))
    moved = dq8.transform_points(motions[..., np.newaxis, :], points)
    return motions, points, moved + noise * rng.normal(size=moved.shape)


def hand_and_eye(rng, *shape, count=10, noise=0.0):
    x, eyes = dq8.random(shape, rng=rng), dq8.random((*shape, count), rng=rng)
    own = x[..., np.newaxis, :]
    hands = dq8.mul(dq8.mul(own, eyes), dq8.inverse(own))
    return x, dq8.mul(hands, dq8.from_twist(noise * rng.normal(size=(*shape, count, 6)))), eyes


def test_mirrored_points_are_refused_and_full_has_the_best_motion(rng):
    _, points, moved = moved_points(rng, noise=1e-3)
    with pytest.raises(ValueError, match="they are mirrored.*`full=True`"):
        dq8.fit(points, moved * [1, 1, -1])
    found = dq8.fit(points, moved * [1, 1, -1], full=True)
    assert found.mirrored and found.faults == [((), found.faults[0][1])] and "mirrored" in found.faults[0][1]
    assert np.linalg.det(dq8.to_matrix(found.motions)[:3, :3]) > 0.999
    assert not dq8.fit(points, moved, full=True).mirrored


def test_a_bad_fit_among_thousands_is_nan_in_its_row_and_named(rng):
    motions, points, moved = moved_points(rng, 2000)
    line = np.outer(np.arange(10.0), [1, 2, 3])
    points[7], moved[7] = line, line
    points[1234] = points[1234] * [1, 1, -1]
    points[99, 3, 1] = np.nan
    with pytest.warns(UserWarning, match=re.escape("2 of 2000 problems have no answer, which is NaN: (7,), (1234,).")):
        found = dq8.fit(points, moved)
    bad = [7, 99, 1234]
    assert np.isnan(found[bad]).all() and dq8.allclose(np.delete(found, bad, 0), np.delete(motions, bad, 0))
    listed = dq8.fit(points, moved, full=True).faults
    assert [index for index, _ in listed] == [(7,), (99,), (1234,)]
    assert "rank is 1" in listed[0][1] and "not finite" in listed[1][1] and "mirrored" in listed[2][1]


def test_lengths_whose_squares_overflow_are_told_from_numbers_that_are_not_finite(rng):
    _, points, moved = moved_points(rng, 3)
    for far in (points[0] * 1e200, (points[0] * 1e30).astype(np.float32)):
        with pytest.raises(ValueError, match="the sums overflow: choose a larger unit"):
            dq8.fit(far, far)
    points[1] *= 1e200
    points[2, 0, 0] = np.inf
    with pytest.warns(UserWarning, match=re.escape("1 of 3 problems have no answer, which is NaN: (1,).") + ".*overflow"):
        assert list(np.isnan(dq8.fit(points, moved)).all(-1)) == [False, True, True]
    faults = dq8.fit(points, moved, full=True).faults
    assert [index for index, _ in faults] == [(1,), (2,)] and "overflow" in faults[0][1] and "not finite" in faults[1][1]
    eyes, x = dq8.random(5, rng=rng), dq8.random(rng=rng)
    eyes = dq8.from_rotation_translation(dq8.rotation(eyes), dq8.translation(eyes) * 1e200)
    with pytest.raises(ValueError, match="the sums overflow: choose a larger unit"):
        dq8.hand_eye(dq8.mul(dq8.mul(x, eyes), dq8.inverse(x)), eyes)


def test_many_fits_have_the_bits_of_single_ones(rng):
    _, points, moved = moved_points(rng, 50, noise=0.1)
    weights = rng.random((50, 10))
    for options in ({}, {"scale": True}, {"about": [0, 0, 1.0]}, {"robust": "huber"}, {"robust": "tukey"}):
        many = dq8.fit(points, moved, weights, full=True, **options)
        for at in range(50):
            one = dq8.fit(points[at], moved[at], weights[at], full=True, **options)
            for name in ("motions", "scales", "rms", "ranks", "conditions", "factors"):
                np.testing.assert_array_equal(getattr(one, name), getattr(many, name)[at])


def test_many_hand_eyes_have_the_bits_of_single_ones(rng):
    _, hands, eyes = hand_and_eye(rng, 50, noise=1e-3)
    weights = rng.random((50, 10))
    for robust in (None, "huber", "tukey"):
        many = dq8.hand_eye(hands, eyes, weights, robust=robust, full=True)
        for at in range(50):
            one = dq8.hand_eye(hands[at], eyes[at], weights[at], robust=robust, full=True)
            for name in ("motions", "ranks", "conditions", "factors"):
                np.testing.assert_array_equal(getattr(one, name), getattr(many, name)[at])


def test_residuals_are_what_is_left(rng):
    _, points, moved = moved_points(rng, 4, noise=0.1)
    found = dq8.fit(points, moved, full=True)
    left = dq8.transform_points(found.motions[:, np.newaxis], points) - moved
    np.testing.assert_allclose(found.residuals, np.linalg.norm(left, axis=-1), rtol=1e-12)
    np.testing.assert_allclose(found.rms, np.sqrt((found.residuals**2).mean(axis=-1)), rtol=1e-12)
    _, hands, eyes = hand_and_eye(rng, 4, noise=1e-3)
    found = dq8.hand_eye(hands, eyes, full=True)
    own = found.motions[:, np.newaxis]
    np.testing.assert_allclose(found.angles, dq8.angle_to(dq8.mul(hands, own), dq8.mul(own, eyes)))
    assert (found.ranks == 6).all() and (found.conditions < 50).all() and 1e-4 < found.distances.mean() < 1e-2


@pytest.mark.parametrize("rule", ["huber", "tukey"])
def test_outliers_of_fits_count_little(rule, rng):
    motions, points, moved = moved_points(rng, 200, count=20, noise=1e-2)
    clean = dq8.fit(points, moved)
    moved[:, :4] += rng.normal(size=(200, 4, 3)) * 10
    found = dq8.fit(points, moved, robust=rule, full=True)
    ordinary = dq8.fit(points, moved)
    error = lambda fits: np.median(dq8.distance_weighted(fits, motions, 1.0))
    assert error(found.motions) < 2 * error(clean) < 0.02 * error(ordinary)
    # The outliers are those that count least; by Tukey's rule not at all.
    assert (found.factors[:, :4].max(axis=1) < 0.3).mean() > 0.9
    assert rule == "huber" or (found.factors[:, :4] == 0).mean() > 0.9


@pytest.mark.parametrize("rule", ["huber", "tukey"])
def test_outliers_of_hand_and_eye_count_little(rule, rng):
    x, hands, eyes = hand_and_eye(rng, 100, count=20, noise=1e-2)
    clean = dq8.hand_eye(hands, eyes)
    hands[:, 0] = dq8.mul(hands[:, 0], dq8.from_twist(0.3 * rng.normal(size=(100, 6))))
    found = dq8.hand_eye(hands, eyes, robust=rule, full=True)
    error = lambda found: np.median(dq8.distance_weighted(found, x, 1.0))
    assert error(found.motions) < 2 * error(clean) < error(dq8.hand_eye(hands, eyes))
    assert (found.factors[:, 0] < 0.3).mean() > 0.9


@pytest.mark.parametrize("components, median, k, c", [(3, 1.5382, 1.6280, 5.4902), (6, 2.3126, 1.8693, 6.3562)])
def test_the_numbers_of_the_robust_rules_keep_95_percent(components, median, k, c):
    chi = stats.chi(components)
    assert abs(chi.median() - median) < 1e-4

    def efficiency(psi, slope, end):
        spread = lambda r: (slope(r) + (components - 1) * psi(r) / r) / components * chi.pdf(r)
        square = lambda r: psi(r) ** 2 / components * chi.pdf(r)
        (a, b) = (integrate.quad(of, 0, end)[0] + integrate.quad(of, end, 15)[0] for of in (spread, square))
        return a * a / b

    assert abs(efficiency(lambda r: min(r, k), lambda r: float(r < k), k) - 0.95) < 1e-4
    bisquare = lambda r: r * (1 - (r / c) ** 2) ** 2 * (r < c)
    assert abs(efficiency(bisquare, lambda r: (1 - (r / c) ** 2) * (1 - 5 * (r / c) ** 2) * (r < c), c) - 0.95) < 1e-4
    # They are those of the docstring.
    doc = dq8.fit.__doc__ if components == 3 else dq8.hand_eye.__doc__
    assert all(f"{number:.3f}" in doc for number in (median, k, c))


def test_absolute_poses_of_hand_and_eye_are_refused(rng):
    # A hand looks at a board from within 30 degrees: A X Z = board, all of them turned by about π.
    tilts = dq8.from_twist(np.concatenate([0.4 * rng.normal(size=(20, 3)), 0.1 * rng.normal(size=(20, 3))], axis=1))
    poses = dq8.mul(dq8.from_screw([1, 0, 0, 0, 0, 0.5, 3.0, 0.2]), tilts)
    x, board = dq8.random(rng=rng), dq8.random(rng=rng)
    seen = dq8.mul(dq8.mul(dq8.inverse(board), poses), x)
    with pytest.raises(ValueError, match="move together.*not where it was"):
        dq8.hand_eye(poses, seen)
    hands, eyes = (dq8.mul(dq8.inverse(them[:-1]), them[1:]) for them in (poses, seen))
    assert dq8.allclose(dq8.hand_eye(hands, eyes), x)
    with pytest.raises(ValueError, match="move together"):
        dq8.hand_eye(dq8.random(20, rng=rng), eyes[np.arange(20) % 19])


def test_noise_at_half_a_turn_chooses_no_sign(rng):
    x = dq8.random(rng=rng)
    axes = rng.normal(size=(20, 3))
    axes /= np.linalg.norm(axes, axis=-1, keepdims=True)
    eyes = dq8.from_twist(np.concatenate([np.pi * axes, rng.normal(size=(20, 3))], axis=-1))
    hands = dq8.mul(dq8.mul(x, eyes), dq8.inverse(x))
    eyes[:12] = dq8.from_twist(np.concatenate([rng.uniform(0.5, 2, (12, 1)) * axes[:12], rng.normal(size=(12, 3))], axis=-1))
    hands[:12] = dq8.mul(dq8.mul(x, eyes[:12]), dq8.inverse(x))
    hands = dq8.mul(hands, dq8.from_twist(1e-3 * rng.normal(size=(20, 6))))
    assert dq8.allclose(dq8.hand_eye(hands, eyes), x, angle=1e-2, length=1e-2)


def test_rules_that_are_none_are_refused(rng):
    _, points, moved = moved_points(rng)
    with pytest.raises(ValueError, match="Expected `robust` to be 'huber', 'tukey' or None, got 'cauchy'"):
        dq8.fit(points, moved, robust="cauchy")


def test_motions_that_do_not_turn_are_refused(rng):
    x = dq8.random(rng=rng)
    slides = dq8.from_translation(rng.normal(size=(5, 3)))
    for hands in (slides, dq8.identity(5)):
        eyes = dq8.mul(dq8.mul(dq8.inverse(x), hands), x)
        with pytest.raises(ValueError, match="axes that are not parallel"):
            dq8.hand_eye(hands, eyes)
        assert dq8.hand_eye(hands, eyes, full=True).ranks < 6


def test_pairs_of_weight_zero_do_not_say_whether_hand_and_eye_move_together(rng):
    eyes, x = dq8.random(10, rng=rng), dq8.random(rng=rng)
    hands = dq8.mul(dq8.mul(x, eyes), dq8.inverse(x))
    hands[4:] = dq8.random(6, rng=rng)
    weights = np.where(np.arange(10) < 4, 1.0, 0.0)
    assert dq8.allclose(dq8.hand_eye(hands, eyes, weights), x)
