"""Meshes that follow joints, against the same sums in NumPy."""

import numpy as np
import pytest
from scipy.linalg import polar
from scipy.spatial.transform import RigidTransform

import dq8

VERTICES, JOINTS, INFLUENCES = 37, 6, 4


@pytest.fixture
def mesh(rng):
    """Points, joints, weights and normals; the last influence of some vertices has weight 0."""
    points = rng.normal(size=(VERTICES, 3))
    joints = rng.integers(JOINTS, size=(VERTICES, INFLUENCES))
    weights = rng.uniform(0.1, 1, size=(VERTICES, INFLUENCES))
    weights[::3, -1] = 0
    weights /= weights.sum(axis=1, keepdims=True)
    normals = rng.normal(size=(VERTICES, 3))
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    return points, joints, weights, normals


@pytest.fixture
def sheared(rng, random_motions):
    """Matrices that rotate, move, scale and shear."""

    def make(*shape: int) -> np.ndarray:
        stretch = np.eye(3) + 0.2 * rng.normal(size=(*shape, 3, 3))
        matrices = RigidTransform.from_dual_quat(random_motions(int(np.prod(shape)))).as_matrix().reshape(*shape, 4, 4)
        matrices[..., :3, :3] @= stretch @ stretch.swapaxes(-1, -2)
        return matrices

    return make


def cofactor(matrix: np.ndarray) -> np.ndarray:
    return np.linalg.det(matrix)[..., None, None] * np.linalg.inv(matrix).swapaxes(-1, -2)


def unit(vectors: np.ndarray) -> np.ndarray:
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


def linear_blend(points, joints, weights, matrices, normals):
    """Σ wᵢMᵢ for each vertex, `einsum` alone."""
    sums = np.einsum("vi,vijk->vjk", weights, matrices[joints])
    posed = np.einsum("vjk,vk->vj", sums[:, :3, :3], points) + sums[:, :3, 3]
    return posed, unit(np.einsum("vjk,vk->vj", cofactor(sums[:, :3, :3]), normals))


def dual_blend(points, joints, weights, motions, normals):
    """Σ ±wᵢσᵢ, signs toward the joint of greatest weight, as a matrix by SciPy."""
    picked = motions[joints]
    greatest = picked[np.arange(len(joints)), weights.argmax(axis=1)]
    signs = np.sign(np.einsum("vic,vc->vi", picked[..., :4], greatest[:, :4]))
    blend = np.einsum("vi,vi,vic->vc", weights, signs, picked)
    # Normalized as dual quaternions are: the dual part at right angles to the real one.
    matrices = RigidTransform.from_dual_quat(blend).as_matrix()
    posed = np.einsum("vjk,vk->vj", matrices[:, :3, :3], points) + matrices[:, :3, 3]
    return posed, np.einsum("vjk,vk->vj", matrices[:, :3, :3], normals)


def stretched_blend(points, joints, weights, matrices, normals):
    """What is left of polar decompositions is blended linearly, the rotations and translations as motions."""
    parts = [polar(matrix[:3, :3]) for matrix in matrices]
    stretches = np.array([stretch for _, stretch in parts])
    rigid = matrices.copy()
    rigid[:, :3, :3] = [rotation for rotation, _ in parts]
    sums = np.einsum("vi,vijk->vjk", weights, stretches[joints])
    points = np.einsum("vjk,vk->vj", sums, points)
    normals = unit(np.einsum("vjk,vk->vj", cofactor(sums), normals))
    return dual_blend(points, joints, weights, RigidTransform.from_matrix(rigid).as_dual_quat(), normals)


def test_dual_blends_are_those_of_numpy(mesh, random_motions, close):
    points, joints, weights, normals = mesh
    motions = random_motions(JOINTS, size=10)
    posed, turned = dq8.skin(points, joints, weights, motions, normals=normals)
    expected, expected_normals = dual_blend(points, joints, weights, motions, normals)
    close(posed, expected, motions, expected)
    close(turned, expected_normals, motions)
    np.testing.assert_array_equal(dq8.skin(points, joints, weights, motions), posed)


def test_the_sign_of_a_motion_changes_no_bit(mesh, random_motions, rng):
    points, joints, weights, _ = mesh
    motions = random_motions(JOINTS)
    signs = rng.choice([-1.0, 1.0], size=(JOINTS, 1))
    expected = dq8.skin(points, joints, weights, motions)
    np.testing.assert_array_equal(dq8.skin(points, joints, weights, signs * motions), expected)


@pytest.mark.parametrize("rows", [3, 4])
def test_linear_blends_of_any_matrix_are_those_of_numpy(mesh, sheared, close, rows):
    points, joints, weights, normals = mesh
    matrices = sheared(JOINTS)
    posed, turned = dq8.skin(points, joints, weights, matrices[:, :rows], method="lbs", normals=normals)
    expected, expected_normals = linear_blend(points, joints, weights, matrices, normals)
    close(posed, expected, matrices, points)
    close(turned, expected_normals)


def test_linear_blends_of_motions_are_those_of_their_matrices(mesh, random_motions, close):
    points, joints, weights, normals = mesh
    motions = random_motions(JOINTS, size=10)
    posed, _ = dq8.skin(points, joints, weights, motions, method="lbs", normals=normals)
    matrices = RigidTransform.from_dual_quat(motions).as_matrix()
    close(posed, linear_blend(points, joints, weights, matrices, normals)[0], matrices, points)


@pytest.mark.parametrize("rows", [3, 4])
def test_dual_blends_of_matrices_stretch_and_then_move(mesh, sheared, close, rows):
    points, joints, weights, normals = mesh
    matrices = sheared(JOINTS)
    posed, turned = dq8.skin(points, joints, weights, matrices[:, :rows], normals=normals)
    expected, expected_normals = stretched_blend(points, joints, weights, matrices, normals)
    close(posed, expected, matrices, expected)
    close(turned, expected_normals)


def test_dual_blends_of_rigid_matrices_are_those_of_their_motions(mesh, random_motions, close):
    points, joints, weights, _ = mesh
    motions = random_motions(JOINTS)
    close(
        dq8.skin(points, joints, weights, dq8.to_matrix(motions)),
        dq8.skin(points, joints, weights, motions),
        points,
        motions,
    )


@pytest.mark.parametrize("method", ["dlb", "lbs"])
@pytest.mark.parametrize("poses", [(), (1,), (5,), (2, 3), (0,)])
def test_leading_dimensions_of_the_palette_are_poses(mesh, sheared, random_motions, method, poses):
    points, joints, weights, normals = mesh
    for palette, core in ((random_motions(*poses, JOINTS), 2), (sheared(*poses, JOINTS), 3)):
        posed, turned = dq8.skin(points, joints, weights, palette, method=method, normals=normals)
        assert posed.shape == turned.shape == (*poses, VERTICES, 3)
        for index in np.ndindex(poses):
            one, one_turned = dq8.skin(points, joints, weights, palette[index], method=method, normals=normals)
            np.testing.assert_array_equal(posed[index], one)
            np.testing.assert_array_equal(turned[index], one_turned)


@pytest.mark.parametrize("influences", [1, 2, 5, 8])
def test_vertices_have_any_number_of_influences(rng, random_motions, close, influences):
    points, motions = rng.normal(size=(9, 3)), random_motions(JOINTS)
    joints = rng.integers(JOINTS, size=(9, influences))
    weights = rng.dirichlet(np.ones(influences), size=9)
    posed = dq8.skin(points, joints, weights, motions)
    close(posed, dual_blend(points, joints, weights, motions, points)[0], motions, points)


def test_dual_blends_divide_by_the_sum_of_weights_and_linear_ones_do_not(mesh, random_motions, close):
    points, joints, weights, _ = mesh
    motions = random_motions(JOINTS)
    close(dq8.skin(points, joints, 2 * weights, motions), dq8.skin(points, joints, weights, motions), motions, points)
    twice = dq8.skin(points, joints, 2 * weights, motions, method="lbs")
    close(twice, 2 * dq8.skin(points, joints, weights, motions, method="lbs"), motions, points)


def test_float32_stays_float32(mesh, sheared):
    points, joints, weights, normals = mesh
    palette = sheared(JOINTS)
    arrays = [array.astype(np.float32) for array in (points, weights, palette, normals)]
    for method in ("dlb", "lbs"):
        single = dq8.skin(arrays[0], joints, arrays[1], arrays[2], method=method, normals=arrays[3])
        double = dq8.skin(points, joints, weights, palette, method=method, normals=normals)
        for one, other in zip(single, double):
            assert one.dtype == np.float32
            np.testing.assert_allclose(one, other, rtol=0, atol=1e-4)
        mixed = dq8.skin(points, joints, arrays[1], arrays[2], method=method)
        assert mixed.dtype == np.float64


def test_every_layout_of_memory_and_integer_gives_the_same_bits(mesh, random_motions):
    points, joints, weights, normals = mesh
    motions = random_motions(3, JOINTS)
    expected = dq8.skin(points, joints, weights, motions, normals=normals)
    wide = np.zeros((VERTICES, 6))
    wide[:, ::2] = points
    frozen = points.copy()
    frozen.flags.writeable = False
    for same in (wide[:, ::2], np.asfortranarray(points), points.astype(">f8"), points.tolist(), frozen):
        np.testing.assert_array_equal(dq8.skin(same, joints, weights, motions), expected[0])
    for dtype in ("u1", "i1", "u2", "i4", "u4", "u8", ">i4"):
        np.testing.assert_array_equal(dq8.skin(points, joints.astype(dtype), weights, motions), expected[0])
    np.testing.assert_array_equal(dq8.skin(points, np.asfortranarray(joints), weights, motions), expected[0])
    repeated = np.broadcast_to(motions[0], (4, JOINTS, 8))
    np.testing.assert_array_equal(dq8.skin(points, joints, weights, repeated)[3], expected[0][0])


def test_out_is_written_and_returned(mesh, random_motions):
    points, joints, weights, normals = mesh
    motions = random_motions(2, JOINTS)
    expected = dq8.skin(points, joints, weights, motions, normals=normals)
    for make in (lambda: np.full((2, VERTICES, 3), np.nan), lambda: np.full((2, VERTICES, 3, 2), np.nan)[..., 0]):
        out = make()
        assert dq8.skin(points, joints, weights, motions, out=out) is out
        np.testing.assert_array_equal(out, expected[0])
        both = make(), make()
        posed, turned = dq8.skin(points, joints, weights, motions, normals=normals, out=both)
        assert posed is both[0] and turned is both[1]
        np.testing.assert_array_equal(both, expected)


def test_out_may_be_the_mesh_at_rest(mesh, random_motions):
    points, joints, weights, normals = mesh
    motions = random_motions(JOINTS)
    expected = dq8.skin(points, joints, weights, motions, normals=normals)
    swapped = (normals, points)
    posed, turned = dq8.skin(points, joints, weights, motions, normals=normals, out=swapped)
    np.testing.assert_array_equal(posed, expected[0])
    np.testing.assert_array_equal(turned, expected[1])


def test_a_mesh_without_vertices_is_one():
    empty = np.zeros((0, 3))
    posed = dq8.skin(empty, np.zeros((0, 4), int), np.zeros((0, 4)), dq8.identity(2)[None], normals=empty)
    assert posed[0].shape == posed[1].shape == (1, 0, 3)


def test_threads_change_no_bit(rng, random_motions, one_thread):
    count = 9001
    points, normals = rng.normal(size=(2, count, 3))
    joints, weights = rng.integers(JOINTS, size=(count, 4)), rng.dirichlet(np.ones(4), size=count)
    motions = random_motions(3, JOINTS)

    def results():
        for palette in (motions, motions[0], dq8.to_matrix(motions)):
            for method in ("dlb", "lbs"):
                yield from dq8.skin(points, joints, weights, palette, method=method, normals=normals)

    expected = list(results())
    dq8.set_num_threads(3)
    for result, one in zip(results(), expected, strict=True):
        np.testing.assert_array_equal(result, one)


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
        ((POINTS, INDICES, WEIGHTS, PALETTE), {"method": "dqs"}, ValueError, r"Expected `method` to be 'dlb' or 'lbs', got 'dqs'"),
        ((POINTS, INDICES, WEIGHTS, PALETTE), {"normals": POINTS[:4]}, ValueError, r"Expected `normals` to have shape \(5, 3\), got \(4, 3\)"),
        ((POINTS, INDICES, WEIGHTS, PALETTE), {"out": np.ones((5, 4))}, ValueError, r"Expected `out` to have shape \(5, 3\).*\(5, 4\)"),
        (
            (POINTS, INDICES, WEIGHTS, PALETTE),
            {"normals": POINTS, "out": np.ones((5, 3))},
            TypeError,
            r"Expected `out` to be a tuple of two arrays where there are `normals`, got ndarray",
        ),
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


def test_outs_may_lie_between_each_other(mesh, random_motions):
    points, joints, weights, normals = mesh
    motions = random_motions(JOINTS)
    expected = dq8.skin(points, joints, weights, motions, normals=normals)
    buffer = np.full((VERTICES, 7), 7.0)
    dq8.skin(points, joints, weights, motions, normals=normals, out=(buffer[:, :3], buffer[:, 3:6]))
    np.testing.assert_array_equal(buffer, np.hstack([*expected, np.full((VERTICES, 1), 7.0)]))
