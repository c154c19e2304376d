//! The table of faults: what is given, to which function, and what it promises to answer.

use dq8::hierarchy::{HierarchyError, PackedError};
use dq8::slices::MatricesError;
use dq8::{DualQuat, Hierarchy, Quat, ShapeError, Skeleton};
use dq8::{scalar::MatrixError, skinning::SkinningError};

/// A product with the inverse, in `f32` on its own scale.
const IN_SINGLE: f32 = 1e-6;
/// Between what is unit here, to a few units of the last place, and what is a thousandth away from
/// it.
const NEARLY: f32 = 1e-5;

/// What somebody may give who has made a mistake.
#[derive(Clone, Copy, Debug)]
struct Class {
    name: &'static str,
    motion: DualQuat<f32>,
    /// Whether p/|p| exists and every component is finite.
    normalizes: bool,
    /// Whether 1/σ is finite as well.
    inverts: bool,
    unit: bool,
}

fn rigid() -> DualQuat<f32> {
    let turn = Quat::from_axis_angle([0.36, 0.48, 0.8], 0.7);
    DualQuat::from_rotation_translation(turn, [1.0, -2.0, 3.0])
}

fn with(component: usize, value: f32) -> DualQuat<f32> {
    let mut motion = rigid();
    motion[component] = value;
    motion
}

fn classes() -> Vec<Class> {
    let class =
        |name, motion, normalizes, inverts, unit| Class { name, motion, normalizes, inverts, unit };
    let mut all = vec![
        class("a motion", rigid(), true, true, true),
        class("its negative", -rigid(), true, true, true),
        class("twice a motion", rigid() * 2.0, true, true, false),
        class("a real number", DualQuat::IDENTITY * -3.0, true, true, false),
        class("as large as can be normalized", rigid() * 1e37, true, true, false),
        class("subnormal", rigid() * 1e-40, true, false, false),
        class(
            "not orthogonal",
            rigid() + DualQuat::new(Quat::ZERO, rigid().real()),
            true,
            true,
            false,
        ),
        class("zero", DualQuat::ZERO, false, false, false),
        class("no real part", DualQuat::new(Quat::ZERO, rigid().dual()), false, false, false),
    ];
    for component in 0..8 {
        for value in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            all.push(class(
                "a component that is not finite",
                with(component, value),
                false,
                false,
                false,
            ));
        }
    }
    all
}

fn all_nan(motion: DualQuat<f32>) -> bool {
    motion.to_array().iter().all(|c| c.is_nan())
}

#[test]
fn checked_functions_refuse_what_the_unchecked_ones_answer_with_nan() {
    for Class { name, motion, normalizes, inverts, unit } in classes() {
        let checked = motion.try_normalize();
        assert_eq!(checked.is_ok(), normalizes, "{name}: {checked:?}");
        let result = motion.normalize();
        assert!(
            if normalizes { result.is_normalized() } else { all_nan(result) },
            "{name}: {result}"
        );
        let checked = motion.try_inverse();
        assert_eq!(checked.is_ok(), inverts, "{name}: {checked:?}");
        let result = motion.inverse();
        let near = (motion * result).abs_diff_eq(DualQuat::IDENTITY, IN_SINGLE);
        assert!(if inverts { near } else { all_nan(result) }, "{name}: {result}");
        assert_eq!((motion.is_unit(NEARLY), motion.is_normalized()), (unit, unit), "{name}");
        assert_eq!(motion.needs_renormalization(NEARLY), !unit, "{name}");
        let finite = motion.to_array().iter().all(|c| c.is_finite());
        assert_eq!(motion.is_finite(), finite, "{name}");
        let rotation = motion.real();
        let norm = rotation.norm();
        let normalizes = rotation.is_finite() && norm > 0.0;
        assert_eq!(rotation.try_normalize().is_ok(), normalizes, "{name}");
        assert_eq!(rotation.normalize().is_normalized(), normalizes, "{name}");
        assert!(normalizes || rotation.normalize().to_array().iter().all(|c| c.is_nan()), "{name}");
        assert!(normalizes || rotation.inverse().to_array().iter().all(|c| c.is_nan()), "{name}");
    }
}

#[test]
fn matrices_are_refused_by_what_is_wrong_with_them() {
    let rigid = rigid().to_matrix4();
    let edited = |row: usize, column: usize, value: f32| {
        let mut rows = rigid;
        rows[row][column] = value;
        DualQuat::try_from_matrix4(rows, 1e-4)
    };
    assert!(DualQuat::try_from_matrix4(rigid, 1e-4).is_ok());
    for bad in [f32::NAN, f32::INFINITY, 1e30, 5.0] {
        for row in 0..3 {
            for column in 0..3 {
                let error = edited(row, column, bad).unwrap_err();
                assert!(matches!(error, MatrixError::NotOrthonormal { .. }), "{bad}: {error}");
            }
            assert_eq!(bad.is_finite(), edited(row, 3, bad).is_ok());
        }
        for column in 0..4 {
            assert!(
                matches!(edited(3, column, bad), Err(MatrixError::NotAffine { column: c, .. }) if c == column)
            );
        }
    }
    let mirrored = rigid.map(|[x, y, z, t]| [-x, y, z, t]);
    let mirrored = [mirrored[0], mirrored[1], mirrored[2], rigid[3]];
    assert!(matches!(DualQuat::try_from_matrix4(mirrored, 1e-4), Err(MatrixError::Mirrors { .. })));
    let zero = Quat::try_from_matrix3([[0.0_f32; 3]; 3], 1e-4).unwrap_err();
    assert_eq!(zero, MatrixError::NotOrthonormal { row: 0, column: 0, value: 0.0 });
}

#[test]
fn parents_are_refused_by_what_is_wrong_with_them_whoever_asks() {
    let root = Hierarchy::ROOT;
    let (before, beyond) = (
        HierarchyError::ParentNotBefore { joint: 0, parent: 1 },
        HierarchyError::ParentOutOfRange { joint: 1, parent: 9, joints: 2 },
    );
    let own = HierarchyError::ParentNotBefore { joint: 0, parent: 0 };
    type Answer = Result<(), HierarchyError>;
    let table: [(&[u32], Answer, Answer); 6] = [
        (&[], Ok(()), Ok(())),
        (&[root, 0], Ok(()), Ok(())),
        (&[1, root], Err(before), Ok(())),
        (&[root, 9], Err(beyond), Err(beyond)),
        (&[0], Err(own), Err(HierarchyError::Cycle { joint: 0 })),
        (&[1, 0], Err(before), Err(HierarchyError::Cycle { joint: 0 })),
    ];
    for (parents, in_order, in_any_order) in table {
        assert_eq!(Hierarchy::new(parents).map(|_| ()), in_order);
        assert_eq!(Skeleton::new(parents).map(|_| ()), in_order);
        assert_eq!(Skeleton::sorted(parents).map(|_| ()), in_any_order);
    }
}

#[test]
fn errors_that_pass_on_another_have_it_as_their_source() {
    fn passes<E: std::error::Error + From<ShapeError>>() {
        let cause = ShapeError::Empty { what: "keys" };
        let error = E::from(cause.clone());
        assert_eq!(error.source().and_then(|it| it.downcast_ref()), Some(&cause), "{error:?}");
    }
    passes::<PackedError>();
    passes::<MatricesError>();
    passes::<SkinningError>();
    let own = HierarchyError::ParentNotBefore { joint: 1, parent: 2 };
    assert!(std::error::Error::source(&own).is_none());
}
