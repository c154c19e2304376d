//! Rates for the velocity of a link, against the pseudoinverse of nalgebra.

use crate::tree::{mechanism, tree, values};
use dq8::{DualQuat, ShapeError, Twist};
use dq8_fixtures::random::Random;
use dq8_robot::{Body, Joint, OwnedMechanism, World, WorldAligned};
use nalgebra::{DMatrix, Vector6};

fn of(
    arm: &OwnedMechanism<f64>,
    values: &[f64],
    link: usize,
    twist: Twist<f64>,
    damping: f64,
) -> Vec<f64> {
    let mut columns = vec![Twist::ZERO; arm.view().rates()];
    let mut rates = vec![9.0; arm.view().rates()];
    arm.view().rates_for(Body, values, link, twist, damping, &mut columns, &mut rates).unwrap();
    rates
}

fn jacobian(arm: &OwnedMechanism<f64>, values: &[f64], link: usize) -> DMatrix<f64> {
    let mut columns = vec![Twist::ZERO; arm.view().rates()];
    arm.view().link_jacobian(Body, values, link, &mut columns).unwrap();
    DMatrix::from_fn(6, columns.len(), |row, column| columns[column].to_array()[row])
}

#[test]
fn rates_are_those_of_the_damped_pseudoinverse() {
    let (mut random, mut compared) = (Random(67), 0);
    for count in 1..20 {
        let joints = tree(&mut random, count);
        let (arm, values) = (mechanism::<f64>(&joints), values(&mut random, &joints));
        for link in 0..count {
            let twist = [(); 6].map(|()| random.number(false, 0.0).clamp(-1.0, 1.0));
            let matrix = jacobian(&arm, &values, link);
            for damping in [0.0, 0.3] {
                let rates = of(&arm, &values, link, Twist::from_array(twist), damping);
                let svd = matrix.clone().svd(true, true);
                let sizes = svd.singular_values.as_slice();
                let largest = sizes.iter().fold(0.0_f64, |most, size| most.max(*size));
                let nearly = |size: f64| size > 1e-14 * largest && size < 1e-6 * largest;
                if damping == 0.0 && sizes.iter().any(|&size| nearly(size)) {
                    continue;
                }
                let (u, v) = (svd.u.as_ref().unwrap(), svd.v_t.as_ref().unwrap());
                let mut wanted = nalgebra::DVector::zeros(rates.len());
                for (at, &size) in
                    sizes.iter().enumerate().filter(|(_, size)| **size > 1e-12 * largest)
                {
                    let along = u.column(at).dot(&Vector6::from(twist));
                    wanted +=
                        v.row(at).transpose() * (along * size / (size * size + damping * damping));
                }
                let error =
                    rates.iter().zip(&wanted).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
                assert!(
                    error <= 1e-9 * (1.0 + wanted.amax()),
                    "link {link} of {count}: {rates:?} {wanted}"
                );
                compared += 1;
            }
        }
    }
    assert!(compared > 300, "{compared}");
}

#[test]
fn rates_do_not_depend_on_the_frame() {
    let joints = crate::reach::seven();
    let arm = mechanism::<f64>(&joints);
    let (at, link) = ([0.3, 0.4, -0.2, -1.0, 0.5, 1.2, 0.1], 7);
    let pose = arm.view().link_pose(&at, link).unwrap();
    let body = Twist { angular: [0.1, -0.3, 0.2], linear: [0.4, 0.1, -0.2] };
    let (world, turned) =
        (pose.adjoint(body), DualQuat::from_rotation(pose.rotation()).adjoint(body));
    let wanted = of(&arm, &at, link, body, 0.0);
    let (mut columns, mut rates) = ([Twist::ZERO; 7], [[0.0; 7]; 2]);
    let view = arm.view();
    view.rates_for(World, &at, link, world, 0.0, &mut columns, &mut rates[0]).unwrap();
    view.rates_for(WorldAligned, &at, link, turned, 0.0, &mut columns, &mut rates[1]).unwrap();
    // The least of many rates is the same, because each frame has the same null space.
    for rates in rates {
        for (rate, wanted) in rates.iter().zip(&wanted) {
            assert!((rate - wanted).abs() < 1e-12, "{rates:?} {wanted}");
        }
    }
}

#[test]
fn directions_that_nothing_moves_have_no_rates() {
    let z = [0.0, 0.0, 1.0];
    let here = DualQuat::IDENTITY;
    let joints = [
        Joint::revolute(None, here, z),
        Joint::revolute(Some(0), here, z),
        Joint::prismatic(Some(1), here, z),
    ];
    let crane = OwnedMechanism::new(&joints).unwrap();
    let twist = Twist::from_array([1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
    let rates = of(&crane, &[0.1, 0.2, 0.3], 2, twist, 0.0);
    assert!(rates.iter().zip([1.5, 1.5, 6.0]).all(|(a, b)| (a - b).abs() < 1e-14), "{rates:?}");
    assert_eq!(of(&crane, &[0.1, 0.2, 0.3], 2, Twist::ZERO, 0.0), [0.0; 3]);
    let (mut columns, mut rates) = ([Twist::ZERO; 3], [7.0; 3]);
    let refused = crane
        .view()
        .rates_for(Body, &[0.1; 3], 3, twist, 0.0, &mut columns, &mut rates)
        .unwrap_err();
    assert!(matches!(refused, ShapeError::NoLink { .. }), "{refused:?}");
    assert!(
        crane
            .view()
            .rates_for(Body, &[0.1; 3], 2, twist, 0.0, &mut columns, &mut rates[..2])
            .is_err()
    );
    assert!(
        crane
            .view()
            .rates_for(Body, &[0.1; 3], 2, twist, 0.0, &mut columns[..2], &mut rates)
            .is_err()
    );
    assert!(
        crane.view().rates_for(Body, &[0.1; 2], 2, twist, 0.0, &mut columns, &mut rates).is_err()
    );
    assert!(columns == [Twist::ZERO; 3] && rates == [7.0; 3]);
}
