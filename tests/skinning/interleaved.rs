//! Vertices that are records of several fields move as those whose fields lie apart, and nothing
//! else is written.

use crate::scene::{Scene, from};
use dq8::skinning::{
    DualBlend, Linear, Mixed, SkinningError, StretchedDualBlend, Surface, SurfaceMut, VertexFields,
    Weight,
};
use dq8::{Backend, Scalar};

/// A buffer of `stride` numbers per vertex, all `around`, but for the fields.
fn buffer<R: Scalar>(fields: VertexFields, around: R, scene: &Scene<R>) -> Vec<R> {
    let mut numbers = vec![around; fields.stride * scene.positions.len()];
    let of = [(Some(fields.position), &scene.positions), (fields.normal, &scene.normals)];
    for (at, vectors) in of.into_iter().chain([(fields.tangent, &scene.positions)]) {
        let Some(at) = at else { continue };
        for (vertex, vector) in vectors.iter().enumerate() {
            numbers[vertex * fields.stride + at..][..3].copy_from_slice(vector);
        }
    }
    numbers
}

fn agrees<R: Scalar + Weight>(vertices: usize, influences: usize) {
    let scene = Scene::<R>::new(vertices, influences);
    let (skin, matrices) = (scene.skin(), scene.matrices());
    let shares: Vec<R> = scene.positions.iter().map(|p| p[0] * p[0]).collect();
    let (linear, dual) = (Linear::new(&matrices), DualBlend::new(&scene.motions));
    let stretched = StretchedDualBlend::new(&scene.motions, &scene.stretches);
    let mixed = Mixed::new(linear, dual, &shares).unwrap();
    // The last field at the very end, one number less than four behind it; and nothing but a
    // position.
    let rest_fields = VertexFields { stride: 11, position: 8, normal: Some(1), tangent: Some(4) };
    let posed_fields = VertexFields { stride: 9, position: 0, normal: Some(6), tangent: Some(3) };
    let rest = buffer(rest_fields, from(f64::NAN), &scene);
    for backend in Backend::available() {
        macro_rules! same {
            ($blend:expr) => {
                let mut posed = [(); 3].map(|()| scene.positions.clone());
                let [p, n, t] = &mut posed;
                let surface = Surface::positions(&scene.positions).normals(&scene.normals);
                let to = SurfaceMut::positions(p).normals(n).tangents(t);
                skin.job()
                    .backend(backend)
                    .pose($blend, surface.tangents(&scene.positions), to)
                    .unwrap();
                let [positions, normals, tangents] = posed;
                let around: R = from(9.0);
                let mut got = vec![around; 9 * vertices];
                let to = (&mut got[..], posed_fields);
                skin.job()
                    .backend(backend)
                    .pose_interleaved($blend, (&rest, rest_fields), to)
                    .unwrap();
                let wanted: Vec<R> = (0..vertices)
                    .flat_map(|i| [positions[i], tangents[i], normals[i]])
                    .flatten()
                    .collect();
                assert_eq!(got, wanted, "{backend} {vertices} {influences}");
                // Positions alone: all other numbers stay.
                let fields = VertexFields { normal: None, tangent: None, ..posed_fields };
                let only = VertexFields { normal: None, tangent: None, ..rest_fields };
                let mut got = vec![around; 9 * vertices];
                let to = (&mut got[..], fields);
                skin.job().backend(backend).pose_interleaved($blend, (&rest, only), to).unwrap();
                for (vertex, got) in got.as_chunks::<9>().0.iter().enumerate() {
                    assert_eq!((&got[..3], &got[3..]), (&positions[vertex][..], &[around; 6][..]));
                }
            };
        }
        same!(linear);
        same!(dual);
        same!(stretched);
        same!(mixed);
    }
}

#[test]
fn vertices_with_fields_move_as_vertices_apart() {
    for (vertices, influences) in [(0, 4), (1, 4), (7, 3), (16, 4), (33, 4), (50, 9)] {
        agrees::<f32>(vertices, influences);
        agrees::<f64>(vertices, influences);
    }
}

#[test]
fn fields_that_do_not_fit_are_named_and_nothing_is_written() {
    let scene = Scene::<f32>::new(6, 4);
    let (skin, dual) = (scene.skin(), DualBlend::new(&scene.motions));
    let good = VertexFields { stride: 10, position: 0, normal: Some(3), tangent: Some(7) };
    let rest = buffer(good, 0.0, &scene);
    let run = |from: VertexFields, to: VertexFields, rest: &[f32], numbers: usize| {
        let mut posed = vec![7.0; 60];
        let to = (&mut posed[..numbers], to);
        let result = skin.job().pose_interleaved(dual, (rest, from), to);
        assert!(result.is_ok() || posed.iter().all(|&number| number == 7.0), "written: {result:?}");
        result
    };
    assert_eq!(run(good, good, &rest, 60), Ok(()));
    for (bad, first) in [
        (VertexFields { position: 8, ..good }, 8),
        (VertexFields { normal: Some(2), ..good }, 2),
        (VertexFields { tangent: Some(usize::MAX), ..good }, usize::MAX),
        (VertexFields { tangent: Some(5), ..good }, 5),
        (VertexFields { stride: 2, ..good }, 0),
        (VertexFields { stride: 0, ..good }, 0),
    ] {
        let error = |what| Err(SkinningError::Field { what, first, stride: bad.stride });
        assert_eq!(run(bad, good, &rest, 60), error("rest"));
        assert_eq!(run(good, bad, &rest, 60), error("posed"));
    }
    let shape = |result| assert!(matches!(result, Err(SkinningError::Shape(_))), "{result:?}");
    shape(run(good, good, &rest[1..], 60));
    shape(run(good, good, &rest, 50));
    shape(run(good, VertexFields { normal: None, ..good }, &rest, 60));
    shape(run(VertexFields { tangent: None, ..good }, good, &rest, 60));
}

#[cfg(feature = "rayon")]
#[test]
fn all_cores_give_every_bit_that_one_gives_to_vertices_with_fields() {
    let vertices = 10_001;
    let scene = Scene::<f32>::new(vertices, 3);
    let fields = VertexFields { stride: 7, position: 4, normal: Some(0), tangent: None };
    let rest = buffer(fields, 5.0, &scene);
    let posed_fields = VertexFields { stride: 8, position: 1, normal: Some(5), tangent: None };
    let shares: Vec<f32> = scene.positions.iter().map(|p| p[0] * p[0]).collect();
    let matrices = scene.matrices();
    // Its shares belong to vertices, so a task must know which are its own.
    let blend =
        Mixed::new(Linear::new(&matrices), DualBlend::new(&scene.motions), &shares).unwrap();
    let mut posed = [(); 2].map(|()| vec![9.0_f32; 8 * vertices]);
    let [one, all] = &mut posed;
    let skin = scene.skin();
    skin.job().pose_interleaved(blend, (&rest, fields), (one, posed_fields)).unwrap();
    skin.job()
        .threads(usize::MAX)
        .pose_interleaved(blend, (&rest, fields), (all, posed_fields))
        .unwrap();
    assert!(one == all);
    // Nothing at all, in vertices of more numbers than there are.
    let vast = VertexFields::positions(1 << 60);
    let nobody = dq8::skinning::Skin::new(1, 1, &[0_u16; 0], &[0.0_f32; 0]).unwrap();
    let rigid = DualBlend::new(&scene.motions[..1]);
    nobody.job().threads(usize::MAX).pose_interleaved(rigid, (&[], vast), (&mut [], vast)).unwrap();
    let before = all.clone();
    let few = &mut all[8..];
    assert!(
        skin.job()
            .threads(usize::MAX)
            .pose_interleaved(blend, (&rest, fields), (few, posed_fields))
            .is_err()
    );
    assert!(posed[1] == before);
}
