//! Matrices that are motions, nearly, or not at all: the same answers, and a mask where the scalar
//! reference has an error.

use super::scene::{cases, motion, quat};
use super::{Provable, columns, holds, lanes, measure, row};
use dq8::simd::{Lanes, Mask, f32x4};
use dq8::{DualQuat, Quat, Real, batch};
use dq8_contract::bound::{exact, rounded, roundoff};
use dq8_contract::ledger::{Ledger, line};
use dq8_contract::on_every_lane_type;
use dq8_contract::sample::Proof;

/// Whether this target has registers of several numbers.
const FOUR: bool = <<f32x4 as Lanes>::Native as Lanes>::LANES > 1;

type Rows = [[f64; 3]; 3];

fn flat<R: Real>(rows: [[R; 3]; 3]) -> [f64; 9] {
    let [[a, b, c], [d, e, f], [g, h, i]] = rows;
    exact([a, b, c, d, e, f, g, h, i])
}

fn flat_row<L: Provable>([a, b, c]: [[L; 3]; 3], index: usize) -> [f64; 9] {
    row([a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]], index)
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

fn columns_of_rows<L: Provable>(cases: &[Rows]) -> [[L; 3]; 3] {
    let all = columns::<L, _, 9>(cases, |rows| flat(*rows));
    [[all[0], all[1], all[2]], [all[3], all[4], all[5]], [all[6], all[7], all[8]]]
}

fn checked_rotations_agree<L: Provable>(ledger: &Ledger) {
    let all = [matrices(), hard_matrices()].concat();
    for chunk in all.chunks(L::LANES) {
        let rows = columns_of_rows::<L>(chunk);
        let (rotation, no_rotation) = batch::Quat::from_matrix3_checked(rows, lanes(&[1e-3]));
        for (index, case) in chunk.iter().enumerate() {
            let rows = case.map(rounded::<L::Real, 3>);
            let wanted = Quat::try_from_matrix3(rows, <L::Real as Real>::from_f64(1e-3));
            assert_eq!(holds(no_rotation, index), wanted.is_err(), "rotation of {case:?}");
            let wanted = wanted.map_or([f64::NAN; 9], |turn| flat(turn.to_matrix3()));
            let got = flat_row(rotation.to_matrix3(), index);
            measure::<L, 9>(ledger, ("from_matrix3", ""), got, wanted, 1.0, case);
        }
    }
}

#[test]
fn rotations_of_matrices_are_read_and_refused_on_lanes_as_by_the_scalar_reference() {
    #[rustfmt::skip]
    let bounds = [
        // Without registers of four numbers the reference divides by the length; with them, both
        // multiply by its reciprocal.
        line("from_matrix3", &[], if FOUR { 3.9 } else { 16.0 }, "another length divides"),
    ];
    Ledger::keep("matrices", &bounds, |ledger| {
        on_every_lane_type!(checked_rotations_agree(ledger))
    });
}

fn checked_matrices<L: Provable>() {
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
                        assert!(worst < 64.0 * roundoff::<L::Real>(), "{rows:?}: {worst:e}");
                    }
                }
            }
        }
    }
}

#[test]
fn a_matrix_that_is_no_motion_is_a_lane_of_nan_and_a_mask() {
    on_every_lane_type!(checked_matrices());
}

/// 32 units of the last place, on either side of 1: scalar, and in all lanes.
fn normalized<L: Provable>() {
    let unit: f64 = L::Real::EPSILON.into();
    for off in [0.0, 20.0, -20.0, 28.0, -28.0, 36.0, -36.0, 1e3, f64::NAN] {
        let is_one = off.abs() < 32.0;
        let motion =
            motion::<L::Real>(cases()[50].a).scale(<L::Real as Real>::from_f64(1.0 + off * unit));
        let bits = if is_one { (1 << L::LANES) - 1 } else { 0 };
        assert_eq!(
            (motion.is_normalized(), motion.real().is_normalized()),
            (is_one, is_one),
            "{off}"
        );
        let on_lanes = batch::DualQuat::<L>::splat(L::Level::proof(), motion.to_array());
        assert_eq!(on_lanes.is_normalized().to_bitmask(), bits, "{off}");
        assert_eq!(on_lanes.real().is_normalized().to_bitmask(), bits, "{off}");
    }
}

#[test]
fn normalized_is_within_32_units_of_the_last_place() {
    on_every_lane_type!(normalized());
}
