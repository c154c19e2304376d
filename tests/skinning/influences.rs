//! Influences that lie between other fields are those that lie one after the other, and nothing
//! else is read.

use crate::scene::{JOINTS, Scene, from};
use dq8::skinning::{
    DualBlend, InfluenceField, Linear, Skin, SkinningError, Surface, SurfaceMut, VertexFields,
    Weight,
};
use dq8::{Backend, Scalar};

/// A buffer of `around` everywhere but in the field.
fn buffer<T: Copy>(field: InfluenceField, each: usize, around: T, of: &[T]) -> Vec<T> {
    let mut buffer = vec![around; of.len() / each * field.stride];
    for (vertex, own) in buffer.chunks_exact_mut(field.stride).zip(of.chunks_exact(each)) {
        vertex[field.first..][..each].copy_from_slice(own);
    }
    buffer
}

fn agrees<R: Scalar + Weight>(vertices: usize, influences: usize) {
    let scene = Scene::<R>::new(vertices, influences);
    let (packed, matrices) = (scene.skin(), scene.matrices());
    let field = |more: usize, first: usize| InfluenceField { stride: influences + more, first };
    // In the middle and at the end of a vertex; rows of four indices of which one is none; without
    // anything between.
    for (at, of) in
        [(field(5, 2), field(2, 2)), (field(1, 0), field(1, 0)), (field(0, 0), field(0, 0))]
    {
        let joints = buffer(at, influences, u16::MAX, &scene.joints);
        let weights = buffer(of, influences, from(f64::NAN), &scene.weights);
        let skin =
            Skin::interleaved(JOINTS, influences, (&joints[..], at), (&weights[..], of)).unwrap();
        assert_eq!((skin.vertices(), skin.joint_count()), (vertices, JOINTS));
        for (vertex, influence) in
            [(0, 0), (vertices / 2, influences - 1), (0, influences), (vertices, 0)]
        {
            let [got, wanted] = [skin, packed].map(|skin| skin.influence::<R>(vertex, influence));
            assert_eq!(got, wanted, "{vertex} {influence}");
        }
        for backend in Backend::available() {
            macro_rules! same {
                ($blend:expr) => {
                    let [got, wanted] = [skin, packed].map(|skin| {
                        let mut posed = scene.positions.clone();
                        let to = SurfaceMut::positions(&mut posed);
                        skin.job()
                            .backend(backend)
                            .pose($blend, Surface::positions(&scene.positions), to)
                            .unwrap();
                        posed
                    });
                    assert_eq!(got, wanted, "{backend} {vertices} {influences} {at:?} {of:?}");
                };
            }
            same!(Linear::new(&matrices));
            same!(DualBlend::new(&scene.motions));
        }
    }
}

#[test]
fn influences_between_other_fields_move_as_those_in_order() {
    for (vertices, influences) in [(0, 4), (1, 4), (16, 3), (33, 4), (50, 4), (20, 1), (21, 9)] {
        agrees::<f32>(vertices, influences);
        agrees::<f64>(vertices, influences);
    }
}

#[test]
fn one_buffer_holds_positions_joints_and_weights() {
    let scene = Scene::<f32>::new(37, 4);
    let joints: Vec<u8> = scene.joints.iter().map(|&joint| joint as u8).collect();
    let weights: Vec<u8> =
        scene.weights.iter().map(|weight| (weight * 255.0).round() as u8).collect();
    let packed = Skin::new(JOINTS, 4, &joints, &weights).unwrap();
    let mut rest = Vec::<f32>::new();
    for (vertex, position) in scene.positions.iter().enumerate() {
        let [joints, weights] = [&joints, &weights].map(|of| of.as_chunks().0[vertex]);
        rest.extend(position.iter().copied().chain([joints, weights].map(f32::from_ne_bytes)));
    }
    let bytes: &[u8] = bytemuck::cast_slice(&rest);
    let [at, of] = [12, 16].map(|first| (bytes, InfluenceField { stride: 20, first }));
    let skin = Skin::<u8, u8>::interleaved(JOINTS, 4, at, of).unwrap();
    let (dual, fields) = (DualBlend::new(&scene.motions), VertexFields::positions(5));
    for backend in Backend::available() {
        let mut wanted = scene.positions.clone();
        let to = SurfaceMut::positions(&mut wanted);
        packed.job().backend(backend).pose(dual, Surface::positions(&scene.positions), to).unwrap();
        let mut posed = rest.clone();
        skin.job()
            .backend(backend)
            .pose_interleaved(dual, (&rest, fields), (&mut posed, fields))
            .unwrap();
        let bits = |number: &f32| number.to_bits();
        for ((posed, rest), wanted) in
            posed.as_chunks::<5>().0.iter().zip(rest.as_chunks::<5>().0).zip(&wanted)
        {
            assert_eq!(posed[..3], wanted[..], "{backend}");
            assert!(posed[3..].iter().map(bits).eq(rest[3..].iter().map(bits)), "{backend}");
        }
    }
}

#[test]
fn influences_that_do_not_lie_in_a_vertex_are_refused() {
    let (joints, weights) = ([0_u16, 9, 1, 0, 9, 2], [0.5_f32, 0.5, 9.0, 1.0, 0.0, 9.0]);
    let new = |joints: &[u16], at, weights: &[f32], of| {
        Skin::interleaved(3, 2, (joints, at), (weights, of)).map(|_| ())
    };
    let field = |stride, first| InfluenceField { stride, first };
    let one = |stride, first| {
        Skin::interleaved(3, 1, (&joints, field(stride, first)), (&weights, field(3, 0)))
    };
    // Joints 0 1 | 0 2 with a 9 between: only one influence of each can be read, at 0 or at 2.
    assert_eq!(one(3, 0).map(|skin| skin.vertices()), Ok(2));
    assert_eq!(
        one(3, 1).unwrap_err(),
        SkinningError::JointOutOfRange { vertex: 0, influence: 0, joint: 9, joints: 3 }
    );
    assert_eq!(
        new(&[0, 1, 9, 0, 3, 9], field(3, 0), &weights, field(3, 0)),
        Err(SkinningError::JointOutOfRange { vertex: 1, influence: 1, joint: 3, joints: 3 })
    );
    let good = [0, 1, 9, 0, 2, 9];
    assert_eq!(new(&good, field(3, 0), &weights, field(3, 0)), Ok(()));
    let bad = [0.5, 0.5, 9.0, 1.0, -1.0, 9.0];
    assert_eq!(
        new(&good, field(3, 0), &bad, field(3, 0)),
        Err(SkinningError::Weight { vertex: 1, influence: 1, value: -1.0 })
    );
    for (stride, first) in [(3, 2), (3, usize::MAX), (1, 0), (0, 0)] {
        let error =
            |what| Err(SkinningError::InfluenceField { what, first, stride, influences: 2 });
        assert_eq!(new(&good, field(stride, first), &weights, field(3, 0)), error("joints"));
        assert_eq!(new(&good, field(3, 0), &weights, field(stride, first)), error("weights"));
    }
    let shape = |result| assert!(matches!(result, Err(SkinningError::Shape(_))), "{result:?}");
    shape(new(&good[..5], field(3, 0), &weights, field(3, 0)));
    shape(new(&good, field(3, 0), &weights[..5], field(3, 0)));
    shape(new(&good, field(3, 0), &weights[..3], field(3, 0)));
    shape(new(&good, field(3, 0), &weights, field(6, 0)));
    let none = Skin::interleaved(3, 0, (&good, field(3, 0)), (&weights, field(3, 0)));
    assert_eq!(none.unwrap_err(), SkinningError::NoInfluences);
}
