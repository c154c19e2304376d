//! Every backend, layout and type against the reference, one vertex at a time.

use super::scene::{JOINTS, Scene, distance, posed};
use dq8::skinning::{
    DualBlend, Index, Linear, Mixed, Skin, StretchedDualBlend, Surface, SurfaceMut, Weight,
    dual_blend, linear_blend,
};
use dq8::{Backend, DualQuat, Element, Scalar, representation::Affine, storage::Block};

/// One vertex, as the papers have it: positions, then normals and tangents of length 1.
fn expected<R: Scalar + Weight>(scene: &Scene<R>, vertex: usize, blend: &str) -> [[R; 3]; 3] {
    let skin = scene.skin();
    let influences = || (0..scene.influences).map(|i| skin.influence::<R>(vertex, i).unwrap());
    let matrices = scene.matrices();
    let of = |table: &[[[R; 4]; 3]]| {
        let some: Vec<_> = influences().map(|(joint, w)| (table[joint as usize], w)).collect();
        Affine::from_matrix3x4(linear_blend(&some))
    };
    let some: Vec<_> = influences().map(|(j, w)| (scene.motions[j as usize], w)).collect();
    let rigid = Affine::from_motion(dual_blend(&some).unwrap());
    let (point, normal) = (scene.positions[vertex], scene.normals[vertex]);
    let through = |map: Affine<R>| {
        [
            map.transform_point(point),
            unit(cofactor(map.linear, normal)),
            unit(map.transform_vector(normal)),
        ]
    };
    match blend {
        "linear" => through(of(&matrices)),
        "dual" => through(rigid),
        "stretched" => through(rigid * of(&scene.stretches)),
        _ => {
            let (a, b) = (through(of(&matrices)), through(rigid));
            let share = share::<R>(vertex);
            let mix =
                |i: usize| core::array::from_fn(|c| (R::ONE - share) * a[i][c] + share * b[i][c]);
            [mix(0), unit(mix(1)), unit(mix(2))]
        }
    }
}

fn share<R: Scalar>(vertex: usize) -> R {
    super::scene::from((vertex % 5) as f64 / 4.0)
}

fn cofactor<R: Scalar>([x, y, z]: [[R; 3]; 3], n: [R; 3]) -> [R; 3] {
    let cross = |a: [R; 3], b: [R; 3]| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    [cross(y, z), cross(z, x), cross(x, y)].map(|r| r[0] * n[0] + r[1] * n[1] + r[2] * n[2])
}

fn unit<R: Scalar>(v: [R; 3]) -> [R; 3] {
    let length = (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
    v.map(|c| c / length)
}

/// The largest error of positions, normals and tangents, all of a size near 1.
fn error<R: Scalar + Weight, P: Element<3>>(
    scene: &Scene<R>,
    backend: Backend,
    blend: &str,
    pack: impl Fn(&[[R; 3]]) -> Vec<P>,
    get: impl Fn(&[P], usize) -> [R; 3],
) -> f64
where
    P::Layout: dq8::storage::Layout<Real = R>,
{
    let skin = scene.skin();
    let (positions, normals) = (pack(&scene.positions), pack(&scene.normals));
    let rest = Surface::positions(&positions).normals(&normals).tangents(&normals);
    let [mut a, mut b, mut c] = [positions.clone(), positions.clone(), positions.clone()];
    let posed = SurfaceMut::positions(&mut a).normals(&mut b).tangents(&mut c);
    let matrices = scene.matrices();
    let shares: Vec<R> = (0..scene.positions.len()).map(share).collect();
    let (linear, dual) = (Linear::new(&matrices), DualBlend::new(&scene.motions));
    match blend {
        "linear" => skin.job().backend(backend).pose(linear, rest, posed),
        "dual" => skin.job().backend(backend).pose(dual, rest, posed),
        "stretched" => {
            let stretched = StretchedDualBlend::new(&scene.motions, &scene.stretches);
            skin.job().backend(backend).pose(stretched, rest, posed)
        }
        _ => skin.job().backend(backend).pose(
            Mixed::new(linear, dual, &shares).unwrap(),
            rest,
            posed,
        ),
    }
    .unwrap();
    let mut worst = 0.0_f64;
    for vertex in 0..scene.positions.len() {
        let [p, n, t] = expected(scene, vertex, blend);
        for (wanted, got) in [(p, &a), (n, &b), (t, &c)] {
            worst = worst.max(distance(wanted, get(got, vertex)));
        }
    }
    worst
}

/// Directions are the worst conditioned: those of a linear blend are quotients by a length that
/// cancellation makes small. 2000 ε covers the shortest of these samples, 1/200.
fn all_agree<R: Scalar + Weight>(epsilon: f64) {
    for influences in [1, 2, 3, 4, 5, 8, 9] {
        for vertices in [0, 1, 7, 8, 9, 16, 33] {
            let scene = Scene::<R>::new(vertices, influences);
            for backend in Backend::available() {
                for blend in ["linear", "dual", "stretched", "mixed"] {
                    let worst = error(&scene, backend, blend, <[_]>::to_vec, |slice, i| slice[i]);
                    let what = format!("{blend}, {influences} of {vertices}, {backend}");
                    assert!(worst <= 2000.0 * epsilon, "{what}: {} ε", worst / epsilon);
                }
            }
        }
    }
}

#[test]
fn every_backend_agrees_with_the_reference_in_single_precision() {
    all_agree::<f32>(f32::EPSILON.into());
}

#[test]
fn every_backend_agrees_with_the_reference_in_double_precision() {
    all_agree::<f64>(f64::EPSILON);
}

#[test]
fn blocks_give_what_plain_slices_give() {
    const N: usize = 16;
    let pack = |slice: &[[f32; 3]]| {
        let mut blocks = vec![Block::<f32, N, 3>::splat([0.0; 3]); slice.len().div_ceil(N)];
        for (i, &point) in slice.iter().enumerate() {
            Element::<3>::set(&mut blocks, i, point);
        }
        blocks
    };
    let get = |blocks: &[Block<f32, N, 3>], i| Element::<3>::get(blocks, i).unwrap();
    for vertices in [1, 16, 33, 40] {
        let scene = Scene::<f32>::new(vertices, 4);
        for backend in Backend::available() {
            for blend in ["linear", "dual", "stretched", "mixed"] {
                let worst = error(&scene, backend, blend, pack, get);
                assert!(worst <= 2000.0 * f64::from(f32::EPSILON), "{blend} {vertices} {backend}");
            }
        }
    }
}

/// Positions alone are posed in another way, which reads the first number of the next point.
fn alone<R: Scalar + Weight, J: Index>(joint: impl Fn(u16) -> J) {
    for vertices in (0..22).chain([32, 33, 64, 65]) {
        let mut scene = Scene::<R>::new(vertices, 4);
        if let Some(point) = scene.positions.get_mut(6) {
            *point = [R::from(f32::NAN); 3];
        }
        let joints: Vec<J> = scene.joints.iter().map(|&j| joint(j)).collect();
        let skin = Skin::new(JOINTS, 4, &joints, &scene.weights).unwrap();
        let matrices = scene.matrices();
        for backend in Backend::available() {
            let [mut alone, mut together, mut normals] = [(); 3].map(|()| scene.positions.clone());
            let rest = Surface::positions(&scene.positions);
            let posed = SurfaceMut::positions(&mut alone);
            skin.job().backend(backend).pose(Linear::new(&matrices), rest, posed).unwrap();
            let posed = SurfaceMut::positions(&mut together).normals(&mut normals);
            let rest = rest.normals(&scene.normals);
            skin.job().backend(backend).pose(Linear::new(&matrices), rest, posed).unwrap();
            for (vertex, (a, b)) in alone.iter().zip(&together).enumerate() {
                let bits = |p: [R; 3]| p.map(|c| Into::<f64>::into(c).to_bits());
                let same =
                    if vertex == 6 { a.iter().all(|c| c.is_nan()) } else { bits(*a) == bits(*b) };
                assert!(same, "{vertex} of {vertices}, {backend}: {a:?} {b:?}");
            }
        }
    }
}

#[test]
fn positions_alone_have_every_bit_that_they_have_with_normals() {
    alone::<f32, u8>(|joint| joint as u8);
    alone::<f32, u16>(|joint| joint);
    alone::<f64, u16>(|joint| joint);
    alone::<f64, u32>(u32::from);
}

/// The same skin in other types is the same skin: every bit of the result.
#[test]
fn joints_and_weights_of_every_type_mean_the_same() {
    let scene = Scene::<f32>::new(100, 4);
    let bytes: Vec<u8> = scene.joints.iter().map(|&j| j as u8).collect();
    let words: Vec<u32> = scene.joints.iter().map(|&j| j.into()).collect();
    let eighths: Vec<[u8; 4]> = (0..100).map(|i| [200 - i, 55, 0, i]).collect();
    let of8 = eighths.as_flattened();
    // 257 · 255 = 65535, so these are the same weights.
    let of16: Vec<u16> = of8.iter().map(|&w| u16::from(w) * 257).collect();
    let singles: Vec<f32> = of8.iter().map(|&w| f32::from(w) / 255.0).collect();
    let run = |posed: &mut [[f32; 3]], which: usize| {
        let (from, to) = (Surface::positions(&scene.positions), SurfaceMut::positions(posed));
        let dual = DualBlend::new(&scene.motions);
        match which {
            0 => Skin::new(JOINTS, 4, &bytes, of8).unwrap().pose(dual, from, to),
            1 => Skin::new(JOINTS, 4, &words, &of16).unwrap().pose(dual, from, to),
            _ => Skin::new(JOINTS, 4, &scene.joints, &singles).unwrap().pose(dual, from, to),
        }
        .unwrap();
    };
    let mut posed = [[[0.0; 3]; 100]; 3];
    for (which, posed) in posed.iter_mut().enumerate() {
        run(posed, which);
    }
    assert_eq!(posed[0], posed[2]);
    assert_eq!(posed[1], posed[2]);
}

#[test]
fn the_implied_weight_is_what_the_others_leave() {
    for influences in [1, 2, 4, 5, 8] {
        let scene = Scene::<f64>::new(30, influences);
        let given: Vec<f64> = scene
            .weights
            .chunks(influences)
            .flat_map(|weights| weights[..influences - 1].to_vec())
            .collect();
        let implied = Skin::with_implied_weight(JOINTS, influences, &scene.joints, &given).unwrap();
        let matrices = scene.matrices();
        for backend in Backend::available() {
            let pairs = [
                (
                    posed(backend, &scene.skin(), DualBlend::new(&scene.motions), &scene.positions),
                    posed(backend, &implied, DualBlend::new(&scene.motions), &scene.positions),
                ),
                (
                    posed(backend, &scene.skin(), Linear::new(&matrices), &scene.positions),
                    posed(backend, &implied, Linear::new(&matrices), &scene.positions),
                ),
            ];
            for (a, b) in pairs {
                let worst = a.iter().zip(&b).map(|(a, b)| distance(*a, *b)).fold(0.0, f64::max);
                // The last weight as one less the others, times lengths of some units.
                assert!(worst < 2e-14, "{influences} {backend}: {worst}");
            }
        }
    }
}

#[cfg(feature = "rayon")]
#[test]
fn all_cores_give_every_bit_that_one_gives() {
    let scene = Scene::<f32>::new(10_000, 4);
    let mut posed = [vec![[0.0; 3]; 10_000], vec![[0.0; 3]; 10_000]];
    let mut normals = posed.clone();
    let rest = Surface::positions(&scene.positions).normals(&scene.normals);
    let blend = DualBlend::new(&scene.motions);
    let [a, b] = &mut posed;
    let [c, d] = &mut normals;
    scene.skin().pose(blend, rest, SurfaceMut::positions(a).normals(c)).unwrap();
    scene
        .skin()
        .job()
        .threads(usize::MAX)
        .pose(blend, rest, SurfaceMut::positions(b).normals(d))
        .unwrap();
    assert!(posed[0] == posed[1] && normals[0] == normals[1]);

    // Positions alone by linear blends begin in the middle of the skin.
    let (matrices, rest) = (scene.matrices(), Surface::positions(&scene.positions));
    let (blend, [a, b]) = (Linear::new(&matrices), &mut posed);
    scene.skin().pose(blend, rest, SurfaceMut::positions(a)).unwrap();
    scene.skin().job().threads(usize::MAX).pose(blend, rest, SurfaceMut::positions(b)).unwrap();
    assert_eq!(posed[0], posed[1]);
}

#[test]
fn a_blend_of_motions_at_right_angles_does_not_depend_on_the_other_vertices() {
    // |p|² has room in f32, the product of three has not: times the dot product at right
    // angles, 0, it is NaN.
    let large = 1e7;
    let palette = [[0.0, 0.0, 0.0, large], [-large, 0.0, 0.0, 0.0]]
        .map(|[x, y, z, w]| DualQuat::from_array([x, y, z, w, 0.0, 0.0, 0.0, 0.0_f32]));
    let joints = [0_u16, 0, 0, 1, 0, 1, 0, 0];
    let weights = [0.4_f32, 0.2, 0.2, 0.2, 0.4, 0.2, 0.2, 0.2];
    let rest = [[0.0_f32, 1.0, 0.0]; 2];
    let influences: Vec<_> =
        joints.iter().zip(weights).take(4).map(|(&j, w)| (palette[usize::from(j)], w)).collect();
    let wanted = dual_blend(&influences).unwrap().transform_point(rest[0]);
    for backend in Backend::available() {
        let posed = |vertices: usize| {
            let skin = Skin::new(2, 4, &joints[..4 * vertices], &weights[..4 * vertices]).unwrap();
            let mut posed = rest;
            let (from, to) = (&rest[..vertices], &mut posed[..vertices]);
            let (from, to) = (Surface::positions(from), SurfaceMut::positions(to));
            skin.job().backend(backend).pose(DualBlend::new(&palette), from, to).unwrap();
            posed[0]
        };
        assert_eq!(posed(1).map(f32::to_bits), posed(2).map(f32::to_bits), "{backend}");
        assert!(distance(posed(1), wanted) < 1e-6, "{backend}: {:?} is not {wanted:?}", posed(1));
    }
}
