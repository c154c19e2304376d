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
def tangents(mesh, rng):
    """At right angles to the normals."""
    return unit(np.cross(mesh[3], rng.normal(size=(VERTICES, 3))))


@pytest.fixture
def shares(rng):
    """How much of the dual blend there is in each vertex; none and all of it in some."""
    return np.concatenate([rng.uniform(size=VERTICES - 2), [0.0, 1.0]])


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


def each(matrices: np.ndarray, vectors: np.ndarray) -> np.ndarray:
    return np.einsum("vjk,vk->vj", matrices, vectors)


def linear_blend(points, joints, weights, matrices, normals, *tangents):
    """Σ wᵢMᵢ for each vertex, `einsum` alone."""
    sums = np.einsum("vi,vijk->vjk", weights, matrices[joints])
    linear = sums[:, :3, :3]
    posed = each(linear, points) + sums[:, :3, 3]
    return posed, unit(each(cofactor(linear), normals)), *(unit(each(linear, t)) for t in tangents)


def dual_blend(points, joints, weights, motions, *directions):
    """Σ ±wᵢσᵢ, signs toward the joint of greatest weight, as a matrix by SciPy."""
    picked = motions[joints]
    greatest = picked[np.arange(len(joints)), weights.argmax(axis=1)]
    signs = np.sign(np.einsum("vic,vc->vi", picked[..., :4], greatest[:, :4]))
    blend = np.einsum("vi,vi,vic->vc", weights, signs, picked)
    # Normalized as dual quaternions are: the dual part at right angles to the real one.
    matrices = RigidTransform.from_dual_quat(blend).as_matrix()
    rotations = matrices[:, :3, :3]
    return each(rotations, points) + matrices[:, :3, 3], *(each(rotations, direction) for direction in directions)


def stretched_blend(points, joints, weights, matrices, normals, *tangents):
    """What is left of polar decompositions is blended linearly, the rotations and translations as motions."""
    parts = [polar(matrix[:3, :3]) for matrix in matrices]
    stretches = np.array([stretch for _, stretch in parts])
    rigid = matrices.copy()
    rigid[:, :3, :3] = [rotation for rotation, _ in parts]
    sums = np.einsum("vi,vijk->vjk", weights, stretches[joints])
    points, normals = each(sums, points), unit(each(cofactor(sums), normals))
    tangents = [unit(each(sums, t)) for t in tangents]
    return dual_blend(points, joints, weights, RigidTransform.from_matrix(rigid).as_dual_quat(), normals, *tangents)


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


def both_blends(points, joints, weights, palette, *directions):
    """The linear one and the dual one, of either kind of palette."""
    if palette.shape[-1] == 8:
        matrices = RigidTransform.from_dual_quat(palette).as_matrix()
        dual = dual_blend(points, joints, weights, palette, *directions)
        return linear_blend(points, joints, weights, matrices, *directions), dual
    linear = linear_blend(points, joints, weights, palette, *directions)
    return linear, stretched_blend(points, joints, weights, palette, *directions)


@pytest.fixture(params=["motions", "matrices"])
def palette(request, random_motions, sheared):
    return random_motions(JOINTS, size=10) if request.param == "motions" else sheared(JOINTS)


@pytest.mark.parametrize("method", ["dlb", "lbs"])
def test_tangents_follow_the_blend_as_in_numpy(mesh, tangents, palette, close, method):
    *mesh, normals = mesh
    posed = dq8.skin(*mesh, palette, method=method, normals=normals, tangents=tangents)
    expected = both_blends(*mesh, palette, normals, tangents)[method == "dlb"]
    for actual, wanted in zip(posed, expected, strict=True):
        close(actual, wanted, mesh[0], palette)
    # Without normals they are the same.
    alone = dq8.skin(*mesh, palette, method=method, tangents=tangents)
    for actual, wanted in zip(alone, (posed[0], posed[2]), strict=True):
        np.testing.assert_array_equal(actual, wanted)


def test_mixed_blends_are_both_by_the_share_of_each_vertex(mesh, tangents, shares, palette, close):
    *mesh, normals = mesh
    posed = dq8.skin(*mesh, palette, method="mix", shares=shares, normals=normals, tangents=tangents)
    linear, dual = both_blends(*mesh, palette, normals, tangents)
    mixed = [(1 - shares[:, None]) * a + shares[:, None] * b for a, b in zip(linear, dual)]
    for actual, wanted in zip(posed, (mixed[0], unit(mixed[1]), unit(mixed[2])), strict=True):
        close(actual, wanted, mesh[0], palette)


def test_a_mix_of_one_blend_alone_is_that_blend(mesh, palette):
    for share, method in ((0.0, "lbs"), (1.0, "dlb")):
        mixed = dq8.skin(*mesh[:3], palette, method="mix", shares=np.full(VERTICES, share))
        np.testing.assert_array_equal(mixed, dq8.skin(*mesh[:3], palette, method=method))


def test_dual_blends_of_rigid_matrices_are_those_of_their_motions(mesh, random_motions, close):
    points, joints, weights, _ = mesh
    motions = random_motions(JOINTS)
    close(
        dq8.skin(points, joints, weights, dq8.to_matrix(motions)),
        dq8.skin(points, joints, weights, motions),
        points,
        motions,
    )


@pytest.mark.parametrize("method", ["dlb", "lbs", "mix"])
@pytest.mark.parametrize("poses", [(), (1,), (5,), (2, 3), (0,)])
def test_leading_dimensions_of_the_palette_are_poses(mesh, tangents, shares, sheared, random_motions, method, poses):
    *mesh, normals = mesh
    options = {"method": method, "normals": normals, "tangents": tangents, "shares": shares if method == "mix" else None}
    for palette in (random_motions(*poses, JOINTS), sheared(*poses, JOINTS)):
        posed = dq8.skin(*mesh, palette, **options)
        assert [array.shape for array in posed] == 3 * [(*poses, VERTICES, 3)]
        for index in np.ndindex(poses):
            for one, many in zip(dq8.skin(*mesh, palette[index], **options), posed, strict=True):
                np.testing.assert_array_equal(many[index], one)


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
    # Within the rounding that is forgiven; more is refused.
    more = dq8.skin(points, joints, 1.0005 * weights, motions, method="lbs")
    close(more, 1.0005 * dq8.skin(points, joints, weights, motions, method="lbs"), motions, points)
    with pytest.raises(ValueError, match="`weights`: vertex 0: the weights sum to 2"):
        dq8.skin(points, joints, 2 * weights, motions, method="lbs")


def test_float32_stays_float32(mesh, shares, palette, close):
    points, joints, weights, normals = mesh
    for method in ("dlb", "lbs", "mix"):

        def skin(points, weights, palette, normals, shares):
            shares = shares if method == "mix" else None
            return dq8.skin(points, joints, weights, palette, method=method, shares=shares, normals=normals, tangents=normals)

        arrays = [array.astype(np.float32) for array in (points, weights, palette, normals, shares)]
        single, double = skin(*arrays), skin(*(array.astype(np.float64) for array in arrays))
        for one, other in zip(single, double, strict=True):
            assert one.dtype == np.float32
            close(one, other, points, palette, bound=2**-21)
        assert skin(points, *arrays[1:])[0].dtype == np.float64


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
    motions, shares = random_motions(3, JOINTS), rng.random(count)

    def results():
        for palette in (motions, motions[0], dq8.to_matrix(motions)):
            for method in ("dlb", "lbs", "mix"):
                options = {"method": method, "shares": shares if method == "mix" else None}
                yield from dq8.skin(points, joints, weights, palette, normals=normals, tangents=normals, **options)

    expected = list(results())
    dq8.set_num_threads(3)
    for result, one in zip(results(), expected, strict=True):
        np.testing.assert_array_equal(result, one)


def test_three_arrays_of_out_are_written_and_returned(mesh, tangents, shares, palette):
    *mesh, normals = mesh
    options = {"method": "mix", "shares": shares, "normals": normals, "tangents": tangents}
    out = tuple(np.full((VERTICES, 3), np.nan) for _ in range(3))
    for expected, written, returned in zip(
        dq8.skin(*mesh, palette, **options), out, dq8.skin(*mesh, palette, **options, out=out), strict=True
    ):
        assert returned is written
        np.testing.assert_array_equal(written, expected)
    # Over what is read.
    mesh[0], normals, tangents = (array.copy() for array in (mesh[0], normals, tangents))
    options.update(normals=normals, tangents=tangents)
    for expected, written in zip(out, dq8.skin(*mesh, palette, **options, out=(tangents, mesh[0], normals)), strict=True):
        np.testing.assert_array_equal(written, expected)


def test_outs_may_lie_between_each_other(mesh, random_motions):
    points, joints, weights, normals = mesh
    motions = random_motions(JOINTS)
    expected = dq8.skin(points, joints, weights, motions, normals=normals)
    buffer = np.full((VERTICES, 7), 7.0)
    dq8.skin(points, joints, weights, motions, normals=normals, out=(buffer[:, :3], buffer[:, 3:6]))
    np.testing.assert_array_equal(buffer, np.hstack([*expected, np.full((VERTICES, 1), 7.0)]))


@pytest.mark.parametrize("method", ["dlb", "lbs", "mix"])
@pytest.mark.parametrize("dtype", [np.uint8, np.uint16])
def test_unsigned_weights_of_8_and_16_bits_are_normalized_as_in_gltf(mesh, shares, random_motions, method, dtype):
    points, joints, weights, _ = mesh
    one = np.iinfo(dtype).max
    stored = np.floor(weights * one).astype(dtype)
    stored[:, 0] += (one - stored.sum(axis=1, dtype=np.int64)).astype(dtype)
    options = {"method": method, "shares": shares if method == "mix" else None}
    motions = random_motions(JOINTS)
    posed = dq8.skin(points, joints, stored, motions, **options)
    assert posed.dtype == np.float64
    np.testing.assert_array_equal(posed, dq8.skin(points, joints, stored / np.float64(one), motions, **options))


def test_whole_weights_are_numbers_as_they_are(mesh, random_motions):
    points, joints, _, _ = mesh
    motions, whole = random_motions(JOINTS), [[0, 1, 0, 0]] * VERTICES
    expected = dq8.transform_points(motions[joints[:, 1]], points)
    for same in (whole, np.array(whole), np.array(whole, np.int32), np.array(whole, bool), np.array(whole, np.float16)):
        np.testing.assert_allclose(dq8.skin(points, joints, same, motions, method="lbs"), expected, rtol=0, atol=1e-14)


def test_large_meshes_are_posed_as_their_parts(rng, random_motions, one_thread):
    points, joints = rng.normal(size=(10_001, 3)), rng.integers(JOINTS, size=(10_001, 3))
    weights, shares, palette = rng.dirichlet(np.ones(3), 10_001), rng.random(10_001), random_motions(3, JOINTS)
    options = {"method": "mix", "shares": shares, "normals": points, "tangents": points}
    for threads in (1, 2):
        dq8.set_num_threads(threads)
        whole = dq8.skin(points, joints, weights, palette, **options)
        for part in (slice(0, 10), slice(4_000, 4_200), slice(9_990, None)):
            cut = {name: value if name == "method" else value[part] for name, value in options.items()}
            parts = dq8.skin(points[part], joints[part], weights[part], palette, **cut)
            for one, other in zip(whole, parts):
                np.testing.assert_array_equal(one[:, part], other)
