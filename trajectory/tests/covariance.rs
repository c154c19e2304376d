//! Covariances are those of plain 6×6 matrices, and of many random poses; in every order and
//! layout.

use dq8::simd::Block;
use dq8::storage::{Element, LinearFirst, Number};
use dq8::{Backend, DualQuat, Real, Scalar, ShapeError, Twist};
use dq8_fixtures::random::Random;
use dq8_trajectory::covariance::{carry_covariances, inverse_covariances, product_covariances};

type Matrix = [[f64; 6]; 6];

fn matrix(entry: impl Fn(usize, usize) -> f64) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    matrix(|i, j| (0..6).map(|k| a[i][k] * b[k][j]).sum())
}

fn transposed(a: &Matrix) -> Matrix {
    matrix(|i, j| a[j][i])
}

fn sum(a: &Matrix, b: &Matrix) -> Matrix {
    matrix(|i, j| a[i][j] + b[i][j])
}

/// [[R, 0], [TR, R]] by the 3×4 matrix of a motion.
fn adjoint(motion: DualQuat<f64>) -> Matrix {
    let m = motion.to_matrix3x4();
    let [x, y, z] = [m[0][3], m[1][3], m[2][3]];
    let cross = [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]];
    matrix(|i, j| match (i / 3, j / 3) {
        (0, 1) => 0.0,
        (1, 0) => (0..3).map(|k| cross[i - 3][k] * m[k][j]).sum(),
        _ => m[i % 3][j % 3],
    })
}

fn by(motion: DualQuat<f64>, covariance: &Matrix) -> Matrix {
    let adjoint = adjoint(motion);
    product(&product(&adjoint, covariance), &transposed(&adjoint))
}

/// LLᵀ, and L.
fn covariance(random: &mut Random, size: f64) -> (Matrix, Matrix) {
    let low: Matrix = std::array::from_fn(|_| random.vector::<6>().map(|x| size * x));
    (product(&low, &transposed(&low)), low)
}

/// The order of the other kinds of memory.
fn linear_first(a: &Matrix) -> Matrix {
    matrix(|i, j| a[(i + 3) % 6][(j + 3) % 6])
}

fn stored<P: Element<36>>(empty: P, count: usize, matrices: &[Matrix]) -> Vec<P> {
    let mut stored = vec![empty; count];
    for (i, matrix) in matrices.iter().enumerate() {
        let numbers =
            std::array::from_fn(|k| <Number<P, 36> as Real>::from_f64(matrix[k / 6][k % 6]));
        P::set(&mut stored, i, numbers);
    }
    stored
}

fn held<M: Element<8>>(empty: M, count: usize, motions: &[DualQuat<f64>]) -> Vec<M> {
    let mut held = vec![empty; count];
    for (i, motion) in motions.iter().enumerate() {
        M::set(&mut held, i, motion.to_array().map(<Number<M, 8> as Real>::from_f64));
    }
    held
}

fn close<R: Scalar>(found: Option<[R; 36]>, wanted: &Matrix, what: &str) {
    let found = found.unwrap();
    let scale = wanted.as_flattened().iter().fold(1.0_f64, |scale, x| scale.max(x.abs()));
    for (found, wanted) in found.into_iter().zip(wanted.as_flattened()) {
        let error = (found.into() - wanted).abs() / scale;
        assert!(
            error <= 64.0 * Into::<f64>::into(R::EPSILON),
            "{what}: {error:e}, {} for {wanted}",
            found.into()
        );
    }
    for (i, j) in (0..36).map(|k| (k / 6, k % 6)) {
        assert_eq!(found[6 * i + j], found[6 * j + i], "{what}: symmetric to the last bit");
    }
}

/// All three, in one kind of memory.
fn agree<M: Element<8>, P: Element<36, Layout = M::Layout>>(
    things: usize,
    motion: M,
    empty: P,
    what: &str,
) {
    let mut random = Random(21);
    for count in [0_usize, 1, 3, 37, 600] {
        let motions: Vec<_> = (0..count).map(|_| random.motion(3.0)).collect();
        let [a, b]: [Vec<_>; 2] =
            std::array::from_fn(|_| (0..count).map(|_| covariance(&mut random, 1.0).0).collect());
        let elements = count.div_ceil(things);
        let held = held(motion, elements, &motions);
        let [first, second] = [&a, &b].map(|all| stored(empty, elements, all));
        for backend in Backend::available() {
            let [mut carried, mut inverse, mut joined] = [(); 3].map(|()| vec![empty; elements]);
            carry_covariances(backend, &held, &first, &mut carried).unwrap();
            inverse_covariances(backend, &held, &first, &mut inverse).unwrap();
            product_covariances(backend, &held, &first, &second, &mut joined).unwrap();
            for (i, &motion) in motions.iter().enumerate() {
                let what = format!("{what}, {backend}, {i} of {count}");
                close(P::get(&carried, i), &by(motion, &a[i]), &what);
                close(P::get(&inverse, i), &by(motion, &a[i]), &what);
                let wanted = sum(&by(motion.conjugate(), &a[i]), &b[i]);
                close(P::get(&joined, i), &wanted, &what);
            }
        }
    }
}

#[test]
fn covariances_agree_with_plain_matrices_in_every_layout() {
    let (single, double) = (DualQuat::<f32>::IDENTITY, DualQuat::<f64>::IDENTITY);
    agree(1, double, [0.0; 36], "numbers");
    agree(1, single, [[0.0; 6]; 6], "rows, f32");
    agree(1, double, [[0.0; 6]; 6], "rows");
    agree(1, single, [LinearFirst([0.0; 6]); 6], "linear first, f32");
    agree(1, double, [LinearFirst([0.0; 6]); 6], "linear first");
    agree(4, Block([[0.0_f64; 4]; 8]), Block([[0.0; 4]; 36]), "blocks");
    agree(8, Block([[0.0_f32; 8]; 8]), Block([[0.0; 8]; 36]), "blocks, f32");
}

/// The order that others hold in memory, number by number, against the same matrices with the
/// blocks changed.
#[test]
fn linear_first_changes_rows_and_columns_alone() {
    let mut random = Random(22);
    let motions: Vec<_> = (0..19).map(|_| random.motion(3.0)).collect();
    let matrices: Vec<_> = (0..19).map(|_| covariance(&mut random, 1.0).0).collect();
    let others: Vec<_> = matrices.iter().map(|a| linear_first(a).map(LinearFirst)).collect();
    let (mut found, mut wanted) = ([[LinearFirst([0.0; 6]); 6]; 19], [[[0.0; 6]; 6]; 19]);
    for backend in Backend::available() {
        carry_covariances(backend, &motions, &others, &mut found).unwrap();
        carry_covariances(backend, &motions, &matrices, &mut wanted).unwrap();
        for (found, wanted) in found.iter().zip(&wanted) {
            assert_eq!(found.map(|row| row.0), linear_first(wanted));
        }
    }
}

#[test]
fn carrying_is_a_group_and_products_are_associative() {
    let mut random = Random(23);
    let best = Backend::best();
    let carry = |motion, covariance| {
        let mut carried = [[[0.0; 6]; 6]];
        carry_covariances(best, &[motion], &[covariance], &mut carried).unwrap();
        carried[0]
    };
    let join = |pose, first, second| {
        let mut joined = [[[0.0; 6]; 6]];
        product_covariances(best, &[pose], &[first], &[second], &mut joined).unwrap();
        joined[0]
    };
    let flat = |a: Matrix| Some(std::array::from_fn::<f64, 36, _>(|k| a[k / 6][k % 6]));
    for _ in 0..100 {
        let [a, b]: [DualQuat<f64>; 2] = std::array::from_fn(|_| random.motion(2.0));
        let [p, q, r]: [Matrix; 3] = std::array::from_fn(|_| covariance(&mut random, 1.0).0);
        close(flat(carry(a * b, p)), &carry(a, carry(b, p)), "of a product");
        close(flat(carry(a.conjugate(), carry(a, p))), &p, "there and back");
        assert_eq!(
            carry(DualQuat::IDENTITY, p),
            carry(DualQuat::IDENTITY, carry(DualQuat::IDENTITY, p))
        );
        // (x a) b and x (a b)
        close(flat(join(b, join(a, p, q), r)), &join(a * b, p, join(b, q, r)), "associative");
        // (a b)⁻¹ = b⁻¹ a⁻¹; the pose of the second factor is a⁻¹.
        let inverse = join(a.conjugate(), carry(b, q), carry(a, p));
        close(flat(carry(a * b, join(b, p, q))), &inverse, "inverse of a product");
    }
}

/// Numbers of the normal distribution (Box and Muller 1958).
fn normal(random: &mut Random) -> f64 {
    let (radius, angle) = (random.between(1e-300, 1.0), random.between(0.0, std::f64::consts::TAU));
    (-2.0 * radius.ln()).sqrt() * angle.cos()
}

/// The covariance of the errors 2 log(σ̄⁻¹σ) of random poses is what was promised for them.
#[test]
fn many_random_poses_have_these_covariances() {
    const SAMPLES: usize = 40_000;
    let mut random = Random(24);
    let [a, b]: [DualQuat<f64>; 2] = std::array::from_fn(|_| random.motion(2.0));
    let [(p, low_p), (q, low_q)] = [(); 2].map(|()| covariance(&mut random, 2e-3));
    let mut error = |low: &Matrix| {
        let numbers: [f64; 6] = std::array::from_fn(|_| normal(&mut random));
        let twist = std::array::from_fn(|i| (0..6).map(|k| low[i][k] * numbers[k]).sum());
        DualQuat::from_twist(Twist::from_array(twist))
    };
    let mut sums = [[[0.0; 6]; 6]; 3];
    for _ in 0..SAMPLES {
        let (first, second) = (a * error(&low_p), b * error(&low_q));
        let errors = [
            // On the left: σσ̄⁻¹.
            first * a.conjugate(),
            a * first.conjugate(),
            (a * b).conjugate() * (first * second),
        ];
        for (sum, error) in sums.iter_mut().zip(errors) {
            let error = error.to_twist().to_array();
            *sum = matrix(|i, j| sum[i][j] + error[i] * error[j] / SAMPLES as f64);
        }
    }
    let mut wanted = [[[0.0; 6]; 6]; 3];
    carry_covariances(Backend::best(), &[a], &[p], &mut wanted[..1]).unwrap();
    inverse_covariances(Backend::best(), &[a], &[p], &mut wanted[1..2]).unwrap();
    product_covariances(Backend::best(), &[b], &[p], &[q], &mut wanted[2..]).unwrap();
    for (found, wanted) in sums.iter().zip(wanted) {
        for (i, j) in (0..36).map(|k| (k / 6, k % 6)) {
            // Five standard deviations of an entry: √((PᵢᵢPⱼⱼ + Pᵢⱼ²) / n).
            let spread = (wanted[i][i] * wanted[j][j] + wanted[i][j].powi(2)) / SAMPLES as f64;
            let error = (found[i][j] - wanted[i][j]).abs();
            assert!(error < 5.0 * spread.sqrt(), "{i} {j}: {} for {}", found[i][j], wanted[i][j]);
        }
    }
}

#[test]
fn nan_stays_in_its_covariance_and_one_half_is_read() {
    let mut random = Random(25);
    let motions: Vec<_> = (0..40).map(|_| random.motion(2.0)).collect();
    let whole: Vec<_> = (0..40).map(|_| covariance(&mut random, 1.0).0).collect();
    for backend in Backend::available() {
        let [mut wanted, mut found] = [[[[0.0; 6]; 6]; 40]; 2];
        product_covariances(backend, &motions, &whole, &whole, &mut wanted).unwrap();
        // A lower half of anything is not read.
        let mut half = whole.clone();
        for (i, row) in half.iter_mut().flat_map(|matrix| matrix.iter_mut().enumerate()) {
            row[..i].fill(f64::NAN);
        }
        product_covariances(backend, &motions, &half, &half, &mut found).unwrap();
        assert_eq!(found, wanted);
        let (mut bad, mut turned) = (whole.clone(), motions.clone());
        bad[7][2][4] = f64::NAN;
        turned[21] = DualQuat::from_array([f64::NAN; 8]);
        product_covariances(backend, &turned, &bad, &whole, &mut found).unwrap();
        for (i, (found, wanted)) in found.iter().zip(&wanted).enumerate() {
            let is_nan = found.as_flattened().iter().any(|number| number.is_nan());
            assert_eq!(is_nan, [7, 21].contains(&i), "{i}");
            assert!(is_nan || found == wanted);
        }
    }
}

#[test]
fn other_lengths_are_refused_and_nothing_is_written() {
    let motions = [DualQuat::<f64>::IDENTITY; 3];
    let given = [[[1.0; 6]; 6]; 3];
    let mut out = [[[7.0; 6]; 6]; 3];
    let best = Backend::best();
    let length = |what| Err(ShapeError::Length { what, length: 2, expected: 3 });
    assert_eq!(carry_covariances(best, &motions, &given[..2], &mut out), length("covariances"));
    assert_eq!(carry_covariances(best, &motions, &given, &mut out[..2]), length("carried"));
    assert_eq!(inverse_covariances(best, &motions, &given[..2], &mut out), length("covariances"));
    assert_eq!(inverse_covariances(best, &motions, &given, &mut out[..2]), length("inverses"));
    let short = &given[..2];
    assert_eq!(product_covariances(best, &motions, short, &given, &mut out), length("first"));
    assert_eq!(product_covariances(best, &motions, &given, short, &mut out), length("second"));
    let joined = product_covariances(best, &motions, &given, &given, &mut out[..2]);
    assert_eq!(joined, length("products"));
    assert_eq!(out, [[[7.0; 6]; 6]; 3]);
}
