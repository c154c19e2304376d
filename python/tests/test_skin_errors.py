"""Errors of `dq8.skin` name the argument, and leave every array of `out` as it was."""

import numpy as np
import pytest

import dq8

POINTS, INDICES, WEIGHTS = np.ones((5, 3)), np.zeros((5, 2), int), np.full((5, 2), 0.5)
PALETTE = np.tile(np.eye(8)[3], (2, 1))
TILTED = np.tile(np.eye(4), (3, 2, 1, 1))
TILTED[1, 0, 3] = [0, 0, 1, 1]
BROKEN = np.tile(np.eye(4)[:3], (3, 2, 1, 1))
BROKEN[2, 1, 0, 0] = np.inf


def at(array: np.ndarray, index, value) -> np.ndarray:
    array = array.copy()
    array[index] = value
    return array


@pytest.mark.parametrize(
    ("arguments", "options", "error", "message"),
    [
        ((np.ones((5, 4)), INDICES, WEIGHTS, PALETTE), {}, ValueError, r"Expected `points` to have shape \(\.\.\., 3\), got \(5, 4\)"),
        ((POINTS[0], INDICES, WEIGHTS, PALETTE), {}, ValueError, r"Expected `points` to have shape \(vertices, 3\), got \(3,\)"),
        ((POINTS, INDICES[:4], WEIGHTS, PALETTE), {}, ValueError, r"Expected `joints` to have shape \(5, influences\), got \(4, 2\)"),
        ((POINTS, INDICES[:, 0], WEIGHTS, PALETTE), {}, ValueError, r"Expected `joints` to have shape \(5, influences\), got \(5,\)"),
        ((POINTS, INDICES + 0.5, WEIGHTS, PALETTE), {}, TypeError, r"Expected `joints` to hold integers, got dtype float64"),
        ((POINTS, at(INDICES, (3, 1), -1), WEIGHTS, PALETTE), {}, ValueError, r"`joints`: -1 is not the number of a joint"),
        ((POINTS, at(INDICES, (3, 1), 2), WEIGHTS, PALETTE), {}, ValueError, r"`joints`: vertex 3: influence 1 is joint 2"),
        ((POINTS, INDICES[:, :0], WEIGHTS[:, :0], PALETTE), {}, ValueError, r"`joints`: a vertex must have at least one influence"),
        ((POINTS, INDICES, WEIGHTS[:, :1], PALETTE), {}, ValueError, r"Expected `weights` to have shape \(5, 2\), got \(5, 1\)"),
        ((POINTS, INDICES, at(WEIGHTS, (4, 1), -0.5), PALETTE), {}, ValueError, r"`weights`: vertex 4: .* influence 1 is -0.5"),
        ((POINTS, INDICES, at(WEIGHTS, 2, 0), PALETTE), {}, ValueError, r"`weights`: vertex 2: the weights sum to 0"),
        (
            (POINTS, INDICES, WEIGHTS, PALETTE[:, :7]),
            {},
            ValueError,
            r"Expected `palette` to have shape \(\.\.\., joints, 8\), \(\.\.\., joints, 3, 4\) or .*, got \(2, 7\)",
        ),
        ((POINTS, INDICES, WEIGHTS, np.eye(4)), {}, ValueError, r"Expected `palette` to have shape .* got \(4, 4\)"),
        ((POINTS, INDICES, WEIGHTS, PALETTE[0]), {}, ValueError, r"Expected `palette` to have shape .* got \(8,\)"),
        ((POINTS, INDICES, WEIGHTS, TILTED), {}, ValueError, r"`palette`: pose 1: joint 0: element 2 of the last row is 1"),
        ((POINTS, INDICES, WEIGHTS, TILTED), {"method": "lbs"}, ValueError, r"`palette`: pose 1: joint 0: element 2"),
        ((POINTS, INDICES, WEIGHTS, BROKEN), {}, ValueError, r"`palette`: pose 2: joint 1: an element of its matrix is inf"),
        ((POINTS, INDICES, WEIGHTS, PALETTE.astype(complex)), {}, TypeError, r"Expected `palette` to hold real numbers"),
        ((POINTS, INDICES, WEIGHTS, PALETTE), {"method": "dqs"}, ValueError, r"Expected `method` to be 'dlb', 'lbs' or 'mix', got 'dqs'"),
        ((POINTS, INDICES, WEIGHTS, PALETTE), {"normals": POINTS[:4]}, ValueError, r"Expected `normals` to have shape \(5, 3\), got \(4, 3\)"),
        ((POINTS, INDICES, WEIGHTS, PALETTE), {"out": np.ones((5, 4))}, ValueError, r"Expected `out` to have shape \(5, 3\).*\(5, 4\)"),
        (
            (POINTS, INDICES, WEIGHTS, PALETTE),
            {"normals": POINTS, "out": np.ones((5, 3))},
            TypeError,
            r"Expected `out` to be a tuple of arrays \(points, normals\), got ndarray",
        ),
        (
            (POINTS, INDICES, WEIGHTS, PALETTE),
            {"normals": POINTS, "tangents": POINTS, "out": (np.ones((5, 3)), np.ones((5, 3)))},
            TypeError,
            r"Expected `out` to be a tuple of arrays \(points, normals, tangents\), got a tuple of 2",
        ),
        ((POINTS, INDICES, WEIGHTS, PALETTE), {"tangents": POINTS[:4]}, ValueError, r"Expected `tangents` to have shape \(5, 3\), got \(4, 3\)"),
        ((POINTS, INDICES, WEIGHTS, PALETTE), {"method": "mix"}, TypeError, r"Expected `shares` where `method` is 'mix', and nowhere else"),
        ((POINTS, INDICES, WEIGHTS, PALETTE), {"shares": np.ones(5)}, TypeError, r"Expected `shares` where `method` is 'mix'"),
        ((POINTS, INDICES, WEIGHTS, PALETTE), {"method": "mix", "shares": np.ones((5, 1))}, ValueError, r"Expected `shares` to have shape \(5,\), got \(5, 1\)"),
        ((POINTS, INDICES, WEIGHTS, PALETTE), {"method": "mix", "shares": at(np.ones(5), 3, 1.5)}, ValueError, r"`shares`: vertex 3: the share is 1\.5"),
        ((POINTS, INDICES, WEIGHTS, TILTED), {"method": "mix", "shares": np.ones(5)}, ValueError, r"`palette`: pose 1: joint 0: element 2"),
    ],
)
def test_errors_name_the_argument_and_leave_out_untouched(arguments, options, error, message):
    poses = np.shape(arguments[3])[:-3] if np.shape(arguments[3])[-1] == 4 else ()
    outs = tuple(np.full((*poses, 5, 3), 7.0) for _ in range(2))
    alone, both = {"out": outs[0], **options}, {"out": outs, "normals": POINTS, **options}
    for given in [alone] if "out" in options else [both] if "normals" in options else [alone, both]:
        with pytest.raises(error, match=message):
            dq8.skin(*arguments, **given)
    assert all((out == 7.0).all() for out in outs)


OFF = at(WEIGHTS, 3, [0.5, 0.498])


@pytest.mark.parametrize("method", ["lbs", "mix"])
@pytest.mark.parametrize(
    ("weights", "vertex", "total"),
    [
        (OFF, 3, "0.998"),
        (at(WEIGHTS, 2, [0.5, 0.502]), 2, "1.002"),
        (np.full((5, 2), 127.5), 0, "255"),
        (np.full((5, 2), 1), 0, "2"),
        (at(np.full((5, 2), 0.5, "f4"), 4, [0.5, 0.25]), 4, "0.75"),
        (np.array([[128, 127]] * 4 + [[128, 125]], np.uint8), 4, "0.992"),
        (np.array([[65535, 0]] * 4 + [[65535, 655]], np.uint16), 4, "1.00999"),
    ],
)
def test_weights_that_do_not_sum_to_one_are_refused_where_nothing_divides_by_their_sum(method, weights, vertex, total):
    shares = np.zeros(5) if method == "mix" else None
    out = np.full((5, 3), 7.0)
    message = rf"`weights`: vertex {vertex}: the weights sum to {total}\d*, which must be 1 \(to 0\.001\) where `method` is"
    with pytest.raises(ValueError, match=message):
        dq8.skin(POINTS, INDICES, weights, PALETTE, method=method, shares=shares, out=out)
    assert (out == 7.0).all()
    dq8.skin(POINTS, INDICES, weights, PALETTE)


def test_the_vertex_is_named_in_a_large_mesh():
    count = 10_000
    mesh = np.ones((count, 3)), np.zeros((count, 2), int), np.full((count, 2), 0.5)
    for change, message in [
        ((mesh[0], at(mesh[1], (9_000, 1), 2), mesh[2]), "`joints`: vertex 9000: influence 1 is joint 2"),
        ((mesh[0], mesh[1], at(mesh[2], (9_000, 1), -1)), "`weights`: vertex 9000: the weight of influence 1 is -1"),
        ((mesh[0], mesh[1], at(mesh[2], 9_000, 0)), "`weights`: vertex 9000: the weights sum to 0"),
        ((mesh[0], mesh[1], at(mesh[2], 9_000, 1)), "`weights`: vertex 9000: the weights sum to 2"),
    ]:
        with pytest.raises(ValueError, match=message):
            dq8.skin(*change, PALETTE, method="lbs")
    shares, out = at(np.ones(count), 9_000, 1.5), np.full((count, 3), 7.0)
    with pytest.raises(ValueError, match=r"`shares`: vertex 9000: the share is 1\.5"):
        dq8.skin(*mesh, PALETTE, method="mix", shares=shares, out=out)
    assert (out == 7.0).all()


def test_a_third_out_that_overlaps_the_first_is_refused_and_untouched():
    base = np.full((3, 5, 3), 7.0)
    with pytest.raises(ValueError, match="Expected the arrays of `out` not to overlap"):
        dq8.skin(POINTS, INDICES, WEIGHTS, PALETTE, normals=POINTS, tangents=POINTS, out=(base[0], base[1], base[0]))
    assert (base == 7.0).all()


def test_a_second_out_that_does_not_fit_leaves_the_first_untouched():
    out = np.full((5, 3), 7.0)
    with pytest.raises(ValueError, match=r"Expected `out` to have shape \(5, 3\).*\(5, 4\)"):
        dq8.skin(POINTS, INDICES, WEIGHTS, PALETTE, normals=POINTS, out=(out, np.ones((5, 4))))
    assert (out == 7.0).all()


@pytest.mark.parametrize("base", [np.full((2, 5, 3), 7.0), np.full((2, 5, 3, 2), 7.0)[..., 0]])
def test_outs_that_overlap_each_other_are_refused_and_untouched(base):
    flat = base.reshape(-1, 3) if base.flags.c_contiguous else base[0]
    for points, normals in ((base[0], base[0]), (flat[:5], base[0]), (base[0], base[0][::-1])):
        with pytest.raises(ValueError, match="Expected the arrays of `out` not to overlap"):
            dq8.skin(POINTS, INDICES, WEIGHTS, PALETTE, normals=POINTS, out=(points, normals))
        assert (base == 7.0).all()
