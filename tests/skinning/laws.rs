use super::scene::{JOINTS, Scene, distance, motion, posed, vector};
use dq8::skinning::{
    DualBlend, Linear, Skin, StretchedDualBlend, Weight, dual_blend, split_palette,
};
use dq8::{Backend, DualQuat, Quat, Scalar, representation::Affine};
use dq8_contract::random::Random;

/// A vertex and its neighbors, with the same influences: 40 ε for some twenty roundings of numbers
/// up to 3.
fn moves_rigidly<R: Scalar + Weight>(epsilon: f64) {
    let scene = Scene::<R>::new(1, 4);
    let (joints, weights) = (scene.joints.repeat(64), scene.weights.repeat(64));
    let skin = Skin::new(JOINTS, 4, &joints, &weights).unwrap();
    let mut random = Random(5);
    let body: Vec<[R; 3]> = (0..64).map(|_| vector(random.direction())).collect();
    for backend in Backend::available() {
        let posed = posed(backend, &skin, DualBlend::new(&scene.motions), &body);
        for i in 1..64 {
            let change = distance(posed[i], posed[0]) - distance(body[i], body[0]);
            assert!(change.abs() < 40.0 * epsilon, "{backend} {i}: {change}");
        }
    }
}

#[test]
fn dual_quaternion_blends_move_bodies_rigidly() {
    moves_rigidly::<f32>(f32::EPSILON.into());
    moves_rigidly::<f64>(f64::EPSILON);
}

fn single<R: Scalar + Weight>() {
    for influences in [1, 2, 4, 8, 9] {
        let mut scene = Scene::<R>::new(50, influences);
        for (vertex, weights) in scene.weights.chunks_mut(influences).enumerate() {
            weights.fill(R::ZERO);
            weights[vertex % influences] = R::ONE;
        }
        let skin = scene.skin();
        let one = |vertex| skin.influence::<R>(vertex, vertex % influences).unwrap().0 as usize;
        let each: Vec<_> = (0..50).map(|vertex| scene.motions[one(vertex)]).collect();
        for backend in Backend::available() {
            let mut moved = vec![[R::ZERO; 3]; 50];
            backend.transform_points_each(&each, &scene.positions, &mut moved).unwrap();
            let posed = posed(backend, &skin, DualBlend::new(&scene.motions), &scene.positions);
            assert_eq!(posed, moved, "{influences} {backend}");
        }
    }
}

#[test]
fn a_single_influence_is_the_motion_to_the_last_bit() {
    single::<f32>();
    single::<f64>();
    let mut random = Random(9);
    let (a, b): (DualQuat<f32>, _) = (motion(&mut random), motion(&mut random));
    assert_eq!(dual_blend(&[(b, 0.0), (a, 1.0)]), Some(a));
}

#[test]
fn negating_any_entry_of_a_palette_changes_no_bit() {
    for influences in [2, 4, 9] {
        let mut scene = Scene::<f32>::new(200, influences);
        // At right angles to each other, exactly: products that cancel, and signed zeros.
        let half = core::f32::consts::FRAC_1_SQRT_2;
        let across = [[half, half, 0.0, 0.0], [half, -half, 0.0, 0.0], [0.0, 0.0, half, half]];
        for (joint, turn) in across.into_iter().enumerate() {
            scene.motions[joint] = DualQuat::from_rotation(Quat::from_array(turn));
        }
        for backend in Backend::available() {
            let wanted =
                posed(backend, &scene.skin(), DualBlend::new(&scene.motions), &scene.positions);
            for joint in 0..JOINTS {
                let mut motions = scene.motions.clone();
                motions[joint] = -motions[joint];
                let posed =
                    posed(backend, &scene.skin(), DualBlend::new(&motions), &scene.positions);
                assert_eq!(posed, wanted, "{influences} {backend} {joint}");
            }
        }
    }
}

/// Turns about z, whose halves are added: the third is on the side of the first of the two with the
/// greatest weight, and not on that of the second.
#[test]
fn of_equal_weights_the_first_says_on_which_side_the_others_are() {
    let turns = [0.0_f64, 170.0, -100.0].map(f64::to_radians);
    let about_z = |angle| DualQuat::from_rotation(Quat::from_axis_angle([0.0, 0.0, 1.0], angle));
    let motions = turns.map(about_z);
    for (joints, weights) in [
        (&[0_u16, 1, 2][..], &[0.4, 0.4, 0.2][..]),
        (&[0, 1, 2, 2], &[0.375, 0.375, 0.125, 0.125]),
        (&[0, 1, 2, 1, 0], &[0.3, 0.3, 0.2, 0.1, 0.1]),
    ] {
        let sum = |part: fn(f64) -> f64| -> f64 {
            let parts = joints.iter().zip(weights);
            parts.map(|(&joint, weight)| weight * part(0.5 * turns[joint as usize])).sum()
        };
        let (sin, cos) = (2.0 * sum(f64::sin).atan2(sum(f64::cos))).sin_cos();
        let skin = Skin::new(motions.len(), joints.len(), joints, weights).unwrap();
        for backend in Backend::available() {
            let posed = posed(backend, &skin, DualBlend::new(&motions), &[[1.0, 0.0, 0.0]]);
            assert!(distance(posed[0], [cos, sin, 0.0]) < 1e-14, "{backend}: {posed:?}");
        }
    }
}

/// Kavan et al. 2008, §4: of two motions DLB turns at most 8.15° off ScLERP, and slides at most
/// 15.1 % of the slide between the two off.
#[test]
fn two_influences_stay_within_the_bound_of_kavan() {
    let mut random = Random(3);
    let (mut angle, mut slide) = (0.0_f64, 0.0_f64);
    for _ in 0..20_000 {
        let a: DualQuat<f64> = motion(&mut random);
        let axis = random.direction();
        let turn = Quat::from_axis_angle(axis, random.between(0.0, core::f64::consts::PI));
        let way = DualQuat::from_rotation_translation(turn, random.direction());
        let (b, t) = (a * way, random.between(0.0, 1.0));
        let blend = dual_blend(&[(a, 1.0 - t), (b, t)]).unwrap();
        let off = (a.sclerp(b, t).conjugate() * blend).normalize().to_screw();
        angle = angle.max(off.angle.to_degrees());
        // Where both are large enough to be measured.
        let whole = way.to_screw();
        if whole.slide.abs() > 0.1 && whole.angle > 0.1 && off.angle > 1e-6 {
            slide = slide.max(off.slide.abs() / whole.slide.abs());
        }
    }
    assert!((7.0..8.16).contains(&angle), "{angle}°");
    assert!(slide < 0.152, "{slide} of the slide");
}

/// Matrices in `f64`, summed and applied number by number.
#[test]
fn a_linear_blend_is_the_sum_of_matrices() {
    let scene = Scene::<f32>::new(500, 4);
    let matrices = scene.matrices();
    for backend in Backend::available() {
        let posed = posed(backend, &scene.skin(), Linear::new(&matrices), &scene.positions);
        for (vertex, posed) in posed.iter().enumerate() {
            for (row, &number) in posed.iter().enumerate() {
                let mut wanted = 0.0;
                for influence in 0..4 {
                    let joint = scene.joints[4 * vertex + influence] as usize;
                    let [x, y, z] = scene.positions[vertex].map(f64::from);
                    let [a, b, c, t] = matrices[joint][row].map(f64::from);
                    let weight = f64::from(scene.weights[4 * vertex + influence]);
                    wanted += weight * (a * x + b * y + c * z + t);
                }
                // Seven roundings of numbers up to 2.
                let error = (f64::from(number) - wanted).abs();
                assert!(error < 8.0 * f64::from(f32::EPSILON), "{backend} {vertex}: {error}");
            }
        }
    }
}

#[test]
fn a_stretch_and_then_a_motion_is_the_matrix_of_a_single_influence() {
    let mut scene = Scene::<f64>::new(60, 1);
    scene.weights.fill(1.0);
    let whole: Vec<[[f64; 4]; 3]> = (0..JOINTS)
        .map(|j| {
            let stretch = Affine::from_matrix3x4(scene.stretches[j]);
            (Affine::from_motion(scene.motions[j]) * stretch).to_matrix3x4()
        })
        .collect();
    let mut motions = vec![DualQuat::IDENTITY; JOINTS];
    let mut stretches = vec![[[0.0; 4]; 3]; JOINTS];
    split_palette(&whole, &mut motions, &mut stretches).unwrap();
    for backend in Backend::available() {
        let wanted = posed(backend, &scene.skin(), Linear::new(&whole), &scene.positions);
        let blend = StretchedDualBlend::new(&motions, &stretches);
        let posed = posed(backend, &scene.skin(), blend, &scene.positions);
        for (a, b) in posed.iter().zip(&wanted) {
            // One matrix, or a stretch and a motion, of some units.
            assert!(distance(*a, *b) < 1e-14, "{backend}: {a:?}, not {b:?}");
        }
    }
}

/// A joint turns on and on, its quaternion now on one side and now on the other; its neighbor
/// follows half an angle behind. No vertex moves farther in a step than the fastest point of the
/// two.
#[test]
fn nothing_flips_when_joints_turn_through_a_full_turn() {
    let weights: Vec<f32> =
        (0..=10).flat_map(|i| [1.0 - i as f32 / 10.0, i as f32 / 10.0]).collect();
    let joints = [0_u16, 1].repeat(11);
    let skin = Skin::new(2, 2, &joints, &weights).unwrap();
    let rest = [[1.0_f32, 0.0, 0.5]; 11];
    let steps = 2000;
    for backend in Backend::available() {
        let mut before: Option<Vec<[f32; 3]>> = None;
        for step in 0..=steps {
            let angle = 3.0 * core::f32::consts::TAU * step as f32 / steps as f32;
            let turn = |angle| Quat::from_axis_angle([0.0_f32, 0.0, 1.0], angle);
            // As a library hands it out that prefers w ≥ 0: it jumps at half a turn.
            let canonical = |q: Quat<f32>| if q.w() < 0.0 { -q } else { q };
            let palette = [turn(angle), turn(angle + 1.5)]
                .map(|q| DualQuat::from_rotation_translation(canonical(q), [0.0, 0.0, 1.0]));
            let posed = posed(backend, &skin, DualBlend::new(&palette), &rest);
            if let Some(before) = &before {
                for (a, b) in posed.iter().zip(before) {
                    let way: f64 = distance(*a, *b);
                    let fastest = 1.01 * 3.0 * core::f64::consts::TAU / f64::from(steps as u16);
                    assert!(way < fastest, "{backend}, step {step}: {way}");
                }
            }
            before = Some(posed);
        }
    }
}

/// Lanes hold four influences of a vertex, or a multiple of that: those that it does not have are
/// no joint.
#[test]
fn a_joint_moves_no_vertex_that_does_not_name_it() {
    for influences in [1, 2, 3, 5, 9] {
        let mut scene = Scene::<f32>::new(37, influences);
        for joint in scene.joints.iter_mut().filter(|joint| **joint == 0) {
            *joint = 1;
        }
        let skin = scene.skin();
        for backend in Backend::available() {
            let posed = |scene: &Scene<f32>| {
                let blended =
                    posed(backend, &skin, Linear::new(&scene.matrices()), &scene.positions);
                (posed(backend, &skin, DualBlend::new(&scene.motions), &scene.positions), blended)
            };
            let mut broken = Scene::<f32>::new(37, influences);
            broken.motions[0] = DualQuat::from_array([f32::NAN; 8]);
            assert_eq!(posed(&broken), posed(&scene), "{influences} {backend}");
        }
    }
}
