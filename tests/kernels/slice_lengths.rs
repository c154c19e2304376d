//! Slices of different lengths.

use dq8::{Backend, DualQuat, ShapeError, hierarchy::MatrixOrder};

#[test]
fn slices_of_different_lengths_are_refused_and_the_output_is_untouched() {
    let backend = Backend::best();
    let (a, t, v) = ([DualQuat::<f32>::IDENTITY; 5], [0.5_f32; 5], [[1.0_f32; 3]; 5]);
    let too_short = |what| ShapeError::Length { what, length: 4, expected: 5 };
    let mut out = [DualQuat::from_translation([7.0, 8.0, 9.0]); 5];
    let before = out;
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

    let (lines, planes) = ([[1.0_f32; 6]; 5], [[1.0_f32; 4]; 5]);
    let answers = [
        (backend.conjugate(&a, &mut out[1..]), "conjugates"),
        (backend.dlb([(&a[1..], &t[..])], &mut out), "influence"),
        (backend.dlb([(&a[..], &t[1..])], &mut out), "weights"),
        (backend.exp(&lines, &mut out[1..]), "motions"),
        (backend.pow_each(&a, &t[1..], &mut out), "t"),
        (backend.pow_each(&a, &t, &mut out[1..]), "powers"),
        (backend.integrate_body(&a, &lines[1..], 0.5, &mut out), "twists"),
        (backend.integrate_body(&a, &lines, 0.5, &mut out[1..]), "later"),
    ];
    for (answer, what) in answers {
        assert_eq!(answer, Err(too_short(what)));
    }
    assert_eq!(out, before);

    let (mut numbers, mut sixes, mut fours) = ([7.0_f32; 5], [[7.0_f32; 6]; 5], [[7.0_f32; 4]; 5]);
    let answers = [
        (backend.angles(&a, &a[1..], &mut numbers), "b"),
        (backend.angles(&a, &a, &mut numbers[1..]), "angles"),
        (backend.distances(&a, &a[1..], &mut numbers), "b"),
        (backend.distances(&a, &a, &mut numbers[1..]), "distances"),
        (backend.log(&a, &mut sixes[1..]), "logs"),
        (backend.transform_lines_each(&a, &lines[1..], &mut sixes), "lines"),
        (backend.transform_lines_each(&a, &lines, &mut sixes[1..]), "moved"),
        (backend.transform_twists_each(&a, &lines[1..], &mut sixes), "twists"),
        (backend.transform_twists_each(&a, &lines, &mut sixes[1..]), "moved"),
        (backend.transform_planes_each(&a, &planes[1..], &mut fours), "planes"),
        (backend.transform_planes_each(&a, &planes, &mut fours[1..]), "moved"),
    ];
    for (answer, what) in answers {
        assert_eq!(answer, Err(too_short(what)));
    }
    assert_eq!((numbers, sixes, fours), ([7.0; 5], [[7.0; 6]; 5], [[7.0; 4]; 5]));

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
