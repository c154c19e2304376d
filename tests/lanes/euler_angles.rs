//! Euler angles, and gimbal lock as a mask.

use super::{Provable, columns, exact, holds, measure, on_every_level, rounded, row};
use dq8::representation::{EulerAngles, EulerOrder, EulerSolution};
use dq8::{Quat, batch};
use dq8_contract::ledger::{Ledger, line};
use std::f64::consts::{FRAC_PI_2, PI};

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

fn euler_angles_agree<L: Provable>(ledger: &Ledger) {
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
    Ledger::keep("Euler angles", &bounds, |ledger| on_every_level!(euler_angles_agree, ledger));
}

#[test]
fn euler_angles_of_what_is_no_number_are_none_on_lanes() {
    let nan = batch::Quat::from_array([f64::NAN, 0.0, 0.0, 1.0]).to_euler(EulerOrder::ALL[0]);
    assert!(nan.angles.angles.iter().all(|angle| angle.is_nan()) && !nan.gimbal_lock);
}

/// Zeros have signs, and the arctangent of a negative one may be −π instead of π.
fn signs_do_not_matter<L: Provable>() {
    let turns = [0.0, 1.0, -1.0];
    let units = (0..4).flat_map(|at| turns[1..].iter().map(move |&sign| (at, sign)));
    let halves = units.map(|(at, sign)| std::array::from_fn(|i| if i == at { sign } else { 0.0 }));
    let quarters = (0..3).flat_map(|at| {
        turns[1..].iter().map(move |&sign| {
            let side = std::f64::consts::FRAC_1_SQRT_2;
            std::array::from_fn(|i| {
                if i == at {
                    sign * side
                } else if i == 3 {
                    side
                } else {
                    0.0
                }
            })
        })
    });
    let quats: Vec<[f64; 4]> = halves.chain(quarters).collect();
    for order in EulerOrder::ALL {
        for quat in &quats {
            let quat = quat.map(|c| columns::<L, _, 1>(&[c], |&c| [c])[0]);
            let lanes = batch::Quat::from_array(quat);
            assert_eq!(row([lanes.x(), lanes.y(), lanes.z()], 0), row(lanes.xyz(), 0));
            let [one, other] = [quat, quat.map(|c| -c)]
                .map(|quat| row(batch::Quat::from_array(quat).to_euler(order).angles.angles, 0));
            assert_eq!(
                one.map(f64::to_bits),
                other.map(f64::to_bits),
                "{order:?} {one:?} {other:?}"
            );
        }
    }
}

#[test]
fn a_quaternion_and_its_negative_have_the_same_euler_angles() {
    on_every_level!(signs_do_not_matter);
}
