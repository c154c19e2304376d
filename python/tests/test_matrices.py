"""`from_matrix` takes rigid matrices, and says of others what is wrong with which."""

import numpy as np
import pytest

import dq8


@pytest.fixture
def matrices(random_motions):
    return dq8.to_matrix(random_motions(3, 700))


def put(matrices, at, matrix):
    matrices = matrices.copy()
    matrices[at] = matrix
    return matrices


def moved(linear, translation=(1.0, 2.0, 3.0), dtype=np.float64):
    matrix = np.eye(4, dtype=dtype)
    matrix[:3, :3], matrix[:3, 3] = linear, translation
    return matrix


WRONG = {
    "columns": (moved(np.eye(3)).T, r"element 0 of the last row is 1, which must be 0 0 0 1 \(columns given as rows\?\)"),
    "projective": (np.diag([1.0, 1, 1, 2]), r"element 3 of the last row is 2"),
    "mirror": (moved(np.diag([1.0, 1, -1])), r"the determinant of its rotation is -1, which must be 1 \(it mirrors"),
    "zeros": (moved(np.zeros((3, 3))), r"the determinant of its rotation is 0"),
    "flat": (moved(np.diag([1.0, 1, 0])), r"the determinant of its rotation is 0"),
}
NOT_ORTHONORMAL = {
    "scaled": (moved(2 * np.eye(3)), r"it scales by 2"),
    "uneven": (moved(np.diag([1.0, 2, 1])), r"the product of rows 1 and 1 of its rotation is 4, which must be 1"),
    "sheared": (moved([[1.0, 0.5, 0], [0, 1, 0], [0, 0, 1]]), r"the product of rows 0 and 0 of its rotation is 1\.25"),
    "coarse": (moved(np.eye(3) * 1.001), r"it scales by 1\.001|the product of rows"),
    "infinite": (moved(np.eye(3), [0, np.inf, 0]), r"the translation is not finite: element 1 is inf"),
}


@pytest.mark.parametrize("dtype", [np.float64, np.float32])
@pytest.mark.parametrize("name", {**WRONG, **NOT_ORTHONORMAL})
def test_the_first_matrix_that_is_not_rigid_is_named(matrices, name, dtype):
    wrong, message = {**WRONG, **NOT_ORTHONORMAL}[name]
    out = np.full((3, 700, 8), 7.0, dtype)
    for at in [(0, 0), (1, 2), (2, 699), (1, 333)]:
        given = put(put(matrices, (2, 699), wrong), at, wrong).astype(dtype)
        with pytest.raises(ValueError, match=rf"`matrices` \({at[0]}, {at[1]}\): {message}"):
            dq8.from_matrix(given, out=out)
    assert (out == 7.0).all()
    with pytest.raises(ValueError, match=rf"`matrices`: {message}"):
        dq8.from_matrix(wrong.astype(dtype))


@pytest.mark.parametrize("name", WRONG)
def test_last_rows_and_mirrors_are_always_refused(matrices, name):
    wrong, message = WRONG[name]
    with pytest.raises(ValueError, match=rf"`matrices` \(1, 5\): {message}"):
        dq8.from_matrix(put(matrices, (1, 5), wrong), check=False)


def test_column_major_matrices_are_refused(matrices):
    with pytest.raises(ValueError, match=r"`matrices` \(0, 0\): .*columns given as rows\?"):
        dq8.from_matrix(matrices.swapaxes(-1, -2))


def test_unchecked_rotations_are_taken_as_they_are(matrices):
    np.testing.assert_array_equal(dq8.from_matrix(matrices, check=False), dq8.from_matrix(matrices))
    for name in NOT_ORTHONORMAL:
        dq8.from_matrix(put(matrices, (1, 5), NOT_ORTHONORMAL[name][0]), check=False)
    for check in (True, False):
        result = dq8.from_matrix(put(matrices, (1, 5), moved(np.full((3, 3), np.nan))), check=check)
        assert np.isnan(result).all(axis=-1).sum() == 1


@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_the_last_row_may_be_left_out(matrices, dtype):
    matrices = matrices.astype(dtype)
    rows = matrices[..., :3, :]
    expected = dq8.from_matrix(matrices)
    for same in (rows, rows.copy(), np.asfortranarray(rows)):
        np.testing.assert_array_equal(dq8.from_matrix(same), expected)
    assert dq8.from_matrix(rows[0, 0].tolist()).shape == (8,)
    mirror = put(rows.copy(), (2, 3), moved(-np.eye(3))[:3])
    with pytest.raises(ValueError, match=r"`matrices` \(2, 3\): the determinant of its rotation is -1"):
        dq8.from_matrix(mirror)


def test_rounded_matrices_are_taken(matrices, close):
    close(dq8.to_matrix(dq8.from_matrix(matrices.round(4))), matrices, bound=2e-4)
    assert dq8.from_matrix(matrices.astype(np.float32)).dtype == np.float32


def test_no_matrices_are_none():
    assert dq8.from_matrix(np.empty((0, 4, 4))).shape == (0, 8)
    assert dq8.from_matrix(np.empty((2, 0, 3, 4))).shape == (2, 0, 8)


def test_threads_find_the_same_matrix(matrices, one_thread):
    many = np.concatenate([matrices.reshape(-1, 4, 4)] * 10)
    many[[12_345, 20_000]] = np.diag([1.0, 1, -1, 1])
    dq8.set_num_threads(3)
    with pytest.raises(ValueError, match=r"`matrices` \(12345,\)"):
        dq8.from_matrix(many)
