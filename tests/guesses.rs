//! One-liners that somebody who knows glam or nalgebra would type without looking anything up. They
//! compile, and mean what they seem to.

#![allow(clippy::op_ref, reason = "operators of references are what is tried")]

use dq8::{
    Backend, Crowd, Dual, DualQuat, Hierarchy, Line, Plane, Quat, Twist,
    geometry::{DualVector, Screw, Wrench},
    representation::{Affine, EulerAxes, EulerFrame, EulerOrder, RotationTranslation},
    storage::LinearFirst,
};
use std::f64::consts::{FRAC_PI_2, PI};

const UP: [f64; 3] = [0.0, 0.0, 1.0];

/// What a few products of numbers no larger than about 4 leave.
const ROUNDING: f64 = 1e-15;
/// Points and translations some lengths away.
const LENGTHS: f64 = 1e-14;
/// Half a unit of the last place of such a length in `f32`.
const IN_SINGLE: f64 = 2.5e-7;

fn a() -> DualQuat<f64> {
    DualQuat::from_rotation_translation(
        Quat::from_axis_angle([0.36, 0.48, 0.8], 0.7),
        [1.0, 2.0, 3.0],
    )
}

fn b() -> DualQuat<f64> {
    DualQuat::from_rotation_translation(Quat::from_rotation_y(-1.1), [-4.0, 0.5, 2.0])
}

fn near(a: [f64; 3], b: [f64; 3]) -> bool {
    a.into_iter().zip(b).all(|(a, b)| (a - b).abs() < LENGTHS)
}

#[test]
fn products_and_sums_take_values_and_references() {
    let (a, b, p, q) = (a(), b(), a().rotation(), b().rotation());
    let product = a * b;
    assert_eq!([&a * &b, a * &b, &a * b], [product; 3]);
    assert_eq!([&p * &q, p * &q, &p * q], [p * q; 3]);
    assert_eq!([&a + &b, a + &b, &a + b], [a + b; 3]);
    assert_eq!([&p - &q, p - &q, &p - q], [p - q; 3]);
    assert_eq!((-&a, -&p), (-a, -p));
    let mut c = a;
    c *= b;
    assert_eq!(c, product);
    c = a;
    c *= &b;
    assert_eq!(c, product);
    c += a;
    c -= &a;
    assert!(c.abs_diff_eq(product, ROUNDING));
    let mut r = p;
    r *= q;
    r += p;
    r -= p;
    assert!(r.abs_diff_eq(p * q, ROUNDING));
    let x = Dual::new(2.0, 1.0);
    assert_eq!(x * dq8::Real::TWO, x + x);
}

#[test]
fn numbers_are_factors_from_both_sides() {
    let (a, q) = (a(), a().rotation());
    assert_eq!([a * 2.0, 2.0 * a, a / 0.5], [a.scale(2.0); 3]);
    assert_eq!([q * 2.0, 2.0 * q, q / 0.5], [q.scale(2.0); 3]);
    let single: DualQuat<f32> = a.cast();
    assert_eq!(2.0 * single, single * 2.0);
    let twist = Twist { angular: UP, linear: [1.0, 2.0, 3.0] };
    assert_eq!([twist * 2.0, 2.0 * twist, twist / 0.5], [twist.scale(2.0); 3]);
    let log = a.log();
    assert_eq!(log * 0.5, 0.5 * log);
    let mut twice = q;
    twice *= 2.0;
    twice /= 2.0;
    assert_eq!(twice, q);
}

#[test]
fn iterators_sum_and_multiply_in_order() {
    let steps = [a(), b(), a()];
    assert_eq!(steps.iter().product::<DualQuat<f64>>(), DualQuat::IDENTITY * a() * b() * a());
    assert_eq!(steps.into_iter().product::<DualQuat<f64>>(), steps.iter().product());
    assert_eq!(steps.iter().sum::<DualQuat<f64>>(), DualQuat::ZERO + a() + b() + a());
    assert_eq!(
        steps.map(|s| s.rotation()).iter().product::<Quat<f64>>(),
        steps.iter().product::<DualQuat<f64>>().rotation()
    );
    let twists = [Twist { angular: UP, linear: UP }; 3];
    assert_eq!(twists.into_iter().sum::<Twist<f64>>(), twists[0] * 3.0);
    let poses = steps.map(RotationTranslation::from);
    let moved = poses.iter().product::<RotationTranslation<f64>>().transform_point(UP);
    assert!(near(moved, steps.iter().product::<DualQuat<f64>>().transform_point(UP)));
    let maps = steps.map(Affine::from_motion);
    assert!(near(maps.iter().product::<Affine<f64>>().transform_point(UP), moved));
    let logs: DualVector<f64> = steps.iter().map(|s| s.log()).sum();
    assert_eq!(logs, DualVector::default() + a().log() + b().log() + a().log());
}

#[test]
fn arrays_quaternions_and_pairs_convert() {
    let (a, q) = (a(), a().rotation());
    let array: [f64; 8] = a.into();
    assert_eq!(DualQuat::from(array), a);
    let xyzw: [f64; 4] = q.into();
    assert_eq!(Quat::from(xyzw), q);
    let (rotation, translation) = a.into();
    assert_eq!(
        DualQuat::from((rotation, translation)),
        DualQuat::from_rotation_translation(rotation, translation)
    );
    assert_eq!(DualQuat::from(q), DualQuat::from_rotation(q));
    assert_eq!(DualQuat::from([a.real(), a.dual()]), a);
    let pose = RotationTranslation::from((rotation, translation));
    let seven: [f64; 7] = pose.into();
    assert_eq!(RotationTranslation::from(seven), pose);
    let six: [f64; 6] = a.to_twist().into();
    assert_eq!(Twist::from(six), a.to_twist());
    assert_eq!(Wrench::from((UP, UP)), Wrench { force: UP, torque: UP });
    assert!((b() * pose).abs_diff_eq(b() * a, LENGTHS));
    assert_eq!((q.as_ref()[3], a.as_ref()[7]), (q.w(), a.dual().w()));
}

#[test]
fn numbers_change_their_type_by_cast() {
    let narrow: DualQuat<f32> = a().cast();
    assert!(narrow.cast::<f64>().abs_diff_eq(a(), IN_SINGLE));
    assert_eq!(narrow.cast::<f64>().cast::<f32>(), narrow);
    assert_eq!(Quat::<f32>::IDENTITY.cast::<f64>(), Quat::IDENTITY);
}

#[test]
fn components_have_indices() {
    let mut q = Quat::from_xyzw(1.0, 2.0, 3.0, 4.0);
    assert_eq!((q[0], q[3]), (q.x(), q.w()));
    q[1] = 7.0;
    assert_eq!(q.y(), 7.0);
    let mut a = a();
    a[7] = -1.0;
    assert_eq!((a[7], a.dual().w()), (-1.0, -1.0));
    assert!(std::panic::catch_unwind(|| Quat::<f32>::IDENTITY[4]).is_err());
}

#[test]
fn text_comes_back_to_the_last_bit() {
    assert_eq!(Quat::from_xyzw(0.5_f32, 0.0, -1.0, 2.0).to_string(), "[0.5, 0, -1, 2]");
    assert_eq!(format!("{:.2}", Quat::<f64>::IDENTITY), "[0.00, 0.00, 0.00, 1.00]");
    assert_eq!(a().to_string().parse(), Ok(a()));
    assert_eq!(" 0 0,0 , 1 ".parse(), Ok(Quat::<f32>::IDENTITY));
    let pose = RotationTranslation::from(a());
    assert_eq!(pose.to_string().parse(), Ok(pose));
    assert_eq!(a().to_twist().to_string().parse(), Ok(a().to_twist()));
    let error = "[1, 2, x, 4]".parse::<Quat<f32>>().unwrap_err();
    assert_eq!(error.to_string(), "element 2 of the list is not a number");
    let error = "[1,, 2, 3, 4]".parse::<Quat<f32>>().unwrap_err();
    assert_eq!(error.to_string(), "element 1 of the list is not a number");
    let error = "[1, 2, 3]".parse::<Quat<f32>>().unwrap_err();
    assert_eq!(error.to_string(), "the list has 3 numbers where 4 are needed");
}

#[test]
fn constants_are_constants() {
    const IDENTITY: DualQuat<f32> = DualQuat::IDENTITY;
    const TURN: Quat<f32> = Quat::from_xyzw(0.0, 0.0, 1.0, 0.0);
    const POSE: RotationTranslation<f32> =
        RotationTranslation { rotation: TURN, translation: [1.0, 2.0, 3.0] };
    const MOTION: DualQuat<f32> = DualQuat::from_rotation(TURN);
    const PARTS: DualQuat<f32> = DualQuat::new(TURN, Quat::ZERO);
    assert_eq!((MOTION, IDENTITY.real().w(), POSE.rotation), (PARTS, 1.0, TURN));
}

#[test]
fn quaternions_have_what_other_libraries_quaternions_have() {
    let (p, q) = (a().rotation(), b().rotation());
    assert!((p * p.inverse()).abs_diff_eq(Quat::IDENTITY, ROUNDING));
    assert!((p * 3.0 * (p * 3.0).inverse()).abs_diff_eq(Quat::IDENTITY, ROUNDING));
    assert!(Quat::<f64>::ZERO.inverse().to_array().iter().all(|c| c.is_nan()));
    assert!(
        p.nlerp(q, 0.0).abs_diff_eq(p, ROUNDING)
            && p.nlerp(-q, 1.0).abs_diff_eq(p.nlerp(q, 1.0), 0.0)
    );
    assert!((p.angle_to(p.nlerp(q, 0.5)) - p.angle_to(q) / 2.0).abs() < ROUNDING);
    assert!((p.angle_to(-(p * Quat::from_rotation_x(0.25))) - 0.25).abs() < ROUNDING);
    assert!(
        p.is_unit(ROUNDING)
            && p.is_normalized()
            && !(p * 2.0).is_unit(0.5)
            && !(p * 2.0).is_normalized()
    );
    assert!(p.is_finite() && !Quat::from_xyzw(0.0, f64::NAN, 0.0, 1.0).is_finite());
    assert!(a().is_finite() && !(a() * f64::INFINITY).is_finite());
    assert!(near(Quat::from_rotation_x(FRAC_PI_2) * [0.0, 1.0, 0.0], UP));
    assert!(near(Quat::from_rotation_y(FRAC_PI_2) * UP, [1.0, 0.0, 0.0]));
    assert!(near(Quat::from_rotation_z(FRAC_PI_2) * [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]));
    assert!((p.slerp(q, 0.5).norm() - 1.0).abs() < ROUNDING && (p.dot(p) - 1.0).abs() < ROUNDING);
}

#[test]
fn the_shortest_arc_takes_one_direction_to_the_other_at_every_angle() {
    let from = [0.6, 0.0, 0.8];
    for angle in [0.0, 1e-300, 1e-20, 1e-8, 0.3, FRAC_PI_2, 3.0, PI - 1e-8, PI - 1e-15, PI] {
        let turn = Quat::from_axis_angle([0.0, 1.0, 0.0], angle);
        let to = turn.rotate(from);
        let arc = Quat::from_rotation_arc(from.map(|c| c * 7.0), to.map(|c| c * 1e-200));
        assert!(arc.is_normalized() && near(arc.rotate(from), to), "{angle}: {arc}");
        assert!((arc.angle_to(Quat::IDENTITY) - angle).abs() < 2.0 * ROUNDING, "{angle}: {arc}");
    }
    let opposite = Quat::from_rotation_arc(UP, [0.0, 0.0, -1.0]);
    assert!(near(opposite.rotate(UP), [0.0, 0.0, -1.0]) && opposite.is_normalized());
    assert!(!Quat::from_rotation_arc([0.0; 3], UP).is_finite());
}

#[test]
fn looking_puts_z_forward_and_y_up() {
    for (forward, up) in [(UP, [0.0, 1.0, 0.0]), ([1.0, -2.0, 0.5], UP), ([0.0, -1e200, 0.0], UP)] {
        let turn = Quat::look_to(forward, up).unwrap();
        let length = forward.iter().fold(0.0_f64, |sum, c| sum.hypot(*c));
        assert!(near(turn.rotate(UP), forward.map(|c| c / length)), "{forward:?}");
        let [_, y, _] = turn.conjugate().rotate(up);
        assert!(turn.conjugate().rotate(up)[0].abs() < ROUNDING && y > 0.0);
    }
    let camera = DualQuat::look_at([1.0, 2.0, 3.0], [1.0, 2.0, 13.0], [0.0, 5.0, 0.0]).unwrap();
    assert!(near(camera.transform_point([0.0, 1.0, 10.0]), [1.0, 3.0, 13.0]));
    assert!(Quat::look_to(UP, UP).is_err() && Quat::look_to([0.0; 3], UP).is_err());
    assert!(DualQuat::look_at(UP, UP, UP).is_err());
    assert!(Quat::look_to([f64::NAN, 0.0, 0.0], UP).is_err());
}

#[test]
fn a_trajectory_keeps_its_signs_after_make_continuous() {
    let mut turns: Vec<_> = (0..50).map(|i| Quat::from_rotation_x(0.4 * f64::from(i))).collect();
    let smooth = turns.clone();
    for index in [3, 4, 20, 49] {
        turns[index] = -turns[index];
    }
    let mut motions: Vec<_> = turns.iter().copied().map(DualQuat::from).collect();
    Quat::make_continuous(&mut turns);
    assert_eq!(turns, smooth);
    DualQuat::make_continuous(&mut motions);
    assert!(motions.iter().zip(&smooth).all(|(m, q)| m.real() == *q));
    Quat::<f32>::make_continuous(&mut []);
}

#[test]
fn angles_of_every_custom_make_the_turn_that_they_name() {
    let (roll, pitch, yaw) = (0.3, -0.7, 1.9);
    let [x, y, z] =
        [Quat::from_rotation_x(roll), Quat::from_rotation_y(pitch), Quat::from_rotation_z(yaw)];
    let urdf = Quat::from_rpy(roll, pitch, yaw);
    assert!(urdf.abs_diff_eq(z * y * x, ROUNDING), "{urdf}");
    let aircraft = EulerOrder { axes: EulerAxes::ZYX, frame: EulerFrame::Intrinsic };
    assert!(Quat::from_euler(aircraft, yaw, pitch, roll).abs_diff_eq(urdf, ROUNDING));
}

#[test]
fn orders_of_euler_angles_have_the_names_of_glam_and_scipy() {
    let (q, turns) = (a().rotation(), [1.9, -0.7, 0.3]);
    let glam = glam::DQuat::from_euler(glam::EulerRot::ZYX, turns[0], turns[1], turns[2]);
    let ours = Quat::from_euler(EulerOrder::ZYX, turns[0], turns[1], turns[2]);
    assert!(ours.abs_diff_eq(Quat::from_array(glam.to_array()), ROUNDING));
    let glam = glam::DQuat::from_euler(glam::EulerRot::XYZEx, 0.3, -0.7, 1.9);
    let ours = Quat::from_euler(EulerOrder::XYZ.extrinsic(), 0.3, -0.7, 1.9);
    assert!(ours.abs_diff_eq(Quat::from_array(glam.to_array()), ROUNDING));
    let names = [EulerOrder::XYZ, EulerOrder::XZY, EulerOrder::YXZ, EulerOrder::YZX];
    let more = [EulerOrder::ZXY, EulerOrder::ZYX, EulerOrder::XYX, EulerOrder::XZX];
    let proper = [EulerOrder::YXY, EulerOrder::YZY, EulerOrder::ZXZ, EulerOrder::ZYZ];
    let all = [names, more, proper];
    assert_eq!(all.as_flattened(), &EulerOrder::ALL[..12]);
    assert!(all.iter().flatten().map(|order| order.extrinsic()).eq(EulerOrder::ALL[12..].to_vec()));
    let [roll, pitch, yaw] = q.to_rpy();
    assert!(Quat::from_rpy(roll, pitch, yaw).abs_diff_eq(q, ROUNDING));
    assert_eq!((-q).to_rpy(), q.to_rpy());
    // At gimbal lock roll has the whole turn.
    let [roll, pitch, yaw] = Quat::from_rpy(0.5, FRAC_PI_2, 0.25).to_rpy();
    assert!((roll - 0.25).abs() < LENGTHS && (pitch - FRAC_PI_2).abs() < LENGTHS && yaw == 0.0);
}

#[test]
fn quaternions_have_logarithms_powers_and_means() {
    let tiny = Quat::from_axis_angle([0.6, 0.0, 0.8], 1e-30);
    let still = -Quat::<f64>::IDENTITY;
    let half_turn = Quat::from_xyzw(0.0, -1.0, 0.0, 0.0);
    for q in [a().rotation(), b().rotation(), tiny, still, half_turn, -a().rotation()] {
        let (log, of_motions) = (q.log(), DualQuat::from_rotation(q).log().real);
        for (ours, wanted) in log.into_iter().zip(of_motions) {
            assert!((ours - wanted).abs() <= ROUNDING * wanted.abs(), "{q}: {log:?}");
        }
        assert!((Quat::exp(log).dot(q).abs() - 1.0).abs() < ROUNDING);
        for t in [0.0, 0.5, 1.0, -2.0, 0.3] {
            let power = DualQuat::from_rotation(q).pow(t).rotation();
            assert!(q.pow(t).abs_diff_eq(power, LENGTHS), "{q} {t}");
        }
    }
    assert!(Quat::<f64>::from_xyzw(f64::NAN, 0.0, 0.0, 1.0).log()[0].is_nan());
    assert!(!Quat::exp([f64::INFINITY, 0.0, 0.0]).is_finite());
    assert_eq!(Quat::exp([0.0, -0.0, 0.0]), Quat::<f64>::IDENTITY);

    let turns: Vec<_> = (0..1000).map(|i| Quat::from_rotation_z(0.001 * f64::from(i))).collect();
    let mean = Quat::mean(&turns).unwrap();
    assert!(mean.abs_diff_eq(Quat::from_rotation_z(0.4995), 1e-13));
    let signed: Vec<_> =
        turns.iter().enumerate().map(|(i, &q)| if i % 3 == 0 { -q } else { q }).collect();
    assert!(Quat::mean(&signed).unwrap().dot(mean).abs() > 1.0 - 1e-13);
    let motions = [a(), -b(), a()];
    let exact = DualQuat::dib(&motions.map(|m| (m, 1.0)), 1e-12, 64).unwrap().motion;
    assert!(DualQuat::mean(&motions).unwrap().abs_diff_eq(exact, 1e-12));
    assert!(a().abs_diff_eq(DualQuat::mean(&[a()]).unwrap(), LENGTHS));
    assert_eq!((DualQuat::<f32>::mean(&[]), Quat::<f32>::mean(&[])), (None, None));
    assert_eq!(DualQuat::mean(&[a(), a() * f64::NAN]), None);
}

#[test]
fn motions_are_made_of_what_files_and_axes_say() {
    let (xyz, rpy) = ([1.0, -2.0, 0.5], [0.3, -0.7, 1.9]);
    let origin = DualQuat::from_xyz_rpy(xyz, rpy);
    assert_eq!(origin.rotation(), Quat::from_rpy(rpy[0], rpy[1], rpy[2]));
    assert!(near(origin.transform_point([0.0; 3]), xyz));
    let turns = [DualQuat::from_rotation_x, DualQuat::from_rotation_y, DualQuat::from_rotation_z];
    for (axis, turn) in turns.into_iter().enumerate() {
        let mut unit = [0.0; 3];
        unit[axis] = 1.0;
        assert_eq!(turn(0.7), DualQuat::from_axis_angle(unit, 0.7));
        assert_eq!(turn(0.7), DualQuat::from_rotation(Quat::from_axis_angle(unit, 0.7)));
    }
    let (moved, turned) = (a().with_translation(xyz), a().with_rotation(b().rotation()));
    assert!(moved.rotation() == a().rotation() && near(moved.translation(), xyz));
    assert!(turned.rotation() == b().rotation() && near(turned.translation(), a().translation()));
    let twist = Twist::from(([0.0, 3.0, 0.0], [0.0, 0.0, 4.0]));
    assert_eq!((twist.norm(), twist.is_finite(), twist.angular[1]), (5.0, true, 3.0));
    assert!(!Twist { linear: [f64::NAN, 0.0, 0.0], ..twist }.is_finite());
    assert!(Twist::<f64>::from(([1e200; 3], [0.0; 3])).norm().is_finite());
}

#[test]
fn crowds_are_made_read_and_written_by_instances() {
    let at = |instance: usize, joint: usize| {
        DualQuat::from_translation([instance as f32, joint as f32, 0.0])
    };
    let mut crowd = Crowd::<f32, 4>::from_fn(3, 7, at);
    let wanted: Vec<_> = (0..7).flat_map(|i| (0..3).map(move |j| at(i, j))).collect();
    assert_eq!(crowd, Crowd::from_slice(3, &wanted).unwrap());
    assert_eq!(crowd.iter().len(), 7);
    assert!(crowd.iter().flatten().eq(wanted.iter().copied()));
    crowd.set_instance(6, &[at(9, 0), at(9, 1), at(9, 2)]).unwrap();
    assert!(crowd.instance(6).eq((0..3).map(|j| at(9, j))));
    assert!(crowd.instance(5).eq(wanted[15..18].iter().copied()));
    let before = crowd.clone();
    assert!(crowd.set_instance(7, &[at(0, 0); 3]).is_err());
    assert!(crowd.set_instance(0, &[at(1, 1); 2]).is_err());
    assert!(crowd.set_instance(0, &[at(1, 1); 4]).is_err());
    assert_eq!(crowd, before);
}

#[test]
fn skeletons_know_names_ancestors_and_leaves() {
    let leg = dq8::Skeleton::new(&[-1, 0, 1, 0]).unwrap();
    assert!(leg.names().eq([None; 4]));
    let leg = leg.with_names(["hip", "knee", "", "tail"]).unwrap();
    assert!(leg.names().eq([Some("hip"), Some("knee"), None, Some("tail")]));
    assert_eq!(leg.names().len(), 4);
    assert!(
        leg.ancestors(2).eq([1, 0])
            && leg.ancestors(0).count() == 0
            && leg.ancestors(9).count() == 0
    );
    assert!((0..6).map(|joint| leg.is_leaf(joint)).eq([false, false, true, true, false, false]));
}

#[cfg(feature = "reproducible")]
#[test]
fn backends_know_whether_they_are_reproducible() {
    use dq8_contract::fusing::PORTABLE_FUSES;
    assert!(Backend::reproducible().is_reproducible());
    for backend in Backend::available() {
        assert_eq!(
            backend.is_reproducible(),
            !backend.to_string().contains("AVX") && !PORTABLE_FUSES
        );
    }
}
/// What is printed with the struct of a game that holds it.
#[test]
fn what_holds_many_numbers_is_printed_on_a_line() {
    use dq8::hierarchy::{Clip, Layered, OwnedClip, PackedClip, Poses, Sampled};
    use dq8::law::{Nlerp, NlerpLerp};
    let keys = [[0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]; 21 * 3].map(RotationTranslation::from);
    let clip = Clip::new(21, &keys).unwrap().with_rate(30.0);
    assert_eq!(format!("{clip:?}"), "Clip { joints: 21, frames: 3, rate: 30.0, loops: false }");
    let owned = OwnedClip::new(21, keys).unwrap();
    assert_eq!(
        format!("{owned:?}"),
        "OwnedClip { joints: 21, frames: 3, rate: 1.0, loops: false }"
    );
    let poses = vec![DualQuat::<f32>::default(); 21];
    let layered = Layered::blend(Nlerp, Poses(&poses), Poses(&poses), &[0.5]);
    assert_eq!(
        format!("{layered:?}"),
        "Layered { law: Nlerp, base: Poses { elements: 21 }, layer: Poses { elements: 21 }, adds: false, \
         instances: 1, masked: false }"
    );
    let sampled = Sampled::new(NlerpLerp, clip, &[0; 5], &[0.5; 5]).unwrap();
    let crowd = Crowd::<f32, 8>::new(21, 500);
    assert_eq!(
        format!("{crowd:?}"),
        "Crowd { joints: 21, instances: 500, lanes: 8, components: 8 }"
    );
    let parents: Vec<_> = (-1..20).collect();
    let skeleton = dq8::Skeleton::new(&parents).unwrap();
    assert_eq!(format!("{skeleton:?}"), "Skeleton { joints: 21, names: 0 }");
    assert_eq!(format!("{:?}", Backend::PORTABLE), "Backend(portable)");
    let packed = PackedClip::new(clip, Default::default()).unwrap();
    for text in [
        format!("{packed:?}"),
        format!("{sampled:?}"),
        format!("{:?}", skeleton.job()),
        format!("{:?}", skeleton.hierarchy()),
        format!("{:?}", Backend::best()),
    ] {
        assert!(text.len() < 160 && !text.contains('['), "{text}");
    }
}

/// An owned clip answers by itself.
#[test]
fn clips_with_memory_of_their_own_are_asked_as_borrowed_ones() {
    use dq8::{hierarchy::OwnedClip, law::Nlerp};
    let keys = [0.0, 0.5, 1.5].map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
    let walk = OwnedClip::new(1, keys).unwrap().with_rate(4.0).looping();
    assert_eq!((walk.duration(), walk.frames(), walk.place(0.6875)), (0.5, 3, (0, 0.75)));
    let at = walk.pose(Nlerp, 0, 0.375).unwrap();
    assert!(near(at.translation(), [1.0, 0.0, 0.0]) && walk.pose(Nlerp, 1, 0.0).is_none());
    let moved = walk.between(Nlerp, 0, 0.25, 1.25).unwrap();
    assert!(near(moved.translation(), [3.0, 0.0, 0.0]), "two rounds");
}

#[test]
fn rotations_and_translations_of_slices_are_interpolated_apart() {
    let (from, to, mut between) = ([a(); 5], [b(); 5], [DualQuat::IDENTITY; 5]);
    Backend::best().slerp_lerp(&from, &to, 0.25, &mut between).unwrap();
    assert!(between.iter().all(|pose| pose.abs_diff_eq(a().slerp_lerp(b(), 0.25), LENGTHS)));
}

#[test]
fn twists_and_wrenches_pair_and_rest_is_zero() {
    let wrench = Wrench { force: [1.0, 2.0, 3.0], torque: [4.0, 5.0, 6.0] };
    let twist = Twist { angular: [0.5, 0.25, 0.125], linear: [2.0, 3.0, 4.0] };
    assert_eq!(wrench.dot(twist), 20.0 + 4.0);
    assert_eq!((wrench.dot(Twist::ZERO), Twist::ZERO + twist), (0.0, twist));
}

#[test]
fn an_instance_of_a_crowd_is_its_joints_in_their_order() {
    let steps: Vec<_> = (0..21).map(|i| DualQuat::from_translation([i as f32, 0.0, 0.0])).collect();
    let crowd = Crowd::<f32, 4>::from_slice(3, &steps).unwrap();
    for (instance, wanted) in steps.chunks(3).enumerate() {
        assert!(
            crowd.instance(instance).eq(wanted.iter().copied())
                && crowd.instance(instance).len() == 3
        );
    }
    assert_eq!(crowd.instance(7).len(), 0);
}

#[test]
fn points_lines_planes_crowds_and_hierarchies_are_where_they_are_looked_for() {
    let moved = a().transform_point(UP);
    assert!(near(a().inverse().transform_point(moved), UP));
    assert!(near(a().conjugate().transform_point(moved), UP));
    assert!(
        (a().sclerp(b(), 0.5).distance_to(a()) - a().sclerp(b(), 0.5).distance_to(b())).abs()
            < LENGTHS
    );
    let line = Line::from_point_direction([0.0; 3], UP);
    let plane = Plane::from_point_normal([0.0; 3], UP);
    assert_eq!(
        (DualQuat::default().transform_line(line), DualQuat::default().transform_plane(plane)),
        (line, plane)
    );
    let crowd = Crowd::<f32, 8>::new(2, 3);
    assert_eq!(crowd.get(2, 1), Some(DualQuat::default()));
    let parents = [Hierarchy::ROOT, 0];
    let mut poses = vec![DualQuat::<f32>::default(); 2];
    Hierarchy::new(&parents).unwrap().job().local_to_model_in_place(&mut poses).unwrap();
    let mut out = poses.clone();
    Backend::best().mul(&poses, &poses, &mut out).unwrap();
    assert_eq!(out, poses);
    assert_eq!(vec![Quat::<f32>::default(); 4].len(), 4);
    let blocks = [dq8::storage::Block::<f32, 8, 12>::splat([1.0; 12]); 2];
    assert_eq!(bytemuck::cast_slice::<_, f32>(&blocks), [1.0; 2 * 12 * 8]);
    let floats: &[f32] = bytemuck_free(&poses);
    assert_eq!(floats.len(), 16);
}

/// As an environment variable says which.
#[test]
fn backends_are_read_by_their_names() {
    for backend in Backend::available() {
        assert_eq!(backend.to_string().parse(), Ok(backend));
        assert_eq!(backend.to_string().to_lowercase().replace('-', "").parse(), Ok(backend));
    }
    assert_eq!("PORT-able".parse(), Ok(Backend::PORTABLE), "neither case nor hyphens matter");
    let best = "avx2".parse().unwrap_or_default();
    assert!(Backend::available().any(|backend| backend == best));
    let error = "AVX3".parse::<Backend>().unwrap_err();
    assert!(error.to_string().starts_with("no such backend here; this CPU has portable"));
    assert!("".parse::<Backend>().is_err());
}

#[test]
fn structs_of_numbers_are_plain_data_in_the_order_of_their_fields() {
    fn numbers<T: bytemuck::Pod, const C: usize>() -> T {
        let counted: [f32; C] = std::array::from_fn(|i| i as f32);
        let plain: T = bytemuck::cast(counted);
        assert_eq!(
            bytemuck::cast_slice::<T, f32>(&[plain, plain]),
            [counted, counted].as_flattened()
        );
        plain
    }
    assert_eq!(numbers::<Dual<f32>, 2>(), Dual::new(0.0, 1.0));
    assert_eq!(numbers::<Quat<f32>, 4>().to_array(), [0.0, 1.0, 2.0, 3.0]);
    assert_eq!(numbers::<Plane<f32>, 4>().offset, 3.0);
    assert_eq!(numbers::<Line<f32>, 6>().moment, [3.0, 4.0, 5.0]);
    assert_eq!(numbers::<Twist<f32>, 6>().linear, [3.0, 4.0, 5.0]);
    assert_eq!(numbers::<Wrench<f32>, 6>().torque, [3.0, 4.0, 5.0]);
    assert_eq!(numbers::<DualVector<f32>, 6>().dual, [3.0, 4.0, 5.0]);
    assert_eq!(numbers::<RotationTranslation<f32>, 7>().translation, [4.0, 5.0, 6.0]);
    assert_eq!(numbers::<DualQuat<f32>, 8>().to_array()[7], 7.0);
    assert_eq!(numbers::<Screw<f32>, 8>().slide, 7.0);
    assert_eq!(numbers::<Affine<f32>, 12>().translation, [9.0, 10.0, 11.0]);
    assert_eq!(numbers::<LinearFirst<f32>, 6>().0[5], 5.0);
}

/// A motion is plain data: `as_ref` needs no crate for casts.
fn bytemuck_free(poses: &[DualQuat<f32>]) -> &[f32] {
    // One slice of records is a slice of arrays by way of `storage::Element`.
    dq8::storage::Element::<8>::plain(poses).unwrap_or_default().as_flattened()
}
