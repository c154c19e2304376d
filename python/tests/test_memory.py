"""Broadcasting, dtypes, strides and `out=`."""

import numpy as np
import pytest

import dq8


@pytest.mark.parametrize(
    ("a_shape", "b_shape"),
    [
        ((), ()),
        ((), (5,)),
        ((5,), ()),
        ((1,), (5,)),
        ((3, 1), (1, 5)),
        ((3, 1), (1, 100)),
        ((7,), (100, 7)),
        ((100, 1), (100, 7)),
        ((100, 7), (7,)),
        ((2, 1, 5), (3, 1)),
        ((2, 1, 50), (3, 1)),
        ((4, 1, 6, 1), (5, 1, 3)),
        ((0,), ()),
        ((0, 3), (3,)),
        ((1, 1), (1,)),
    ],
)
def test_leading_dimensions_broadcast_as_in_numpy(random_motions, a_shape, b_shape):
    a, b = random_motions(*a_shape), random_motions(*b_shape)
    shape = np.broadcast_shapes(a_shape, b_shape)
    whole_a = np.broadcast_to(a, (*shape, 8)).reshape(-1, 8)
    whole_b = np.broadcast_to(b, (*shape, 8)).reshape(-1, 8)
    expected = np.array([dq8.mul(x, y) for x, y in zip(whole_a, whole_b)]).reshape(*shape, 8)
    result = dq8.mul(a, b)
    assert result.shape == (*shape, 8)
    np.testing.assert_array_equal(result, expected)


@pytest.mark.parametrize("shapes", [((7,), (7,), (50, 7)), ((1,), (2, 1), (2, 9)), ((50, 1), (3,), ()), ((50, 1), (3,), (50, 3))])
def test_three_arguments_broadcast_as_in_numpy(random_motions, rng, shapes):
    a, b, t = random_motions(*shapes[0]), random_motions(*shapes[1]), rng.random(shapes[2])
    shape = np.broadcast_shapes(*shapes)
    result = dq8.sclerp(a, b, t)
    a, b = (np.broadcast_to(x, (*shape, 8)).copy() for x in (a, b))
    np.testing.assert_array_equal(result, dq8.sclerp(a, b, np.broadcast_to(t, shape).copy()))


def test_a_dimension_without_stride_is_read_once(random_motions):
    one, many = random_motions(), random_motions(1000)
    repeated = np.broadcast_to(one, (1000, 8))
    np.testing.assert_array_equal(dq8.mul(repeated, many), dq8.mul(one, many))
    mixed = np.broadcast_to(random_motions(4, 1), (4, 9, 8))
    np.testing.assert_array_equal(dq8.conjugate(mixed), dq8.conjugate(mixed.copy()))
    np.testing.assert_array_equal(dq8.dlb(mixed), dq8.dlb(mixed.copy()))
    hierarchy = dq8.Hierarchy([-1] + list(range(8)))
    np.testing.assert_array_equal(hierarchy.local_to_model(mixed), hierarchy.local_to_model(mixed.copy()))


def test_every_layout_of_memory_gives_the_same_bits(random_motions):
    a, b = random_motions(20), random_motions(20)
    expected = dq8.mul(a, b)
    wide = np.zeros((40, 16))
    wide[::2, 1::2] = a
    unaligned = np.frombuffer(b"\0" + a.tobytes(), np.uint8)[1:].view(np.float64).reshape(20, 8)
    frozen = a.copy()
    frozen.flags.writeable = False
    for same in (
        wide[::2, 1::2],
        a[::-1].copy()[::-1],
        np.asfortranarray(a),
        a.astype(">f8"),
        unaligned,
        frozen,
        a.tolist(),
        a.view(np.matrix),
    ):
        np.testing.assert_array_equal(dq8.mul(same, b), expected)


@pytest.mark.parametrize(
    ("dtypes", "expected"),
    [
        (("f4", "f4"), "f4"),
        (("f4", "f8"), "f8"),
        (("f2", "f4"), "f4"),
        (("i8", "f4"), "f8"),
        (("f8", "f8"), "f8"),
        (("?", "i2"), "f8"),
    ],
)
def test_results_are_single_if_all_arrays_are(dtypes, expected):
    a, b = (np.eye(8)[3].astype(dtype) for dtype in dtypes)
    assert dq8.mul(a, b).dtype == expected


def test_numbers_of_python_do_not_make_single_double(random_motions):
    a = random_motions(5).astype(np.float32)
    assert dq8.pow(a, 0.5).dtype == np.float32
    assert dq8.pow(a, 2).dtype == np.float32
    assert dq8.pow(a, np.float64(0.5)).dtype == np.float64


@pytest.mark.parametrize("shape", [(), (1,), (5,), (3, 7), (0,)])
def test_out_is_written_and_returned(random_motions, shape):
    a, b = random_motions(*shape), random_motions(*shape)
    out = np.full((*shape, 8), np.nan)
    assert dq8.mul(a, b, out=out) is out
    np.testing.assert_array_equal(out, dq8.mul(a, b))


def test_out_may_be_an_argument(random_motions):
    a, b = random_motions(50), random_motions(50)
    expected = dq8.mul(a, b)
    for out in (a.copy(), b.copy()):
        x, y = (out, b) if np.array_equal(out, a) else (a, out)
        np.testing.assert_array_equal(dq8.mul(x, y, out=out), expected)


def test_out_may_overlap_an_argument(random_motions):
    memory = random_motions(60)
    a, b, out = memory[:50].copy(), memory[10:].copy(), memory[5:55]
    np.testing.assert_array_equal(dq8.mul(memory[:50], memory[10:], out=out), dq8.mul(a, b))


def test_out_may_be_strided(random_motions):
    a, b = random_motions(50), random_motions(50)
    memory = np.zeros((50, 16))
    dq8.mul(a, b, out=memory[:, ::2])
    np.testing.assert_array_equal(memory[:, ::2], dq8.mul(a, b))
    assert not memory[:, 1::2].any()


def test_results_of_no_dimensions_are_numbers(random_motions):
    assert isinstance(dq8.distance_to(random_motions(), random_motions()), np.float64)
    assert dq8.distance_to(random_motions(1), random_motions()).shape == (1,)


def test_arguments_are_not_copied(random_motions):
    tracemalloc = pytest.importorskip("tracemalloc")
    a, b = random_motions(100_000), random_motions()
    out = np.empty_like(a)
    tracemalloc.start()
    dq8.mul(a, b, out=out)
    dq8.mul(b, np.broadcast_to(a[0], a.shape), out=out)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 10_000


def test_threads_change_no_bit(random_motions, rng, one_thread):
    a, b, v = random_motions(50_001), random_motions(50_001), rng.normal(size=(50_001, 3))
    poses = a[:49_994].reshape(-1, 7, 8)
    arm = dq8.Hierarchy([-1, 0, 1, 2, 3, 4, 5])

    def results():
        return [
            dq8.mul(a, b),
            dq8.transform_points(a[0], v),
            dq8.transform_points(a, v),
            dq8.mul(a[:3, None], b),
            dq8.mul(a[:7], poses),
            dq8.mul(a[:2000, None], b[:50]),
            dq8.dlb(poses),
            arm.local_to_model(poses),
            arm.local_to_model(poses.copy(), root=b[0]),
        ]

    expected = results()
    dq8.set_num_threads(3)
    assert dq8.get_num_threads() == 3
    for result, one in zip(results(), expected):
        np.testing.assert_array_equal(result, one)
