"""A plugin of pytest: puts `dq8.RigidTransform` in the place of SciPy's before SciPy's tests import it.

    python -m pytest -p in_place_of_scipy --pyargs scipy.spatial.transform.tests.test_rigid_transform
"""

import numpy as np
import pytest
import scipy.spatial.transform
from scipy._lib._array_api import xp_capabilities_table

import dq8

# Tests that ask for what dq8 says it does not do, each with the reason.
EXCEPTIONS = {
    "test_copy_flag": "copy=False shares memory with the matrix: dq8 holds dual quaternions, no matrices",
}


def _put_in_place() -> None:
    theirs = scipy.spatial.transform.RigidTransform
    # SciPy's decorators look a function up to learn for which array libraries it is tested.
    for name in dir(theirs):
        method = getattr(theirs, name)
        if callable(method) and method in xp_capabilities_table:
            xp_capabilities_table[getattr(dq8.RigidTransform, name)] = xp_capabilities_table[method]
    # One test looks at the type of this private attribute, before and after `**`.
    dq8.RigidTransform._matrix = property(dq8.RigidTransform.as_matrix)
    scipy.spatial.transform.RigidTransform = dq8.RigidTransform


def pytest_configure() -> None:
    _put_in_place()


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        assert item.module.RigidTransform is dq8.RigidTransform
        for name, reason in EXCEPTIONS.items():
            if item.originalname == name:
                # Strict: an exception that is none any more is to be taken off the list.
                item.add_marker(pytest.mark.xfail(reason=reason, strict=True))


def pytest_report_header() -> str:
    return f"dq8.RigidTransform in the place of SciPy's {scipy.__version__}, NumPy {np.__version__}"
