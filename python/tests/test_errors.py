"""Errors name the argument and the shape, and leave `out` as it was."""

import numpy as np
import pytest

import dq8

A = np.tile(dq8.identity(), (5, 1))


@pytest.mark.parametrize(
    ("call", "error", "message"),
    [
        (lambda: dq8.mul(A, A[:, :7]), ValueError, r"Expected `b` to have shape \(\.\.\., 8\), got \(5, 7\)"),
        (lambda: dq8.mul(1.0, A), ValueError, r"Expected `a` to have shape \(\.\.\., 8\), got \(\)"),
        (lambda: dq8.log([]), ValueError, r"Expected `motions` to have shape \(\.\.\., 8\), got \(0,\)"),
        (lambda: dq8.mul(A, A[:3]), ValueError, r"could not be broadcast.*`a` \(5,\), `b` \(3,\)"),
        (lambda: dq8.sclerp(A, A, [0.5] * 4), ValueError, r"could not be broadcast.*`t` \(4,\)"),
        (lambda: dq8.from_matrix(np.eye(3)), ValueError, r"Expected `matrices` to have shape \(\.\.\., 4, 4\), got \(3, 3\)"),
        (lambda: dq8.mul(A.astype(complex), A), TypeError, r"Expected `a` to hold real numbers.*complex128"),
        (lambda: dq8.mul(A, A.astype(object)), TypeError, r"Expected `b` to hold real numbers.*object"),
        (lambda: dq8.mul(A, "text"), TypeError, r"Expected `b` to hold real numbers"),
        (lambda: dq8.mul(A, [[1.0], [1.0, 2.0]]), ValueError, r"`b`: "),
        (lambda: dq8.mul(A, A, out=A.tolist()), TypeError, r"Expected `out` to be an array, got list"),
        (lambda: dq8.mul(A, A, out=A.astype("f4")), TypeError, r"Expected `out` to have dtype float64.*float32"),
        (lambda: dq8.mul(A, A, out=A[:4].copy()), ValueError, r"Expected `out` to have shape \(5, 8\).*\(4, 8\)"),
        (lambda: dq8.dlb(A, np.ones(4)), ValueError, r"Expected `weights` to have shape \(5,\) or \(5,\), got \(4,\)"),
        (lambda: dq8.dlb(A[0]), ValueError, r"Expected `motions` to have shape \(\.\.\., n, 8\) with n > 0, got \(8,\)"),
        (lambda: dq8.mean(A[:0]), ValueError, r"with n > 0, got \(0, 8\)"),
        (lambda: dq8.set_num_threads(0), ValueError, r"Expected `count` to be from 1 to 256, got 0"),
        (lambda: dq8.Hierarchy([-1, 2, 1]), ValueError, r"`parents`: joint 2 is its own ancestor"),
        (lambda: dq8.Hierarchy([-2]), ValueError, r"`parents`: -2 is neither a joint nor"),
        (lambda: dq8.Hierarchy(["x"]), TypeError, r"Expected `parents` to be a sequence of integers"),
        (lambda: dq8.Hierarchy([-1, 0]).local_to_model(A), ValueError, r"Expected `locals` to have shape \(\.\.\., 2, 8\), got \(5, 8\)"),
        (lambda: dq8.Hierarchy([-1] * 5).local_to_model(A, root=A), ValueError, r"Expected `root` to have shape \(8,\), got \(5, 8\)"),
    ],
)
def test_errors_name_argument_and_shape(call, error, message):
    with pytest.raises(error, match=message):
        call()


def test_out_is_untouched_where_arguments_do_not_fit():
    out = np.full((5, 8), 7.0)
    with pytest.raises(ValueError, match="broadcast"):
        dq8.mul(A, A[:3], out=out)
    assert (out == 7.0).all()


def test_what_is_read_only_is_not_written():
    out = np.zeros((5, 8))
    out.flags.writeable = False
    with pytest.raises(ValueError, match="writeable"):
        dq8.mul(A, A, out=out)
