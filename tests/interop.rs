//! What other crates own comes in and goes out with the same meaning: each by what it does to a
//! point.
#![allow(dead_code, unused_imports, reason = "each feature has its own tests")]

use dq8::{DualQuat, Quat, Twist, representation::RotationTranslation, scalar::MatrixError};

/// Points and translations of a few lengths, a few operations each; and in `f32`.
const ROUNDING: f64 = 4e-15;
#[cfg(feature = "glam_034")]
const IN_SINGLE: f32 = 1e-6;

const POINT: [f64; 3] = [0.3, -7.0, 2.0];

fn motion() -> DualQuat<f64> {
    let turn = Quat::from_axis_angle([0.36, 0.48, 0.8], 0.7);
    DualQuat::from_rotation_translation(turn, [1.0, -2.0, 3.0])
}

fn near(a: [f64; 3], b: [f64; 3]) -> bool {
    a.into_iter().zip(b).all(|(a, b)| (a - b).abs() < ROUNDING)
}

fn close(a: DualQuat<f64>, b: DualQuat<f64>) -> bool {
    a.abs_diff_eq(b, ROUNDING)
}

#[cfg(feature = "glam_034")]
mod glam_034 {
    use super::*;
    use dq8::interop::glam_034;
    use glam::{Affine3A, DAffine3, DMat3, DMat4, DQuat, DVec3};

    #[test]
    fn glam_moves_points_as_dq8_does() {
        let (sigma, point) = (motion(), DVec3::from(POINT));
        let wanted = sigma.transform_point(POINT);
        assert!(near(DAffine3::from(sigma).transform_point3(point).into(), wanted));
        assert!(near(DMat4::from(sigma).transform_point3(point).into(), wanted));
        let turned = sigma.rotation().rotate(POINT);
        assert!(near(DMat3::from(sigma.rotation()).mul_vec3(point).into(), turned));
        assert!(near((DQuat::from(sigma.rotation()) * point).into(), turned));
        let (rotation, translation): (DQuat, DVec3) = sigma.into();
        assert!(near((rotation * point + translation).into(), wanted));
        assert!(close((rotation, translation).into(), sigma));
        assert!(close(DMat4::from(sigma).try_into().unwrap(), sigma));
        assert!(close(DAffine3::from(sigma).try_into().unwrap(), sigma));
        assert_eq!(Quat::from(rotation), sigma.rotation());
        let scaled = DAffine3::from_scale(DVec3::splat(0.01));
        let MatrixError::Scales { factor } = DualQuat::try_from(scaled).unwrap_err() else {
            panic!()
        };
        assert!((factor - 0.01).abs() < ROUNDING);
        let single = sigma.cast::<f32>();
        assert!(DualQuat::try_from(Affine3A::from(single)).unwrap().abs_diff_eq(single, IN_SINGLE));
    }

    #[test]
    fn slices_of_glam_are_cast_where_they_lie() {
        let mut theirs = [glam::Quat::from_xyzw(1.0, 2.0, 3.0, 4.0); 3];
        assert_eq!(glam_034::quats(&theirs)[2], Quat::from_xyzw(1.0, 2.0, 3.0, 4.0));
        glam_034::quats_mut(&mut theirs)[0] = Quat::IDENTITY;
        assert_eq!(theirs[0], glam::Quat::IDENTITY);
        assert_eq!(glam_034::dquats(&[DQuat::IDENTITY; 2]), [Quat::IDENTITY; 2]);
        let mut points = [glam::Vec3::new(1.0, 2.0, 3.0); 2];
        glam_034::points_mut(&mut points)[1] = [0.0; 3];
        assert_eq!(glam_034::points(&points), [[1.0, 2.0, 3.0], [0.0; 3]]);
        assert_eq!(glam_034::dpoints(&[DVec3::ONE]), [[1.0; 3]]);
    }
}

#[cfg(feature = "nalgebra_035")]
mod nalgebra_035 {
    use super::*;
    use dq8::interop::nalgebra_035;
    use nalgebra::{
        DualQuaternion, Isometry3, Matrix4, Point3, Quaternion, Rotation3, UnitDualQuaternion,
        UnitQuaternion,
    };

    #[test]
    fn nalgebra_moves_points_as_dq8_does() {
        let (sigma, point) = (motion(), Point3::from(POINT));
        let wanted = sigma.transform_point(POINT);
        assert!(near(Isometry3::from(sigma).transform_point(&point).coords.into(), wanted));
        assert!(near(
            UnitDualQuaternion::from(sigma).transform_point(&point).coords.into(),
            wanted
        ));
        assert!(near(Matrix4::from(sigma).transform_point(&point).coords.into(), wanted));
        let turned = sigma.rotation().rotate(POINT);
        assert!(near(
            UnitQuaternion::from(sigma.rotation()).transform_point(&point).coords.into(),
            turned
        ));
        assert!(near(
            Rotation3::from(sigma.rotation()).transform_point(&point).coords.into(),
            turned
        ));
        assert!(close(Isometry3::from(sigma).into(), sigma));
        assert!(close(UnitDualQuaternion::from(sigma).into(), sigma));
        assert!(close(DualQuaternion::from(sigma).into(), sigma));
        assert!(close(Matrix4::from(sigma).try_into().unwrap(), sigma));
        assert!(DualQuat::try_from(Matrix4::<f64>::new_scaling(2.0)).is_err());
        let unit = UnitQuaternion::from(sigma.rotation());
        assert_eq!(Quat::from(unit), sigma.rotation());
        assert_eq!(Quat::from(Quaternion::from(sigma.rotation())), sigma.rotation());
    }

    #[test]
    fn slices_of_nalgebra_are_cast_where_they_lie() {
        let sigmas = [motion(), motion() * motion()];
        let theirs = nalgebra_035::dual_quaternions(&sigmas);
        assert_eq!(theirs[1], DualQuaternion::from(sigmas[1]));
        assert_eq!(nalgebra_035::motions(theirs), sigmas);
        let quats = sigmas.map(|s| s.rotation());
        let theirs = nalgebra_035::quaternions(&quats);
        assert_eq!(theirs[1].w, quats[1].w());
        assert_eq!(nalgebra_035::quats(theirs), quats);
    }
}

#[cfg(feature = "mint_05")]
#[test]
fn mint_has_rows_as_rows_and_columns_as_columns() {
    use mint::{ColumnMatrix3, ColumnMatrix4, Quaternion, RowMatrix3, RowMatrix3x4, RowMatrix4};
    let sigma = motion();
    let theirs = Quaternion::from(sigma.rotation());
    assert_eq!((theirs.s, theirs.v.x), (sigma.rotation().w(), sigma.rotation().x()));
    assert_eq!(Quat::from(theirs), sigma.rotation());
    let (columns, rows) = (ColumnMatrix4::from(sigma), RowMatrix4::from(sigma));
    assert!(near([columns.w.x, columns.w.y, columns.w.z], sigma.translation()));
    assert!(near([rows.x.w, rows.y.w, rows.z.w], sigma.translation()));
    assert_eq!(RowMatrix3x4::from(sigma).x.w, rows.x.w);
    assert!(close(columns.try_into().unwrap(), sigma) && close(rows.try_into().unwrap(), sigma));
    let (columns, rows) =
        (ColumnMatrix3::from(sigma.rotation()), RowMatrix3::from(sigma.rotation()));
    assert_eq!((columns.x.y, columns.z.x), (rows.y.x, rows.x.z));
    assert_eq!(rows.x.y, sigma.to_matrix3x4()[0][1]);
}

#[cfg(feature = "serde")]
#[test]
fn serde_writes_arrays_and_names_and_reads_them_back() {
    fn there_and_back<T>(thing: &T, text: &str)
    where
        T: serde::Serialize + serde::de::DeserializeOwned + PartialEq + std::fmt::Debug,
    {
        let written = serde_json::to_string(thing).unwrap();
        assert!(text.is_empty() || written == text, "{written}");
        assert_eq!(&serde_json::from_str::<T>(&written).unwrap(), thing);
    }
    there_and_back(&Quat::from_xyzw(1.0_f32, 2.0, 3.0, 4.5), "[1.0,2.0,3.0,4.5]");
    there_and_back(&motion(), "");
    there_and_back(&motion().cast::<f32>(), "");
    there_and_back(&dq8::Dual::new(1.0, 2.0), r#"{"real":1.0,"dual":2.0}"#);
    there_and_back(&motion().log(), "");
    there_and_back(&motion().to_screw(), "");
    there_and_back(&motion().to_screw().axis, "");
    there_and_back(&RotationTranslation::from(motion()), "");
    there_and_back(&dq8::representation::Affine::from_motion(motion()), "");
    let twist = Twist { angular: [1.0, 2.0, 3.0], linear: [4.0, 5.0, 6.0] };
    there_and_back(&twist, r#"{"angular":[1.0,2.0,3.0],"linear":[4.0,5.0,6.0]}"#);
    there_and_back(&dq8::geometry::Wrench { force: [1.0; 3], torque: [2.0; 3] }, "");
    there_and_back(&dq8::Plane { normal: [1.0, 0.0, 0.0], offset: 2.0 }, "");
    assert!(serde_json::from_str::<Quat<f32>>("[1, 2, 3]").is_err());
}

#[cfg(feature = "rkyv_08")]
#[test]
fn rkyv_archives_what_is_plain() {
    fn archived<T: rkyv::Archive>() -> usize {
        size_of::<T::Archived>()
    }
    assert_eq!(archived::<Quat<f32>>(), 16);
    assert_eq!(archived::<DualQuat<f64>>(), 64);
    assert_eq!(archived::<Twist<f32>>(), 24);
    assert_eq!(archived::<RotationTranslation<f32>>(), 28);
}

#[cfg(feature = "approx_05")]
#[test]
fn approx_compares_component_by_component() {
    use approx::{
        assert_abs_diff_eq, assert_abs_diff_ne, assert_relative_eq, assert_ulps_eq, relative_eq,
    };
    let sigma = motion();
    for component in 0..8 {
        let mut other = sigma;
        other[component] += 1e-6;
        assert_abs_diff_ne!(sigma, other, epsilon = 1e-7);
        assert_abs_diff_eq!(sigma, other, epsilon = 1e-5);
        assert!(!relative_eq!(sigma, other));
        assert_relative_eq!(sigma, other, epsilon = 1e-5);
        assert_ulps_eq!(sigma, other, epsilon = 1e-5);
    }
    assert_abs_diff_eq!(sigma.rotation(), sigma.rotation());
    assert_abs_diff_eq!(sigma.to_twist(), sigma.to_twist());
    assert_abs_diff_ne!(sigma, -sigma);
}

#[cfg(feature = "arbitrary")]
#[test]
fn arbitrary_makes_any_bits() {
    use arbitrary::{Arbitrary, Unstructured};
    let bytes: Vec<u8> = (0..64).collect();
    let sigma = DualQuat::<f32>::arbitrary(&mut Unstructured::new(&bytes)).unwrap();
    let wanted: Vec<_> =
        bytes.chunks(4).take(8).map(|b| f32::from_le_bytes(b.try_into().unwrap())).collect();
    assert_eq!(sigma.to_array()[..], wanted);
    assert!(Quat::<f64>::arbitrary(&mut Unstructured::new(&[0xff; 32])).unwrap().w().is_nan());
}

#[cfg(feature = "proptest")]
#[test]
fn strategies_make_unit_motions_with_half_turns_among_them() {
    use proptest::strategy::{Strategy, ValueTree};
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    let strategy = dq8::interop::proptest::motions::<f32>(100.0);
    let (mut half_turns, mut far) = (0, 0.0_f32);
    for _ in 0..1000 {
        let sigma = strategy.new_tree(&mut runner).unwrap().current();
        assert!(sigma.is_normalized(), "{sigma}");
        half_turns += usize::from(sigma.rotation().w() == 0.0);
        far = sigma.translation().into_iter().fold(far, |far, c| far.max(c.abs()));
    }
    assert!((50..250).contains(&half_turns) && (90.0..100.1).contains(&far), "{half_turns} {far}");
}

#[cfg(feature = "rand_010")]
#[test]
fn random_rotations_are_uniform() {
    use rand::{RngExt, SeedableRng};
    let mut rng = rand::rngs::SmallRng::seed_from_u64(1);
    // The mean of |w| of a uniform unit quaternion is 4/(3π), and a turned axis points anywhere.
    let (mut sum, mut where_to, count) = (0.0, [0.0; 3], 100_000);
    for _ in 0..count {
        let rotation: Quat<f64> = rng.random();
        assert!(rotation.is_normalized());
        sum += rotation.w().abs();
        let turned = rotation.rotate([1.0, 0.0, 0.0]);
        where_to = [0, 1, 2].map(|i| where_to[i] + turned[i]);
    }
    let count = f64::from(count);
    assert!((sum / count - 4.0 / (3.0 * std::f64::consts::PI)).abs() < 3e-3);
    assert!(where_to.iter().all(|c| (c / count).abs() < 8e-3), "{where_to:?}");
    let pose: DualQuat<f32> = rng.random();
    assert!(pose.is_normalized() && pose.translation().iter().all(|c| c.abs() <= 1.000001));
}

#[cfg(feature = "defmt")]
#[test]
fn defmt_formats_what_is_plain() {
    // Writing needs a logger of the board: that the types have the trait is what a host can tell.
    fn formats<T: defmt::Format>() {}
    formats::<Quat<f32>>();
    formats::<DualQuat<f64>>();
    formats::<RotationTranslation<f32>>();
    formats::<Twist<f32>>();
    // What a controller logs when something fails.
    formats::<(
        dq8::ik::LimbError,
        dq8::hierarchy::HierarchyError,
        dq8::ShapeError,
        dq8::skinning::SkinningError,
    )>();
    formats::<(dq8::scalar::NormalizeError, dq8::scalar::InverseError, dq8::scalar::MatrixError)>();
    formats::<(dq8::incidence::IncidenceError, dq8::representation::OrthonormalError)>();
    formats::<dq8::text::ParseError>();
}

/// Whatever is called an error, those that come later too.
#[test]
fn every_error_is_logged_by_defmt() {
    // What users get has no robots.
    let folders = ["src", "robot/src/mechanism", "robot/src/ik"].map(std::path::PathBuf::from);
    let (mut folders, mut errors) = (Vec::from(folders), 0);
    folders.retain(|folder| folder.exists());
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).expect("a folder of sources") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            let text = std::fs::read_to_string(&path).expect("text");
            let lines: Vec<&str> = text.lines().collect();
            for (index, line) in lines.iter().enumerate() {
                let attributes = lines[..index].iter().rev().map(|line| line.trim_start());
                let above: Vec<_> = attributes.take_while(|line| line.starts_with("#[")).collect();
                // Or in a list of errors: then its attributes are above it, and no keyword.
                let listed = line.strip_prefix("    ").filter(|_| !above.is_empty());
                let name = line.strip_prefix("pub enum ").or(line.strip_prefix("pub struct "));
                let name = name.or(listed).and_then(|rest| rest.split([' ', '<']).next());
                let Some(name) = name.filter(|name| name.ends_with("Error")) else { continue };
                let logged = above.into_iter().any(|line| line.contains("derive(defmt::Format)"));
                assert!(logged, "{name} in {}", path.display());
                errors += 1;
            }
        }
    }
    // Without those of robots there are fewer.
    let robots = std::path::Path::new("robot/src").exists();
    assert!(errors >= if robots { 17 } else { 11 }, "{errors}");
}
