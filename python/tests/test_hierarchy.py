"""Forward kinematics against a loop of SciPy's products."""

import pickle

import numpy as np
import pytest
from scipy.spatial.transform import RigidTransform

import dq8

PARENTS = [-1, 0, 1, 0, 3, -1, 5]


def loop(parents, locals_):
    models = []
    for joint, parent in enumerate(parents):
        local = RigidTransform.from_dual_quat(locals_[joint])
        models.append(local if parent < 0 else models[parent] * local)
    return np.stack([model.as_matrix() for model in models])


@pytest.mark.parametrize("leading", [(), (1,), (9,), (3, 5)])
def test_models_are_products_down_the_hierarchy(random_motions, close, leading):
    locals_ = random_motions(*leading, len(PARENTS))
    models = dq8.Hierarchy(PARENTS).local_to_model(locals_)
    assert models.shape == locals_.shape
    for own, expected in zip(models.reshape(-1, 7, 8), locals_.reshape(-1, 7, 8)):
        close(dq8.to_matrix(own), loop(PARENTS, expected), expected, own)


def test_a_root_moves_all_joints(random_motions, close):
    hierarchy, locals_, root = dq8.Hierarchy(PARENTS), random_motions(9, 7), random_motions()
    moved = hierarchy.local_to_model(locals_, root=root)
    close(dq8.to_matrix(moved), dq8.to_matrix(dq8.mul(root, hierarchy.local_to_model(locals_))), root, locals_, moved)


@pytest.mark.parametrize("with_root", [False, True])
def test_model_to_local_undoes_local_to_model(random_motions, close, with_root):
    hierarchy, locals_ = dq8.Hierarchy(PARENTS), random_motions(9, 7)
    root = random_motions() if with_root else None
    models = hierarchy.local_to_model(locals_, root=root)
    close(hierarchy.model_to_local(models, root=root), locals_, locals_, models)


def test_hierarchies_run_in_place(random_motions):
    hierarchy, poses = dq8.Hierarchy(PARENTS), random_motions(9, 7)
    models = hierarchy.local_to_model(poses)
    locals_ = hierarchy.model_to_local(models)
    assert hierarchy.local_to_model(poses, out=poses) is poses
    np.testing.assert_array_equal(poses, models)
    hierarchy.model_to_local(poses, out=poses)
    np.testing.assert_array_equal(poses, locals_)


def test_float32_stays_float32(random_motions):
    poses = random_motions(9, 7).astype(np.float32)
    assert dq8.Hierarchy(PARENTS).local_to_model(poses).dtype == np.float32


def test_a_hierarchy_is_its_parents():
    hierarchy = dq8.Hierarchy(np.array(PARENTS))
    assert hierarchy.parents == PARENTS
    assert len(hierarchy) == 7
    assert repr(hierarchy) == f"Hierarchy({PARENTS})"
    assert pickle.loads(pickle.dumps(hierarchy)).parents == PARENTS


def test_parents_may_be_names_in_any_order_and_roots_one_for_each_instance(random_motions, close):
    hierarchy = dq8.Hierarchy({"toe": "knee", "hip": None, "knee": "hip"})
    assert (hierarchy.names, hierarchy.parents) == (["toe", "hip", "knee"], [2, -1, 1])
    assert pickle.loads(pickle.dumps(hierarchy)).names == hierarchy.names
    assert dq8.Hierarchy([-1, 0], ["hip", "knee"]).names == ["hip", "knee"] and dq8.Hierarchy([-1]).names is None
    locals_, roots = random_motions(4, 3), random_motions(4)
    models = hierarchy.local_to_model(locals_, root=roots)
    hip = dq8.mul(roots, locals_[:, 1])
    knee = dq8.mul(hip, locals_[:, 2])
    for joint, expected in enumerate([dq8.mul(knee, locals_[:, 0]), hip, knee]):
        close(models[:, joint], expected, models, expected)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (({"knee": "hip"},), r"`parents`: there is no joint \"hip\""),
        (([-1, 0], ["hip"]), r"`names` to have 2 names, got 1"),
        (([-1, 0], ["hip", "hip"]), r"`names`: two have the name \"hip\""),
        (({"a": "b", "b": "a"},), r"`parents`: "),
    ],
)
def test_names_that_do_not_fit_are_refused(arguments, message):
    with pytest.raises(ValueError, match=message):
        dq8.Hierarchy(*arguments)


def test_an_arm_of_screws_is_that_of_pytransform3d(rng, close):
    # Product of exponentials: the pose of link j is exp(ξ₁θ₁) … exp(ξⱼθⱼ) Mⱼ, here as twists of the joints.
    import pytransform3d.transformations as p3d

    axes, angles = rng.normal(size=(7, 6)), rng.normal(size=(20, 7))
    axes[:, :3] /= np.linalg.norm(axes[:, :3], axis=-1, keepdims=True)
    arm = dq8.Hierarchy([-1, 0, 1, 2, 3, 4, 5])
    hand = dq8.to_matrix(arm.local_to_model(dq8.integrate_body(dq8.identity(), axes, angles)))[:, -1]
    for own, theta in zip(hand, angles):
        expected = np.eye(4)
        for axis, angle in zip(axes, theta):
            expected = expected @ p3d.transform_from_exponential_coordinates(axis * angle)
        close(own, expected, axes * theta[:, None], expected)
