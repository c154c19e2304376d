//! Skins of vertices some of which are wrong, and meshes that they pose: in arrays, and in vertex buffers.

use crate::random::Fuzz;
use dq8_capi::Status;
use dq8_capi::mesh::VertexFields;
use dq8_capi::palette::single as p;
use dq8_capi::skin::{InfluenceField, Skin};
use dq8_capi::skinning::single as c;
use std::mem::MaybeUninit;
use std::ptr;

pub(crate) fn skins(fuzz: &mut Fuzz) {
    let (joints, vertices, influences) = (1 + fuzz.below(5), fuzz.below(30), fuzz.below(6));
    // What is wrong: nothing, mostly.
    let wrong = fuzz.below(20);
    let index = |fuzz: &mut Fuzz| {
        let beyond = wrong == 1 && fuzz.below(40) == 0;
        if beyond { fuzz.bits() as u16 } else { fuzz.below(joints) as u16 }
    };
    let weight = |fuzz: &mut Fuzz| {
        let any = wrong == 2 && fuzz.below(40) == 0;
        if any { fuzz.number() } else { 0.01 + fuzz.below(100) as f32 }
    };
    // A vertex is a position, a normal, a tangent, the weights, and what lies between.
    let stride = 9 + influences + fuzz.below(3);
    let mut buffer = fuzz.numbers(stride * vertices);
    for vertex in buffer.chunks_exact_mut(stride) {
        let weights = &mut vertex[9..9 + influences];
        weights.fill_with(|| weight(fuzz));
        let sum: f32 = weights.iter().sum();
        weights.iter_mut().for_each(|weight| *weight /= sum);
    }
    let indices: Box<[u16]> = (0..influences * vertices).map(|_| index(fuzz)).collect();
    let field = InfluenceField { stride, first: if wrong == 3 { fuzz.below(20) } else { 9 } };
    let packed = InfluenceField { stride: influences, first: 0 };
    let mut made = MaybeUninit::<Skin<f32>>::zeroed();
    let (skin, mut bad) = (made.as_mut_ptr(), usize::MAX);
    let (from, of) = (buffer.as_ptr(), indices.as_ptr());
    // SAFETY: arrays are as long as is said, and a skin of zeros is one that has not been made.
    let status = unsafe {
        c::make_interleaved(
            joints,
            influences,
            of,
            packed,
            from,
            field,
            vertices,
            skin,
            &raw mut bad,
        )
    };
    let named = matches!(status, Status::JointOutOfRange | Status::Weight | Status::WeightSum);
    assert_eq!(bad < vertices, named, "{status:?}");
    // SAFETY: as above.
    let made = unsafe { made.assume_init_ref() };
    assert_eq!(made.influences != 0, status == Status::Ok, "{status:?}");
    assert!(wrong > 3 || wrong == 0 || influences == 0 || status != Status::Ok || bad > vertices);
    let there = if status == Status::Ok { status } else { Status::NoSkin };
    poses(fuzz, made, joints, (&buffer, stride, vertices), there);
}

/// Every way to pose the mesh; `there` if nothing else is wrong.
fn poses(
    fuzz: &mut Fuzz,
    skin: &Skin<f32>,
    joints: usize,
    (rest, stride, vertices): (&[f32], usize, usize),
    there: Status,
) {
    let fields = VertexFields { stride, position: 0, normal: 3, tangent: 6 };
    let to_stride = 9 + fuzz.below(4);
    let last = to_stride as i32 - 3;
    let wanted = VertexFields { stride: to_stride, position: last, normal: 0, tangent: 3 };
    let bad = VertexFields { position: fuzz.below(3 * to_stride) as i32 - 3, ..wanted };
    let mut posed = fuzz.numbers(to_stride * vertices);
    let (models, binds) = (fuzz.numbers(16 * joints), fuzz.numbers(16 * joints));
    let (mut matrices, mut motions) = (fuzz.numbers(12 * joints), fuzz.numbers(8 * joints));
    let mut stretches = fuzz.numbers(12 * joints);
    let shares: Box<[f32]> = (0..vertices).map(|_| fuzz.below(100) as f32 / 99.0).collect();
    let (from, to, h) = (rest.as_ptr(), posed.as_mut_ptr(), shares.as_ptr());
    let (m, d, s) = (matrices.as_mut_ptr(), motions.as_mut_ptr(), stretches.as_mut_ptr());
    // SAFETY: arrays are as long as is said.
    unsafe {
        // These refuse numbers that are not finite, and matrices that are not affine.
        let _ = p::products(models.as_ptr(), binds.as_ptr(), fuzz.below(3) as i32, m, joints);
        let _ = p::split(m, d, s, joints);
        for (status, fewer) in [
            (
                c::linear_interleaved(skin, m, joints, from, fields, to, wanted, vertices),
                c::linear_interleaved(skin, m, joints - 1, from, fields, to, wanted, vertices),
            ),
            (
                c::dual_interleaved(skin, d, joints, from, fields, to, wanted, vertices),
                c::dual_interleaved(skin, d, joints, from, fields, to, wanted, vertices + 1),
            ),
            (
                c::stretched_interleaved(skin, d, s, joints, from, fields, to, wanted, vertices),
                c::stretched_interleaved(skin, d, s, joints, from, fields, to, bad, 0),
            ),
            (
                c::mixed_interleaved(skin, m, d, h, joints, from, fields, to, wanted, vertices),
                c::mixed_interleaved(skin, m, d, h, joints - 1, from, fields, to, wanted, vertices),
            ),
        ] {
            assert_eq!(status, there);
            assert!(fewer != Status::Ok || vertices == 0, "{fewer:?}");
        }
        // A field may lie anywhere in its vertex, but not beyond it, or in another one.
        let status = c::dual_interleaved(skin, d, joints, from, fields, to, bad, vertices);
        let fits = (6..=last).contains(&bad.position);
        assert_eq!(status == Status::Ok, there == Status::Ok && fits, "{bad:?}: {status:?}");
        let (p3, mut o3) = (fuzz.numbers(3 * vertices), fuzz.numbers(3 * vertices));
        let (none, nowhere) = (ptr::null(), ptr::null_mut());
        let (p3, o3) = (p3.as_ptr(), o3.as_mut_ptr());
        assert_eq!(
            c::linear(skin, m, joints, p3, none, none, o3, nowhere, nowhere, vertices),
            there
        );
        assert_eq!(c::dual(skin, d, joints, p3, none, none, o3, nowhere, nowhere, vertices), there);
        let status =
            c::dual(skin, d, joints, p3, none, none, o3.byte_add(1), nowhere, nowhere, vertices);
        assert!(status != Status::Ok || vertices == 0);
    }
}
