//! Euler angles in all 24 orders.

use super::{between, for_random_motions, opinion, worst};
use core::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, PI};
use dq8::{
    Quat, Real,
    representation::{EulerAngles, EulerAxes, EulerFrame, EulerOrder},
};
use dq8_contract::bound::{exact, rounded, roundoff};
use glam::EulerRot;
use nalgebra::{UnitQuaternion, Vector3};

/// glam's sines of angles of a few turns, three products.
const BY_GLAM: f64 = 1e-14;
/// The outer angles lose as many digits as the sine or cosine of the middle one has, some
/// hundredths here.
const AWAY_FROM_LOCK: f64 = 1e-13;

/// The names that glam has for [`EulerOrder::ALL`].
const OF_GLAM: [EulerRot; 24] = [
    EulerRot::XYZ,
    EulerRot::XZY,
    EulerRot::YXZ,
    EulerRot::YZX,
    EulerRot::ZXY,
    EulerRot::ZYX,
    EulerRot::XYX,
    EulerRot::XZX,
    EulerRot::YXY,
    EulerRot::YZY,
    EulerRot::ZXZ,
    EulerRot::ZYZ,
    EulerRot::XYZEx,
    EulerRot::XZYEx,
    EulerRot::YXZEx,
    EulerRot::YZXEx,
    EulerRot::ZXYEx,
    EulerRot::ZYXEx,
    EulerRot::XYXEx,
    EulerRot::XZXEx,
    EulerRot::YXYEx,
    EulerRot::YZYEx,
    EulerRot::ZXZEx,
    EulerRot::ZYZEx,
];

/// The three turns multiplied by nalgebra.
fn product(EulerAngles { angles, order }: EulerAngles<f64>) -> UnitQuaternion<f64> {
    let axes = order.axes.indices().map(Vector3::ith_axis);
    let [first, second, third] =
        std::array::from_fn(|i| UnitQuaternion::from_axis_angle(&axes[i], angles[i]));
    match order.frame {
        EulerFrame::Intrinsic => first * second * third,
        EulerFrame::Extrinsic => third * second * first,
    }
}

/// The middle angles of gimbal lock.
fn locks(order: EulerOrder) -> [f64; 2] {
    if order.axes.is_proper() { [0.0, PI] } else { [-FRAC_PI_2, FRAC_PI_2] }
}

/// Angles at and near every gimbal lock, down to distances far below rounding, on the side where
/// the middle angle is in its range.
fn near_lock(order: EulerOrder) -> impl Iterator<Item = EulerAngles<f64>> {
    let inward = [1.0, -1.0];
    let outer = [[0.3, -1.1], [-2.9, 3.0], [0.0, 0.7], [3.1, 0.0], [FRAC_PI_2, -FRAC_PI_2]];
    locks(order).into_iter().zip(inward).flat_map(move |(lock, inward)| {
        (0..=40).flat_map(move |half_decades| {
            let off =
                if half_decades == 40 { 0.0 } else { 10_f64.powf(-0.5 * f64::from(half_decades)) };
            outer.into_iter().map(move |[first, last]| EulerAngles {
                angles: [first, lock + inward * off, last],
                order,
            })
        })
    })
}

fn narrow<R: Real>(quat: UnitQuaternion<f64>) -> Quat<R> {
    let [x, y, z, w] = rounded(quat.coords.into());
    Quat::from_xyzw(x, y, z, w)
}

#[test]
fn twelve_orders_of_axes_have_no_equal_neighbours_and_are_all_there_are() {
    let mut all: Vec<_> = EulerAxes::ALL.map(EulerAxes::indices).to_vec();
    assert!(all.iter().all(|[a, b, c]| a != b && b != c && a.max(b).max(c) <= &2));
    all.sort_unstable();
    all.dedup();
    assert_eq!(all.len(), 12);
    for axes in EulerAxes::ALL {
        let letters = axes.indices().map(|axis| ['X', 'Y', 'Z'][axis]);
        assert_eq!(format!("{axes:?}"), String::from_iter(letters));
        for frame in [EulerFrame::Intrinsic, EulerFrame::Extrinsic] {
            let order = EulerOrder { axes, frame };
            assert_eq!(EulerOrder::ALL.iter().filter(|other| **other == order).count(), 1);
        }
    }
}

#[test]
fn three_turns_are_what_nalgebra_and_glam_make_of_them() {
    fn check<R: Real>(allowed: f64) {
        let worst = worst(
            "three turns",
            allowed,
            "three half angles of up to 5, their sines and cosines, and two products",
        );
        for (order, of_glam) in EulerOrder::ALL.into_iter().zip(OF_GLAM) {
            for angles in [[0.1, 0.2, 0.3], [-3.0, 1.4, 2.0], [6.0, -5.0, 9.0], [0.0, PI, -PI]] {
                let angles = EulerAngles { angles: rounded::<R, 3>(angles), order };
                let [a, b, c] = exact(angles.angles);
                let known = EulerAngles { angles: [a, b, c], order };
                let got = opinion(angles.to_quat());
                worst.see(between(got, product(known)), roundoff::<R>(), &known);
                let glam = glam::DQuat::from_euler(of_glam, a, b, c).to_array();
                assert!(between(opinion(Quat::from_array(glam)), product(known)) < BY_GLAM);
            }
        }
    }
    check::<f32>(4.0);
    check::<f64>(8.0);
}

/// The angles found make the rotation again, for any rotation, near gimbal lock as elsewhere.
#[test]
fn the_angles_of_a_rotation_make_it_again_in_every_order_near_gimbal_lock_too() {
    fn check<R: Real>(allowed: f64) {
        let worst = worst(
            "angles of a rotation",
            allowed,
            "sums and differences of two arctangents, each of up to π",
        );
        let see = |quat: Quat<R>, order: EulerOrder| {
            let solution = quat.to_euler(order);
            let exact = EulerAngles { angles: exact(solution.angles.angles), order };
            worst.see(between(opinion(quat), product(exact)), roundoff::<R>(), &(quat, solution));
            let [low, high] = locks(order);
            let [first, middle, last] = exact.angles;
            let rounding: f64 = R::EPSILON.into();
            assert!(first.abs() <= PI + rounding && last.abs() <= PI + rounding, "{solution:?}");
            assert!(middle >= low - rounding && middle <= high + rounding, "{solution:?}");
            let [ours, negative] = [solution, (-quat).to_euler(order)];
            assert_eq!(ours, negative, "the sign of {quat:?} matters");
        };
        for order in EulerOrder::ALL {
            near_lock(order).for_each(|angles| see(narrow(product(angles)), order));
        }
        for_random_motions(|motion| {
            let [x, y, z, w] = rounded(motion.rotation().to_array());
            EulerOrder::ALL.iter().for_each(|order| see(Quat::from_xyzw(x, y, z, w), *order));
        });
    }
    check::<f32>(12.0);
    check::<f64>(12.0);
}

/// The arcsine of an element of the matrix has an error of √ε there.
#[test]
fn the_middle_angle_is_good_to_a_few_units_near_gimbal_lock() {
    fn check<R: Real>(allowed: f64) {
        let worst = worst(
            "middle angle near gimbal lock",
            allowed,
            "the rotation is rounded, and an arctangent and a difference",
        );
        for order in EulerOrder::ALL {
            for known in near_lock(order) {
                let found = narrow::<R>(product(known)).to_euler(order);
                let middle: f64 = found.angles.angles[1].into();
                worst.see(middle - known.angles[1], roundoff::<R>(), &known);
            }
        }
    }
    check::<f32>(8.0);
    check::<f64>(12.0);
}

#[test]
fn away_from_gimbal_lock_the_angles_are_those_of_glam() {
    let checked = std::cell::Cell::new(0);
    for_random_motions(|motion| {
        let quat = motion.rotation();
        for (order, of_glam) in EulerOrder::ALL.into_iter().zip(OF_GLAM) {
            let ours = quat.to_euler(order);
            let lock = locks(order).into_iter();
            let off = lock.fold(1.0_f64, |off, lock| off.min((ours.angles.angles[1] - lock).abs()));
            if off < 0.1 {
                continue;
            }
            let [a, b, c] = glam::DQuat::from_array(quat.to_array()).to_euler(of_glam).into();
            // Its middle angle is negative in half of the proper orders.
            let negative = order.axes.is_proper() && b < 0.0;
            let [a, b, c] = if negative { [a + PI, -b, c + PI] } else { [a, b, c] };
            for (ours, theirs) in ours.angles.angles.into_iter().zip([a, b, c]) {
                let apart = (ours - theirs).rem_euclid(2.0 * PI);
                assert!(apart.min(2.0 * PI - apart) < AWAY_FROM_LOCK, "{order:?} of {quat:?}");
            }
            checked.set(checked.get() + 1);
        }
    });
    assert!(checked.get() > 10_000);
}

/// Arends ch. 2 §5: at θ = π/2 of XYZ and at θ = 0 of ZXZ only the sum of the others is left.
#[test]
fn at_gimbal_lock_the_last_angle_is_zero_and_the_first_has_the_sum_or_the_difference() {
    fn check<R: Real>(tolerance: f64) {
        for order in EulerOrder::ALL {
            for middle in locks(order) {
                // Whether the outer turns have the same sense there: by the product itself.
                let [at, both] = [[0.5, middle, 0.25], [0.75, middle, 0.0]]
                    .map(|angles| EulerAngles { angles, order });
                let same = between(product(at), product(both)) < BY_GLAM;
                let named = [(EulerAxes::XYZ, FRAC_PI_2), (EulerAxes::ZXZ, 0.0)];
                let turns_along = order.frame == EulerFrame::Intrinsic;
                assert!(same || !turns_along || !named.contains(&(order.axes, middle)));
                let wanted = [if same { 0.75 } else { 0.25 }, middle, 0.0];
                let angles = EulerAngles { angles: rounded::<R, 3>(at.angles), order };
                for quat in [narrow(product(at)), angles.to_quat()] {
                    let solution = quat.to_euler(order);
                    let found = exact(solution.angles.angles);
                    assert!(solution.gimbal_lock, "{order:?} at {middle}");
                    assert_eq!(found[1..], exact(rounded::<R, 3>(wanted))[1..], "{solution:?}");
                    assert!((found[0] - wanted[0]).abs() < tolerance, "{solution:?}");
                }
            }
        }
    }
    check::<f32>(1e-6);
    check::<f64>(2e-15);
}

#[test]
fn gimbal_lock_is_reported_within_rounding_of_it_and_nowhere_else() {
    fn check<R: Real>() {
        let epsilon: f64 = R::EPSILON.into();
        for order in EulerOrder::ALL {
            for (lock, inward) in locks(order).into_iter().zip([1.0, -1.0]) {
                let at = |units: f64| {
                    let angles = [0.4, lock + inward * units * epsilon, -0.9];
                    narrow::<R>(product(EulerAngles { angles, order })).to_euler(order).gimbal_lock
                };
                assert!(at(0.0) && at(2.0), "{order:?} at {lock}");
                assert!(!at(8.0) && !at(1e3) && !at(0.5 / epsilon), "{order:?} off {lock}");
            }
        }
    }
    check::<f32>();
    check::<f64>();
}

#[test]
fn quarter_and_half_turns_about_one_axis_are_exact() {
    let orders = EulerOrder::ALL.into_iter().filter(|order| !order.axes.is_proper());
    for order in orders {
        for (place, axis) in order.axes.indices().into_iter().enumerate() {
            let turn = |sine: f64, cosine: f64| {
                let mut xyzw = [0.0, 0.0, 0.0, cosine];
                xyzw[axis] = sine;
                Quat::from_array(xyzw).to_euler(order)
            };
            let mut wanted = [0.0; 3];
            assert_eq!(turn(0.0, 1.0).angles.angles, wanted);
            wanted[place] = FRAC_PI_2;
            assert_eq!(turn(FRAC_1_SQRT_2, FRAC_1_SQRT_2).angles.angles, wanted, "{order:?}");
            wanted[place] = -FRAC_PI_2;
            assert_eq!(turn(-FRAC_1_SQRT_2, FRAC_1_SQRT_2).angles.angles, wanted, "{order:?}");
            if place != 1 {
                let half = turn(1.0, 0.0).angles.angles.map(f64::abs);
                wanted[place] = PI;
                assert_eq!(half, wanted, "{order:?}");
            }
        }
    }
}

/// Without loss: all digits of an angle far below rounding of 1.
#[test]
fn tiny_angles_about_three_axes_keep_their_digits() {
    let orders = EulerOrder::ALL.into_iter().filter(|order| !order.axes.is_proper());
    for (order, size) in orders.flat_map(|order| [1e-6_f32, 1e-20, 1e-37].map(|size| (order, size)))
    {
        let angles = [1.0, -0.7, 0.4].map(|c| c * size);
        let found = EulerAngles { angles, order }.to_quat().to_euler(order).angles.angles;
        for (found, wanted) in found.into_iter().zip(angles) {
            assert!(
                (found - wanted).abs() < 4.0 * f32::EPSILON * size,
                "{order:?}: {found:e} for {wanted:e}"
            );
        }
    }
}

#[test]
fn angles_of_what_is_not_a_number_are_not_a_number() {
    for order in EulerOrder::ALL {
        let solution = Quat::from_xyzw(0.0, f32::NAN, 0.0, 1.0).to_euler(order);
        assert!(solution.angles.angles.iter().all(|angle| angle.is_nan()), "{solution:?}");
        let turned = EulerAngles { angles: [0.0, f32::INFINITY, 0.0], order }.to_quat();
        assert!(turned.to_array().iter().all(|c| c.is_nan()), "{turned:?}");
    }
}
