//! Manipulability against the determinant of nalgebra, and where it has an edge.

use crate::tree::{mechanism, tree, values};
use dq8::{Dual, DualQuat, Real, ShapeError, Twist};
use dq8_fixtures::random::Random;
use dq8_robot::{Body, Joint, OwnedMechanism, World, WorldAligned};
use nalgebra::{Matrix6, Vector6};

/// The tolerance of the volume, relative to the sixth power of an entry: the determinant of
/// matrices loses half of the digits.
const OF_MATRICES: f64 = 1e-7;
const ROUNDING: f64 = 1e-13;

fn of<R: Real>(arm: &OwnedMechanism<R>, values: &[R], link: usize) -> R {
    let mut columns = vec![Twist::ZERO; arm.view().rates()];
    arm.view().manipulability(values, link, &mut columns).unwrap()
}

fn by_matrices(columns: &[Twist<f64>]) -> f64 {
    let mut square = Matrix6::zeros();
    for column in columns {
        let column = Vector6::from(column.to_array());
        square += column * column.transpose();
    }
    square.determinant().max(0.0).sqrt()
}

#[test]
fn manipulability_is_the_root_of_the_determinant_in_every_frame() {
    let (mut random, mut regular) = (Random(61), 0);
    for count in 1..25 {
        let joints = tree(&mut random, count);
        let arm = mechanism::<f64>(&joints);
        let values = values(&mut random, &joints);
        for link in 0..count {
            let volume = of(&arm, &values, link);
            let mut columns = vec![Twist::ZERO; arm.view().rates()];
            for frame in 0..3 {
                let columns = &mut columns;
                match frame {
                    0 => arm.view().link_jacobian(Body, &values, link, columns),
                    1 => arm.view().link_jacobian(World, &values, link, columns),
                    _ => arm.view().link_jacobian(WorldAligned, &values, link, columns),
                }
                .unwrap();
                let wanted = by_matrices(columns);
                let error = (volume - wanted).abs() / (1.0 + wanted);
                assert!(error < OF_MATRICES, "link {link} of {count}: {volume} {wanted}");
            }
            regular += usize::from(volume > 0.01);
        }
    }
    assert!(regular > 50, "{regular}");
}

/// A hinge about z at each of these places on x, and slides along all axes before them if told so.
fn hinges(places: &[f64], slides: bool) -> OwnedMechanism<f64> {
    let mut joints = Vec::new();
    for axis in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].iter().filter(|_| slides) {
        let on = joints.len().checked_sub(1);
        joints.push(Joint::prismatic(on, DualQuat::IDENTITY, *axis));
    }
    for &place in places {
        let on = joints.len().checked_sub(1);
        let at = DualQuat::from_translation([place, 0.0, 0.0]);
        joints.push(Joint::revolute(on, at, [0.0, 0.0, 1.0]));
    }
    OwnedMechanism::new(&joints).unwrap()
}

#[test]
fn few_rates_and_few_directions_are_singular() {
    // Exactly, where there are fewer than six rates, or none moves the link.
    let five = mechanism::<f64>(&crate::reach::seven()[..5]);
    assert_eq!(of(&five, &[0.3, 0.4, -0.2, -1.0, 0.5], 4), 0.0);
    let arm = hinges(&[0.0, 0.3, 0.4], false);
    assert_eq!(of(&arm, &[0.2, 0.7, 0.1], 2), 0.0);
    let arm = hinges(&[0.0, 0.3], true);
    assert_eq!(of(&arm, &[0.1, 0.2, 0.3, 0.4, 0.5], 4), 0.0);
    let still = Joint::fixed(None, DualQuat::<f64>::IDENTITY);
    let still = OwnedMechanism::new(&[still]).unwrap();
    assert_eq!(of(&still, &[], 0), 0.0);
    // But for rounding, where all hinges are parallel.
    for count in 3..9 {
        let arm = hinges(&vec![0.3; count], true);
        let values: Vec<_> = (0..3 + count).map(|i| 0.1 + 0.3 * i as f64).collect();
        let volume = of(&arm, &values, 2 + count);
        assert!((0.0..ROUNDING).contains(&volume), "{count}: {volume}");
    }
}

#[test]
fn what_is_not_a_number_has_no_manipulability() {
    let arm = hinges(&[0.1, 0.3, 0.4], true);
    for (index, number) in [(3, f64::NAN), (4, f64::NAN), (3, f64::INFINITY)] {
        let mut values = [0.1; 6];
        values[index] = number;
        assert!(of(&arm, &values, 5).is_nan(), "{index} {number}");
    }
    let mut columns = [Twist::ZERO; 6];
    let refused = arm.view().manipulability(&[0.1; 6], 6, &mut columns).unwrap_err();
    assert!(matches!(refused, ShapeError::NoLink { .. }), "{refused:?}");
    assert!(arm.view().manipulability(&[0.1; 5], 5, &mut columns).is_err());
    assert!(arm.view().manipulability(&[0.1; 6], 5, &mut columns[..5]).is_err());
    assert_eq!(columns, [Twist::ZERO; 6]);
}

/// The gradient, as somebody wants it who climbs to where the arm moves best.
#[test]
fn dual_numbers_differentiate_manipulability() {
    let joints = crate::reach::seven();
    let (single, dual) = (mechanism::<f64>(&joints), mechanism::<Dual<f64>>(&joints));
    let at = [0.3, 0.4, -0.2, -1.0, 0.5, 1.2, 0.1];
    for (moved, &value) in at.iter().enumerate() {
        let mut values = at.map(|value| Dual::new(value, 0.0));
        values[moved].dual = 1.0;
        let slope = of(&dual, &values, 7).dual;
        let beside = |step: f64| {
            let mut values = at;
            values[moved] = value + step;
            of(&single, &values, 7)
        };
        let wanted = (beside(1e-5) - beside(-1e-5)) / 2e-5;
        assert!((slope - wanted).abs() < 1e-9, "{moved}: {slope} {wanted}");
    }
}
