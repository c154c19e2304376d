//! Kernels over slices: in every layout, on every backend, of any length, what one motion after the
//! other is.

use crate::inputs::{BETWEEN, HEAVIER, Inputs, LONG};
use crate::memory::{Memory, lay, read, round};
use crate::records::{equal, is_finite, same_bits};
use crate::scene::rounded;
#[cfg(doc)]
use crate::subject::Subject;
use crate::subject::for_every_subject;
use dq8::{Backend, DualQuat, Line, Plane, Twist, geometry::DualVector, hierarchy::MatrixOrder};

/// What is computed of [`Inputs`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Operation {
    Mul,
    MulLeft,
    Normalize,
    Inverse,
    Nlerp,
    NlerpEach,
    Sclerp,
    SclerpEach,
    Points,
    Vectors,
    PointsEach,
    VectorsEach,
    LinesEach,
    PlanesEach,
    TwistsEach,
    Conjugate,
    Dlb,
    Log,
    Exp,
    ToTwist,
    FromTwist,
    PowEach,
    IntegrateBody,
    Angles,
    Distances,
    Matrices3x4(MatrixOrder),
    Matrices4x4(MatrixOrder),
}

impl Operation {
    pub(crate) const ALL: [Self; 29] = [
        Self::Mul,
        Self::MulLeft,
        Self::Normalize,
        Self::Inverse,
        Self::Nlerp,
        Self::NlerpEach,
        Self::Sclerp,
        Self::SclerpEach,
        Self::Points,
        Self::Vectors,
        Self::PointsEach,
        Self::VectorsEach,
        Self::LinesEach,
        Self::PlanesEach,
        Self::TwistsEach,
        Self::Conjugate,
        Self::Dlb,
        Self::Log,
        Self::Exp,
        Self::ToTwist,
        Self::FromTwist,
        Self::PowEach,
        Self::IntegrateBody,
        Self::Angles,
        Self::Distances,
        Self::Matrices3x4(MatrixOrder::Rows),
        Self::Matrices3x4(MatrixOrder::Columns),
        Self::Matrices4x4(MatrixOrder::Rows),
        Self::Matrices4x4(MatrixOrder::Columns),
    ];
}

/// What [`Subject::slices`] gives, of one layout.
pub(crate) fn compute<L: Memory>(
    backend: Backend,
    operation: Operation,
    inputs: &Inputs,
) -> Vec<Vec<f64>> {
    let (a, b) = (lay::<L, 8>(1, &inputs.a), lay::<L, 8>(1, &inputs.b));
    let (t, vectors) = (lay::<L, 1>(1, &inputs.t), lay::<L, 3>(1, &inputs.vectors));
    let one = DualQuat::from_array(round(inputs.one));
    let [between] = round([BETWEEN]);
    let long = lay::<L, 8>(1, &inputs.long());
    let mut motions = b.clone();
    let mut moved = vectors.clone();
    let planes = lay::<L, 4>(1, &inputs.planes);
    let (twists, mut numbers) = (lay::<L, 6>(1, &inputs.twists), t.clone());
    let (mut moved_planes, mut moved_twists) = (planes.clone(), twists.clone());
    let answer = match operation {
        Operation::Mul => {
            let mut products = a.clone();
            backend.mul_in_place(&mut products, &b).expect("they fit");
            let answer = backend.mul(&a, &b, &mut motions);
            assert_in_place::<L, 8>(&products, &motions);
            answer
        }
        Operation::MulLeft => {
            backend.mul_left_in_place(one, &mut motions);
            Ok(())
        }
        Operation::Normalize => {
            let mut units = long.clone();
            backend.normalize_in_place(&mut units);
            let answer = backend.normalize(&long, &mut motions);
            assert_in_place::<L, 8>(&units, &motions);
            answer
        }
        Operation::Inverse => {
            let mut inverses = long.clone();
            backend.inverse_in_place(&mut inverses);
            let answer = backend.inverse(&long, &mut motions);
            assert_in_place::<L, 8>(&inverses, &motions);
            answer
        }
        Operation::Nlerp => backend.nlerp(&a, &b, between, &mut motions),
        Operation::NlerpEach => backend.nlerp_each(&a, &b, &t, &mut motions),
        Operation::Sclerp => backend.sclerp(&a, &b, between, &mut motions),
        Operation::SclerpEach => backend.sclerp_each(&a, &b, &t, &mut motions),
        Operation::Points => {
            let mut in_place = vectors.clone();
            backend.transform_points_in_place(one, &mut in_place);
            let answer = backend.transform_points(one, &vectors, &mut moved);
            assert_in_place::<L, 3>(&in_place, &moved);
            answer
        }
        Operation::Vectors => {
            let mut in_place = vectors.clone();
            backend.transform_vectors_in_place(one, &mut in_place);
            let answer = backend.transform_vectors(one, &vectors, &mut moved);
            assert_in_place::<L, 3>(&in_place, &moved);
            answer
        }
        Operation::PointsEach => backend.transform_points_each(&a, &vectors, &mut moved),
        Operation::VectorsEach => backend.transform_vectors_each(&a, &vectors, &mut moved),
        Operation::LinesEach => backend.transform_lines_each(&a, &twists, &mut moved_twists),
        Operation::PlanesEach => backend.transform_planes_each(&a, &planes, &mut moved_planes),
        Operation::TwistsEach => backend.transform_twists_each(&a, &twists, &mut moved_twists),
        Operation::Conjugate => {
            let mut conjugates = a.clone();
            backend.conjugate_in_place(&mut conjugates);
            let answer = backend.conjugate(&a, &mut motions);
            assert_in_place::<L, 8>(&conjugates, &motions);
            answer
        }
        Operation::Dlb => {
            let weights = lay::<L, 1>(1, &vec![[HEAVIER]; inputs.a.len()]);
            backend.dlb([(&a[..], &weights[..]), (&b, &t)], &mut motions)
        }
        Operation::Log => backend.log(&a, &mut moved_twists),
        Operation::Exp => backend.exp(&twists, &mut motions),
        Operation::ToTwist => backend.to_twist(&a, &mut moved_twists),
        Operation::FromTwist => backend.from_twist(&twists, &mut motions),
        Operation::PowEach => backend.pow_each(&a, &t, &mut motions),
        Operation::IntegrateBody => {
            backend.integrate_body(&a, &twists, round([BETWEEN])[0], &mut motions)
        }
        Operation::Angles => backend.angles(&a, &b, &mut numbers),
        Operation::Distances => backend.distances(&a, &b, &mut numbers),
        Operation::Matrices3x4(order) => {
            let mut matrices = lay::<L, 12>(1, &vec![[9.0; 12]; inputs.a.len()]);
            backend.matrices(&a, order, &mut matrices).expect("they fit");
            return flat(inputs, &read::<L, 12>(1, &matrices));
        }
        Operation::Matrices4x4(order) => {
            let mut matrices = lay::<L, 16>(1, &vec![[9.0; 16]; inputs.a.len()]);
            backend.matrices(&a, order, &mut matrices).expect("they fit");
            return flat(inputs, &read::<L, 16>(1, &matrices));
        }
    };
    answer.expect("they fit");
    match operation {
        Operation::Points | Operation::Vectors | Operation::PointsEach | Operation::VectorsEach => {
            flat(inputs, &read::<L, 3>(1, &moved))
        }
        Operation::PlanesEach => flat(inputs, &read::<L, 4>(1, &moved_planes)),
        Operation::LinesEach | Operation::TwistsEach | Operation::Log | Operation::ToTwist => {
            flat(inputs, &read::<L, 6>(1, &moved_twists))
        }
        Operation::Angles | Operation::Distances => flat(inputs, &read::<L, 1>(1, &numbers)),
        _ => flat(inputs, &read::<L, 8>(1, &motions)),
    }
}

fn flat<const C: usize>(inputs: &Inputs, records: &[[f64; C]]) -> Vec<Vec<f64>> {
    records.iter().take(inputs.a.len()).map(|record| record.to_vec()).collect()
}

fn assert_in_place<L: Memory, const C: usize>(in_place: &[L::Record<C>], apart: &[L::Record<C>]) {
    let (in_place, apart) = (read::<L, C>(1, in_place), read::<L, C>(1, apart));
    crate::records::assert_same_bits(&in_place, &apart, "in place");
}

fn halves([a, b, c, d, e, f]: [f64; 6]) -> ([f64; 3], [f64; 3]) {
    ([a, b, c], [d, e, f])
}

/// The same by the scalar reference in `f64`.
fn wanted(operation: Operation, inputs: &Inputs, i: usize, between: f64) -> Vec<f64> {
    let motion = DualQuat::<f64>::from_array;
    let (a, b, one) = (motion(inputs.a[i]), motion(inputs.b[i]), motion(inputs.one));
    let ([t], v) = (inputs.t[i], inputs.vectors[i]);
    let entry = |columns: bool, count: usize| {
        let (rows, matrix) = (count / 4, a.to_matrix4());
        let place = |k: usize| if columns { (k % rows, k / rows) } else { (k / 4, k % 4) };
        (0..count).map(|k| matrix[place(k).0][place(k).1]).collect()
    };
    match operation {
        Operation::Mul => (a * b).to_array().to_vec(),
        Operation::MulLeft => (one * b).to_array().to_vec(),
        Operation::Normalize => a.to_array().to_vec(),
        Operation::Inverse => a.conjugate().scale(1.0 / LONG).to_array().to_vec(),
        Operation::Nlerp => a.nlerp(b, between).to_array().to_vec(),
        Operation::NlerpEach => a.nlerp(b, t).to_array().to_vec(),
        Operation::Sclerp => a.sclerp(b, between).to_array().to_vec(),
        Operation::SclerpEach => a.sclerp(b, t).to_array().to_vec(),
        Operation::Points => one.transform_point(v).to_vec(),
        Operation::Vectors => one.transform_vector(v).to_vec(),
        Operation::PointsEach => a.transform_point(v).to_vec(),
        Operation::VectorsEach => a.transform_vector(v).to_vec(),
        Operation::LinesEach => {
            let ([x, y, z], [u, v, w]) = halves(inputs.twists[i]);
            let line = a.transform_line(Line { direction: [x, y, z], moment: [u, v, w] });
            [line.direction, line.moment].concat()
        }
        Operation::PlanesEach => {
            let [x, y, z, offset] = inputs.planes[i];
            let plane = a.transform_plane(Plane { normal: [x, y, z], offset });
            [&plane.normal[..], &[plane.offset]].concat()
        }
        Operation::TwistsEach => a.adjoint(Twist::from_array(inputs.twists[i])).to_array().to_vec(),
        Operation::Conjugate => a.conjugate().to_array().to_vec(),
        Operation::Dlb => DualQuat::dlb(&[(a, HEAVIER), (b, t)]).expect("two").to_array().to_vec(),
        Operation::Log => [a.log().real, a.log().dual].concat(),
        Operation::Exp => {
            let (real, dual) = halves(inputs.twists[i]);
            DualQuat::exp(DualVector { real, dual }).to_array().to_vec()
        }
        Operation::ToTwist => a.to_twist().to_array().to_vec(),
        Operation::FromTwist => {
            DualQuat::from_twist(Twist::from_array(inputs.twists[i])).to_array().to_vec()
        }
        Operation::PowEach => a.pow(t).to_array().to_vec(),
        Operation::IntegrateBody => {
            a.integrate_body(Twist::from_array(inputs.twists[i]), between).to_array().to_vec()
        }
        Operation::Angles => vec![a.angle_to(b)],
        Operation::Distances => vec![a.distance_to(b)],
        Operation::Matrices3x4(order) => entry(order == MatrixOrder::Columns, 12),
        Operation::Matrices4x4(order) => entry(order == MatrixOrder::Columns, 16),
    }
}

#[test]
fn slices_are_computed_as_one_motion_after_the_other() {
    // Some more than two steps of the widest lanes there are.
    for length in [0, 1, 3, 7, 8, 16, 17, 33, 37] {
        let inputs = Inputs::new(length);
        for_every_subject(|subject, backend| {
            let single = subject.single();
            let epsilon = if single { f64::from(f32::EPSILON) } else { f64::EPSILON };
            let exact = inputs.rounded(single);
            let between = rounded(single, &[[BETWEEN]])[0][0];
            for operation in Operation::ALL {
                let got = subject.slices(backend, operation, &inputs);
                assert_eq!(got.len(), length);
                for (i, got) in got.iter().enumerate() {
                    let wanted = wanted(operation, &exact, i, between);
                    let close = |(a, b): (&f64, &f64)| (a - b).abs() <= 24.0 * epsilon;
                    assert!(
                        got.len() == wanted.len() && got.iter().zip(&wanted).all(close),
                        "{operation:?}, {} of {length}, {i}, {backend}: {got:?} is not {wanted:?}",
                        subject.name()
                    );
                }
            }
        });
    }
}

#[test]
fn an_element_gets_the_same_bits_wherever_it_stands() {
    let inputs = Inputs::new(37);
    for_every_subject(|subject, backend| {
        for operation in Operation::ALL {
            let whole = subject.slices(backend, operation, &inputs);
            for first in [1, 2, 3, 5, 8, 13, 15, 16, 21, 29, 36] {
                let rest = subject.slices(backend, operation, &inputs.from(first));
                for (rest, whole) in rest.iter().zip(&whole[first..]) {
                    let name = subject.name();
                    assert!(same_bits(rest, whole), "{operation:?}, {name}, {backend}, {first}");
                }
            }
        }
    });
}

/// One motion that is none leaves the others as they are, whatever is computed.
#[test]
fn what_is_no_motion_is_seen_in_its_own_place_only() {
    let clean = Inputs::new(35);
    for_every_subject(|subject, backend| {
        for operation in Operation::ALL {
            let without = subject.slices(backend, operation, &clean);
            for (at, component) in [(0, 3), (7, 0), (33, 5)] {
                for poison in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                    let mut inputs = clean.clone();
                    (inputs.a[at][component], inputs.b[at][component]) = (poison, poison);
                    (inputs.t[at][0], inputs.vectors[at][0]) = (poison, poison);
                    (inputs.planes[at][0], inputs.twists[at][component % 6]) = (poison, poison);
                    let with = subject.slices(backend, operation, &inputs);
                    for (i, (with, without)) in with.iter().zip(&without).enumerate() {
                        let what = || format!("{operation:?}, {}, {backend}", subject.name());
                        // A rotation does not know of a dual part.
                        let turns = [Operation::VectorsEach, Operation::Angles];
                        let knows = component < 4 || !turns.contains(&operation);
                        if i != at {
                            assert!(same_bits(with, without), "{}: {at} reached {i}", what());
                        } else if knows || operation == Operation::Vectors {
                            // The inverse of what is infinite may be zero.
                            let changed = !is_finite(with) || !equal(with, without);
                            assert!(changed, "{}: nothing of {poison}", what());
                        }
                    }
                }
            }
        }
        let mut zero = clean.clone();
        zero.a[7] = [0.0; 8];
        for (i, unit) in subject.slices(backend, Operation::Normalize, &zero).iter().enumerate() {
            assert_eq!(unit.iter().any(|c| c.is_nan()), i == 7, "{backend}: {i}");
        }
    });
}
