//! Matrices become motions, in every layout on every backend, and those that are none are named.

use crate::memory::{Memory, lay, read, round};
use crate::records::entries;
use crate::scene::motions;
use dq8::hierarchy::MatrixOrder;
use dq8::scalar::MatrixError;
use dq8::simd::Float;
use dq8::slices::{MatricesError, RigidMatrix};
use dq8::storage::{AoSoA, Aos};
use dq8::{Backend, DualQuat, Real, ShapeError};
use dq8_contract::random::Random;

fn check<L: Memory, const C: usize>(backend: Backend, order: MatrixOrder, length: usize)
where
    L::Record<C>: RigidMatrix<C, Layout = L>,
{
    let mut random = Random(length as u64 + 7);
    let motions = motions(&mut random, length);
    let matrices = motions.iter().map(|m| entries(DualQuat::from_array(*m), order, C));
    let matrices: Vec<[f64; C]> = matrices.map(|all| all.try_into().expect("so many")).collect();
    let given = lay::<L, C>(1, &matrices);
    let blank = || vec![L::filled::<8>(L::Real::ZERO); given.len()];
    let what = format!("{} {backend} {order:?}, {length} of {C} numbers", L::name());
    let tolerance = round::<L::Real, 1>([1e-5])[0];

    let (mut quick, mut checked) = (blank(), blank());
    backend.from_matrices(&given, order, &mut quick).expect("they fit");
    for (got, wanted) in read::<L, 8>(1, &quick).iter().zip(&motions) {
        let sign = if got[..4].iter().zip(wanted).map(|(a, b)| a * b).sum::<f64>() < 0.0 {
            -1.0
        } else {
            1.0
        };
        let near = got
            .iter()
            .zip(wanted)
            .all(|(a, b)| (a - sign * b).abs() < if L::Real::SINGLE { 4e-6 } else { 1e-14 });
        assert!(near && got[3] >= 0.0, "{what}: {got:?} {wanted:?}");
    }
    backend.try_from_matrices(&given, order, tolerance, &mut checked).expect("they are rigid");
    assert_eq!(
        read::<L, 8>(1, &checked),
        read::<L, 8>(1, &quick),
        "{what}: a check changes nothing"
    );

    // One that scales, wherever it stands, and a later one that mirrors.
    for index in 0..length {
        let mut wrong = matrices.clone();
        let (place, last) = (if C == 16 || order == MatrixOrder::Rows { 5 } else { 4 }, length - 1);
        wrong[last][place] += 3.0;
        wrong[index][place] += 2.0;
        let mut untouched = blank();
        let answer =
            backend.try_from_matrices(&lay::<L, C>(1, &wrong), order, tolerance, &mut untouched);
        let Err(MatricesError::NotRigid {
            index: found,
            error: MatrixError::NotOrthonormal { .. },
        }) = answer
        else {
            panic!("{what}, {index}: {answer:?}");
        };
        assert_eq!(found, index, "{what}");
        assert_eq!(read::<L, 8>(1, &untouched), read::<L, 8>(1, &blank()), "{what}");
    }
    if length > 1 {
        let shape =
            ShapeError::Length { what: "motions", length: given.len() - 1, expected: given.len() };
        let mut short = blank();
        short.pop();
        assert_eq!(backend.from_matrices(&given, order, &mut short), Err(shape.clone()));
        let answer = backend.try_from_matrices(&given, order, tolerance, &mut short);
        assert_eq!(answer, Err(MatricesError::Shape(shape)));
    }
}

fn check_all<L: Memory>(lengths: &[usize])
where
    L::Record<12>: RigidMatrix<12, Layout = L>,
    L::Record<16>: RigidMatrix<16, Layout = L>,
{
    for backend in Backend::available() {
        for order in [MatrixOrder::Rows, MatrixOrder::Columns] {
            for &length in lengths {
                check::<L, 12>(backend, order, length);
                check::<L, 16>(backend, order, length);
            }
        }
    }
}

#[test]
fn rigid_matrices_are_motions_again_and_others_are_named() {
    check_all::<Aos<f32>>(&[0, 1, 3, 8, 19]);
    check_all::<Aos<f64>>(&[0, 1, 3, 8, 19]);
}

/// Blocks are filled: what is no matrix in a lane is named as well.
#[test]
fn rigid_matrices_in_blocks_are_motions_again_and_others_are_named() {
    check_all::<AoSoA<[f32; 8]>>(&[0, 8, 24]);
    check_all::<AoSoA<[f32; 16]>>(&[16, 32]);
    check_all::<AoSoA<[f64; 4]>>(&[4, 12]);
}

#[test]
fn what_a_last_row_must_be_is_said_of_the_matrix_that_has_another() {
    let one = DualQuat::<f64>::IDENTITY.to_matrix4();
    let mut perspective = one;
    perspective[3][2] = 0.5;
    let mut motions = [DualQuat::IDENTITY; 2];
    let backend = Backend::best();
    let answer =
        backend.try_from_matrices(&[one, perspective], MatrixOrder::Rows, 0.1, &mut motions);
    let error = MatrixError::NotAffine { column: 2, value: 0.5 };
    assert_eq!(answer, Err(MatricesError::NotRigid { index: 1, error }));
    let mut far = one;
    far[1][3] = f64::INFINITY;
    let answer =
        backend.try_from_matrices(&[far], MatrixOrder::Rows, f64::INFINITY, &mut motions[..1]);
    let error = MatrixError::NotFinite { row: 1, value: f64::INFINITY };
    assert_eq!(answer, Err(MatricesError::NotRigid { index: 0, error }));
}
