//! Other representations of rotations and motions: the same answers, and a mask where the scalar reference has
//! an error.

use super::{
    Portably, columns, exact, holds, lane, lanes, measure, on_every_lane_type, rounded, row,
};
use dq8::{
    DualQuat, Plane, Quat, Real, Twist, batch,
    representation::{
        Affine, EulerAngles, EulerOrder, EulerSolution, Polar, RotationTranslation, gram_schmidt,
    },
};
use dq8_contract::inputs;
use dq8_contract::ledger::{Ledger, line};
use std::f64::consts::{FRAC_PI_2, PI};

type Rows = [[f64; 3]; 3];

/// A motion, another one, and vectors.
#[derive(Clone, Debug)]
struct Case {
    a: [f64; 8],
    b: [f64; 8],
    v: [f64; 3],
    w: [f64; 3],
}

/// Every motion at an edge, those next to no turn and half a turn among them.
fn cases() -> Vec<Case> {
    let motions: Vec<_> = inputs::edge_motions()
        .into_iter()
        .filter(|m| m[4..].iter().all(|c| c.abs() < 100.0))
        .collect();
    let vector = |i: usize| {
        let at = |k: f64| 2.0 * ((i + 1) as f64 * k).sin();
        [at(1.0), at(1.7), at(2.3)]
    };
    let other = |i: usize| motions[(i * 31 + 7) % motions.len()];
    let each = motions.iter().enumerate();
    each.map(|(i, &a)| Case { a, b: other(i), v: vector(i), w: vector(i + 5) }).collect()
}

fn quat<R: Real>([x, y, z, w, ..]: [f64; 8]) -> Quat<R> {
    Quat::from_array(rounded([x, y, z, w])).normalize()
}

fn quats<L: Portably>(cases: &[Case], pick: impl Fn(&Case) -> [f64; 8]) -> batch::Quat<L> {
    batch::Quat::from_array(columns(cases, |case| exact(quat::<L::Real>(pick(case)).to_array())))
}

fn motion<R: Real>(components: [f64; 8]) -> DualQuat<R> {
    DualQuat::from_array(rounded(components)).normalize()
}

fn motions<L: Portably>(cases: &[Case], pick: impl Fn(&Case) -> [f64; 8]) -> batch::DualQuat<L> {
    let unit = |case: &Case| exact(motion::<L::Real>(pick(case)).to_array());
    batch::DualQuat::from_array(columns(cases, unit))
}

fn flat<R: Real>(rows: [[R; 3]; 3]) -> [f64; 9] {
    let [[a, b, c], [d, e, f], [g, h, i]] = rows;
    exact([a, b, c, d, e, f, g, h, i])
}

fn flat_row<L: Portably>([a, b, c]: [[L; 3]; 3], index: usize) -> [f64; 9] {
    row([a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]], index)
}

fn rotations_agree<L: Portably>(ledger: &Ledger) {
    for chunk in cases().chunks(L::LANES) {
        let q = quats::<L>(chunk, |case| case.a);
        let (v, w) = (columns::<L, _, 3>(chunk, |case| case.v), columns(chunk, |case| case.w));
        let (axis, angle) = q.to_axis_angle();
        let scaled = q.to_scaled_axis();
        let (arc, turn) = (batch::Quat::from_rotation_arc(v, w), batch::Quat::from_scaled_axis(v));
        let (look, failed) = batch::Quat::look_to_checked(v, w);
        let about = [
            batch::Quat::from_rotation_x(v[0]),
            batch::Quat::from_rotation_y(v[0]),
            batch::Quat::from_rotation_z(v[0]),
        ];
        for (index, case) in chunk.iter().enumerate() {
            let (q, v, w) = (quat(case.a), rounded(case.v), rounded(case.w));
            let (by_axis, by_angle): ([L::Real; 3], _) = q.to_axis_angle();
            let see = |name: &str, got: [f64; 4], wanted: [f64; 4], scale: f64| {
                measure::<L, 4>(ledger, (name, ""), got, wanted, scale, case);
            };
            let vector = |[x, y, z]: [f64; 3]| [x, y, z, 0.0];
            see("axis", vector(row(axis, index)), vector(exact(by_axis)), 1.0);
            // An angle keeps its relative precision, however small it is.
            let wanted: f64 = by_angle.into();
            see("angle", [lane(angle, index), 0.0, 0.0, 0.0], [wanted, 0.0, 0.0, 0.0], wanted);
            let wanted = vector(exact(q.to_scaled_axis()));
            see("to_scaled_axis", vector(row(scaled, index)), wanted, by_angle.into());
            let wanted = exact(Quat::<L::Real>::from_scaled_axis(v).to_array());
            see("from_scaled_axis", row(turn.to_array(), index), wanted, 1.0);
            let wanted = exact(Quat::<L::Real>::from_rotation_arc(v, w).to_array());
            see("from_rotation_arc", row(arc.to_array(), index), wanted, 1.0);
            let by_directions = Quat::look_to(v, w).expect("they have directions");
            assert!(!holds(failed, index));
            see("look_to", row(look.to_array(), index), exact(by_directions.to_array()), 1.0);
            let wanted = [
                Quat::from_rotation_x(v[0]),
                Quat::from_rotation_y(v[0]),
                Quat::from_rotation_z(v[0]),
            ];
            for (got, wanted) in about.into_iter().zip(wanted) {
                see(
                    "from_rotation_x, y, z",
                    row(got.to_array(), index),
                    exact(wanted.to_array()),
                    1.0,
                );
            }
        }
    }
}

#[test]
fn axes_angles_and_directions_on_lanes_are_those_of_the_scalar_reference() {
    #[rustfmt::skip]
    let bounds = [
        line("axis", &[], 2.0, "another length"),
        line("angle", &[], 6.5, "a polynomial, where scalar asks for an arctangent"),
        line("to_scaled_axis", &[], 4.5, "as the angle"),
        line("from_scaled_axis", &[], 5.0, "polynomials, where scalar asks the library"),
        line("from_rotation_arc", &[], 5.0, "three lengths and a normalization"),
        line("look_to", &[], 5.0, "Gram–Schmidt, and a rotation from a matrix"),
        line("from_rotation_x, y, z", &[], 2.0, "polynomials, where scalar asks the library"),
    ];
    Ledger::keep("rotations", &bounds, |ledger| on_every_lane_type!(rotations_agree, ledger));
}

fn axes_at_the_edges<L: Portably>() {
    let nan = f64::NAN;
    // No turn, of both signs, half a turn with w of either sign, and what is no rotation.
    for q in [
        [0.0, 0.0, 0.0, 1.0],
        [0.0, 0.0, 0.0, -1.0],
        [-0.0, -0.0, -0.0, 1.0],
        [0.0, 1.0, 0.0, 0.0],
        [0.0, -1.0, 0.0, -0.0],
        [1e-40, 0.0, 0.0, 1.0],
        [0.0, -1e-40, 0.0, -1.0],
        [nan, 0.0, 0.0, 1.0],
        [0.0, 0.0, 0.0, nan],
    ] {
        let (axis, angle) = batch::Quat::from_array(q.map(|c| lanes::<L>(&[c]))).to_axis_angle();
        let by_the_book = Quat::<L::Real>::from_array(rounded(q)).to_axis_angle();
        let (by_axis, by_angle) = by_the_book;
        let (got, wanted): (f64, f64) = (lane(angle, 0), by_angle.into());
        if q.iter().any(|c| c.is_nan()) {
            assert!(got.is_nan() && wanted.is_nan(), "{q:?}");
        } else {
            assert_eq!(row(axis, 0), exact(by_axis), "{q:?}");
            assert!((got - wanted).abs() <= 4.0 * super::roundoff::<L>() * wanted, "{q:?}");
        }
    }
    for (from, to) in [([1.0, 0.0, 0.0], [-2.0, 0.0, 0.0]), ([0.0, 3.0, 0.0], [0.0, 3.0, 0.0])] {
        let turn =
            batch::Quat::from_rotation_arc(from.map(|c| lanes::<L>(&[c])), to.map(|c| lanes(&[c])));
        let wanted = Quat::<L::Real>::from_rotation_arc(rounded(from), rounded(to));
        assert_eq!(row(turn.to_array(), 0), exact(wanted.to_array()), "{from:?} {to:?}");
    }
    let none = batch::Quat::from_rotation_arc([lanes::<L>(&[0.0]); 3], [lanes(&[1.0]); 3]);
    assert!(row(none.to_array(), 0).iter().any(|c| c.is_nan()));
    let still = batch::Quat::from_scaled_axis([lanes::<L>(&[0.0]); 3]);
    assert_eq!(row(still.to_array(), 0), [0.0, 0.0, 0.0, 1.0]);
    for (forward, up) in [
        ([0.0; 3], [1.0; 3]),
        ([1.0; 3], [0.0; 3]),
        ([1.0; 3], [2.0; 3]),
        ([nan; 3], [1.0, 0.0, 0.0]),
    ] {
        let (look, failed) = batch::Quat::look_to_checked(
            forward.map(|c| lanes::<L>(&[c])),
            up.map(|c| lanes(&[c])),
        );
        assert!(Quat::<L::Real>::look_to(rounded(forward), rounded(up)).is_err());
        assert!(
            holds(failed, 0) && row(look.to_array(), 0).iter().all(|c| c.is_nan()),
            "{forward:?} {up:?}"
        );
    }
}

#[test]
fn axes_and_directions_at_the_edges_are_those_of_the_scalar_reference() {
    on_every_lane_type!(axes_at_the_edges);
}

/// Angles of every kind, and those at and near gimbal lock.
fn euler_cases(order: EulerOrder) -> Vec<[f64; 3]> {
    let locks = if order.axes.is_proper() { [0.0, PI] } else { [-FRAC_PI_2, FRAC_PI_2] };
    let mut cases = Vec::new();
    for (lock, inward) in locks.into_iter().zip([1.0, -1.0]) {
        for off in [0.0, 1e-12, 1e-5, 1e-3, 0.1, 1.0] {
            for outer in [[0.3, -1.1], [-2.9, 3.0], [0.0, 0.7], [3.1, 0.0]] {
                cases.push([outer[0], lock + inward * off, outer[1]]);
            }
        }
    }
    cases
}

fn euler_angles_agree<L: Portably>(ledger: &Ledger) {
    for order in EulerOrder::ALL {
        for chunk in euler_cases(order).chunks(L::LANES) {
            let angles = columns::<L, _, 3>(chunk, |angles| *angles);
            let turn = batch::Quat::from_euler(EulerAngles { angles, order });
            // The same quaternion for both: another rounding is another answer near the lock.
            let solution = turn.to_euler(order);
            for (index, case) in chunk.iter().enumerate() {
                let wanted = EulerAngles { angles: rounded::<L::Real, 3>(*case), order }.to_quat();
                let got = row(turn.to_array(), index);
                measure::<L, 4>(
                    ledger,
                    ("from_euler", ""),
                    got,
                    exact(wanted.to_array()),
                    1.0,
                    case,
                );
                let EulerSolution { angles, gimbal_lock } =
                    Quat::from_array(rounded::<L::Real, 4>(got)).to_euler(order);
                assert_eq!(holds(solution.gimbal_lock, index), gimbal_lock, "{order:?} {case:?}");
                let (got, wanted) = (row(solution.angles.angles, index), exact(angles.angles));
                // π and −π are one angle.
                let turns = |k: usize| ((got[k] - wanted[k]) / (2.0 * PI)).round() * 2.0 * PI;
                let got: [f64; 3] = std::array::from_fn(|k| got[k] - turns(k));
                measure::<L, 3>(ledger, ("to_euler", ""), got, wanted, 1.0, &(order, case));
            }
        }
    }
}

#[test]
fn euler_angles_of_all_orders_and_their_locks_are_those_of_the_scalar_reference() {
    let bounds = [
        line("from_euler", &[], 3.5, "three turns by polynomials, and two products"),
        line("to_euler", &[], 13.0, "arctangents of products, another order of summands"),
    ];
    Ledger::keep("Euler angles", &bounds, |ledger| on_every_lane_type!(euler_angles_agree, ledger));
}

#[test]
fn euler_angles_of_what_is_no_number_are_none_on_lanes() {
    let nan = batch::Quat::from_array([f64::NAN, 0.0, 0.0, 1.0]).to_euler(EulerOrder::ALL[0]);
    assert!(nan.angles.angles.iter().all(|angle| angle.is_nan()) && !nan.gimbal_lock);
}

/// Matrices of every kind: rotations, stretched ones, mirrors, flat ones and worse.
fn matrices() -> Vec<Rows> {
    let mut matrices: Vec<Rows> = Vec::new();
    for (i, case) in cases().into_iter().enumerate().step_by(3) {
        let turn = quat::<f64>(case.a).to_matrix3();
        let [x, y, z] = case.v;
        let stretch =
            [1.5 + x / 2.0, 1.5 + y / 2.0, (1.5 + z / 2.0) * if i % 2 == 0 { 1.0 } else { -1.0 }];
        let mixed = quat::<f64>(case.b).to_matrix3();
        let scaled =
            mixed.map(|row| [row[0] * stretch[0], row[1] * stretch[1], row[2] * stretch[2]]);
        matrices.push(turn);
        matrices.push(
            turn.map(|row| std::array::from_fn(|j| (0..3).map(|k| row[k] * scaled[k][j]).sum())),
        );
    }
    matrices
}

/// Without an answer, or with one out of the ordinary.
fn hard_matrices() -> Vec<Rows> {
    let (o, i, n) = (0.0, f64::INFINITY, f64::NAN);
    let one = [[1.0, o, o], [o, 1.0, o], [o, o, 1.0]];
    let scaled = |s: f64| one.map(|row| row.map(|c| c * s));
    vec![
        one,
        scaled(-1.0),
        scaled(0.0),
        scaled(1e-30),
        scaled(1e37),
        scaled(3.0),
        [[1.0, o, o], [o, 1.0, o], [o, o, -1.0]],
        [[1.0, o, o], [o, 1.0, o], [o, o, o]],
        [[1.0, o, o], [o, o, o], [o, o, o]],
        [[1.0, 2.0, o], [2.0, 4.0, o], [o, o, 1.0]],
        [[1.0, 1.0, 1.0], [1.0, 1.0, 1.0], [1.0, 1.0, 1.0]],
        [[i, o, o], [o, 1.0, o], [o, o, 1.0]],
        [[1.0, o, o], [o, n, o], [o, o, 1.0]],
        [[3e38, 3e38, o], [3e38, -3e38, o], [o, o, 3e38]],
    ]
}

fn columns_of_rows<L: Portably>(cases: &[Rows]) -> [[L; 3]; 3] {
    let all = columns::<L, _, 9>(cases, |rows| flat(*rows));
    [[all[0], all[1], all[2]], [all[3], all[4], all[5]], [all[6], all[7], all[8]]]
}

fn repaired_matrices_agree<L: Portably>(ledger: &Ledger) {
    let all = [matrices(), hard_matrices()].concat();
    for chunk in all.chunks(L::LANES) {
        let rows = columns_of_rows::<L>(chunk);
        let (by_columns, crooked) = batch::gram_schmidt_checked(rows);
        let (polar, ambiguous) = batch::Polar::from_matrix3_checked(rows);
        let translation = [lanes::<L>(&[1.0]), lanes(&[-2.0]), lanes(&[3.0])];
        let affine = batch::Affine { linear: rows, translation };
        let (motion, stretch, failed) = affine.decompose_checked();
        let (rotation, no_rotation) = batch::Quat::from_matrix3_checked(rows, lanes(&[1e-3]));
        for (index, case) in chunk.iter().enumerate() {
            let rows = case.map(rounded::<L::Real, 3>);
            let largest = case.as_flattened().iter().fold(0.0_f64, |most, c| most.max(c.abs()));
            let wanted = gram_schmidt(rows);
            assert_eq!(holds(crooked, index), wanted.is_err(), "Gram–Schmidt of {case:?}");
            let (got, nan) = (flat_row(by_columns, index), [f64::NAN; 9]);
            measure::<L, 9>(ledger, ("gram_schmidt", ""), got, wanted.map_or(nan, flat), 1.0, case);

            let wanted = Polar::try_from_matrix3(rows);
            assert_eq!(holds(ambiguous, index), wanted.is_err(), "polar decomposition of {case:?}");
            assert_eq!(holds(failed, index), wanted.is_err());
            let got = flat_row(polar.rotation.to_matrix3(), index);
            let turned = wanted.map_or(nan, |polar| flat(polar.rotation.to_matrix3()));
            measure::<L, 9>(ledger, ("polar rotation", ""), got, turned, 1.0, case);
            let got = flat_row(polar.stretch, index);
            let stretched = wanted.map_or(nan, |polar| flat(polar.stretch));
            measure::<L, 9>(ledger, ("polar stretch", ""), got, stretched, largest, case);
            assert_eq!(flat_row(stretch, index).map(f64::to_bits), got.map(f64::to_bits));
            if let Ok(wanted) = wanted {
                assert_eq!(holds(polar.mirrors, index), wanted.mirrors, "{case:?}");
                assert_eq!(
                    row(motion.rotation().to_array(), index),
                    row(polar.rotation.to_array(), index)
                );
            }

            let wanted = Quat::try_from_matrix3(rows, <L::Real as Real>::from_f64(1e-3));
            assert_eq!(holds(no_rotation, index), wanted.is_err(), "rotation of {case:?}");
            let wanted = wanted.map_or([f64::NAN; 9], |turn| flat(turn.to_matrix3()));
            let got = flat_row(rotation.to_matrix3(), index);
            measure::<L, 9>(ledger, ("from_matrix3", ""), got, wanted, 1.0, case);
        }
    }
}

#[test]
fn matrices_are_repaired_and_refused_on_lanes_as_by_the_scalar_reference() {
    #[rustfmt::skip]
    let bounds = [
        line("gram_schmidt", &[], 6.5, "a rounding over the sines of the columns"),
        line("polar rotation", &[], 15.0, "Jacobi's turns, another order of summands"),
        line("polar stretch", &[], 14.0, "a product with the rotation"),
        line("from_matrix3", &[], 3.9, "another length divides"),
    ];
    Ledger::keep("matrices", &bounds, |ledger| {
        on_every_lane_type!(repaired_matrices_agree, ledger)
    });
}

fn checked_matrices<L: Portably>() {
    let good = motion::<L::Real>(cases()[50].a).to_matrix4();
    let number = |value: f64| <L::Real as Real>::from_f64(value);
    let with = |r: usize, c: usize, value: f64| {
        let mut rows = good;
        rows[r][c] = number(value);
        rows
    };
    let matrices = [
        good,
        with(0, 0, 3.0),
        with(1, 3, f64::NAN),
        with(2, 3, f64::INFINITY),
        with(3, 0, 1e-9),
        with(3, 3, 0.0),
        with(3, 3, 2.0),
        with(2, 2, f64::NAN),
        good.map(|row| row.map(|c| -c)),
        good.map(|[x, y, z, w]| [y, x, z, w]),
    ];
    for tolerance in [1e-3, f64::INFINITY] {
        let tolerance = number(tolerance);
        for rows in matrices {
            let on_lanes = rows.map(|row| row.map(|c| lanes::<L>(&[c.into()])));
            let tolerances = lanes::<L>(&[tolerance.into()]);
            let (four, failed_four) = batch::DualQuat::from_matrix4_checked(on_lanes, tolerances);
            let [a, b, c, _] = on_lanes;
            let (three, failed_three) =
                batch::DualQuat::from_matrix3x4_checked([a, b, c], tolerances);
            let [a, b, c, _] = rows;
            let by_four = DualQuat::try_from_matrix4(rows, tolerance);
            let by_three = DualQuat::try_from_matrix3x4([a, b, c], tolerance);
            for (got, failed, wanted) in
                [(four, failed_four, by_four), (three, failed_three, by_three)]
            {
                let got = row(got.to_array(), 0);
                assert_eq!(holds(failed, 0), wanted.is_err(), "{rows:?}");
                match wanted {
                    Err(_) => assert!(got.iter().all(|c| c.is_nan()), "{rows:?}"),
                    Ok(wanted) => {
                        let off =
                            got.iter().zip(exact(wanted.to_array())).map(|(a, b)| (a - b).abs());
                        let worst = off.fold(0.0, f64::max);
                        assert!(worst < 64.0 * super::roundoff::<L>(), "{rows:?}: {worst:e}");
                    }
                }
            }
        }
    }
}

#[test]
fn a_matrix_that_is_no_motion_is_a_lane_of_nan_and_a_mask() {
    on_every_lane_type!(checked_matrices);
}

fn poses_and_maps_agree<L: Portably>(ledger: &Ledger) {
    for chunk in cases().chunks(L::LANES) {
        let (a, b) = (motions::<L>(chunk, |case| case.a), motions(chunk, |case| case.b));
        let (v, w) = (columns::<L, _, 3>(chunk, |case| case.v), columns(chunk, |case| case.w));
        let (pose, other) =
            (batch::RotationTranslation::from(a), batch::RotationTranslation::from(b));
        let identity = batch::RotationTranslation::identity(dq8::simd::Portable);
        let (product, inverse) = (pose * other * identity, pose.inverse());
        let same = batch::RotationTranslation::from_array(pose.to_array());
        let back = batch::DualQuat::from(same);
        let plane = Plane { normal: v, offset: w[0] };
        let map = batch::Affine::from_motion(a)
            * batch::Affine::scale(w)
            * batch::Affine::shear(v, w)
            * batch::Affine::reflection(plane)
            * batch::Affine::identity(dq8::simd::Portable);
        let map = batch::Affine::from_matrix3x4(map.to_matrix3x4());
        let twist = Twist { angular: v, linear: w };
        let jacobian = batch::DualQuat::left_jacobian_matrix(twist);
        let undone = batch::DualQuat::left_jacobian_inverse_matrix(twist);
        for (index, case) in chunk.iter().enumerate() {
            let (a, b) = (motion::<L::Real>(case.a), motion::<L::Real>(case.b));
            let (v, w) = (rounded(case.v), rounded(case.w));
            let (by_pose, by_other) = (RotationTranslation::from(a), RotationTranslation::from(b));
            let size = 1.0 + case.a.iter().chain(&case.b).map(|c| c.abs()).sum::<f64>();
            let pair = |got: batch::RotationTranslation<L>,
                        wanted: RotationTranslation<L::Real>,
                        name: &str| {
                let got = row(got.to_array(), index);
                measure::<L, 7>(ledger, (name, ""), got, exact(wanted.to_array()), size, case);
            };
            pair(pose, by_pose, "RotationTranslation::from");
            pair(product, by_pose * by_other, "RotationTranslation::mul");
            pair(inverse, by_pose.inverse(), "RotationTranslation::inverse");
            let wanted = exact(DualQuat::from(by_pose).to_array());
            let got = row(back.to_array(), index);
            measure::<L, 8>(ledger, ("DualQuat::from", ""), got, wanted, size, case);
            let three = |got: [L; 3], wanted: [L::Real; 3], scale: f64, name: &str| {
                measure::<L, 3>(ledger, (name, ""), row(got, index), exact(wanted), scale, case);
            };
            let on = columns::<L, _, 3>(chunk, |case| case.v);
            three(
                pose.transform_point(on),
                by_pose.transform_point(v),
                size,
                "RotationTranslation::apply",
            );
            three(
                pose.transform_vector(on),
                by_pose.transform_vector(v),
                size,
                "RotationTranslation::apply",
            );
            let plane = Plane { normal: v, offset: w[0] };
            let by_map = Affine::from_motion(a)
                * Affine::scale(w)
                * Affine::shear(v, w)
                * Affine::reflection(plane);
            three(map.transform_point(on), by_map.transform_point(v), 1e3 * size, "Affine");
            three(map.transform_vector(on), by_map.transform_vector(v), 1e3 * size, "Affine");
            three(map.translation, by_map.translation, 1e3 * size, "Affine");
            let twist = Twist { angular: v, linear: w };
            let wanted = DualQuat::left_jacobian_matrix(twist);
            for (got, wanted) in jacobian.into_iter().zip(wanted) {
                measure::<L, 6>(
                    ledger,
                    ("Jacobian", ""),
                    row(got, index),
                    exact(wanted),
                    10.0,
                    case,
                );
            }
            let wanted = DualQuat::left_jacobian_inverse_matrix(twist);
            for (got, wanted) in undone.into_iter().zip(wanted) {
                measure::<L, 6>(
                    ledger,
                    ("Jacobian", ""),
                    row(got, index),
                    exact(wanted),
                    10.0,
                    case,
                );
            }
        }
    }
}

#[test]
fn poses_affine_maps_and_jacobians_on_lanes_are_those_of_the_scalar_reference() {
    #[rustfmt::skip]
    let bounds = [
        line("RotationTranslation::from", &[], 0.8, "fused products"),
        line("RotationTranslation::mul", &[], 1.2, "fused products"),
        line("RotationTranslation::inverse", &[], 1.2, "fused products"),
        line("RotationTranslation::apply", &[], 3.2, "fused products"),
        line("DualQuat::from", &[], 0.4, "fused products"),
        line("Affine", &[], 0.35, "sums of products in another order"),
        line("Jacobian", &[], 0.8, "polynomials for series"),
    ];
    Ledger::keep("poses and maps", &bounds, |ledger| {
        on_every_lane_type!(poses_and_maps_agree, ledger)
    });
}

#[test]
fn affine_maps_with_a_translation_that_is_not_finite_have_no_parts_on_lanes() {
    let map = batch::Affine {
        linear: batch::Affine::uniform_scale(1.0).linear,
        translation: [0.0, f64::NAN, 0.0],
    };
    let (motion, stretch, failed) = map.decompose_checked();
    assert!(failed && motion.to_array().iter().all(|c| c.is_nan()) && stretch[0][0].is_nan());
}
