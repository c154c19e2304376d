//! What is wrong is said by the vertex, and nothing is written.

use dq8::DualQuat;
use dq8::skinning::{DualBlend, Linear, Mixed, Skin, SkinningError, Surface, SurfaceMut};

#[test]
fn a_bad_skin_names_the_vertex() {
    let good = [0.5_f32, 0.5, 1.0, 0.0];
    let new = |joints: &[u8], weights: &[f32]| Skin::new(3, 2, joints, weights).map(|_| ());
    assert_eq!(new(&[0, 1, 2, 2], &good), Ok(()));
    assert_eq!(
        new(&[0, 1, 3, 2], &good),
        Err(SkinningError::JointOutOfRange { vertex: 1, influence: 0, joint: 3, joints: 3 })
    );
    for (bad, vertex, influence) in [(f32::INFINITY, 0, 1), (-0.25, 1, 0)] {
        let mut weights = good;
        weights[2 * vertex + influence] = bad;
        let value = bad.into();
        assert_eq!(new(&[0; 4], &weights), Err(SkinningError::Weight { vertex, influence, value }));
    }
    let nan = new(&[0; 4], &[0.5, 0.5, f32::NAN, 1.0]).unwrap_err();
    assert!(matches!(nan, SkinningError::Weight { vertex: 1, influence: 0, .. }), "{nan}");
    for total in [0.0, 2048.0] {
        let error = new(&[0; 4], &[0.5, 0.5, total as f32, 0.0]);
        assert_eq!(error, Err(SkinningError::Total { vertex: 1, total }));
    }
    assert!(matches!(new(&[0; 3], &good[..3]), Err(SkinningError::Shape(_))));
    assert!(matches!(new(&[0; 4], &good[..3]), Err(SkinningError::Shape(_))));
    assert_eq!(
        Skin::new(3, 0, &[0_u8; 0], &good[..0]).map(|_| ()),
        Err(SkinningError::NoInfluences)
    );
    let implied =
        |weights: &[f32]| Skin::with_implied_weight(3, 2, &[0_u8; 4], weights).map(|_| ());
    assert_eq!(implied(&[0.5, 1.0]), Ok(()));
    assert_eq!(implied(&[0.5, 1.5]), Err(SkinningError::Total { vertex: 1, total: 1.5 }));
    assert!(matches!(implied(&good), Err(SkinningError::Shape(_))));
}

#[test]
fn a_run_that_does_not_fit_writes_nothing() {
    let (joints, weights) = ([0_u32, 1, 1], [1.0_f32; 3]);
    let skin = Skin::new(2, 1, &joints, &weights).unwrap();
    let motions = [DualQuat::<f32>::from_translation([1.0; 3]); 3];
    let matrices = motions.map(|motion| motion.to_matrix3x4());
    let (rest, untouched) = ([[0.0; 3]; 3], [[7.0_f32; 3]; 3]);
    let mut posed = untouched;
    let mut normals = untouched;
    let from = Surface::positions(&rest);
    let complaints = [
        // A palette of three for a skin of two.
        skin.pose(DualBlend::new(&motions), from, SurfaceMut::positions(&mut posed)),
        skin.pose(Linear::new(&matrices), from, SurfaceMut::positions(&mut posed)),
        skin.pose(DualBlend::new(&motions[..1]), from, SurfaceMut::positions(&mut posed)),
        skin.pose(DualBlend::new(&motions[..2]), from, SurfaceMut::positions(&mut posed[..2])),
        skin.pose(
            DualBlend::new(&motions[..2]),
            Surface::positions(&rest[..2]),
            SurfaceMut::positions(&mut posed[..2]),
        ),
        skin.pose(
            DualBlend::new(&motions[..2]),
            from,
            SurfaceMut::positions(&mut posed).normals(&mut normals),
        ),
        skin.pose(
            Mixed::new(Linear::new(&matrices[..2]), DualBlend::new(&motions[..2]), &[0.5; 2])
                .unwrap(),
            from,
            SurfaceMut::positions(&mut posed),
        ),
    ];
    for (i, complaint) in complaints.into_iter().enumerate() {
        assert!(matches!(complaint, Err(SkinningError::Shape(_))), "{i}: {complaint:?}");
    }
    assert_eq!((posed, normals), (untouched, untouched));
    // A skin may be of more joints than any palette has, and than 32 bits can number sixteen times.
    let joints = [u32::MAX - 1];
    let skin = Skin::new(usize::MAX, 1, &joints, &weights[..1]).unwrap();
    let to = SurfaceMut::positions(&mut posed[..1]);
    let error = skin.pose(DualBlend::new(&motions), Surface::positions(&rest[..1]), to);
    assert!(matches!(error, Err(SkinningError::Shape(_))), "{error:?}");
    assert_eq!(posed, untouched);
    let shares = [0.5_f32, 1.5, 0.0];
    let error = Mixed::new(Linear::new(&matrices), DualBlend::new(&motions), &shares).unwrap_err();
    assert_eq!(error, SkinningError::Share { vertex: 1, value: 1.5 });
}
