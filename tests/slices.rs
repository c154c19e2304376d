//! Kernels over slices: every layout, on every backend, of any length, is what one motion after the
//! other is; and slices that do not fit are refused before anything is written.

mod memory;

use dq8::place::{Layout, Plain};
use dq8::slices::MatrixOrder;
use dq8::{Backend, DualQuat, Place, Quat, Real, ShapeError};
use dq8_simd::{Block, Float};
use memory::Memory;

type Number<P> = <<P as Place<8>>::Layout as Layout>::Real;

/// `count` unit motions; `seed` makes them others.
fn motions<R: Real>(count: usize, seed: f64) -> Vec<DualQuat<R>> {
    let wave = |i: usize, f: f64| R::from_f64((i as f64 * f + seed).sin());
    let one = |i| {
        let turn = Quat::from_parts([wave(i, 0.7), wave(i, 1.3), wave(i, 1.9)], wave(i, 0.4));
        DualQuat::from_rotation_translation(
            turn.normalize(),
            [wave(i, 0.3), wave(i, 2.1), R::TWO * wave(i, 0.9)],
        )
    };
    (0..count).map(one).collect()
}

/// Some more than two steps of the widest lanes there are.
const LENGTHS: [usize; 9] = [0, 1, 3, 7, 8, 16, 17, 33, 37];

/// The largest difference of components, in units of the last place of 1.
#[track_caller]
fn close<R: Real, const C: usize>(what: &str, got: &[[R; C]], wanted: &[[R; C]]) {
    assert_eq!(got.len(), wanted.len(), "{what}");
    for (i, (got, wanted)) in got.iter().zip(wanted).enumerate() {
        for (a, b) in got.iter().zip(wanted) {
            let units = ((*a - *b).abs() / R::EPSILON).into();
            assert!(units <= 24.0, "{what}, element {i}: {got:?} is not {wanted:?}");
        }
    }
}

fn numbers<R: Real>(motions: &[DualQuat<R>]) -> Vec<[R; 8]> {
    motions.iter().map(|motion| motion.to_array()).collect()
}

/// Every kernel in one layout: `P` motions, `V` vectors, `T` numbers, `M` matrices.
fn is_one_after_the_other<P, V, T, M, G>(backend: Backend)
where
    P: Memory<8, Number = Number<P>> + Place<8, Layout: Layout<Real: Real>>,
    V: Memory<3, Number = P::Number> + Place<3, Layout = P::Layout>,
    T: Memory<1, Number = P::Number> + Place<1, Layout = P::Layout>,
    M: Memory<12, Number = P::Number> + Place<12, Layout = P::Layout>,
    G: Memory<16, Number = P::Number> + Place<16, Layout = P::Layout>,
{
    for length in LENGTHS {
        let (a, b) = (motions::<Number<P>>(length, 0.1), motions::<Number<P>>(length, 2.0));
        let (pa, pb) = (P::pack(&numbers(&a)), P::pack(&numbers(&b)));
        let real = <Number<P> as Real>::from_f64;
        let each = |f: &dyn Fn(usize) -> DualQuat<Number<P>>| {
            (0..length).map(|i| f(i).to_array()).collect::<Vec<_>>()
        };
        let t: Vec<_> = (0..length).map(|i| [real(i as f64 / 40.0)]).collect();
        let v: Vec<_> = (0..length).map(|i| [1.0, -0.5, 0.1 * i as f64].map(real)).collect();
        let (pt, pv) = (T::pack(&t), V::pack(&v));
        let mut out = pb.clone();
        let check = |what: &str, out: &[P], wanted: Vec<[Number<P>; 8]>| {
            close(&format!("{backend}: {what} of {length}"), &P::unpack(out, length), &wanted);
        };

        backend.mul(&pa, &pb, &mut out).expect("they fit");
        check("mul", &out, each(&|i| a[i] * b[i]));
        let mut in_place = pa.clone();
        backend.mul_in_place(&mut in_place, &pb).expect("they fit");
        assert_eq!(P::unpack(&in_place, length), P::unpack(&out, length), "mul in place");

        let left = motions::<Number<P>>(1, 7.0)[0];
        let mut in_place = pb.clone();
        backend.mul_left_in_place(left, &mut in_place);
        check("mul_left", &in_place, each(&|i| left * b[i]));

        let twice: Vec<_> = a.iter().map(|a| a.scale(real(2.0))).collect();
        let twice = P::pack(&numbers(&twice));
        backend.normalize(&twice, &mut out).expect("they fit");
        check("normalize", &out, each(&|i| a[i]));
        let mut in_place = twice.clone();
        backend.normalize_in_place(&mut in_place);
        assert_eq!(P::unpack(&in_place, length), P::unpack(&out, length), "normalize in place");

        backend.inverse(&twice, &mut out).expect("they fit");
        check("inverse", &out, each(&|i| a[i].conjugate().scale(real(0.5))));
        let mut in_place = twice;
        backend.inverse_in_place(&mut in_place);
        assert_eq!(P::unpack(&in_place, length), P::unpack(&out, length), "inverse in place");

        backend.nlerp(&pa, &pb, real(0.3), &mut out).expect("they fit");
        check("nlerp", &out, each(&|i| a[i].nlerp(b[i], real(0.3))));
        backend.nlerp_each(&pa, &pb, &pt, &mut out).expect("they fit");
        check("nlerp_each", &out, each(&|i| a[i].nlerp(b[i], t[i][0])));
        backend.sclerp(&pa, &pb, real(0.3), &mut out).expect("they fit");
        check("sclerp", &out, each(&|i| a[i].sclerp(b[i], real(0.3))));
        backend.sclerp_each(&pa, &pb, &pt, &mut out).expect("they fit");
        check("sclerp_each", &out, each(&|i| a[i].sclerp(b[i], t[i][0])));

        let one = motions::<Number<P>>(1, 5.0)[0];
        let vectors = |what: &str, got: &[V], wanted: &dyn Fn(usize) -> [Number<P>; 3]| {
            let wanted: Vec<_> = (0..length).map(wanted).collect();
            close(&format!("{backend}: {what} of {length}"), &V::unpack(got, length), &wanted);
        };
        let mut moved = pv.clone();
        backend.transform_points(one, &pv, &mut moved).expect("they fit");
        vectors("transform_points", &moved, &|i| one.transform_point(v[i]));
        let mut in_place = pv.clone();
        backend.transform_points_in_place(one, &mut in_place);
        assert_eq!(V::unpack(&in_place, length), V::unpack(&moved, length), "points in place");
        backend.transform_vectors(one, &pv, &mut moved).expect("they fit");
        vectors("transform_vectors", &moved, &|i| one.transform_vector(v[i]));
        let mut in_place = pv.clone();
        backend.transform_vectors_in_place(one, &mut in_place);
        assert_eq!(V::unpack(&in_place, length), V::unpack(&moved, length), "vectors in place");
        backend.transform_points_each(&pa, &pv, &mut moved).expect("they fit");
        vectors("transform_points_each", &moved, &|i| a[i].transform_point(v[i]));
        backend.transform_vectors_each(&pa, &pv, &mut moved).expect("they fit");
        vectors("transform_vectors_each", &moved, &|i| a[i].transform_vector(v[i]));

        let mut small = M::pack(&vec![[real(9.0); 12]; length]);
        let mut large = G::pack(&vec![[real(9.0); 16]; length]);
        for order in [MatrixOrder::Rows, MatrixOrder::Columns] {
            backend.matrices::<_, _, 12>(&pa, order, &mut small).expect("they fit");
            backend.matrices::<_, _, 16>(&pa, order, &mut large).expect("they fit");
            let (small, large) = (M::unpack(&small, length), G::unpack(&large, length));
            for (i, (small, large)) in small.iter().zip(&large).enumerate() {
                let rows = a[i].to_matrix4();
                let wanted = |row: usize, column: usize| rows[row][column];
                let of_rows = order == MatrixOrder::Rows;
                for (k, &number) in small.iter().enumerate() {
                    let (row, column) = if of_rows { (k / 4, k % 4) } else { (k % 3, k / 3) };
                    close("matrices", &[[number]], &[[wanted(row, column)]]);
                }
                for (k, &number) in large.iter().enumerate() {
                    let (row, column) = if of_rows { (k / 4, k % 4) } else { (k % 4, k / 4) };
                    close("matrices", &[[number]], &[[wanted(row, column)]]);
                }
            }
        }
    }
}

fn plain<R>(backend: Backend)
where
    R: Real + Float + Memory<1, Number = R> + Place<1, Layout = Plain<R>>,
{
    is_one_after_the_other::<DualQuat<R>, [R; 3], R, [[R; 4]; 3], [[R; 4]; 4]>(backend);
    is_one_after_the_other::<DualQuat<R>, [R; 3], R, [R; 12], [R; 16]>(backend);
}

fn blocks<A: dq8_simd::Row<Real: Real>>(backend: Backend) {
    is_one_after_the_other::<Block<A, 8>, Block<A, 3>, Block<A, 1>, Block<A, 12>, Block<A, 16>>(
        backend,
    );
}

#[test]
fn plain_slices_are_computed_as_one_after_the_other() {
    for backend in Backend::available() {
        plain::<f32>(backend);
        plain::<f64>(backend);
    }
}

#[test]
fn blocks_are_computed_as_one_after_the_other() {
    for backend in Backend::available() {
        blocks::<[f32; 4]>(backend);
        blocks::<[f32; 8]>(backend);
        blocks::<[f32; 16]>(backend);
        blocks::<[f64; 2]>(backend);
        blocks::<[f64; 4]>(backend);
        blocks::<[f64; 8]>(backend);
    }
}

#[test]
fn an_element_gets_the_same_bits_wherever_it_stands() {
    for backend in Backend::available() {
        let (a, b) = (motions::<f32>(37, 0.1), motions::<f32>(37, 2.0));
        let mut whole = a.clone();
        backend.sclerp(&a, &b, 0.3, &mut whole).expect("they fit");
        for first in 1..37 {
            let mut rest = a[first..].to_vec();
            backend.sclerp(&a[first..], &b[first..], 0.3, &mut rest).expect("they fit");
            assert_eq!(rest, whole[first..], "{backend}: from {first}");
        }
    }
}

#[test]
fn a_backend_that_the_machine_lacks_does_its_work_with_the_best_below_it() {
    // Whatever the machine, all of these have to be answered, and alike up to rounding.
    for backend in [Backend::Portable, Backend::Avx2, Backend::Avx512] {
        plain::<f32>(backend);
    }
}

#[test]
fn slices_of_different_lengths_are_refused_and_the_output_is_untouched() {
    let backend = Backend::best();
    let (a, t, v) = (motions::<f32>(5, 0.1), [0.5_f32; 5], [[1.0_f32; 3]; 5]);
    let too_short = |what| ShapeError::Length { what, length: 4, expected: 5 };
    let mut out = motions::<f32>(5, 3.0);
    let before = out.clone();
    let answers = [
        (backend.mul(&a, &a[1..], &mut out), "b"),
        (backend.mul(&a, &a, &mut out[1..]), "products"),
        (backend.mul_in_place(&mut out, &a[1..]), "b"),
        (backend.normalize(&a, &mut out[1..]), "units"),
        (backend.inverse(&a, &mut out[1..]), "inverses"),
        (backend.nlerp(&a, &a[1..], 0.5, &mut out), "b"),
        (backend.nlerp(&a, &a, 0.5, &mut out[1..]), "between"),
        (backend.nlerp_each(&a, &a, &t[1..], &mut out), "t"),
        (backend.nlerp_each(&a, &a[1..], &t, &mut out), "b"),
        (backend.sclerp(&a, &a[1..], 0.5, &mut out), "b"),
        (backend.sclerp(&a, &a, 0.5, &mut out[1..]), "between"),
        (backend.sclerp_each(&a, &a, &t[1..], &mut out), "t"),
        (backend.sclerp_each(&a, &a, &t, &mut out[1..]), "between"),
    ];
    for (answer, what) in answers {
        assert_eq!(answer, Err(too_short(what)));
    }
    assert_eq!(out, before);

    let mut moved = [[7.0_f32; 3]; 5];
    let mut rows = [[[7.0_f32; 4]; 3]; 5];
    let answers = [
        (backend.transform_points(a[0], &v, &mut moved[1..]), "moved"),
        (backend.transform_vectors(a[0], &v, &mut moved[1..]), "turned"),
        (backend.transform_points_each(&a, &v[1..], &mut moved), "points"),
        (backend.transform_points_each(&a, &v, &mut moved[1..]), "moved"),
        (backend.transform_vectors_each(&a, &v[1..], &mut moved), "vectors"),
        (backend.transform_vectors_each(&a, &v, &mut moved[1..]), "turned"),
        (backend.matrices(&a, MatrixOrder::Rows, &mut rows[1..]), "matrices"),
    ];
    for (answer, what) in answers {
        assert_eq!(answer, Err(too_short(what)));
    }
    assert_eq!((moved, rows), ([[7.0; 3]; 5], [[[7.0; 4]; 3]; 5]));
}

/// Large outputs are written past the caches, unless they are read as well, and are the same.
#[test]
fn outputs_larger_than_caches_are_computed_as_small_ones() {
    let few = [0.1, 0.4, 0.7].map(|seed| {
        let sixteen = motions::<f32>(16, seed);
        Block::<[f32; 16], 8>::pack(&numbers(&sixteen))[0]
    });
    let length = (64 << 20) / size_of_val(&few[0]) + 1;
    let many: Vec<_> = few.into_iter().cycle().take(length).collect();
    let as_few = |all: &[_], few: [_; 3]| all.iter().enumerate().all(|(i, a)| *a == few[i % 3]);
    for backend in Backend::available() {
        let (mut units, mut all) = (few, many.clone());
        backend.normalize(&few, &mut units).expect("they fit");
        backend.normalize(&many, &mut all).expect("they fit");
        assert!(as_few(&all, units), "{backend}");

        let mut squares = units;
        backend.mul_in_place(&mut squares, &units).expect("they fit");
        let factors = all.clone();
        backend.mul_in_place(&mut all, &factors).expect("they fit");
        assert!(as_few(&all, squares), "{backend}, in place");
    }
}

#[test]
fn what_is_no_motion_is_nan_in_its_own_place_only() {
    for backend in Backend::available() {
        let mut poses = motions::<f32>(19, 0.1);
        poses[7] = DualQuat::ZERO;
        backend.normalize_in_place(&mut poses);
        for (i, pose) in poses.iter().enumerate() {
            assert_eq!(pose.to_array().iter().any(|c| c.is_nan()), i == 7, "{backend}: {i}");
        }
    }
}
