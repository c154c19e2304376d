//! Arms whose axes miss those of a family by what people type.

use super::{Poses, families};
use dq8_arms::{Axis, Plan, Random};
use dq8_robot::ik::Family;

/// The arm with axes that are turned and moved by this.
fn missed(plan: &Plan<6>, by: f64) -> Plan<6> {
    let mut random = Random(5);
    let mut off = |v: [f64; 3]| {
        let way: [f64; 3] = random.direction();
        core::array::from_fn(|i| v[i] + by * way[i])
    };
    let turned = plan.axes.map(|axis| {
        let direction: [f64; 3] = off(axis.direction);
        let norm = direction.iter().map(|c| c * c).sum::<f64>().sqrt();
        Axis { direction: direction.map(|c| c / norm), through: off(axis.through), ..axis }
    });
    Plan { axes: turned, ..*plan }
}

#[test]
fn arms_nearly_of_a_family_have_what_many_starts_find_and_it_is_not_said_to_be_all() {
    let (mut all, mut first) = (0, 0);
    for (name, plan, _) in families() {
        // A quarter turn with four decimals, and with two.
        for by in [3.7e-6, 4e-4] {
            let near = missed(&plan, by);
            let poses = Poses::<f64>::random(&near, 50);
            assert_eq!(poses.six().family(), Family::Other, "{name}");
            for (found, values) in poses.solve().iter().zip(&poses.values) {
                assert!(!found.is_complete);
                all += found.len();
                first += usize::from(found.first().is_some_and(|it| it.distance < 1e-7));
                for one in found.iter() {
                    let [turn, way] = near.apart(&one.values, values);
                    assert!(turn < 1e-9 && way < 1e-9, "{name}: {turn:e}, {way:e}");
                }
            }
        }
    }
    // From 64 other starts, in ten times the time and more, searches find 4,133.
    assert!(all >= 4_130 && first >= 597, "{all}, and {first} of 600");
}

/// Angles of less than a roundoff's root from where two solutions are one, where what the arm
/// misses is amplified the most.
#[test]
fn what_is_found_of_arms_that_miss_a_family_by_less_than_a_fit_is_at_the_target() {
    let (mut random, mut found_of_all) = (Random(29), 0);
    for (name, plan, family) in families() {
        let near = missed(&plan, 4e-9);
        let values = (0..300).map(|index| {
            let mut values = near.draw(&mut random);
            let small = random.signed() * 10.0_f64.powi(-(index % 10));
            match index / 10 % 4 {
                0 => values[4] = small,
                1 => values[2] += small - values[2],
                2 => (values[2], values[4]) = (small, -small),
                _ => {}
            }
            values
        });
        let poses = Poses::<f64>::at(&near, values.collect());
        assert_eq!(poses.six().family(), family, "{name}");
        for (found, values) in poses.solve().iter().zip(&poses.values) {
            found_of_all += found.len();
            for one in found.iter() {
                let [turn, way] = near.apart(&one.values, values);
                // 16 of 10⁻⁸, of half the turn, and of an arm of a few lengths.
                assert!(turn < 3.3e-7 && way < 8e-7, "{name}: {turn:e}, {way:e} at {values:?}");
            }
        }
    }
    assert!(found_of_all > 6_000, "{found_of_all}");
}
